// SPDX-License-Identifier: MIT
// Frames that do to a whole picture what libraries of pixel loops do.
#include "tests/bench/frame_builder.h"
#include "tests/bench/frames.h"

namespace bench {

using namespace pipeline;

namespace {

// As the first step of a cloud's blur: each pixel's centre falls on the corner that four texels share.
Frame box2() {
    Frame frame = one_pass_frame(kFillWidth / 2, kFillHeight / 2);
    Pass& pass  = frame.passes[0];
    pass.clear  = {};
    show_texture(pass.state, TextureFilter::Linear, TextureAddress::Clamp);
    DrawRectangle blit;
    blit.x1          = kFillWidth / 2;
    blit.y1          = kFillHeight / 2;
    blit.textures[0] = {.texture = add_noise_texture(frame, TextureFormat::A8R8G8B8, kFillWidth, kFillHeight),
                        .target  = {}};
    pass.draws.emplace_back(blit);
    return frame;
}

Frame srcalpha() {
    Frame frame      = one_pass_frame(kFillWidth, kFillHeight);
    Pass& pass       = frame.passes[0];
    pass.clear       = {};
    pass.state.blend = kAlphaOver;
    show_texture(pass.state, TextureFilter::Point, TextureAddress::Clamp);
    DrawRectangle layer;
    layer.x1          = kFillWidth;
    layer.y1          = kFillHeight;
    layer.textures[0] = {.texture = add_noise_texture(frame, TextureFormat::A8R8G8B8, kFillWidth, kFillHeight),
                         .target  = {}};
    pass.draws.emplace_back(layer);
    return frame;
}

}  // namespace

std::vector<FrameCase> image_cases() {
    constexpr double kPixels = double{kFillWidth} * kFillHeight;
    return {{"downsample/box2", &box2, kPixels, "pixels"}, {"blend/srcalpha_rows", &srcalpha, kPixels, "pixels"}};
}

}  // namespace bench
