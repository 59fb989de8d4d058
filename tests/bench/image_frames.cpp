// SPDX-License-Identifier: MIT
// Frames that do to a picture what libraries of pixel loops do, kImageRounds times, so that the loops are timed and not
// what begins and ends a frame.
#include "tests/bench/frame_builder.h"
#include "tests/bench/frames.h"

namespace bench {

using namespace pipeline;

namespace {

// As the first step of a cloud's blur: each pixel's centre falls on the corner that four texels share.
Frame box2() {
    Frame frame = one_pass_frame(kImageWidth / 2, kImageHeight / 2);
    Pass& pass  = frame.passes[0];
    pass.clear  = {};
    show_texture(pass.state, TextureFilter::Linear, TextureAddress::Clamp);
    DrawRectangle blit;
    blit.x1          = kImageWidth / 2;
    blit.y1          = kImageHeight / 2;
    blit.textures[0] = {.texture = add_noise_texture(frame, TextureFormat::A8R8G8B8, kImageWidth, kImageHeight),
                        .target  = {}};
    pass.draws.assign(kImageRounds, blit);
    return frame;
}

Frame srcalpha() {
    Frame frame      = one_pass_frame(kImageWidth, kImageHeight);
    Pass& pass       = frame.passes[0];
    pass.clear       = {};
    pass.state.blend = kAlphaOver;
    show_texture(pass.state, TextureFilter::Point, TextureAddress::Clamp);
    DrawRectangle layer;
    layer.x1          = kImageWidth;
    layer.y1          = kImageHeight;
    layer.textures[0] = {.texture = add_noise_texture(frame, TextureFormat::A8R8G8B8, kImageWidth, kImageHeight),
                         .target  = {}};
    pass.draws.assign(kImageRounds, layer);
    return frame;
}

}  // namespace

std::vector<FrameCase> image_cases() {
    constexpr double kPixels = double{kImageRounds} * kImageWidth * kImageHeight;
    return {{"downsample/box2", &box2, kPixels, "pixels"}, {"blend/srcalpha_rows", &srcalpha, kPixels, "pixels"}};
}

}  // namespace bench
