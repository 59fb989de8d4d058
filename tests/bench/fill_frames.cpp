// SPDX-License-Identifier: MIT
// Frames that do nothing but fill: 32 layers, each of which writes every pixel of a 1920x1080 target.
//
// An executor may drop opaque layers that later ones hide; llvmpipe does so by tiles of 64x64 pixels if a target has
// no depth. 31 of 32 layers would then cost nothing. So layers without depth that are opaque leave the alpha that is
// there: they are no longer alone in deciding a pixel, and are drawn. What is timed is thus a masked store, in both
// executors. With depth every layer is nearer than the last, so that all fragments pass and are written.
#include "tests/bench/frame_builder.h"
#include "tests/bench/frames.h"

namespace bench {

using namespace pipeline;

namespace {

constexpr BlendState kOpaque{};

float layer_depth(int layer) {
    return 1.0f - static_cast<float>(layer + 1) / (kFillLayers + 1);
}

// The colours of neighbouring layers differ.
Argb layer_color(int layer, std::uint32_t alpha) {
    const auto i = static_cast<std::uint32_t>(layer);
    return {alpha << 24 | (i * 0x070503 & 0xffffff)};
}

Frame fill_frame(const BlendState& blend, bool has_depth = false) {
    Frame frame = one_pass_frame(kFillWidth, kFillHeight, has_depth ? std::optional(TargetFormat::D24) : std::nullopt);
    PipelineState& state = frame.passes[0].state;
    state.blend          = blend;
    if (has_depth)
        state.depth = {.func = CompareFunc::LessEqual, .write = true};
    else
        state.color_mask.alpha = blend != kOpaque;
    return frame;
}

template <class Color>
void add_rectangles(Frame& frame, Color&& color, const UvRect& uv = {}, TextureId texture = {}) {
    for (int layer = 0; layer < kFillLayers; ++layer) {
        DrawRectangle rectangle;
        rectangle.x1          = kFillWidth;
        rectangle.y1          = kFillHeight;
        rectangle.depth       = layer_depth(layer);
        rectangle.color       = color(layer);
        rectangle.uv[0]       = uv;
        rectangle.textures[0] = {.texture = texture, .target = {}};
        frame.passes[0].draws.emplace_back(rectangle);
    }
}

// Two triangles over the whole target. w: the clip coordinate at the left and at the right edge, powers of two so
// that the division by it is exact; the camera's projection makes it z.
void add_quad(Frame& frame, const std::array<Argb, 4>& colors, float depth, float w_left = 1.0f, float w_right = 1.0f,
              TextureId texture = {}) {
    const auto first = static_cast<std::uint32_t>(frame.vertices.size());
    DrawTriangles draw;
    draw.first_index = static_cast<std::uint32_t>(frame.indices.size());
    draw.index_count = 6;
    draw.textures[0] = {.texture = texture, .target = {}};
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
        const bool right = corner == 1 || corner == 2, down = corner >= 2;
        const float w   = right ? w_right : w_left;
        Vertex& vertex  = frame.vertices.emplace_back();
        vertex.position = {(right ? w : -w), (down ? -w : w), w_left == w_right ? depth : w};
        vertex.diffuse  = colors[corner];
        vertex.uv0      = {right ? 1.0f : 0.0f, down ? 1.0f : 0.0f};
    }
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) frame.indices.push_back(first + corner);
    frame.passes[0].draws.emplace_back(draw);
}

Frame opaque_flat(bool has_depth) {
    Frame frame = fill_frame(kOpaque, has_depth);
    add_rectangles(frame, [](int layer) { return layer_color(layer, 0xff); });
    return frame;
}

Frame opaque_gouraud_z() {
    Frame frame = fill_frame(kOpaque, true);
    for (int layer = 0; layer < kFillLayers; ++layer)
        add_quad(frame,
                 {layer_color(layer, 0xff), Argb{0xffff8000}, layer_color(layer + kFillLayers, 0xff), Argb{0xff0080ff}},
                 layer_depth(layer));
    return frame;
}

Frame srcalpha_flat() {
    Frame frame = fill_frame(kAlphaOver);
    add_rectangles(frame, [](int layer) { return layer_color(layer, 0x60); });
    return frame;
}

// So near to white that the picture does not become black before the last layer.
Frame multiply_flat() {
    Frame frame = fill_frame(kMultiply);
    add_rectangles(frame, [](int) { return Argb{0xfcfafbfd}; });
    return frame;
}

// As the fractal box of a cloud seen from near: its six A8 faces multiply the alpha of what is there, in perspective.
Frame a8_bilinear_alpha_multiply() {
    Frame frame          = fill_frame(kMultiply);
    Mat4& projection     = frame.cameras[0].projection;
    projection[2][2]     = 0.125f;  // depth: any value within 0..1
    projection[2][3]     = 1.0f;    // w = z
    projection[3][3]     = 0.0f;
    PipelineState& state = frame.passes[0].state;
    state.color_mask     = {.red = false, .green = false, .blue = false, .alpha = true};
    show_texture(state, TextureFilter::Linear, TextureAddress::Clamp);
    state.stages[0].mip_filter = MipFilter::Linear;
    const TextureId texture    = add_noise_texture(frame, TextureFormat::A8, 256, 256);
    for (std::uint8_t& texel : frame.textures[0].texels) texel |= 0xe0;  // so that some alpha is left after all layers
    for (int layer = 0; layer < kFillLayers; ++layer)
        add_quad(frame, {}, 0.0f, layer % 2 == 0 ? 1.0f : 2.0f, layer % 2 == 0 ? 2.0f : 1.0f, texture);
    return frame;
}

// texels: of the texture on each pixel, along both axes.
Frame rgba_bilinear(float texels) {
    constexpr int kSize = 512;
    Frame frame         = fill_frame(kOpaque);
    show_texture(frame.passes[0].state, TextureFilter::Linear);
    const TextureId texture = add_noise_texture(frame, TextureFormat::A8R8G8B8, kSize, kSize);
    add_rectangles(
        frame, [](int) { return Argb{}; },
        {.u0 = 0.0f, .v0 = 0.0f, .u1 = kFillWidth * texels / kSize, .v1 = kFillHeight * texels / kSize}, texture);
    return frame;
}

Frame rgba_1to1_srcalpha() {
    Frame frame = fill_frame(kAlphaOver);
    show_texture(frame.passes[0].state, TextureFilter::Point, TextureAddress::Clamp);
    const TextureId texture = add_noise_texture(frame, TextureFormat::A8R8G8B8, kFillWidth, kFillHeight);
    add_rectangles(
        frame, [](int) { return Argb{}; }, {}, texture);
    return frame;
}

}  // namespace

std::vector<FrameCase> fill_cases() {
    constexpr double kPixels = double{kFillWidth} * kFillHeight * kFillLayers;
    const auto fill          = [](const char* name, std::function<Frame()> build) {
        return FrameCase{std::string("fill/") + name, std::move(build), kPixels, "pixels"};
    };
    return {
        fill("opaque_flat", [] { return opaque_flat(false); }),
        fill("opaque_flat_z", [] { return opaque_flat(true); }),
        fill("opaque_gouraud_z", &opaque_gouraud_z),
        fill("srcalpha_flat", &srcalpha_flat),
        fill("multiply_flat", &multiply_flat),
        fill("a8_bilinear_alpha_multiply", &a8_bilinear_alpha_multiply),
        fill("rgba_bilinear_magnified", [] { return rgba_bilinear(0.4f); }),
        fill("rgba_bilinear_minified", [] { return rgba_bilinear(1.5f); }),
        fill("rgba_1to1_srcalpha", &rgba_1to1_srcalpha),
    };
}

}  // namespace bench
