// SPDX-License-Identifier: MIT
#include "demo/image_file.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <new>
#include <stdexcept>

#include "demo/image_module.h"
#include "demo/new_file.h"

namespace demo {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
    throw std::runtime_error(path + ": " + reason);
}

// A module that is missing is a fault of the installation, not of the input: hence no runtime_error.
const Nimbus7ImageModule& load_module() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (error) throw std::logic_error("cannot find the running program: " + error.message());
    const std::string path = program.parent_path() / "libnimbus7_image.so";
    void* library          = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (!library) throw std::logic_error(std::string("cannot load the image module: ") + dlerror());
    void* symbol = dlsym(library, "nimbus7_image_module");
    if (!symbol) throw std::logic_error(std::string("cannot use the image module: ") + dlerror());
    return *reinterpret_cast<decltype(&nimbus7_image_module)>(symbol)();
}

const Nimbus7ImageModule& module() {
    static const Nimbus7ImageModule& loaded = load_module();
    return loaded;
}

void check_input(const std::string& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) fail(path, "no such file");
    if (fs::is_directory(status)) fail(path, "is a directory");
    if (!fs::is_regular_file(status)) fail(path, "is not a regular file");
    if (access(path.c_str(), R_OK) != 0) fail(path, std::strerror(errno));
    if (fs::file_size(path, error) == 0) fail(path, "the file is empty");
}

// Runs the module's reader with room in `samples` of `image`, a vector; an exception may not pass through the module.
template <class Image, class Sample>
Image read_with(decltype(Nimbus7ImageModule::read_pixels) read, std::vector<Sample> Image::*samples,
                const std::string& path) {
    check_input(path);
    struct Room {
        Image image;
        std::vector<Sample> Image::*samples;
    } room{{}, samples};
    const Nimbus7Allocate allocate = [](void* owner, int width, int height) -> void* {
        auto& [image, member] = *static_cast<Room*>(owner);
        try {
            (image.*member).resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        } catch (const std::bad_alloc&) {
            return nullptr;
        }
        image.width  = width;
        image.height = height;
        return (image.*member).data();
    };
    Nimbus7Reason reason{};
    if (!read(path.c_str(), allocate, &room, &reason)) fail(path, reason.text);
    return std::move(room.image);
}

std::string extension_of(const std::string& path) {
    const std::string extension = fs::path(path).extension();
    if (extension.size() < 2) fail(path, "an image file needs an extension, such as .png");
    return extension.substr(1);
}

}  // namespace

std::future<void> preload_image_module() {
    return std::async(std::launch::async, [] {
        try {
            module();
        } catch (const std::exception&) {
            // The next call of module() tries again, and throws where it can be told.
        }
    });
}

pipeline::ColorImage read_image(const std::string& path) {
    return read_with<pipeline::ColorImage>(module().read_pixels, &pipeline::ColorImage::pixels, path);
}

HeightMap read_height_map(const std::string& path) {
    return read_with<HeightMap>(module().read_heights, &HeightMap::heights, path);
}

void check_image_output(const std::string& path) {
    check_output(path);
    const std::string extension = extension_of(path);
    Nimbus7Reason reason{};
    if (!module().can_write(extension.c_str(), &reason)) fail(path, reason.text);
}

std::string encode_image(const std::string& name, const pipeline::ColorImage& image, Channels channels) {
    if (image.width < 1 || image.height < 1 || image.width > kMaxImageSide || image.height > kMaxImageSide) {
        fail(name, "cannot hold an image of " + std::to_string(image.width) + "x" + std::to_string(image.height));
    }
    const Nimbus7TakeFile keep = [](void* owner, const unsigned char* bytes, std::size_t size) {
        static_cast<std::string*>(owner)->assign(reinterpret_cast<const char*>(bytes), size);
    };
    std::string file;
    Nimbus7Reason reason{};
    if (!module().encode_pixels(extension_of(name).c_str(), image.pixels.data(), image.width, image.height,
                                channels == Channels::Rgba ? 4 : 3, keep, &file, &reason)) {
        fail(name, reason.text);
    }
    return file;
}

void write_image(const std::string& path, const pipeline::ColorImage& image, Channels channels) {
    check_image_output(path);
    write_file(path, encode_image(path, image, channels));
}

}  // namespace demo
