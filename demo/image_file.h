// SPDX-License-Identifier: MIT
// Image files, through OpenImageIO. That library takes 0.3 s to load, so it lives in a module (image_module.cpp) which
// the first call here loads. Errors are std::runtime_error with the path and the reason. Writing is all or nothing:
// the file is made beside its place and renamed, so a failure leaves an older file as it was.
#pragma once

#include <cstdint>
#include <future>
#include <string>
#include <vector>

#include "pipeline/execute/execute.h"

namespace demo {

// Loads the module beside what the caller does next, until when the end of what is returned waits: while a library is being
// loaded a program must not end. Never fails: whoever needs the module learns what is wrong with it.
[[nodiscard]] std::future<void> preload_image_module();

// Any file OpenImageIO reads, as 0xAARRGGBB with alpha 255 where the file has none; grey fills all three channels.
pipeline::ColorImage read_image(const std::string& path);

// The first channel of a file as 0..1 at the file's own precision (16-bit and float height maps keep theirs).
struct HeightMap {
    int width = 0, height = 0;
    std::vector<float> heights;
};
HeightMap read_height_map(const std::string& path);

enum class Channels : std::uint8_t { Rgb, Rgba };
void write_image(const std::string& path, const pipeline::ColorImage& image, Channels channels);

// The bytes that write_image would write to a file of that name, which is not touched.
std::string encode_image(const std::string& name, const pipeline::ColorImage& image, Channels channels);

// Throws what write_image would, as far as that can be told before there is an image: bad directory, unknown extension.
void check_image_output(const std::string& path);

}  // namespace demo
