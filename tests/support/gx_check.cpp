// SPDX-License-Identifier: MIT
#include "tests/support/gx_check.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>

#include "pipeline/check/memory_map.h"
#include "pipeline/check/needed_pixels.h"
#include "pipeline/execute/fog.h"
#include "pipeline/execute/lighting.h"
#include "pipeline/profile/profile.h"
#include "pipeline/validate/check_pass.h"

namespace test_support {

namespace {

using namespace pipeline;
using Color = std::array<double, 4>;  // red, green, blue, alpha; 0..1

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

double clamp1(double x) {
    return std::clamp(x, 0.0, 1.0);
}
Color unpacked(Argb color) {
    const auto channel = [&](int shift) { return static_cast<double>((color.value >> shift) & 255u) / 255.0; };
    return {channel(16), channel(8), channel(0), channel(24)};
}
std::array<int, 4> bytes_of(Argb color) {
    const auto channel = [&](int shift) { return static_cast<int>((color.value >> shift) & 255u); };
    return {channel(16), channel(8), channel(0), channel(24)};
}

// What flows into the stages of a draw.
struct Inputs {
    Color diffuse{}, specular{};
    std::array<Color, kTextureStages> texels{};
    double fog = 1.0;
};

// The frame's stages in real numbers, by the words of texture_state.h.
class FrameStages {
  public:
    FrameStages(const PipelineState& state, const Inputs& inputs) : state_(state), inputs_(inputs) {}

    Color result(bool is_rectangle, bool has_fog) {
        current_ = inputs_.diffuse;
        for (index_ = 0; index_ < static_cast<std::size_t>(stage_count(state_)); ++index_) {
            const TextureStage& stage = state_.stages[index_];
            Color next{};
            for (std::size_t channel = 0; channel < 4; ++channel) {
                const bool is_color = channel < 3;
                next[channel]       = clamp1(op(is_color ? stage.color_op : stage.alpha_op,
                                          is_color ? stage.color_arg1 : stage.alpha_arg1,
                                          is_color ? stage.color_arg2 : stage.alpha_arg2, channel));
            }
            current_ = next;
        }
        for (std::size_t channel = 0; channel < 3 && !is_rectangle; ++channel) {
            double& value = current_[channel];
            if (state_.lighting.specular_enable) value = clamp1(value + inputs_.specular[channel]);
            if (has_fog) value = inputs_.fog * value + (1.0 - inputs_.fog) * unpacked(state_.fog.color)[channel];
        }
        return current_;
    }

  private:
    Color source(ArgSource of) const {
        switch (of) {
            case ArgSource::Diffuse:
                return inputs_.diffuse;
            case ArgSource::Current:
                return current_;
            case ArgSource::Texture:
                return inputs_.texels[index_];
            case ArgSource::TFactor:
                return unpacked(state_.texture_factor);
            case ArgSource::Specular:
                return {inputs_.specular[0], inputs_.specular[1], inputs_.specular[2], 1.0};
        }
        return {};
    }
    double op(TextureOp op, const TextureArg& arg1, const TextureArg& arg2, std::size_t channel) const {
        const auto value = [&](const TextureArg& arg) { return source(arg.source)[arg.alpha_replicate ? 3 : channel]; };
        const double a = value(arg1), b = value(arg2);
        const auto blend = [&](ArgSource by) { return a * source(by)[3] + b * (1.0 - source(by)[3]); };
        switch (op) {
            case TextureOp::Disable:
                break;
            case TextureOp::SelectArg1:
                return a;
            case TextureOp::SelectArg2:
                return b;
            case TextureOp::Modulate:
                return a * b;
            case TextureOp::Modulate2X:
                return 2.0 * a * b;
            case TextureOp::Modulate4X:
                return 4.0 * a * b;
            case TextureOp::Add:
                return a + b;
            case TextureOp::AddSigned:
                return a + b - 0.5;
            case TextureOp::AddSigned2X:
                return 2.0 * (a + b - 0.5);
            case TextureOp::Subtract:
                return a - b;
            case TextureOp::BlendDiffuseAlpha:
                return blend(ArgSource::Diffuse);
            case TextureOp::BlendTextureAlpha:
                return blend(ArgSource::Texture);
            case TextureOp::BlendFactorAlpha:
                return blend(ArgSource::TFactor);
            case TextureOp::BlendCurrentAlpha:
                return blend(ArgSource::Current);
            case TextureOp::ModulateColorAddAlpha:
                return a * b + source(arg1.source)[3];
        }
        return 0.0;
    }

    const PipelineState& state_;
    const Inputs& inputs_;
    Color current_{};
    std::size_t index_ = 0;
};

// The TEV in real numbers. ras: of the colour channels 0 and 1; texels: of the maps.
Color run_tev(const GxRegisters& r, const std::array<Color, 2>& ras, const std::array<Color, 2>& texels) {
    std::array<Color, 4> registers{};
    for (const auto& [id, bytes] : r.tev_color)
        for (std::size_t i = 0; i < 4; ++i) registers[static_cast<std::size_t>(id)][i] = bytes[i] / 255.0;
    registers[0] = {-5.0, -5.0, -5.0, -5.0};  // nobody may read it before it is written
    for (int index = 0; index < r.tev_stages; ++index) {
        const GxTevStageRead& stage = r.tev[static_cast<std::size_t>(index)];
        const int map = stage.order[1], channel = stage.order[2];
        const Color poison{-7.0, -7.0, -7.0, -7.0};
        const Color texel     = map == 0xff ? poison : texels[static_cast<std::size_t>(map)];
        const Color of_vertex = channel == 4 ? ras[0] : channel == 5 ? ras[1] : poison;
        const auto color_in   = [&](int code, std::size_t i) -> double {
            if (code < 8) return registers[static_cast<std::size_t>(code / 2)][code % 2 == 0 ? i : 3];
            const double values[] = {texel[i], texel[3], of_vertex[i], of_vertex[3], 1.0, 0.5, -9.0, 0.0};
            return values[code - 8];
        };
        const auto alpha_in = [&](int code) -> double {
            if (code < 4) return registers[static_cast<std::size_t>(code)][3];
            const double values[] = {texel[3], of_vertex[3], 1.0, 0.0};
            return values[code - 4];
        };
        const auto unit = [](const std::array<double, 4>& in, const std::array<int, 5>& op) {
            constexpr double kBias[] = {0.0, 0.5, -0.5}, kScale[] = {1.0, 2.0, 4.0, 0.5};
            const double lerp = in[0] * (1.0 - in[2]) + in[1] * in[2];
            const double out  = (in[3] + kBias[op[1]] + (op[0] == 0 ? lerp : -lerp)) * kScale[op[2]];
            return op[3] != 0 ? clamp1(out) : out;
        };
        std::array<double, 4> next{};
        for (std::size_t i = 0; i < 3; ++i) {
            std::array<double, 4> in{};
            for (std::size_t k = 0; k < 4; ++k) in[k] = color_in(stage.color_in[k], i);
            next[i] = unit(in, stage.color_op);
        }
        std::array<double, 4> in{};
        for (std::size_t k = 0; k < 4; ++k) in[k] = alpha_in(stage.alpha_in[k]);
        next[3]      = unit(in, stage.alpha_op);
        Color& color = registers[static_cast<std::size_t>(stage.color_op[4])];
        std::copy(next.begin(), next.begin() + 3, color.begin());
        registers[static_cast<std::size_t>(stage.alpha_op[4])][3] = next[3];
    }
    return registers[0];
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
        const Color ras{0.1, 0.2, 0.3, 0.4};
        CHECK(run_tev(r, {ras, Color{}}, {}) == ras);
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

    // Clip coordinates as the chip has them.
    static std::array<double, 4> clip(const GxRegisters& r, const GxVertexRead& vertex) {
        const std::array<double, 12>& m = r.matrices.at(0);
        std::array<double, 4> eye{0.0, 0.0, 0.0, 1.0}, out{};
        for (std::size_t row = 0; row < 3; ++row)
            eye[row] = m[4 * row] * vertex.position[0] + m[4 * row + 1] * vertex.position[1] +
                       m[4 * row + 2] * vertex.position[2] + m[4 * row + 3];
        const std::array<double, 16>& p = r.projection;
        // The chip keeps six numbers of the matrix; the others must be what it takes them to be.
        if (r.projection_type == 0)
            CHECK((p[1] == 0 && p[3] == 0 && p[4] == 0 && p[7] == 0 && p[14] == -1 && p[15] == 0));
        else
            CHECK((p[1] == 0 && p[2] == 0 && p[4] == 0 && p[6] == 0 && p[14] == 0 && p[15] == 1));
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t k = 0; k < 4; ++k) out[row] += p[4 * row + k] * eye[k];
        return out;
    }
    static double window_depth(const GxRegisters& r, const GxVertexRead& vertex) {
        const std::array<double, 4> c = clip(r, vertex);
        CHECK(r.viewport[4] == 0.0);
        CHECK(r.viewport[5] == 1.0);
        return 1.0 + c[2] / c[3];
    }
    static std::array<double, 2> window(const GxRegisters& r, const GxVertexRead& vertex) {
        const std::array<double, 4> c = clip(r, vertex);
        return {r.viewport[0] + (1.0 + c[0] / c[3]) * r.viewport[2] / 2.0,
                r.viewport[1] + (1.0 - c[1] / c[3]) * r.viewport[3] / 2.0};
    }
    static std::array<double, 4> window_rect(const GxEvent& event) {
        REQUIRE(event.vertices.size() == 4);
        std::array<std::array<double, 2>, 4> corners;
        for (std::size_t i = 0; i < 4; ++i) corners[i] = window(event.registers, event.vertices[i]);
        const auto rounded = [](double x) { return std::round(x * 1024.0) / 1024.0; };
        return {rounded(corners[0][0]), rounded(corners[0][1]), rounded(corners[2][0]), rounded(corners[2][1])};
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
    static void random_texel(std::mt19937& random, const Texture* texture, bool is_white, Color& frame, Color& chip) {
        std::uniform_real_distribution<double> value(0.0, 1.0);
        if (is_white) {
            frame = {1.0, 1.0, 1.0, 1.0}, chip = {-3.0, -3.0, -3.0, -3.0};
        } else if (texture == nullptr || texture->format == TextureFormat::A8R8G8B8) {
            frame = chip = {value(random), value(random), value(random), value(random)};
        } else {
            const double v = value(random);
            chip           = {v, v, v, v};
            frame          = texture->format == TextureFormat::A8 ? Color{0.0, 0.0, 0.0, v} : Color{v, v, v, 1.0};
        }
    }

    void check_stages(const Pass& pass, const GxRegisters& r, const TextureBindings& textures, bool is_rectangle,
                      bool has_vertex_fog) const {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> value(0.0, 1.0);
        for (int round = 0; round < 8; ++round) {
            Inputs inputs;
            std::array<Color, 2> ras{}, texels{};
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
            const Color want = FrameStages(pass.state, inputs).result(is_rectangle, has_vertex_fog);
            const Color got  = run_tev(r, ras, texels);
            for (std::size_t i = 0; i < 4; ++i) CHECK(got[i] == Approx(want[i]).margin(1e-9));
        }
    }

    // Which coordinate the TEV reads a map with; -1 if it does not.
    static int coordinate_of(const GxRegisters& r, int map) {
        for (int i = 0; i < r.tev_stages; ++i)
            if (r.tev[static_cast<std::size_t>(i)].order[1] == map) return r.tev[static_cast<std::size_t>(i)].order[0];
        return -1;
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
        std::size_t differing = 0, texel = 0;
        auto start = static_cast<std::size_t>(read.address);
        for (int level = 0; level < texture.levels; ++level) {
            const auto width             = static_cast<std::size_t>(std::max(1, texture.width >> level)),
                       height            = static_cast<std::size_t>(std::max(1, texture.height >> level));
            const std::size_t tile_width = is_color ? 4 : 8, tile_bytes = is_color ? 64 : 32;
            const std::size_t tiles = (width + tile_width - 1) / tile_width;
            for (std::size_t y = 0; y < height; ++y) {
                for (std::size_t x = 0; x < width; ++x, ++texel) {
                    const std::size_t tile = start + (y / 4 * tiles + x / tile_width) * tile_bytes;
                    const std::size_t in   = y % 4 * tile_width + x % tile_width;
                    if (!is_color) {
                        differing += data_.at(tile + in) != texture.texels[texel];
                        continue;
                    }
                    const std::uint8_t* bgra = &texture.texels[4 * texel];
                    differing += data_.at(tile + 2 * in) != bgra[3] || data_.at(tile + 2 * in + 1) != bgra[2] ||
                                 data_.at(tile + 32 + 2 * in) != bgra[1] || data_.at(tile + 32 + 2 * in + 1) != bgra[0];
                }
            }
            start += tiles * ((height + 3) / 4) * tile_bytes;
        }
        CHECK(differing == 0);
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

    // s, t, q
    static std::array<double, 3> generated(const GxRegisters& r, int coordinate, const GxVertexRead& vertex) {
        REQUIRE(coordinate < r.texgens);
        const std::array<int, 3>& how = r.texgen.at(coordinate);
        if (how[0] == 1) {  // 2x4, of which the identity is all that is used
            CHECK(how[2] == 60);
            const std::array<double, 2>& st = vertex.tex.at(static_cast<std::size_t>(how[1] - 4));
            return {st[0], st[1], 1.0};
        }
        CHECK(how[1] == 0);  // positions
        const std::array<double, 12>& m = r.matrices.at(how[2]);
        std::array<double, 3> out{};
        for (std::size_t row = 0; row < 3; ++row)
            out[row] = m[4 * row] * vertex.position[0] + m[4 * row + 1] * vertex.position[1] +
                       m[4 * row + 2] * vertex.position[2] + m[4 * row + 3];
        return out;
    }

    // A channel that gives the vertex's own colour, and alpha.
    static void check_channel(const GxRegisters& r, int channel) {
        CHECK(r.channels > channel);
        for (const int half : {channel, channel + 2}) {
            CHECK(r.channel.at(half)[0] == 0);
            CHECK(r.channel.at(half)[2] == 1);
        }
    }

    // What the chip's lights give, by the formula of hwtests' lighting.cpp.
    static std::array<int, 4> lit(const GxRegisters& r, const GxVertexRead& vertex) {
        const std::array<int, 6>& control = r.channel.at(0);
        const auto transformed = [&](const std::array<double, 12>& m, const std::array<double, 3>& v, double w) {
            std::array<double, 3> out{};
            for (std::size_t row = 0; row < 3; ++row)
                out[row] = m[4 * row] * v[0] + m[4 * row + 1] * v[1] + m[4 * row + 2] * v[2] + m[4 * row + 3] * w;
            return out;
        };
        const auto dot = [](const auto& a, const auto& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
        const std::array<double, 3> eye    = transformed(r.matrices.at(0), vertex.position, 1.0),
                                    normal = transformed(r.matrices.at(1000), vertex.normal, 0.0);
        CHECK(control[1] == 0);
        CHECK(control[4] == 2);
        CHECK(control[5] == 1);
        std::array<double, 3> sum{};
        for (std::size_t i = 0; i < 3; ++i) sum[i] = r.ambient.at(4)[i];
        for (const auto& [bit, light] : r.lights) {
            if ((control[3] & bit) == 0) continue;
            std::array<double, 3> path{};
            for (std::size_t i = 0; i < 3; ++i) path[i] = light.position[i] - eye[i];
            const double d = std::sqrt(dot(path, path));
            CHECK(light.a == std::array<double, 3>{1.0, 0.0, 0.0});
            const double share = std::max(0.0, dot(normal, path) / d / std::sqrt(dot(normal, normal))) /
                                 (light.k[0] + light.k[1] * d + light.k[2] * d * d);
            for (std::size_t i = 0; i < 3; ++i) sum[i] += share * light.color[i];
        }
        std::array<int, 4> out{};
        for (std::size_t i = 0; i < 3; ++i) {
            const int l = static_cast<int>(std::clamp(sum[i], 0.0, 255.0));
            const int m = control[2] == 1 ? vertex.color0[i] : r.material.at(4)[i];
            out[i]      = m * (l + (l >> 7)) >> 8;
        }
        out[3] = r.channel.at(2)[2] == 1 ? vertex.color0[3] : r.material.at(4)[3];
        return out;
    }

    struct Lit {
        std::array<int, 4> first{}, second{};
    };
    Lit frame_colors(const Pass& pass, const CameraLighting& lighting, const Vec3& camera, const Vertex& vertex) const {
        const VertexColors colors = light_vertex(lighting, vertex, camera);
        const auto byte           = [](double c) { return static_cast<int>(clamp1(c) * 255.0 + 0.5); };
        const auto bytes          = [&](double x, double y, double z, double w) {
            return std::array<int, 4>{byte(x), byte(y), byte(z), byte(w)};
        };
        return {bytes(colors.diffuse.r, colors.diffuse.g, colors.diffuse.b, colors.diffuse.a),
                bytes(colors.specular.r, colors.specular.g, colors.specular.b, fog_factor(pass.state.fog, camera))};
    }

    // The share that the chip's own fog leaves.
    static double chip_fog(const GxRegisters& r, double depth) {
        const auto type    = static_cast<int>(r.fog[0]);
        const double start = r.fog[1], end = r.fog[2], near = r.fog[3], far = r.fog[4];
        const double eye = type >= 8 ? near + depth * (far - near) : far * near / (far - depth * (far - near));
        const double f   = clamp1((eye - start) / (end - start));
        switch (type & 7) {
            case 2:
                return 1.0 - f;
            case 4:
                return std::exp2(-8.0 * f);
            case 5:
                return std::exp2(-8.0 * f * f);
        }
        return 1.0;
    }

    void check_triangles(const Pass& pass, const DrawTriangles& draw) {
        if (draw.index_count == 0) return;
        const Camera& camera          = frame_.cameras[at(pass.camera)];
        const glm::dmat4 to_camera    = glm::dmat4(camera.view) * glm::dmat4(draw.world);
        const glm::dmat4 to_clip      = glm::dmat4(camera.projection) * to_camera;
        const CameraLighting lighting = prepare_lighting(pass.state.lighting, camera.view, draw.world);
        const bool has_fog            = pass.state.fog.mode != FogMode::None;
        std::size_t done              = 0;
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
            const bool is_chip_lit = r.channel.at(0)[0] == 1;
            if (!is_chip_lit) check_channel(r, 0);
            if (r.channels > 1) check_channel(r, 1);
            for (std::size_t i = 0; i < event.vertices.size(); i += step_) {
                const Vertex& vertex     = frame_.vertices[frame_.indices[draw.first_index + done + i]];
                const GxVertexRead& read = event.vertices[i];
                const glm::dvec4 want    = to_clip * glm::dvec4(glm::dvec3(vertex.position), 1.0);
                check_clip(want, clip(r, read));
                const Vec3 in_camera(to_camera * glm::dvec4(glm::dvec3(vertex.position), 1.0));
                const Lit colors = frame_colors(pass, lighting, in_camera, vertex);
                if (is_chip_lit) {
                    const std::array<int, 4> by_chip = lit(r, read);
                    for (std::size_t k = 0; k < 4; ++k) CHECK(std::abs(by_chip[k] - colors.first[k]) <= 2);
                } else {
                    CHECK(read.color0 == colors.first);
                }
                if (r.channels > 1 && !std::equal(read.color1.begin(), read.color1.begin() + 3, colors.second.begin()))
                    CHECK(read.color1 == colors.second);
                if (has_vertex_fog) CHECK(read.color1[3] == colors.second[3]);
                const double depth = want.z / want.w;
                if (chip_has_fog && want.w > 0.0 && depth > 0.0 && depth < 1.0)
                    CHECK(chip_fog(r, depth) ==
                          Approx(static_cast<double>(fog_factor(pass.state.fog, in_camera))).margin(0.006));
                check_coordinates(pass, r, vertex, read, in_camera);
            }
            if (chip_has_fog)
                for (std::size_t k = 0; k < 3; ++k) CHECK(r.fog[5 + k] == bytes_of(pass.state.fog.color)[k]);
            done += event.vertices.size();
        }
    }

    void check_coordinates(const Pass& pass, const GxRegisters& r, const Vertex& vertex, const GxVertexRead& read,
                           const Vec3& in_camera) const {
        for (std::size_t i = 0; i < kTextureStages; ++i) {
            const int coordinate = coordinate_of(r, static_cast<int>(i));
            if (coordinate < 0) continue;
            const TextureStage& stage      = pass.state.stages[i];
            const std::array<double, 3> st = generated(r, coordinate, read);
            if (stage.coords == CoordSource::CameraPosition) {
                const glm::dvec4 want = glm::dmat4(stage.transform) * glm::dvec4(glm::dvec3(in_camera), 1.0);
                CHECK(st[0] / st[2] == Approx(want.x / want.z).margin(1e-4));
                CHECK(st[1] / st[2] == Approx(want.y / want.z).margin(1e-4));
            } else {
                const Vec2 want = stage.coords == CoordSource::Vertex0 ? vertex.uv0 : vertex.uv1;
                CHECK(st == std::array<double, 3>{static_cast<double>(want.x), static_cast<double>(want.y), 1.0});
            }
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

    // Homogeneous: the same up to a positive factor, with z' = z - w.
    static void check_clip(const glm::dvec4& want, const std::array<double, 4>& got) {
        const double scale = std::max({std::abs(want.x), std::abs(want.y), std::abs(want.w), 1e-3});
        if (std::abs(want.w) < 1e-4 * scale) return;
        const double factor = got[3] / want.w, margin = 2e-5 * scale;
        CHECK(factor > 0.0);
        CHECK(got[0] / factor == Approx(want.x).margin(margin));
        CHECK(got[1] / factor == Approx(want.y).margin(margin));
        CHECK(got[2] / factor == Approx(want.z - want.w).margin(margin));
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
