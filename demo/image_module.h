// SPDX-License-Identifier: MIT
// What the program and the image module say to each other: the module is loaded at run time, so this is C. Functions
// return 1, or 0 with a reason for the user in `reason` (one line). No exception crosses.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

struct Nimbus7Reason {
    char text[400];
};

// Called once the size is known and found acceptable: returns room for width * height pixels, or null to give up.
using Nimbus7Allocate = void* (*)(void* owner, int width, int height);

// Receives a finished file, which the caller still owns.
using Nimbus7TakeFile = void (*)(void* owner, const unsigned char* bytes, std::size_t size);

struct Nimbus7ImageModule {
    // Pixels are uint32_t, 0xAARRGGBB with straight alpha.
    int (*read_pixels)(const char* path, Nimbus7Allocate allocate, void* owner, Nimbus7Reason* reason);
    // Heights are float.
    int (*read_heights)(const char* path, Nimbus7Allocate allocate, void* owner, Nimbus7Reason* reason);
    // extension: "png", without the dot.
    int (*can_write)(const char* extension, Nimbus7Reason* reason);
    // Makes a file in the format of `extension` and hands it over in one piece; channels: 3 (RGB) or 4 (RGBA).
    int (*encode_pixels)(const char* extension, const std::uint32_t* pixels, int width, int height, int channels,
                         Nimbus7TakeFile take, void* owner, Nimbus7Reason* reason);
};

// The one symbol of the module.
const Nimbus7ImageModule* nimbus7_image_module();

}  // extern "C"

// Larger images are refused before anything is allocated for them.
inline constexpr int kMaxImageSide            = 16384;
inline constexpr std::int64_t kMaxImagePixels = std::int64_t{1} << 26;
