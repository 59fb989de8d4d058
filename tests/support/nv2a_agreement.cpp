// SPDX-License-Identifier: MIT
#include "tests/support/nv2a_agreement.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "pipeline/check/memory_map.h"
#include "pipeline/check/target_use.h"
#include "pipeline/execute/fog.h"
#include "pipeline/execute/lighting.h"
#include "pipeline/frame/text_values.h"
#include "pipeline/profile/profile.h"
#include "tests/support/nv2a_state.h"
#include "tests/support/random.h"

namespace test_support {

using namespace pipeline;

namespace {

using Color = std::array<double, 4>;

double clamp01(double x) {
    return std::min(std::max(x, 0.0), 1.0);
}
Real4 real4(const Color& c) {
    return {c[0], c[1], c[2], c[3]};
}
Color color_of(Argb argb) {
    return {(argb.value >> 16 & 255) / 255.0, (argb.value >> 8 & 255) / 255.0, (argb.value & 255) / 255.0,
            (argb.value >> 24) / 255.0};
}

double combined(TextureOp op, double a, double b, double blend, double a_alpha) {
    switch (op) {
        case TextureOp::Disable:
            return 0.0;
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
        case TextureOp::BlendTextureAlpha:
        case TextureOp::BlendFactorAlpha:
        case TextureOp::BlendCurrentAlpha:
            return a * blend + b * (1.0 - blend);
        case TextureOp::ModulateColorAddAlpha:
            return a * b + a_alpha;
    }
    return 0.0;
}

}  // namespace

std::array<double, 4> shaded(const PipelineState& state, const StageColors& colors, bool has_fog) {
    Color current      = colors.diffuse;
    const Color factor = color_of(state.texture_factor);
    for (std::size_t i = 0; i < kTextureStages && state.stages[i].color_op != TextureOp::Disable; ++i) {
        const TextureStage& stage = state.stages[i];
        const auto source         = [&](ArgSource from) -> Color {
            switch (from) {
                case ArgSource::Diffuse:
                    return colors.diffuse;
                case ArgSource::Current:
                    return current;
                case ArgSource::Texture:
                    return colors.texels[i];
                case ArgSource::TFactor:
                    return factor;
                case ArgSource::Specular:
                    return {colors.specular[0], colors.specular[1], colors.specular[2], 1.0};
            }
            return {};
        };
        const auto value = [&](const TextureArg& arg, std::size_t channel) {
            const double x = source(arg.source)[arg.alpha_replicate ? 3 : channel];
            return arg.complement ? 1.0 - x : x;
        };
        Color next{};
        for (std::size_t channel = 0; channel < 4; ++channel) {
            const bool of_alpha    = channel == 3;
            const TextureOp op     = of_alpha ? stage.alpha_op : stage.color_op;
            const TextureArg& arg1 = of_alpha ? stage.alpha_arg1 : stage.color_arg1;
            const TextureArg& arg2 = of_alpha ? stage.alpha_arg2 : stage.color_arg2;
            const ArgSource by     = op == TextureOp::BlendDiffuseAlpha   ? ArgSource::Diffuse
                                     : op == TextureOp::BlendTextureAlpha ? ArgSource::Texture
                                     : op == TextureOp::BlendFactorAlpha  ? ArgSource::TFactor
                                                                          : ArgSource::Current;
            next[channel] =
                clamp01(combined(op, value(arg1, channel), value(arg2, channel), source(by)[3], value(arg1, 3)));
        }
        current = next;
    }
    const Color fog = color_of(state.fog.color);
    for (std::size_t i = 0; i < 3; ++i) {
        if (state.lighting.specular_enable) current[i] = clamp01(current[i] + colors.specular[i]);
        if (has_fog) current[i] = colors.fog * current[i] + (1.0 - colors.fog) * fog[i];
    }
    return current;
}

namespace {

constexpr std::uint32_t kFactors[]   = {0, 1, 0x300, 0x301, 0x306, 0x307, 0x302, 0x303, 0x304, 0x305};
constexpr std::uint32_t kCompares[]  = {0x207, 0x203, 0x201, 0x206, 0x204, 0x202, 0x205, 0x200};
constexpr std::uint32_t kAddresses[] = {1, 3, 2};

template <class Enum>
std::size_t index_of(Enum value) {
    return static_cast<std::size_t>(value);
}

PixelRect whole_of(const Target& target) {
    return {0, 0, target.width, target.height};
}

class Walk {
  public:
    Walk(const Frame& frame, const Emitted& emitted)
        : frame_(frame), text_(emitted.text), memory_(emitted), map_(lay_out(frame, *find_profile("xbox"))) {}

    std::vector<std::string> run() {
        list_expected();
        run_nv2a(text_, [&](const Nv2aEvent& event) { visit(event); });
        if (next_ != expected_.size()) differ("clears, draws or copies are missing");
        return differences_;
    }

  private:
    // draw -1: the pass's clear.
    struct Expected {
        Nv2aEvent::Kind kind;
        std::size_t pass;
        std::ptrdiff_t draw = -1;
    };

    void differ(const std::string& what) {
        if (differences_.size() < 20) differences_.push_back(where_ + what);
    }
    void expect(bool holds, const char* what) {
        if (!holds) differ(what);
    }
    void near(double value, double wanted, double most, const std::string& what) {
        if (!(std::abs(value - wanted) <= most))
            differ(what + " is " + std::to_string(value) + ", not " + std::to_string(wanted));
    }

    PixelRect viewport(const Pass& pass) const {
        if (pass.state.viewport != PixelRect{}) return pass.state.viewport;
        return whole_of(frame_.targets[index((pass.color ? pass.color : pass.depth))]);
    }
    PixelRect part(const Pass& pass) const {
        PixelRect rect     = viewport(pass);
        const PixelRect& s = pass.state.scissor;
        if (s != PixelRect{})
            rect = {std::max(rect.x0, s.x0), std::max(rect.y0, s.y0), std::min(rect.x1, s.x1), std::min(rect.y1, s.y1)};
        return rect;
    }
    template <class Of>
    static std::size_t index(Id<Of> id) {
        return static_cast<std::size_t>(id.index);
    }

    void list_expected() {
        for (std::size_t i = 0; i < frame_.passes.size(); ++i) {
            const Pass& pass     = frame_.passes[i];
            const PixelRect rect = part(pass);
            const bool is_empty  = rect.x0 >= rect.x1 || rect.y0 >= rect.y1;
            expected_.push_back({Nv2aEvent::Pass, i});
            if (!is_empty && (pass.clear.color || pass.clear.depth)) expected_.push_back({Nv2aEvent::Clear, i});
            for (std::size_t d = 0; d < pass.draws.size(); ++d) {
                const Draw& draw      = pass.draws[d];
                const auto* triangles = std::get_if<DrawTriangles>(&draw);
                const auto* window    = std::get_if<DrawWindowTriangles>(&draw);
                const bool has_none = (triangles && triangles->index_count < 3) || (window && window->index_count < 3);
                const bool copies   = std::holds_alternative<CopyRectangle>(draw);
                if (copies || (!is_empty && !has_none))
                    expected_.push_back(
                        {copies ? Nv2aEvent::Copy : Nv2aEvent::Draw, i, static_cast<std::ptrdiff_t>(d)});
            }
        }
    }

    void visit(const Nv2aEvent& event) {
        if (next_ == 0 && event.kind == Nv2aEvent::Clear) return check_zeros(event);
        if (next_ == expected_.size() || expected_[next_].kind != event.kind) {
            differ("an event that the frame has not");
            return;
        }
        const Expected& expected = expected_[next_++];
        const Pass& pass         = frame_.passes[expected.pass];
        where_ = "pass " + std::to_string(expected.pass) + " draw " + std::to_string(expected.draw) + ": ";
        if (event.kind == Nv2aEvent::Clear) check_clear(event, pass);
        if (event.kind == Nv2aEvent::Copy)
            check_copy(event, pass, std::get<CopyRectangle>(pass.draws[static_cast<std::size_t>(expected.draw)]));
        if (event.kind == Nv2aEvent::Draw) check_draw(event, pass, pass.draws[static_cast<std::size_t>(expected.draw)]);
    }

    void check_zeros(const Nv2aEvent& event) {
        where_ = "before the passes: ";
        expect(event.registers.at(0x1d90) == 0 && event.registers.at(0x1d8c) == 0, "not cleared to zero");
    }

    void check_surfaces(const Nv2aRegisters& registers, const Pass& pass) {
        const Target& size         = frame_.targets[index(pass.color ? pass.color : pass.depth)];
        const std::uint32_t format = registers.at(0x208);
        expect(registers.at(0x200) == static_cast<std::uint32_t>(size.width) << 16, "surface clip x");
        expect(registers.at(0x204) == static_cast<std::uint32_t>(size.height) << 16, "surface clip y");
        expect((format & ~0xffu) == 0x100, "surface type");
        const auto check = [&](TargetId id, std::uint32_t offset, std::uint32_t pitch, std::uint32_t code) {
            const Target& target        = frame_.targets[index(id)];
            const MemoryBlock& block    = map_.blocks[index(id)];
            const std::uint32_t codes[] = {8, 4, 3, 0, 0, 0, 0, 0, 1, 2, 0};
            expect(offset == block.address, "surface offset");
            expect(memory_.is_surface(block.address, block.bytes), "surface in the table");
            expect(pitch == block.pitch * static_cast<std::uint64_t>(bytes_per_pixel(target.format)), "surface pitch");
            expect(code == codes[index_of(target.format)], "surface format");
        };
        if (pass.color) check(pass.color, registers.at(0x210), registers.at(0x20c) & 0xffff, format & 15);
        if (pass.depth) check(pass.depth, registers.at(0x214), registers.at(0x20c) >> 16, format >> 4 & 15);
        expect(registers.at(0x290) == 0x100000, "CONTROL0");
        expect(registers.real(0x394) == 0.0f, "CLIP_MIN");
        if (pass.depth) expect(registers.real(0x398) == greatest_depth(pass), "CLIP_MAX");
        const PixelRect rect = part(pass);
        const auto word      = [](std::int32_t from, std::int32_t to) {
            return static_cast<std::uint32_t>(from) | static_cast<std::uint32_t>(to - 1) << 16;
        };
        expect(registers.at(0x2b4) == 0, "window clip type");
        for (std::uint32_t i = 0; i < 8; ++i) {
            expect(registers.at(0x2c0 + 4 * i) == word(rect.x0, rect.x1), "window clip x");
            expect(registers.at(0x2e0 + 4 * i) == word(rect.y0, rect.y1), "window clip y");
        }
    }

    float greatest_depth(const Pass& pass) const {
        return pass.depth && frame_.targets[index(pass.depth)].format == TargetFormat::D16 ? 65535.0f : 16777215.0f;
    }

    void check_clear(const Nv2aEvent& event, const Pass& pass) {
        check_surfaces(event.registers, pass);
        const PixelRect rect = part(pass);
        expect(event.registers.at(0x1d98) ==
                   (static_cast<std::uint32_t>(rect.x0) | static_cast<std::uint32_t>(rect.x1 - 1) << 16),
               "clear rect x");
        expect(event.registers.at(0x1d9c) ==
                   (static_cast<std::uint32_t>(rect.y0) | static_cast<std::uint32_t>(rect.y1 - 1) << 16),
               "clear rect y");
        expect((event.flags & 0xf0) == (pass.clear.color ? 0xf0u : 0u), "clears colour");
        expect((event.flags & 1) == (pass.clear.depth ? 1u : 0u), "clears depth");
        if (pass.clear.color) {
            const std::uint32_t value = event.registers.at(0x1d90);
            const Color wanted        = color_of(*pass.clear.color);
            if (frame_.targets[index(pass.color)].format == TargetFormat::R5G6B5) {
                near((value >> 11 & 31) / 31.0, wanted[0], 1 / 31.0, "clear red");
                near((value >> 5 & 63) / 63.0, wanted[1], 1 / 63.0, "clear green");
                near((value & 31) / 31.0, wanted[2], 1 / 31.0, "clear blue");
            } else {
                expect(value == pass.clear.color->value, "clear colour");
            }
        }
        if (pass.clear.depth) {
            const bool is_16 = frame_.targets[index(pass.depth)].format == TargetFormat::D16;
            near(is_16 ? event.registers.at(0x1d8c) : event.registers.at(0x1d8c) >> 8,
                 *pass.clear.depth * (is_16 ? 65535.0 : 16777215.0), 1.0, "clear depth");
        }
    }

    void check_copy(const Nv2aEvent& event, const Pass& pass, const CopyRectangle& copy) {
        const Nv2aRegisters& blit = event.blit;
        const auto pair           = [](std::int32_t low, std::int32_t high) {
            return static_cast<std::uint32_t>(low) | static_cast<std::uint32_t>(high) << 16;
        };
        expect(blit.at(0x308) == pair(copy.from.x1 - copy.from.x0, copy.from.y1 - copy.from.y0), "copy size");
        expect(blit.at(0x304) == pair(copy.x, copy.y), "copy to");
        expect(blit.at(0x30c) == map_.blocks[index(pass.color)].address, "copy destination");
    }

    void check_pixels(const Nv2aRegisters& registers, const Pass& pass, bool is_rectangle) {
        const PipelineState& state = pass.state;
        expect(registers.at(0x304) == (state.blend != BlendState{}), "BLEND_ENABLE");
        expect(registers.at(0x344) == kFactors[index_of(state.blend.source)], "SFACTOR");
        expect(registers.at(0x348) == kFactors[index_of(state.blend.dest)], "DFACTOR");
        expect(registers.at(0x350) == 0x8006, "BLEND_EQUATION");
        const ColorMask mask = pass.color ? state.color_mask : ColorMask{false, false, false, false};
        expect(registers.at(0x358) == ((mask.alpha ? 1u << 24 : 0) | (mask.red ? 1u << 16 : 0) |
                                       (mask.green ? 1u << 8 : 0) | (mask.blue ? 1u : 0)),
               "COLOR_MASK");
        expect(registers.at(0x30c) == (state.depth.func != CompareFunc::Always || state.depth.write), "DEPTH_TEST");
        expect(registers.at(0x354) == kCompares[index_of(state.depth.func)], "DEPTH_FUNC");
        expect(registers.at(0x35c) == state.depth.write, "DEPTH_MASK");
        expect(registers.at(0x300) == (state.alpha_test.func != CompareFunc::Always), "ALPHA_TEST");
        expect(registers.at(0x33c) == kCompares[index_of(state.alpha_test.func)], "ALPHA_FUNC");
        expect(registers.at(0x340) == state.alpha_test.reference, "ALPHA_REF");
        const CullMode cull = is_rectangle ? CullMode::None : state.cull;
        expect(registers.at(0x308) == (cull != CullMode::None), "CULL_FACE_ENABLE");
        if (cull != CullMode::None) {
            // Front is clockwise.
            expect(registers.at(0x3a0) == 0x900, "FRONT_FACE");
            expect(registers.at(0x39c) == (cull == CullMode::Clockwise ? 0x404u : 0x405u), "CULL_FACE");
        }
        expect(registers.at(0x37c) == (state.shade == ShadeMode::Flat ? 0x1d00u : 0x1d01u), "SHADE_MODE");
        expect(registers.at(0x9fc) == 1, "PROVOKING_VERTEX");
        for (const std::uint32_t off : {0x310u, 0x318u, 0x31cu, 0x320u, 0x324u, 0x328u, 0x32cu, 0x338u, 0x17bcu})
            expect(registers.at(off) == 0, "a state that no frame has");
        expect(registers.at(0x1e94) == 4, "TRANSFORM_EXECUTION_MODE");
        expect(registers.at(0x1d78) == 1, "ZMIN_MAX_CONTROL");
        expect(registers.at(0x38c) == 0x1b02 && registers.at(0x390) == 0x1b02, "POLYGON_MODE");
    }

    enum Texel : std::uint8_t { None, Colored, Alpha };
    Texel texel_kind(const PipelineState& state, const TextureBindings& bindings, std::size_t stage) const {
        const TextureBinding& binding = bindings[stage];
        if (!reads_texture(state, static_cast<int>(stage)) || (!binding.texture && !binding.target)) return None;
        if (static_cast<int>(stage) >= stage_count(state)) return None;
        return binding.texture && frame_.textures[index(binding.texture)].format == TextureFormat::A8 ? Alpha : Colored;
    }

    void check_combiners(const Nv2aRegisters& registers, const Pass& pass, const TextureBindings& bindings,
                         bool has_fog, bool second_is_black) {
        const auto random = [&] {
            Color color;
            for (double& x : color)
                x = random_.chance(20) ? (random_.chance(50) ? 1.0 : 0.0) : random_.real(0.0f, 1.0f);
            return color;
        };
        for (int i = 0; i < 8; ++i) {
            StageColors colors{.diffuse = random(), .specular = random(), .fog = random()[0]};
            if (second_is_black) colors.specular = {0, 0, 0, 1};
            Nv2aInputs inputs{.v0 = real4(colors.diffuse), .v1 = real4(colors.specular), .fog = colors.fog};
            Real4* texels[] = {&inputs.t0, &inputs.t1};
            for (std::size_t stage = 0; stage < 2; ++stage) {
                colors.texels[stage] = random();
                const Texel kind     = texel_kind(pass.state, bindings, stage);
                const double alpha   = colors.texels[stage][3];
                *texels[stage]       = real4(kind == None ? random() : colors.texels[stage]);
                if (kind == None) colors.texels[stage] = {1, 1, 1, 1};
                if (kind == Alpha) {
                    colors.texels[stage] = {0, 0, 0, alpha};
                    *texels[stage]       = {1, 1, 1, alpha};
                }
            }
            const Color wanted = shaded(pass.state, colors, has_fog);
            const Real4 got    = combine(registers, inputs);
            near(got.r, wanted[0], 1e-6, "combined red");
            near(got.g, wanted[1], 1e-6, "combined green");
            near(got.b, wanted[2], 1e-6, "combined blue");
            near(got.a, wanted[3], 1e-6, "combined alpha");
        }
    }

    void check_texels(const Nv2aTexture& texture, TextureId id) {
        const Texture& own = frame_.textures[index(id)];
        expect(texture.width == static_cast<std::uint32_t>(own.width), "texture width");
        expect(texture.height == static_cast<std::uint32_t>(own.height), "texture height");
        expect(texture.levels == static_cast<std::uint32_t>(own.levels), "texture levels");
        if (!checked_textures_.insert(id.index).second) return;
        const std::uint8_t* texels = own.texels.data();
        for (std::uint32_t level = 0; level < texture.levels; ++level) {
            const std::uint32_t width  = std::max(1u, texture.width >> level),
                                height = std::max(1u, texture.height >> level);
            const std::size_t count = std::size_t{width} * height, step = std::max<std::size_t>(1, count / 5000) | 1;
            for (std::size_t i = 0; i < count; i += step) {
                std::uint32_t wanted = 0;
                switch (own.format) {
                    case TextureFormat::A8:
                        wanted = std::uint32_t{texels[i]} << 24 | 0xffffff;
                        break;
                    case TextureFormat::L8:
                        wanted = 0xff000000 | texels[i] * 0x10101u;
                        break;
                    case TextureFormat::A8R8G8B8:
                        for (std::size_t j = 4; j-- > 0;) wanted = wanted << 8 | texels[4 * i + j];
                        break;
                }
                const auto x = static_cast<std::uint32_t>(i % width), y = static_cast<std::uint32_t>(i / width);
                expect(texel_of(texture, memory_, level, x, y) == wanted, "texel");
            }
            texels += count * static_cast<std::size_t>(bytes_per_texel(own.format));
        }
    }

    void check_textures(const Nv2aRegisters& registers, const Pass& pass, const TextureBindings& bindings) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::optional<Nv2aTexture> texture = texture_of(registers, i);
            const bool is_on                         = i < 2 && texel_kind(pass.state, bindings, i) != None;
            expect(texture.has_value() == is_on, "texture enabled");
            if (!texture || !is_on) continue;
            const TextureStage& stage = pass.state.stages[i];
            const std::uint32_t base = 0x1b00 + 64 * i, linear = stage.filter == TextureFilter::Linear;
            if (bindings[i].target) {
                const Target& target        = frame_.targets[index(bindings[i].target)];
                const std::uint32_t codes[] = {0x12, 0x1e, 0x11};
                expect(texture->address == map_.blocks[index(bindings[i].target)].address, "target's address");
                expect(texture->format == codes[index_of(target.format)], "target's format");
                expect(texture->width == static_cast<std::uint32_t>(target.width), "target's width");
                expect(texture->height == static_cast<std::uint32_t>(target.height), "target's height");
                expect(texture->pitch == map_.blocks[index(bindings[i].target)].pitch *
                                             static_cast<std::uint64_t>(bytes_per_pixel(target.format)),
                       "target's pitch");
            } else {
                check_texels(*texture, bindings[i].texture);
            }
            expect(registers.at(base + 8) ==
                       (kAddresses[index_of(stage.address_u)] | kAddresses[index_of(stage.address_v)] << 8 | 3u << 16),
                   "TEXTURE_ADDRESS");
            const std::uint32_t min = 2 * static_cast<std::uint32_t>(stage.mip_filter) + 1 + linear;
            expect(registers.at(base + 0x14) == (0x2000 | min << 16 | (1 + linear) << 24), "TEXTURE_FILTER");
            expect(registers.at(base + 0xc) == (1u << 30 | 4095u << 6), "TEXTURE_CONTROL0");
        }
    }

    // To what a texture's coordinates are multiplied on their way.
    std::array<double, 2> coords_scale(const TextureBinding& binding) const {
        if (binding.target) {
            const Target& target = frame_.targets[index(binding.target)];
            return {static_cast<double>(target.width), static_cast<double>(target.height)};
        }
        const Texture& texture = frame_.textures[index(binding.texture)];
        const auto is_power    = [](std::int32_t size) { return (size & (size - 1)) == 0; };
        if (is_power(texture.width) && is_power(texture.height)) return {1.0, 1.0};
        return {static_cast<double>(texture.width), static_cast<double>(texture.height)};
    }

    void check_coords(const Nv2aRegisters& registers, const Nv2aVertex& vertex, const TextureBinding& binding,
                      std::uint32_t unit, const std::array<double, 3>& stq, double size) {
        const std::array<double, 2> scale = coords_scale(binding);
        const std::array<double, 4> got   = coords_of(registers, vertex, unit);
        near(got[0], stq[0] * scale[0], 1e-6 * scale[0] * size, "coordinate s");
        near(got[1], stq[1] * scale[1], 1e-6 * scale[1] * size, "coordinate t");
        near(got[3], stq[2], 1e-6 * size, "coordinate q");
    }

    void check_color(const Real4& got, const Color& wanted, double most, const std::string& what) {
        near(got.r, wanted[0], most, what + " red");
        near(got.g, wanted[1], most, what + " green");
        near(got.b, wanted[2], most, what + " blue");
        near(got.a, wanted[3], most, what + " alpha");
    }

    void check_vertex(const Nv2aRegisters& registers, const Pass& pass, const DrawTriangles& draw,
                      std::uint32_t element, const Vertex& own, const CameraLighting& lighting) {
        const Nv2aVertex vertex    = fetch_vertex(registers, memory_, element);
        const PipelineState& state = pass.state;
        const Camera& camera       = frame_.cameras[index(pass.camera)];
        const glm::dvec4 position(own.position, 1.0);
        const glm::dmat4 to_camera = glm::dmat4(camera.view) * glm::dmat4(draw.world);
        const glm::dvec4 clip      = glm::dmat4(camera.projection) * (to_camera * position);
        const PixelRect rect       = viewport(pass);
        const double half_w = (rect.x1 - rect.x0) / 2.0, half_h = (rect.y1 - rect.y0) / 2.0;
        const double wanted[]           = {(rect.x0 + half_w) * clip.w + half_w * clip.x,
                                           (rect.y0 + half_h) * clip.w - half_h * clip.y, clip.z * greatest_depth(pass), clip.w};
        const std::array<double, 4> got = window_of(registers, vertex);
        const Real4x4 matrix            = matrix_at(registers, 0x680);
        for (std::size_t i = 0; i < 4; ++i) {
            double size = 0.0;
            for (std::size_t j = 0; j < 4; ++j) size += std::abs(matrix[i][j] * vertex.position[j]);
            near(got[i], wanted[i], 1e-7 * size + 1e-30, "window " + std::string(1, "xyzw"[i]));
        }
        const Vec3 at(to_camera * position);
        const VertexColors lit = light_vertex(lighting, own, at);
        const bool by_chip     = registers.at(0x314) != 0;
        const double most      = by_chip ? 1e-4 : state.lighting.enabled ? 0.5001 / 255 : 1e-7;
        check_color(first_color(registers, vertex), {lit.diffuse.r, lit.diffuse.g, lit.diffuse.b, lit.diffuse.a}, most,
                    "first colour");
        if (registers.at(0x3b8) != 0) {
            const Real4 second = second_color(registers, vertex);
            near(second.r, lit.specular.r, most, "second red");
            near(second.g, lit.specular.g, most, "second green");
            near(second.b, lit.specular.b, most, "second blue");
        }
        if (state.fog.mode != FogMode::None) near(fog_of(registers, vertex), fog_factor(state.fog, at), 1e-4, "fog");
        for (std::uint32_t stage = 0; stage < 2; ++stage) {
            if (texel_kind(state, draw.textures, stage) == None) continue;
            const TextureStage& own_stage = state.stages[stage];
            std::array<double, 3> stq{};
            double size = 1.0;
            if (own_stage.coords == CoordSource::CameraPosition) {
                const glm::dvec4 result =
                    glm::dmat4(own_stage.transform) * glm::dvec4(glm::dvec3(to_camera * position), 1.0);
                stq  = {result.x, result.y, result.z};
                size = 100.0 * (1.0 + std::abs(at.x) + std::abs(at.y) + std::abs(at.z));
            } else {
                const Vec2 uv = own_stage.coords == CoordSource::Vertex1 ? own.uv1 : own.uv0;
                stq           = {uv.x, uv.y, 1.0};
                size          = 1.0 + std::abs(uv.x) + std::abs(uv.y);
            }
            check_coords(registers, vertex, draw.textures[stage], stage, stq, size);
        }
    }

    void check_triangles(const Nv2aEvent& event, const Pass& pass, const DrawTriangles& draw) {
        expect(event.primitive == 5, "triangles");
        if (event.elements.size() != draw.index_count / 3 * 3) return differ("number of indices");
        const Camera& camera          = frame_.cameras[index(pass.camera)];
        const CameraLighting lighting = prepare_lighting(pass.state.lighting, camera.view, draw.world);
        const std::size_t step        = std::max<std::size_t>(1, event.elements.size() / 100) | 1;
        for (std::size_t i = 0; i < event.elements.size(); i += step)
            check_vertex(event.registers, pass, draw, event.elements[i],
                         frame_.vertices[frame_.indices[draw.first_index + i]], lighting);
    }

    // A vertex in window space.
    void check_placed(const Nv2aRegisters& registers, const Pass& pass, const TextureBindings& bindings,
                      const WindowVertex& own, std::uint32_t element) {
        const Nv2aVertex vertex         = fetch_vertex(registers, memory_, element);
        const std::array<double, 4> got = window_of(registers, vertex);
        near(got[0] / got[3], own.x, 1e-6 * (1 + std::abs(own.x)), "window x");
        near(got[1] / got[3], own.y, 1e-6 * (1 + std::abs(own.y)), "window y");
        near(got[2] / got[3], own.z * static_cast<double>(greatest_depth(pass)), 4.0, "window z");
        near(got[3] * own.rhw, 1.0, 1e-6, "w");
        check_color(first_color(registers, vertex), color_of(own.diffuse), 1e-7, "first colour");
        for (std::uint32_t stage = 0; stage < 2; ++stage) {
            if (texel_kind(pass.state, bindings, stage) == None) continue;
            const Vec3& uv = stage == 0 ? own.uv0 : own.uv1;
            check_coords(registers, vertex, bindings[stage], stage, {uv.x, uv.y, uv.z},
                         1 + std::abs(uv.x) + std::abs(uv.y) + std::abs(uv.z));
        }
        if (registers.at(0x2a4) != 0) near(fog_of(registers, vertex), color_of(own.specular)[3], 1e-6, "fog");
        if (registers.at(0x3b8) != 0) {
            const Color specular = color_of(own.specular);
            const Real4 second   = second_color(registers, vertex);
            near(second.r, specular[0], 1e-9, "second red");
            near(second.b, specular[2], 1e-9, "second blue");
        }
    }

    void check_window_triangles(const Nv2aEvent& event, const Pass& pass, const DrawWindowTriangles& draw) {
        expect(event.primitive == 5, "triangles");
        if (event.elements.size() != draw.index_count / 3 * 3) return differ("number of indices");
        for (std::size_t i = 0; i < event.elements.size(); ++i)
            check_placed(event.registers, pass, draw.textures,
                         frame_.window_vertices[frame_.indices[draw.first_index + i]], event.elements[i]);
    }

    void check_rectangle(const Nv2aEvent& event, const Pass& pass, const DrawRectangle& draw) {
        expect(event.primitive == 8, "quads");
        if (event.elements.size() != 4) return differ("number of corners");
        const float xs[] = {draw.x0, draw.x1, draw.x1, draw.x0}, ys[] = {draw.y0, draw.y0, draw.y1, draw.y1};
        for (std::size_t i = 0; i < 4; ++i) {
            const auto coords = [&](const UvRect& uv) {
                return Vec3(i == 1 || i == 2 ? uv.u1 : uv.u0, i >= 2 ? uv.v1 : uv.v0, 1.0f);
            };
            check_placed(event.registers, pass, draw.textures,
                         {.x       = xs[i],
                          .y       = ys[i],
                          .z       = draw.depth,
                          .diffuse = draw.color,
                          .uv0     = coords(draw.uv[0]),
                          .uv1     = coords(draw.uv[1])},
                         event.elements[i]);
        }
    }

    void check_draw(const Nv2aEvent& event, const Pass& pass, const Draw& draw) {
        const auto* rectangle          = std::get_if<DrawRectangle>(&draw);
        const auto* triangles          = std::get_if<DrawTriangles>(&draw);
        const TextureBindings bindings = textures_of(draw);
        const bool has_fog             = pass.state.fog.mode != FogMode::None && rectangle == nullptr;
        check_surfaces(event.registers, pass);
        check_pixels(event.registers, pass, rectangle != nullptr);
        expect(event.registers.at(0x2a4) == has_fog, "FOG_ENABLE");
        // Without highlights lit vertices have no second colour; nor have rectangles.
        const bool black = rectangle != nullptr || (triangles != nullptr && event.registers.at(0x314) != 0);
        if (event.registers.at(0x3b8) == 0 && !black) {
            for (const TextureStage& stage : pass.state.stages)
                for (const TextureArg& arg : {stage.color_arg1, stage.color_arg2, stage.alpha_arg1, stage.alpha_arg2})
                    expect(stage.color_op == TextureOp::Disable || arg.source != ArgSource::Specular, "second colour");
            expect(!pass.state.lighting.specular_enable, "second colour is added");
        }
        check_combiners(event.registers, pass, bindings, has_fog, black);
        check_textures(event.registers, pass, bindings);
        if (triangles != nullptr) check_triangles(event, pass, *triangles);
        if (rectangle != nullptr) check_rectangle(event, pass, *rectangle);
        if (const auto* window = std::get_if<DrawWindowTriangles>(&draw)) check_window_triangles(event, pass, *window);
    }

    const Frame& frame_;
    const std::string& text_;
    Nv2aBytes memory_;
    MemoryMap map_;
    Random random_{1};
    std::vector<Expected> expected_;
    std::size_t next_ = 0;
    std::string where_;
    std::vector<std::string> differences_;
    std::set<std::int32_t> checked_textures_;
};

}  // namespace

std::vector<std::string> nv2a_differences(const Frame& frame, const Emitted& emitted) {
    return Walk(frame, emitted).run();
}

}  // namespace test_support
