// SPDX-License-Identifier: MIT
// The built-in canyon, a whole picture with terrain, clouds, their blur and fog, at several sizes.
#include "demo/frame_source.h"
#include "tests/bench/frames.h"

namespace bench {

namespace {

// Nothing of the scene stays, for the memory that a drawing takes is measured.
pipeline::Frame canyon(demo::Size size) {
    constexpr int kFrameOfAnimation = 6;
    return demo::FrameSource("canyon").frame(size, kFrameOfAnimation);
}

FrameCase canyon_case(const char* name, int width, int height) {
    return {.name = name,
            .build =
                [=] {
                    return canyon({width, height});
                },
            .size = static_cast<double>(width) * height};
}

}  // namespace

std::vector<FrameCase> scene_cases() {
    return {
        canyon_case("frame/canyon_1080p", 1920, 1080),     canyon_case("frame/canyon_720p", 1280, 720),
        canyon_case("frame/canyon_ps2_640x448", 640, 448), canyon_case("growth/canyon/480p", 854, 480),
        canyon_case("growth/canyon/720p", 1280, 720),      canyon_case("growth/canyon/1080p", 1920, 1080),
        canyon_case("growth/canyon/1440p", 2560, 1440),    canyon_case("growth/canyon/2160p", 3840, 2160),
    };
}

}  // namespace bench
