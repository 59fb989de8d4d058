// SPDX-License-Identifier: MIT
// A state that a special program draws, with textures, numbers and a format chosen at random.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "raster/alpha_quads.h"
#include "raster/fill_plan.h"
#include "tests/raster/special_parts.h"
#include "tests/support/random.h"

namespace special_state {

class SpecialState {
  public:
    SpecialState(const raster::FillProgram& program, std::uint32_t seed) : program_(program) {
        test_support::Random random(seed);
        set_numbers(random);
        state.floor_colors    = program.floor_colors;
        state.stage_count     = program.stage_count;
        state.stages          = program.stages;
        state.combine_rule    = program.combine_rule;
        state.add_specular    = program.add_specular;
        state.fog             = program.fog;
        state.fog_rule        = program.fog_rule;
        state.alpha_func      = program.alpha_func;
        state.alpha_fail      = program.alpha_fail;
        state.dest_alpha_test = program.dest_alpha_test;
        state.depth_func      = program.depth_func;
        state.depth_write     = program.depth_write;
        set_blend(random);
        for (int i = 0; i < raster::kMaxTextures; ++i) set_texture(i, random);
    }
    SpecialState(const SpecialState&)            = delete;
    SpecialState& operator=(const SpecialState&) = delete;

    raster::FillPlan plan(bool general) const {
        return raster::plan_fill(state, has_color(), format, depth_bits(), general);
    }
    bool has_color() const { return program_.uses_color_target() || !program_.tests_first(); }
    int depth_bits() const { return program_.depth_bits == 0 ? 24 : program_.depth_bits; }

    raster::FillState state;
    raster::ColorFormat format;

  private:
    void set_numbers(test_support::Random& random) {
        state.constant        = random.bits();
        state.fog_color       = random.bits();
        state.alpha_reference = static_cast<std::uint8_t>(random.from(0, 63));  // most alphas pass GREATER
    }
    void set_blend(test_support::Random& random) {
        state.blend.rule            = program_.blend;
        state.blend.source          = program_.source;
        state.blend.dest            = program_.dest;
        state.blend.shift7          = program_.shift7;
        state.blend.shift7.constant = static_cast<std::uint8_t>(random.from(0, 255));
        state.blend.dither          = program_.dither;
        for (std::int8_t& offset : state.blend.dither_matrix) offset = static_cast<std::int8_t>(random.from(-4, 3));
        switch (program_.writes) {
            case raster::Writes::Nothing:
                state.blend.write_mask = 0;
                break;
            case raster::Writes::All:
                state.blend.write_mask = 0xffffffff;
                break;
            case raster::Writes::Alpha:
                state.blend.write_mask = 0xff000000;
                break;
            case raster::Writes::Some:
                state.blend.write_mask = 0x00ff00ff;
                break;
        }
        if (!program_.whole_bytes) format = {.red = 5, .green = 6, .blue = 5, .alpha = 0};
    }
    void set_texture(int i, test_support::Random& random) {
        const raster::TextureProgram& texture = program_.textures[i];
        raster::Sampler& sampler              = state.samplers[i];
        if (!texture.has_texels) return;
        sampler.linear    = texture.linear;
        sampler.rule      = texture.rule;
        sampler.mip       = texture.mip;
        sampler.address_u = texture.address_u;
        sampler.address_v = texture.address_v;
        for (int size = random.one_of({16, 32, 64}); size > 0; size = texture.has_mips ? size / 2 : 0) {
            std::vector<std::uint32_t>& texels = texels_[i].emplace_back(static_cast<std::size_t>(size * size));
            for (std::uint32_t& texel : texels) texel = random.bits() & (texture.alpha_quads ? 0xff000000 : 0xffffffff);
            sampler.levels.push_back({texels.data(), size, size, size});
            if (!texture.alpha_quads) continue;
            std::vector<std::uint8_t> alphas;
            for (const std::uint32_t texel : texels) alphas.push_back(static_cast<std::uint8_t>(texel >> 24));
            std::vector<std::uint32_t>& quads = quads_[i].emplace_back(raster::alpha_quad_count(size, size));
            raster::pack_alpha_quads(alphas.data(), size, size, quads.data());
            sampler.alpha_quads.push_back({quads.data(), size, size, size + 1});
        }
    }

    const raster::FillProgram& program_;
    std::array<std::vector<std::vector<std::uint32_t>>, raster::kMaxTextures> texels_, quads_;
};

}  // namespace special_state
