// SPDX-License-Identifier: MIT
// The passes of a frame as GX calls, and the data they need. Each pass writes all state that it uses, whatever the one
// before has left.
#pragma once

#include <vector>

#include "pipeline/check/frame_buffer.h"
#include "pipeline/check/needed_pixels.h"
#include "pipeline/check/target_use.h"
#include "pipeline/emit/gx_data.h"
#include "pipeline/emit/gx_lights.h"
#include "pipeline/emit/gx_tev.h"
#include "pipeline/emit/gx_text.h"
#include "pipeline/emit/gx_transform.h"

namespace pipeline {

// What all passes share.
struct GxFrame {
    explicit GxFrame(const Frame& of);

    const Frame& frame;
    std::vector<bool> is_in_buffer;  // of targets; the others are copies, in main memory
    BufferPlaces places;
    std::vector<std::vector<PixelRegion>> zeros;  // pixels_used_as_zeros, of targets in the buffer
    GxVertices vertices;
    GxData data;
    std::vector<std::uint32_t> texels;  // offsets of textures
    bool uses_normals = false, uses_colors0 = false, uses_colors1 = false;
    std::array<bool, 2> uses_uv{};
};

std::string gx_target_name(std::size_t index);  // of its array in the program
// 64 bytes for each tile of 4x4.
std::uint64_t gx_target_bytes(const Target& target);

// Appends what pass number `index` does. pixel_format: the frame buffer's, before and after.
void emit_gx_pass(GxFrame& gx, std::size_t index, std::string_view& pixel_format, CText& text);

// A draw's calls, written only where they differ from those of the draw before in the same pass.
class GxDraws {
  public:
    GxDraws(GxFrame& gx, std::size_t pass, const BufferSpot& spot, CText& text);
    void emit(const DrawTriangles& draw, std::size_t index);
    void emit(const DrawRectangle& draw, std::size_t index);

  private:
    struct Fog {
        bool is_vertex = false;
        std::string call;
    };
    Fog fog_of(const GxTransform& transform) const;
    void space_of_triangles(const DrawTriangles& draw, const GxTransform& transform, const Fog& fog);
    void space_of_rectangle();
    void stages(const TevProgram& program, const TextureBindings& textures);
    void coordinates(const TevProgram& program, const DrawTriangles* draw);
    void channels(bool has_second, const GxLighting* lighting);
    void part(const GxPart& part, const std::string& what, const TevProgram& program, const VertexColorist& colorist,
              const GxLighting* lighting);
    TevInputs inputs_of(const TextureBindings& textures) const;
    TexelKind kind_of(std::size_t stage, const TextureBinding& binding) const;
    std::vector<int> uv_sets(const TevProgram& program) const;
    void write(std::string& last, CText& calls);

    GxFrame& gx_;
    const Pass& pass_;
    std::size_t pass_index_;
    BufferSpot spot_;
    Target target_;
    PixelRect viewport_;
    CText& text_;
    std::string last_space_, last_stages_, last_coordinates_, last_channels_, last_arrays_;
    std::array<std::string, kTextureStages> last_textures_;
};

}  // namespace pipeline
