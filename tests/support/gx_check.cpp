// SPDX-License-Identifier: MIT
#include "tests/support/gx_check.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>

#include "pipeline/check/memory_map.h"
#include "pipeline/check/needed_pixels.h"
#include "pipeline/profile/profile.h"
#include "pipeline/validate/check_pass.h"
#include "tests/support/gx_shading.h"
#include "tests/support/gx_vertex_check.h"

namespace test_support {

namespace {

using namespace pipeline;

// libogc's values by hand, in the order of the frame's enumerators; -1: the chip has none.
constexpr int kCompare[]       = {7, 3, 1, 6, 4, 2, 5, 0};
constexpr int kSourceFactor[]  = {0, 1, -1, -1, 2, 3, 4, 5, 6, 7};
constexpr int kDestFactor[]    = {0, 1, 2, 3, -1, -1, 4, 5, 6, 7};
constexpr int kCull[]          = {0, 1, 2};
constexpr int kWrap[]          = {1, 0, 2};
constexpr int kMinFilter[2][3] = {{0, 2, 4}, {1, 3, 5}};  // by filter, by mip filter
template <class Enum, std::size_t count>
int value_of(const int (&table)[count], Enum of) {
    return table[static_cast<std::size_t>(of)];
}

std::array<int, 4> bytes_of(Argb color) {
    const auto channel = [&](int shift) { return static_cast<int>((color.value >> shift) & 255u); };
    return {channel(16), channel(8), channel(0), channel(24)};
}

struct Places {
    std::vector<int> x, y;
};
Places places_of(const Frame& frame) {
    const MemoryMap map = lay_out(frame, *find_profile("gamecube"));
    Places places;
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        // Blocks are listed by region: the frame buffer's first.
        const std::string start = "target " + std::to_string(i) + ' ';
        const auto block        = std::find_if(map.blocks.begin(), map.blocks.end(),
                                               [&](const MemoryBlock& b) { return b.what.rfind(start, 0) == 0; });
        REQUIRE(block != map.blocks.end());
        const auto pixel = static_cast<int>(block->address / 3 % (640 * 528));
        places.x.push_back(pixel % 640);
        places.y.push_back(pixel / 640);
    }
    return places;
}

class Checker {
  public:
    Checker(const Frame& frame, const std::vector<GxEvent>& events, const std::vector<std::uint8_t>& data,
            std::size_t step)
        : frame_(frame), events_(events), data_(data), step_(step), places_(places_of(frame)) {
        for (std::size_t i = 0; i < frame.targets.size(); ++i)
            zeros_.push_back(pixels_used_as_zeros(frame, {static_cast<std::int32_t>(i)}));
    }

    void run() {
        for (index_ = 0; index_ < frame_.passes.size(); ++index_) {
            INFO("pass " << index_ << " '" << frame_.passes[index_].label << '\'');
            const Pass& pass = frame_.passes[index_];
            check_clears(pass);
            for (const Draw& draw : pass.draws) {
                if (const auto* triangles = std::get_if<DrawTriangles>(&draw))
                    check_triangles(pass, *triangles);
                else if (const auto* rectangle = std::get_if<DrawRectangle>(&draw))
                    check_rectangle(pass, *rectangle);
                else
                    check_copy(pass, std::get<CopyRectangle>(draw));
            }
        }
        if (frame_.targets[at(frame_.output)].format == TargetFormat::A8R8G8B8) next();  // drawn for the display
        const GxEvent& display = next();
        CHECK(display.kind == GxEvent::Kind::Display);
        CHECK(next_ == events_.size());
    }

  private:
    template <class Of>
    static std::size_t at(Id<Of> id) {
        return static_cast<std::size_t>(id.index);
    }
    const GxEvent& next() {
        REQUIRE(next_ < events_.size());
        return events_[next_++];
    }

    PixelRect part_of(const Pass& pass) const {
        const Target& target = frame_.targets[at(pass.color ? pass.color : pass.depth)];
        const PixelRect all{0, 0, target.width, target.height};
        const PixelRect v = pass.state.viewport == PixelRect{} ? all : pass.state.viewport;
        const PixelRect s = pass.state.scissor == PixelRect{} ? all : pass.state.scissor;
        return {std::max(v.x0, s.x0), std::max(v.y0, s.y0), std::min(v.x1, s.x1), std::min(v.y1, s.y1)};
    }

    void check_scissor(const GxEvent& event, TargetId target, const PixelRect& part) const {
        const std::array<int, 4> want{places_.x[at(target)] + part.x0, places_.y[at(target)] + part.y0,
                                      part.x1 - part.x0, part.y1 - part.y0};
        CHECK(event.registers.scissor == want);
    }

    void check_wipe(TargetId color, TargetId depth, const PixelRect& part, Argb argb, float z) {
        const GxEvent& event = next();
        const GxRegisters& r = event.registers;
        CHECK(event.primitive == 0x80);
        check_scissor(event, color ? color : depth, part);
        CHECK(r.blend[0] == 0);
        CHECK(r.color_update == (color ? 1 : 0));
        CHECK(r.alpha_update == (color ? 1 : 0));
        CHECK(r.z == (depth ? std::array<int, 3>{1, 7, 1} : std::array<int, 3>{0, 7, 0}));
        CHECK(r.alpha_compare[0] == 7);
        CHECK(r.fog[0] == 0.0);
        CHECK(r.dither == 0);
        for (const GxVertexRead& vertex : event.vertices) {
            if (color) CHECK(vertex.color0 == bytes_of(argb));
            if (depth) CHECK(window_depth(r, vertex) == Approx(static_cast<double>(z)));
        }
        CHECK(window_rect(event) == std::array<double, 4>{static_cast<double>(r.scissor[0]),
                                                          static_cast<double>(r.scissor[1]),
                                                          static_cast<double>(r.scissor[0] + r.scissor[2]),
                                                          static_cast<double>(r.scissor[1] + r.scissor[3])});
        const RealColor ras{0.1, 0.2, 0.3, 0.4};
        CHECK(run_tev(r, {ras, RealColor{}}, {}) == ras);
    }

    // Those together that lie at one place.
    void check_wipes(const Pass& pass, const PixelRect& part, bool color, bool depth, Argb argb, float z) {
        const bool both = color && depth && places_.x[at(pass.color)] == places_.x[at(pass.depth)] &&
                          places_.y[at(pass.color)] == places_.y[at(pass.depth)];
        if (both) return check_wipe(pass.color, pass.depth, part, argb, z);
        if (color) check_wipe(pass.color, {}, part, argb, z);
        if (depth) check_wipe({}, pass.depth, part, argb, z);
    }

    bool is_in_buffer(TargetId id) const { return id && frame_.targets[at(id)].format != TargetFormat::A8R8G8B8; }

    // Where a target begins so with this pass.
    void check_zeros(TargetId color, TargetId depth) {
        const TargetId id = color ? color : depth;
        if (!is_in_buffer(id)) return;
        for (const PixelRect& part : zeros_[at(id)][index_].parts()) check_wipe(color, depth, part, Argb{0}, 0.0f);
    }

    void check_clears(const Pass& pass) {
        if (!is_in_buffer(pass.color ? pass.color : pass.depth)) return;
        check_zeros(pass.color, {});
        check_zeros({}, pass.depth);
        const PixelRect part = part_of(pass);
        if (pass.clear.color || pass.clear.depth)
            check_wipes(pass, part, pass.clear.color.has_value(), pass.clear.depth.has_value(),
                        pass.clear.color.value_or(Argb{0}), pass.clear.depth.value_or(0.0f));
    }

    void check_copy(const Pass& pass, const CopyRectangle& copy) {
        check_zeros(copy.source, {});
        const GxEvent& event = next();
        REQUIRE(event.kind == GxEvent::Kind::Copy);
        const Target &from = frame_.targets[at(copy.source)], &to = frame_.targets[at(pass.color)];
        CHECK(event.registers.pixel_format == (from.format == TargetFormat::R6G6B6A6 ? 1 : 0));
        CHECK(event.copy_from == std::array<int, 4>{places_.x[at(copy.source)] + copy.from.x0,
                                                    places_.y[at(copy.source)] + copy.from.y0,
                                                    copy.from.x1 - copy.from.x0, copy.from.y1 - copy.from.y0});
        CHECK(event.copy_to == std::array<int, 4>{to.width, to.height, 6, copy.halve ? 1 : 0});
        const int tiles_in_row     = (to.width + 3) / 4;
        const long long start      = event.address - 64ll * (copy.y / 4 * tiles_in_row + copy.x / 4);
        const auto [known, is_new] = addresses_.try_emplace(pass.color.index, start);
        CHECK(known->second == start);
    }

    void check_state(const Pass& pass, const GxEvent& event, bool is_rectangle) const {
        const GxRegisters& r       = event.registers;
        const PipelineState& state = pass.state;
        REQUIRE(event.kind == GxEvent::Kind::Primitive);
        check_scissor(event, pass.color ? pass.color : pass.depth, part_of(pass));
        if (pass.color)
            CHECK(r.pixel_format == (frame_.targets[at(pass.color)].format == TargetFormat::R6G6B6A6 ? 1 : 0));
        const bool is_blended = state.blend != kReplace;
        CHECK(r.blend[0] == (is_blended ? 1 : 0));
        if (is_blended) {
            CHECK(r.blend[1] == value_of(kSourceFactor, state.blend.source));
            CHECK(r.blend[2] == value_of(kDestFactor, state.blend.dest));
        }
        CHECK(r.color_update == (pass.color && state.color_mask.red ? 1 : 0));
        CHECK(r.alpha_update == (pass.color && state.color_mask.alpha ? 1 : 0));
        CHECK(r.dst_alpha == 0);
        CHECK(r.indirect_stages == 0);
        CHECK(r.dither == (state.dither.mode == DitherMode::None ? 0 : 1));
        // The chip does not write depth while it does not test it.
        const bool tests = pass.depth && (state.depth.func != CompareFunc::Always || state.depth.write);
        CHECK(r.z[0] == (tests ? 1 : 0));
        if (tests) CHECK(r.z[1] == value_of(kCompare, state.depth.func));
        if (tests) CHECK(r.z[2] == (state.depth.write ? 1 : 0));
        CHECK(r.alpha_compare ==
              std::array<int, 5>{value_of(kCompare, state.alpha_test.func), state.alpha_test.reference, 0, 7, 0});
        if (state.alpha_test.func != CompareFunc::Always) CHECK(r.z_before_texture == 0);
        CHECK(r.cull == (is_rectangle ? 0 : value_of(kCull, state.cull)));
    }

    // The frame's texel and the chip's.
    static void random_texel(std::mt19937& random, const Texture* texture, bool is_white, RealColor& frame,
                             RealColor& chip) {
        std::uniform_real_distribution<double> value(0.0, 1.0);
        if (is_white) {
            frame = {1.0, 1.0, 1.0, 1.0}, chip = {-3.0, -3.0, -3.0, -3.0};
        } else if (texture == nullptr || texture->format == TextureFormat::A8R8G8B8) {
            frame = chip = {value(random), value(random), value(random), value(random)};
        } else {
            const double v = value(random);
            chip           = {v, v, v, v};
            frame = texture->format == TextureFormat::A8 ? RealColor{0.0, 0.0, 0.0, v} : RealColor{v, v, v, 1.0};
        }
    }

    void check_stages(const Pass& pass, const GxRegisters& r, const TextureBindings& textures, bool is_rectangle,
                      bool has_vertex_fog) const {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> value(0.0, 1.0);
        for (int round = 0; round < 8; ++round) {
            StageColors inputs;
            std::array<RealColor, 2> ras{}, texels{};
            inputs.fog = value(random);
            for (double& channel : inputs.diffuse) channel = value(random);
            for (double& channel : inputs.specular) channel = is_rectangle ? 0.0 : value(random);
            for (std::size_t i = 0; i < textures.size(); ++i)
                random_texel(random, find_texture(frame_, textures[i].texture),
                             !textures[i].texture && !textures[i].target, inputs.texels[i], texels[i]);
            ras[0]    = inputs.diffuse;
            ras[1]    = inputs.specular;
            ras[1][3] = has_vertex_fog ? inputs.fog : -4.0;
            if (is_rectangle) ras[1] = {-4.0, -4.0, -4.0, -4.0};
            const RealColor want = shaded(pass.state, inputs, has_vertex_fog);
            const RealColor got  = run_tev(r, ras, texels);
            for (std::size_t i = 0; i < 4; ++i) CHECK(got[i] == Approx(want[i]).margin(1e-9));
        }
    }

    void check_textures(const Pass& pass, const GxEvent& event, const TextureBindings& textures) {
        for (std::size_t i = 0; i < textures.size(); ++i) {
            if (coordinate_of(event.registers, static_cast<int>(i)) < 0) continue;
            const TextureStage& stage = pass.state.stages[i];
            const GxTextureRead& read = event.registers.textures.at(static_cast<int>(i));
            const Texture* texture    = find_texture(frame_, textures[i].texture);
            const Target* target      = find_target(frame_, textures[i].target);
            CHECK(read.wrap_s == value_of(kWrap, stage.address_u));
            CHECK(read.wrap_t == value_of(kWrap, stage.address_v));
            const bool has_mips = texture != nullptr && texture->levels > 1 && stage.mip_filter != MipFilter::None;
            CHECK(read.mipmap == (has_mips ? 1 : 0));
            CHECK(read.min_lod == 0);
            CHECK(read.max_lod == (has_mips ? texture->levels - 1 : 0));
            CHECK(read.min_filter ==
                  kMinFilter[stage.filter == TextureFilter::Linear][has_mips ? static_cast<int>(stage.mip_filter) : 0]);
            CHECK(read.mag_filter == (stage.filter == TextureFilter::Linear ? 1 : 0));
            CHECK(read.width == (texture != nullptr ? texture->width : target->width));
            CHECK(read.height == (texture != nullptr ? texture->height : target->height));
            if (texture != nullptr) {
                check_texels(*texture, textures[i].texture.index, read);
            } else {
                CHECK(read.format == 6);
                const auto [known, is_new] = addresses_.try_emplace(textures[i].target.index, read.address);
                CHECK(known->second == read.address);
                if (!is_new) CHECK(event.is_synced);
            }
        }
    }

    // Once for each texture.
    void check_texels(const Texture& texture, int index, const GxTextureRead& read) {
        const bool is_color = texture.format == TextureFormat::A8R8G8B8;
        CHECK(read.format == (is_color ? 6 : 1));
        if (!checked_.insert(index).second) return;
        CHECK(differing_texels(texture, data_, static_cast<std::size_t>(read.address)) == 0);
    }

    void check_rectangle(const Pass& pass, const DrawRectangle& draw) {
        const GxEvent& event = next();
        check_state(pass, event, true);
        check_stages(pass, event.registers, draw.textures, true, false);
        check_textures(pass, event, draw.textures);
        CHECK(event.registers.fog[0] == 0.0);
        const TargetId target = pass.color ? pass.color : pass.depth;
        const double x = places_.x[at(target)], y = places_.y[at(target)];
        const std::array<double, 4> rect = window_rect(event);
        CHECK(rect[0] == Approx(x + static_cast<double>(draw.x0)).margin(1e-3));
        CHECK(rect[1] == Approx(y + static_cast<double>(draw.y0)).margin(1e-3));
        CHECK(rect[2] == Approx(x + static_cast<double>(draw.x1)).margin(1e-3));
        CHECK(rect[3] == Approx(y + static_cast<double>(draw.y1)).margin(1e-3));
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const GxVertexRead& vertex = event.vertices[corner];
            CHECK(window_depth(event.registers, vertex) == Approx(static_cast<double>(draw.depth)).margin(1e-6));
            CHECK(vertex.color0 == bytes_of(draw.color));
            for (std::size_t i = 0; i < kTextureStages; ++i) {
                const int coordinate = coordinate_of(event.registers, static_cast<int>(i));
                if (coordinate < 0) continue;
                const UvRect& uv = draw.uv[i];
                const bool right = corner == 1 || corner == 2, bottom = corner >= 2;
                const std::array<double, 3> st = generated(event.registers, coordinate, vertex);
                CHECK(st[0] == static_cast<double>(right ? uv.u1 : uv.u0));
                CHECK(st[1] == static_cast<double>(bottom ? uv.v1 : uv.v0));
            }
        }
        check_channel(event.registers, 0);
    }

    // A channel that gives the vertex's own colour, and alpha.
    static void check_channel(const GxRegisters& r, int channel) {
        CHECK(r.channels > channel);
        for (const int half : {channel, channel + 2}) {
            CHECK(r.channel.at(half)[0] == 0);
            CHECK(r.channel.at(half)[2] == 1);
        }
    }

    void check_triangles(const Pass& pass, const DrawTriangles& draw) {
        if (draw.index_count == 0) return;
        const GxVertexCheck check(frame_, pass, draw);
        const bool has_fog = pass.state.fog.mode != FogMode::None;
        std::size_t done   = 0;
        while (done < draw.index_count) {
            const GxEvent& event = next();
            const GxRegisters& r = event.registers;
            REQUIRE(event.primitive == 0x90);
            REQUIRE(done + event.vertices.size() <= draw.index_count);
            const bool chip_has_fog = r.fog[0] != 0.0, has_vertex_fog = has_fog && !chip_has_fog;
            if (pass.state.fog.range) CHECK_FALSE(chip_has_fog);
            if (!has_fog) CHECK_FALSE(chip_has_fog);
            check_state(pass, event, false);
            check_stages(pass, r, draw.textures, false, has_vertex_fog);
            check_textures(pass, event, draw.textures);
            check_viewport(pass, r);
            if (r.channel.at(0)[0] != 1) check_channel(r, 0);
            if (r.channels > 1) check_channel(r, 1);
            for (std::size_t i = 0; i < event.vertices.size(); i += step_) {
                const Vertex& vertex     = frame_.vertices[frame_.indices[draw.first_index + done + i]];
                const GxVertexRead& read = event.vertices[i];
                check(r, vertex, read, has_vertex_fog);
            }
            if (chip_has_fog)
                for (std::size_t k = 0; k < 3; ++k) CHECK(r.fog[5 + k] == bytes_of(pass.state.fog.color)[k]);
            done += event.vertices.size();
        }
    }

    void check_viewport(const Pass& pass, const GxRegisters& r) const {
        const TargetId id    = pass.color ? pass.color : pass.depth;
        const Target& target = frame_.targets[at(id)];
        const PixelRect v =
            pass.state.viewport == PixelRect{} ? PixelRect{0, 0, target.width, target.height} : pass.state.viewport;
        CHECK(r.viewport == std::array<double, 6>{static_cast<double>(places_.x[at(id)] + v.x0),
                                                  static_cast<double>(places_.y[at(id)] + v.y0),
                                                  static_cast<double>(v.x1 - v.x0), static_cast<double>(v.y1 - v.y0),
                                                  0.0, 1.0});
    }

    const Frame& frame_;
    const std::vector<GxEvent>& events_;
    const std::vector<std::uint8_t>& data_;
    std::size_t step_, next_ = 0, index_ = 0;
    Places places_;
    std::vector<std::vector<PixelRegion>> zeros_;  // [target][pass]
    std::map<int, long long> addresses_;           // of copied targets
    std::set<int> checked_;
};

}  // namespace

void check_gx(const Frame& frame, const std::vector<GxEvent>& events, const std::vector<std::uint8_t>& data,
              std::size_t step) {
    Checker(frame, events, data, step).run();
}

}  // namespace test_support
