// SPDX-License-Identifier: MIT
#include "demo/image_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

int fail(Nimbus7Reason* reason, const std::string& text) {
    std::string line;
    for (const char c : text) {
        const bool is_space = static_cast<unsigned char>(c) <= ' ';
        if (!is_space || (!line.empty() && line.back() != ' ')) line += is_space ? ' ' : c;
    }
    while (!line.empty() && (line.back() == ' ' || line.back() == '.')) line.pop_back();
    std::snprintf(reason->text, sizeof reason->text, "%s", line.c_str());
    return 0;
}

std::string with_detail(const std::string& what, const std::string& detail) {
    return what + " (" + (detail.empty() ? "OpenImageIO gives no reason" : detail) + ")";
}

// The libraries behind OpenImageIO complain on standard error, beside the reason that we get from it: not while this lives.
class QuietStandardError {
  public:
    QuietStandardError() : kept_(fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3)) {
        const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (kept_ >= 0 && nowhere >= 0) dup2(nowhere, STDERR_FILENO);
        if (nowhere >= 0) close(nowhere);
    }
    ~QuietStandardError() {
        if (kept_ < 0) return;
        dup2(kept_, STDERR_FILENO);
        close(kept_);
    }
    QuietStandardError(const QuietStandardError&)            = delete;
    QuietStandardError& operator=(const QuietStandardError&) = delete;

  private:
    int kept_;
};

// The first image of a file, in as many bits as the file has: bytes, 16-bit words or floats.
struct Samples {
    OIIO::ImageSpec spec;
    OIIO::TypeDesc type;
    std::vector<unsigned char> bytes;  // of `type`, channels interleaved
    bool is_associated = false;        // colour is stored times alpha

    // 0..1 for the integer types.
    float at(std::int64_t pixel, int channel) const {
        const std::int64_t index = pixel * spec.nchannels + channel;
        if (type == OIIO::TypeUInt8) return static_cast<float>(bytes[static_cast<std::size_t>(index)]) / 255.0f;
        if (type == OIIO::TypeUInt16) {
            return static_cast<float>(reinterpret_cast<const std::uint16_t*>(bytes.data())[index]) / 65535.0f;
        }
        return reinterpret_cast<const float*>(bytes.data())[index];
    }
    std::int64_t pixels() const { return static_cast<std::int64_t>(spec.width) * spec.height; }
};

int read_samples(const char* path, Samples& samples, Nimbus7Reason* reason) {
    const QuietStandardError quiet;
    OIIO::ImageSpec wanted;
    wanted.attribute("oiio:UnassociatedAlpha", 1);
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path, &wanted);
    if (!input) return fail(reason, with_detail("not an image OpenImageIO can read", OIIO::geterror()));

    samples.spec                = input->spec();
    const OIIO::ImageSpec& spec = samples.spec;
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) return fail(reason, "the image is empty");
    if (spec.deep || spec.depth > 1) return fail(reason, "deep and volume images are not supported");
    if (spec.width > kMaxImageSide || spec.height > kMaxImageSide || samples.pixels() > kMaxImagePixels) {
        return fail(reason, "the image is too large: " + std::to_string(spec.width) + "x" +
                                std::to_string(spec.height) + " (at most " + std::to_string(kMaxImageSide) +
                                " a side and " + std::to_string(kMaxImagePixels) + " pixels)");
    }
    if (spec.nchannels > 64) return fail(reason, "the image has too many channels");
    const bool is_word = spec.format == OIIO::TypeUInt16;
    samples.type = spec.format == OIIO::TypeUInt8 ? OIIO::TypeUInt8 : is_word ? OIIO::TypeUInt16 : OIIO::TypeFloat;
    // What OpenEXR always and TIFF sometimes stores; the other readers give straight alpha, as asked, but not all say
    // so.
    const std::string format = input->format_name();
    samples.is_associated =
        format == "openexr" || (format == "tiff" && !spec.get_int_attribute("oiio:UnassociatedAlpha"));
    samples.bytes.resize(static_cast<std::size_t>(samples.pixels()) * static_cast<std::size_t>(spec.nchannels) *
                         samples.type.size());
    if (!input->read_image(0, 0, 0, spec.nchannels, samples.type, samples.bytes.data())) {
        return fail(reason, with_detail("the image is damaged", input->geterror()));
    }
    return 1;
}

// Nearest byte; a NaN gives 0. Exact for 8- and 16-bit samples: none of those comes within 1/600 of a half.
std::uint32_t to_byte(float value) {
    if (!(value > 0.0f)) return 0;
    return value >= 1.0f ? 255u : static_cast<std::uint32_t>(value * 255.0f + 0.5f);
}

int read_pixels(const char* path, Nimbus7Allocate allocate, void* owner, Nimbus7Reason* reason) try {
    Samples samples;
    if (!read_samples(path, samples, reason)) return 0;
    const OIIO::ImageSpec& spec = samples.spec;
    // One or two channels are grey (and alpha); of more than three the alpha is the one so named.
    const bool is_grey          = spec.nchannels < 3;
    const int green = is_grey ? 0 : 1, blue = is_grey ? 0 : 2;
    const int alpha = spec.nchannels == 1 || spec.nchannels == 3 ? -1 : is_grey ? 1 : spec.alpha_channel;

    auto* pixels = static_cast<std::uint32_t*>(allocate(owner, spec.width, spec.height));
    if (!pixels) return fail(reason, "out of memory");
    for (std::int64_t i = 0; i < samples.pixels(); ++i) {
        const float a      = alpha >= 0 ? samples.at(i, alpha) : 1.0f;
        const auto channel = [&](int index) {
            const float value = samples.at(i, index);
            return to_byte(samples.is_associated && a > 0.0f ? value / a : value);
        };
        pixels[i] = to_byte(a) << 24 | channel(0) << 16 | channel(green) << 8 | channel(blue);
    }
    return 1;
} catch (const std::exception& error) {
    return fail(reason, error.what());
}

int read_heights(const char* path, Nimbus7Allocate allocate, void* owner, Nimbus7Reason* reason) try {
    Samples samples;
    if (!read_samples(path, samples, reason)) return 0;
    auto* heights = static_cast<float*>(allocate(owner, samples.spec.width, samples.spec.height));
    if (!heights) return fail(reason, "out of memory");
    for (std::int64_t i = 0; i < samples.pixels(); ++i) {
        heights[i] = samples.at(i, 0);
        if (!(heights[i] >= 0.0f && heights[i] <= 1.0f)) {
            return fail(reason, "heights must lie in 0..1 (pixel " + std::to_string(i % samples.spec.width) + ", " +
                                    std::to_string(i / samples.spec.width) + " is " + std::to_string(heights[i]) + ")");
        }
    }
    return 1;
} catch (const std::exception& error) {
    return fail(reason, error.what());
}

int can_write(const char* extension, Nimbus7Reason* reason) try {
    // These two "formats" make no file.
    const bool is_display = std::string_view(extension) == "term" || std::string_view(extension) == "null";
    if (!is_display && OIIO::ImageOutput::create(extension)) return 1;
    OIIO::geterror();  // and forget it
    return fail(reason, std::string("OpenImageIO writes no image with the extension '.") + extension +
                            "' (png, exr, tga, bmp, jpg and others are known)");
} catch (const std::exception& error) {
    return fail(reason, error.what());
}

// The image as OpenImageIO writes it, in memory: several of its writers do not notice a full disk, and the JPEG
// library ends the program there. Formats that cannot write to memory write to a file without a name.
class MemoryFile {
  public:
    explicit MemoryFile(OIIO::ImageOutput& output) : takes_proxy_(output.supports("ioproxy")) {
        if (takes_proxy_) {
            output.set_ioproxy(&proxy_);
        } else {
            file_ = memfd_create("nimbus7", MFD_CLOEXEC);
        }
    }
    ~MemoryFile() {
        if (file_ >= 0) close(file_);
    }
    MemoryFile(const MemoryFile&)            = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    std::string path(const char* extension) const {
        return takes_proxy_ ? std::string("image.") + extension : "/proc/self/fd/" + std::to_string(file_);
    }
    // After the writer has closed it.
    const std::vector<unsigned char>& read() {
        if (!takes_proxy_) {
            bytes_.resize(static_cast<std::size_t>(std::max<off_t>(0, lseek(file_, 0, SEEK_END))));
            rlimit limit{};
            const bool is_cut = getrlimit(RLIMIT_FSIZE, &limit) == 0 && bytes_.size() >= limit.rlim_cur;
            if (is_cut) throw std::runtime_error("the file is too large");
            std::size_t done = 0;
            while (done < bytes_.size()) {
                const ssize_t got = pread(file_, bytes_.data() + done, bytes_.size() - done, static_cast<off_t>(done));
                if (got <= 0) throw std::runtime_error("cannot be read back from memory");
                done += static_cast<std::size_t>(got);
            }
        }
        return bytes_;
    }

  private:
    std::vector<unsigned char> bytes_;
    OIIO::Filesystem::IOVecOutput proxy_{bytes_};
    bool takes_proxy_;
    int file_ = -1;
};

// OpenEXR knows colour times alpha only, and does not convert: the channels as floats, 0..1.
std::vector<float> associated(const std::vector<unsigned char>& rgba) {
    std::vector<float> floats;
    floats.reserve(rgba.size());
    for (std::size_t i = 0; i < rgba.size(); ++i) {
        const float alpha = i % 4 == 3 ? 1.0f : static_cast<float>(rgba[i | 3]) / 255.0f;
        floats.push_back(static_cast<float>(rgba[i]) / 255.0f * alpha);
    }
    return floats;
}

int encode_pixels(const char* extension, const std::uint32_t* pixels, int width, int height, int channels,
                  Nimbus7TakeFile take, void* owner, Nimbus7Reason* reason) try {
    const QuietStandardError quiet;
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(extension);
    if (!output) return fail(reason, OIIO::geterror());
    std::vector<unsigned char> bytes;
    bytes.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                  static_cast<std::size_t>(channels));
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(width) * height; ++i) {
        for (const int shift : {16, 8, 0}) bytes.push_back(static_cast<unsigned char>(pixels[i] >> shift & 255));
        if (channels == 4) bytes.push_back(static_cast<unsigned char>(pixels[i] >> 24));
    }

    const bool associates = channels == 4 && std::string_view(output->format_name()) == "openexr";
    OIIO::ImageSpec spec(width, height, channels, associates ? OIIO::TypeHalf : OIIO::TypeUInt8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("png:compressionLevel", 2);  // a quarter of the time of 6, for a file a tenth larger
    spec.attribute("CompressionQuality", 95);
    MemoryFile file(*output);
    const bool is_written = output->open(file.path(extension), spec) &&
                            (associates ? output->write_image(OIIO::TypeFloat, associated(bytes).data())
                                        : output->write_image(OIIO::TypeUInt8, bytes.data())) &&
                            output->close();
    if (!is_written) return fail(reason, with_detail("cannot be written", output->geterror()));
    if (file.read().empty()) return fail(reason, "OpenImageIO wrote nothing");
    take(owner, file.read().data(), file.read().size());
    return 1;
} catch (const std::exception& error) {
    return fail(reason, error.what());
}

}  // namespace

extern "C" const Nimbus7ImageModule* nimbus7_image_module() {
    OIIO::attribute("threads", 1);  // one small image at a time: a pool of threads costs more than it brings
    static constexpr Nimbus7ImageModule kModule{&read_pixels, &read_heights, &can_write, &encode_pixels};
    return &kModule;
}
