// SPDX-License-Identifier: MIT
// What a frame of one quad writes to the registers of the NV2A.
#pragma once

#include <catch2/catch.hpp>
#include <functional>
#include <optional>

#include "pipeline/emit/emit_nv2a.h"
#include "tests/support/nv2a_agreement.h"
#include "tests/support/nv2a_state.h"
#include "tests/support/small_frame.h"

namespace test_support {

using namespace pipeline;

// What the last draw finds in the registers, by offset.
class Written {
  public:
    explicit Written(const Frame& frame) {
        const LegalFrame legal = {.frame = frame, .notes = {}, .left = {}};
        const Emitted emitted  = emit_nv2a(legal, "f");
        for (const std::string& difference : nv2a_differences(frame, emitted)) FAIL_CHECK(difference);
        run_nv2a(emitted.text, [&](const Nv2aEvent& event) {
            if (event.kind == Nv2aEvent::Draw) registers_ = event.registers;
            if (event.kind == Nv2aEvent::Clear) clears_ = event.registers;
        });
    }
    std::uint32_t operator[](std::uint32_t offset) const { return registers_.at(offset); }
    float real(std::uint32_t offset) const { return registers_.real(offset); }
    bool has(std::uint32_t offset) const { return registers_.is_set(offset); }
    std::uint32_t at_clear(std::uint32_t offset) const { return clears_.at(offset); }

  private:
    Nv2aRegisters registers_, clears_;
};

inline Frame quad_frame(std::optional<TargetFormat> depth = TargetFormat::D24) {
    Frame frame           = small_frame(16, 8, depth);
    frame.arithmetic      = find_profile("xbox")->arithmetic;
    frame.passes[0].draws = {add_quad(frame, 0xffffffff)};
    return frame;
}

inline Written with_state(const std::function<void(PipelineState&)>& change) {
    Frame frame = quad_frame();
    change(frame.passes[0].state);
    return Written(frame);
}

inline DrawTriangles& quad_of(Frame& frame) {
    return std::get<DrawTriangles>(frame.passes[0].draws[0]);
}

// Stage 0 reads a texture of one texel.
inline Written with_stage(const TextureStage& stage, TextureFormat format = TextureFormat::A8R8G8B8,
                          bool second = false) {
    Frame frame             = quad_frame();
    PipelineState& state    = frame.passes[0].state;
    const TextureId texture = add_texture(frame, format, 1, 1, {1, 2, 3, 4});
    frame.textures[0].texels.resize(static_cast<std::size_t>(bytes_per_texel(format)));
    state.texture_factor = {0x80402010};
    state.stages[0]      = second ? kTextureOnly : stage;
    if (second) state.stages[1] = stage;
    quad_of(frame).textures = {bound(texture), bound(texture)};
    return Written(frame);
}

}  // namespace test_support
