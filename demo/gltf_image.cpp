// SPDX-License-Identifier: MIT
#include "demo/gltf_image.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "demo/gltf_check.h"
#include "demo/image_file.h"
#include "demo/texture_pyramid.h"

namespace demo {
namespace {

// Bytes as a file without a name, for the image reader, which takes paths.
class MemoryFile {
  public:
    explicit MemoryFile(const std::vector<unsigned char>& bytes) : file_(memfd_create("picture", MFD_CLOEXEC)) {
        std::size_t done = 0;
        while (file_ >= 0 && done < bytes.size()) {
            const ssize_t written = write(file_, bytes.data() + done, bytes.size() - done);
            if (written <= 0) break;
            done += static_cast<std::size_t>(written);
        }
        is_complete_ = file_ >= 0 && done == bytes.size();
    }
    ~MemoryFile() {
        if (file_ >= 0) close(file_);
    }
    MemoryFile(const MemoryFile&)            = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    bool is_complete() const { return is_complete_; }
    std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

  private:
    int file_;
    bool is_complete_ = false;
};

pipeline::ColorImage decode(const std::vector<unsigned char>& bytes) {
    const MemoryFile memory(bytes);
    if (!memory.is_complete()) throw std::runtime_error("does not fit into memory");
    try {
        return read_image(memory.path());
    } catch (const std::runtime_error& error) {
        // Without the path, which nobody has named: it stands in front, and in the library's own words.
        std::string line       = error.what();
        const std::string path = memory.path();
        line.erase(0, path.size() + 2);
        if (const std::size_t at = line.find(path); at != std::string::npos) line.replace(at, path.size(), "a picture");
        throw std::runtime_error(line);
    }
}

}  // namespace

pipeline::Texture read_gltf_texture(const GltfFile& file, int texture) {
    const std::string what       = "textures[" + std::to_string(texture) + "]";
    const int source             = file.find(file.model().textures, texture, what + " is not there").source;
    const tinygltf::Image& image = file.find(file.model().images, source, what + ".source names no image");
    const std::string name       = "images[" + std::to_string(source) + "]";
    try {
        pipeline::ColorImage pixels = image.as_is ? decode(image.image) : read_image(file.path_of(image.uri));
        return texture_pyramid(file.path() + "#" + std::to_string(source), pixels.width, pixels.height,
                               std::move(pixels.pixels));
    } catch (const std::runtime_error& error) {
        file.fail(name + ": " + error.what());
    }
}

}  // namespace demo
