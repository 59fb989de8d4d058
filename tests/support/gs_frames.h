// SPDX-License-Identifier: MIT
// Frames that the Graphics Synthesizer draws as they are, and what its replay makes of them.
#pragma once

#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/emit/emit_gs.h"
#include "pipeline/frame/frame.h"
#include "tests/support/random.h"

namespace test_support {

// Target 0 is the output, target 1 the depth target if there is one; one pass, with no draws.
pipeline::Frame gs_frame(int width, int height, pipeline::TargetFormat color = pipeline::TargetFormat::Psmct32,
                         std::optional<pipeline::TargetFormat> depth = {});

// Appends three window vertices and their indices, and a draw of them to the pass.
void add_triangle(pipeline::Frame& frame, pipeline::Pass& pass, const std::array<pipeline::WindowVertex, 3>& corners,
                  const pipeline::TextureBinding& binding = {});

// Any bytes, of any size.
pipeline::TextureId add_random_texture(pipeline::Frame& frame, pipeline::TextureFormat format, int width, int height,
                                       Random& random);

// Two families of targets, textures of each format; passes that fill the targets, and two to six with all that the chip has.
// Triangles read textures whose sizes are powers of two.
pipeline::Frame random_gs_frame(std::uint32_t seed);

// Fails the test that calls it unless the frame is valid and has nothing that the chip lacks.
pipeline::LegalFrame legal_gs_frame(const pipeline::Frame& frame);

// The output of the frame's dump, replayed.
std::vector<std::uint32_t> replayed(const pipeline::Frame& frame);
std::vector<std::uint32_t> replayed(const pipeline::Frame& frame, const pipeline::GsStream& stream);

// The first pixel that differs, "(x, y): got ..., want ...", or "".
std::string difference_of(const pipeline::Frame& frame, const std::vector<std::uint32_t>& got);

// The same for each colour target that the frame uses, after the last pass.
std::string difference_in_targets(const pipeline::Frame& frame);

}  // namespace test_support
