// SPDX-License-Identifier: MIT
// Frames of a few pixels whose answers can be worked out by hand, and what such tests have in common: drawing on both
// backends, and tables with a row for each enumerator.
#pragma once

#include <catch2/catch.hpp>
#include <functional>
#include <optional>
#include <set>
#include <type_traits>

#include "pipeline/execute/execute.h"
#include "tests/support/frame_agreement.h"
#include "tests/support/one_pass_frame.h"

namespace test_support {

inline pipeline::Frame small_frame(int width, int height, std::optional<pipeline::TargetFormat> depth = {}) {
    return one_pass_frame(width, height, depth);
}

inline pipeline::DrawRectangle rectangle(const pipeline::PixelRect& pixels, std::uint32_t color, float depth = 0.0f) {
    pipeline::DrawRectangle draw;
    draw.x0    = static_cast<float>(pixels.x0);
    draw.y0    = static_cast<float>(pixels.y0);
    draw.x1    = static_cast<float>(pixels.x1);
    draw.y1    = static_cast<float>(pixels.y1);
    draw.depth = depth;
    draw.color = {color};
    return draw;
}

// Two triangles, clockwise, over the whole viewport; appends their vertices and indices to the frame.
inline pipeline::DrawTriangles add_quad(pipeline::Frame& frame, std::uint32_t diffuse, float depth = 0.0f,
                                        std::uint32_t specular = 0) {
    const auto first_vertex = static_cast<std::uint32_t>(frame.vertices.size());
    pipeline::DrawTriangles draw;
    draw.first_index = static_cast<std::uint32_t>(frame.indices.size());
    draw.index_count = 6;
    for (const auto& [x, y] : {std::pair{-1.0f, 1.0f}, {1.0f, 1.0f}, {1.0f, -1.0f}, {-1.0f, -1.0f}}) {
        pipeline::Vertex& vertex = frame.vertices.emplace_back();
        vertex.position          = {x, y, depth};
        vertex.diffuse           = {diffuse};
        vertex.specular          = {specular};
    }
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) frame.indices.push_back(first_vertex + corner);
    return draw;
}

inline pipeline::TextureId add_texture(pipeline::Frame& frame, pipeline::TextureFormat format, int width, int height,
                                       std::vector<std::uint8_t> texels, int levels = 1) {
    pipeline::Texture& texture = frame.textures.emplace_back();
    texture.format             = format;
    texture.width              = width;
    texture.height             = height;
    texture.levels             = levels;
    texture.texels             = std::move(texels);
    return {static_cast<std::int32_t>(frame.textures.size()) - 1};
}

// The stage's colour and alpha are its texture.
inline constexpr pipeline::TextureStage kTextureOnly{.color_op = pipeline::TextureOp::SelectArg1,
                                                     .alpha_op = pipeline::TextureOp::SelectArg1};

inline pipeline::TextureBinding bound(pipeline::TextureId texture) {
    return {.texture = texture, .target = {}};
}

// The kernels' drawing, after a check that the reference's is the same.
inline Drawn draw_on_both(const pipeline::Frame& frame) {
    const Drawn drawn = draw(frame);
    CHECK(difference(drawn, draw_reference(frame)) == "");
    return drawn;
}

inline std::vector<std::uint32_t> pixels_on_both(const pipeline::Frame& frame) {
    return draw_on_both(frame).execution.output.pixels;
}

// The one colour that the output has everywhere.
inline std::uint32_t color_on_both(const pipeline::Frame& frame) {
    const std::set<std::uint32_t> colors = [&] {
        const std::vector<std::uint32_t> pixels = pixels_on_both(frame);
        return std::set(pixels.begin(), pixels.end());
    }();
    REQUIRE(colors.size() == 1);
    return *colors.begin();
}

// Has the table a row for each enumerator, in their order, and no two rows with the same answer? If two had, drawing
// one as the other would not show.
template <class Rows, class Key, class Answer>
void check_table(const Rows& rows, Key key, Answer answer) {
    using Row  = std::remove_cvref_t<decltype(*std::begin(rows))>;
    using Enum = std::remove_cvref_t<std::invoke_result_t<Key, const Row&>>;
    std::set<std::remove_cvref_t<std::invoke_result_t<Answer, const Row&>>> answers;
    std::size_t count = 0;
    for (const Row& row : rows) {
        CHECK(std::invoke(key, row) == static_cast<Enum>(count++));
        answers.insert(std::invoke(answer, row));
    }
    CHECK(count == pipeline::EnumNames<Enum>::names.size());
    CHECK(answers.size() == count);
}

}  // namespace test_support
