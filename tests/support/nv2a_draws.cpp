// SPDX-License-Identifier: MIT
#include "tests/support/nv2a_draws.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pipeline/execute/fog.h"
#include "pipeline/execute/lighting.h"
#include "pipeline/validate/check_pass.h"
#include "tests/support/nv2a_shading.h"
#include "tests/support/stage_colors.h"

namespace test_support {

using namespace pipeline;

namespace {

constexpr std::uint32_t kFactors[]   = {0, 1, 0x300, 0x301, 0x306, 0x307, 0x302, 0x303, 0x304, 0x305};
constexpr std::uint32_t kCompares[]  = {0x207, 0x203, 0x201, 0x206, 0x204, 0x202, 0x205, 0x200};
constexpr std::uint32_t kAddresses[] = {1, 3, 2};

Real4 real4(const RealColor& c) {
    return {c[0], c[1], c[2], c[3]};
}

class DrawComparison {
  public:
    explicit DrawComparison(Nv2aComparison& compare) : compare_(compare) {}

    void run(const Nv2aEvent& event, const Pass& pass, const Draw& draw) {
        const auto* rectangle          = std::get_if<DrawRectangle>(&draw);
        const auto* triangles          = std::get_if<DrawTriangles>(&draw);
        const TextureBindings bindings = textures_of(draw);
        const bool has_fog             = pass.state.fog.mode != FogMode::None && rectangle == nullptr;
        check_pixels(event.registers, pass, rectangle != nullptr);
        compare_.expect(event.registers.at(0x2a4) == has_fog, "FOG_ENABLE");
        // Without highlights lit vertices have no second colour; nor have rectangles.
        const bool black = rectangle != nullptr || (triangles != nullptr && event.registers.at(0x314) != 0);
        if (event.registers.at(0x3b8) == 0 && !black) {
            for (const TextureStage& stage : pass.state.stages)
                for (const TextureArg& arg : {stage.color_arg1, stage.color_arg2, stage.alpha_arg1, stage.alpha_arg2})
                    compare_.expect(stage.color_op == TextureOp::Disable || arg.source != ArgSource::Specular,
                                    "second colour");
            compare_.expect(!pass.state.lighting.specular_enable, "second colour is added");
        }
        check_combiners(event.registers, pass, bindings, has_fog, black);
        check_textures(event.registers, pass, bindings);
        if (triangles != nullptr) check_triangles(event, pass, *triangles);
        if (rectangle != nullptr) check_rectangle(event, pass, *rectangle);
        if (const auto* window = std::get_if<DrawWindowTriangles>(&draw)) check_window_triangles(event, pass, *window);
    }

  private:
    void check_pixels(const Nv2aRegisters& registers, const Pass& pass, bool is_rectangle) {
        const PipelineState& state = pass.state;
        compare_.expect(registers.at(0x304) == (state.blend != BlendState{}), "BLEND_ENABLE");
        compare_.expect(registers.at(0x344) == kFactors[index_of(state.blend.source)], "SFACTOR");
        compare_.expect(registers.at(0x348) == kFactors[index_of(state.blend.dest)], "DFACTOR");
        compare_.expect(registers.at(0x350) == 0x8006, "BLEND_EQUATION");
        const ColorMask mask = pass.color ? state.color_mask : ColorMask{false, false, false, false};
        compare_.expect(registers.at(0x358) == ((mask.alpha ? 1u << 24 : 0) | (mask.red ? 1u << 16 : 0) |
                                                (mask.green ? 1u << 8 : 0) | (mask.blue ? 1u : 0)),
                        "COLOR_MASK");
        compare_.expect(registers.at(0x30c) == (state.depth.func != CompareFunc::Always || state.depth.write),
                        "DEPTH_TEST");
        compare_.expect(registers.at(0x354) == kCompares[index_of(state.depth.func)], "DEPTH_FUNC");
        compare_.expect(registers.at(0x35c) == state.depth.write, "DEPTH_MASK");
        compare_.expect(registers.at(0x300) == (state.alpha_test.func != CompareFunc::Always), "ALPHA_TEST");
        compare_.expect(registers.at(0x33c) == kCompares[index_of(state.alpha_test.func)], "ALPHA_FUNC");
        compare_.expect(registers.at(0x340) == state.alpha_test.reference, "ALPHA_REF");
        const CullMode cull = is_rectangle ? CullMode::None : state.cull;
        compare_.expect(registers.at(0x308) == (cull != CullMode::None), "CULL_FACE_ENABLE");
        if (cull != CullMode::None) {
            // Front is clockwise.
            compare_.expect(registers.at(0x3a0) == 0x900, "FRONT_FACE");
            compare_.expect(registers.at(0x39c) == (cull == CullMode::Clockwise ? 0x404u : 0x405u), "CULL_FACE");
        }
        compare_.expect(registers.at(0x37c) == (state.shade == ShadeMode::Flat ? 0x1d00u : 0x1d01u), "SHADE_MODE");
        compare_.expect(registers.at(0x9fc) == 1, "PROVOKING_VERTEX");
        for (const std::uint32_t off : {0x310u, 0x318u, 0x31cu, 0x320u, 0x324u, 0x328u, 0x32cu, 0x338u, 0x17bcu})
            compare_.expect(registers.at(off) == 0, "a state that no frame has");
        compare_.expect(registers.at(0x1e94) == 4, "TRANSFORM_EXECUTION_MODE");
        compare_.expect(registers.at(0x1d78) == 1, "ZMIN_MAX_CONTROL");
        compare_.expect(registers.at(0x38c) == 0x1b02 && registers.at(0x390) == 0x1b02, "POLYGON_MODE");
    }

    enum Texel : std::uint8_t { None, Colored, Alpha };
    Texel texel_kind(const PipelineState& state, const TextureBindings& bindings, std::size_t stage) const {
        const TextureBinding& binding = bindings[stage];
        if (!reads_texture(state, static_cast<int>(stage)) || (!binding.texture && !binding.target)) return None;
        if (static_cast<int>(stage) >= stage_count(state)) return None;
        return binding.texture && compare_.frame.textures[index_of(binding.texture)].format == TextureFormat::A8
                   ? Alpha
                   : Colored;
    }

    void check_combiners(const Nv2aRegisters& registers, const Pass& pass, const TextureBindings& bindings,
                         bool has_fog, bool second_is_black) {
        const auto random = [&] {
            RealColor color;
            for (double& x : color)
                x = compare_.random.chance(20) ? (compare_.random.chance(50) ? 1.0 : 0.0)
                                               : compare_.random.real(0.0f, 1.0f);
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
            const RealColor wanted = shaded(pass.state, colors, has_fog);
            const Real4 got        = combine(registers, inputs);
            compare_.near(got.r, wanted[0], 1e-6, "combined red");
            compare_.near(got.g, wanted[1], 1e-6, "combined green");
            compare_.near(got.b, wanted[2], 1e-6, "combined blue");
            compare_.near(got.a, wanted[3], 1e-6, "combined alpha");
        }
    }

    void check_texels(const Nv2aTexture& texture, TextureId id) {
        const Texture& own = compare_.frame.textures[index_of(id)];
        compare_.expect(texture.width == static_cast<std::uint32_t>(own.width), "texture width");
        compare_.expect(texture.height == static_cast<std::uint32_t>(own.height), "texture height");
        compare_.expect(texture.levels == static_cast<std::uint32_t>(own.levels), "texture levels");
        if (!compare_.checked_textures.insert(id.index).second) return;
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
                compare_.expect(texel_of(texture, compare_.memory, level, x, y) == wanted, "texel");
            }
            texels += count * static_cast<std::size_t>(bytes_per_texel(own.format));
        }
    }

    void check_textures(const Nv2aRegisters& registers, const Pass& pass, const TextureBindings& bindings) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::optional<Nv2aTexture> texture = texture_of(registers, i);
            const bool is_on                         = i < 2 && texel_kind(pass.state, bindings, i) != None;
            compare_.expect(texture.has_value() == is_on, "texture enabled");
            if (!texture || !is_on) continue;
            const TextureStage& stage = pass.state.stages[i];
            const std::uint32_t base = 0x1b00 + 64 * i, linear = stage.filter == TextureFilter::Linear;
            if (bindings[i].target) {
                const Target& target        = compare_.frame.targets[index_of(bindings[i].target)];
                const std::uint32_t codes[] = {0x12, 0x1e, 0x11};
                compare_.expect(texture->address == compare_.map.blocks[index_of(bindings[i].target)].address,
                                "target's address");
                compare_.expect(texture->format == codes[index_of(target.format)], "target's format");
                compare_.expect(texture->width == static_cast<std::uint32_t>(target.width), "target's width");
                compare_.expect(texture->height == static_cast<std::uint32_t>(target.height), "target's height");
                compare_.expect(texture->pitch == compare_.map.blocks[index_of(bindings[i].target)].pitch *
                                                      static_cast<std::uint64_t>(bytes_per_pixel(target.format)),
                                "target's pitch");
            } else {
                check_texels(*texture, bindings[i].texture);
            }
            compare_.expect(registers.at(base + 8) == (kAddresses[index_of(stage.address_u)] |
                                                       kAddresses[index_of(stage.address_v)] << 8 | 3u << 16),
                            "TEXTURE_ADDRESS");
            const std::uint32_t min = 2 * static_cast<std::uint32_t>(stage.mip_filter) + 1 + linear;
            compare_.expect(registers.at(base + 0x14) == (0x2000 | min << 16 | (1 + linear) << 24), "TEXTURE_FILTER");
            compare_.expect(registers.at(base + 0xc) == (1u << 30 | 4095u << 6), "TEXTURE_CONTROL0");
        }
    }

    // To what a texture's coordinates are multiplied on their way.
    std::array<double, 2> coords_scale(const TextureBinding& binding) const {
        if (binding.target) {
            const Target& target = compare_.frame.targets[index_of(binding.target)];
            return {static_cast<double>(target.width), static_cast<double>(target.height)};
        }
        const Texture& texture = compare_.frame.textures[index_of(binding.texture)];
        const auto is_power    = [](std::int32_t size) { return (size & (size - 1)) == 0; };
        if (is_power(texture.width) && is_power(texture.height)) return {1.0, 1.0};
        return {static_cast<double>(texture.width), static_cast<double>(texture.height)};
    }

    void check_coords(const Nv2aRegisters& registers, const Nv2aVertex& vertex, const TextureBinding& binding,
                      std::uint32_t unit, const std::array<double, 3>& stq, double size) {
        const std::array<double, 2> scale = coords_scale(binding);
        const std::array<double, 4> got   = coords_of(registers, vertex, unit);
        compare_.near(got[0], stq[0] * scale[0], 1e-6 * scale[0] * size, "coordinate s");
        compare_.near(got[1], stq[1] * scale[1], 1e-6 * scale[1] * size, "coordinate t");
        compare_.near(got[3], stq[2], 1e-6 * size, "coordinate q");
    }

    void check_color(const Real4& got, const RealColor& wanted, double most, const std::string& what) {
        compare_.near(got.r, wanted[0], most, what + " red");
        compare_.near(got.g, wanted[1], most, what + " green");
        compare_.near(got.b, wanted[2], most, what + " blue");
        compare_.near(got.a, wanted[3], most, what + " alpha");
    }

    void check_vertex(const Nv2aRegisters& registers, const Pass& pass, const DrawTriangles& draw,
                      std::uint32_t element, const Vertex& own, const CameraLighting& lighting) {
        const Nv2aVertex vertex    = fetch_vertex(registers, compare_.memory, element);
        const PipelineState& state = pass.state;
        const Camera& camera       = compare_.frame.cameras[index_of(pass.camera)];
        const glm::dvec4 position(own.position, 1.0);
        const glm::dmat4 to_camera = glm::dmat4(camera.view) * glm::dmat4(draw.world);
        const glm::dvec4 clip      = glm::dmat4(camera.projection) * (to_camera * position);
        const PixelRect rect       = compare_.viewport(pass);
        const double half_w = (rect.x1 - rect.x0) / 2.0, half_h = (rect.y1 - rect.y0) / 2.0;
        const double wanted[]           = {(rect.x0 + half_w) * clip.w + half_w * clip.x,
                                           (rect.y0 + half_h) * clip.w - half_h * clip.y, clip.z * compare_.greatest_depth(pass),
                                           clip.w};
        const std::array<double, 4> got = window_of(registers, vertex);
        const Real4x4 matrix            = matrix_at(registers, 0x680);
        for (std::size_t i = 0; i < 4; ++i) {
            double size = 0.0;
            for (std::size_t j = 0; j < 4; ++j) size += std::abs(matrix[i][j] * vertex.position[j]);
            compare_.near(got[i], wanted[i], 1e-7 * size + 1e-30, "window " + std::string(1, "xyzw"[i]));
        }
        const Vec3 at(to_camera * position);
        const VertexColors lit = light_vertex(lighting, own, at);
        const bool by_chip     = registers.at(0x314) != 0;
        const double most      = by_chip ? 1e-4 : state.lighting.enabled ? 0.5001 / 255 : 1e-7;
        check_color(first_color(registers, vertex), {lit.diffuse.r, lit.diffuse.g, lit.diffuse.b, lit.diffuse.a}, most,
                    "first colour");
        if (registers.at(0x3b8) != 0) {
            const Real4 second = second_color(registers, vertex);
            compare_.near(second.r, lit.specular.r, most, "second red");
            compare_.near(second.g, lit.specular.g, most, "second green");
            compare_.near(second.b, lit.specular.b, most, "second blue");
        }
        if (state.fog.mode != FogMode::None)
            compare_.near(fog_of(registers, vertex), fog_factor(state.fog, at), 1e-4, "fog");
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
        compare_.expect(event.primitive == 5, "triangles");
        if (event.elements.size() != draw.index_count / 3 * 3) return compare_.differ("number of indices");
        const Camera& camera          = compare_.frame.cameras[index_of(pass.camera)];
        const CameraLighting lighting = prepare_lighting(pass.state.lighting, camera.view, draw.world);
        const std::size_t step        = std::max<std::size_t>(1, event.elements.size() / 100) | 1;
        for (std::size_t i = 0; i < event.elements.size(); i += step)
            check_vertex(event.registers, pass, draw, event.elements[i],
                         compare_.frame.vertices[compare_.frame.indices[draw.first_index + i]], lighting);
    }

    // A vertex in window space.
    void check_placed(const Nv2aRegisters& registers, const Pass& pass, const TextureBindings& bindings,
                      const WindowVertex& own, std::uint32_t element) {
        const Nv2aVertex vertex         = fetch_vertex(registers, compare_.memory, element);
        const std::array<double, 4> got = window_of(registers, vertex);
        compare_.near(got[0] / got[3], own.x, 1e-6 * (1 + std::abs(own.x)), "window x");
        compare_.near(got[1] / got[3], own.y, 1e-6 * (1 + std::abs(own.y)), "window y");
        compare_.near(got[2] / got[3], own.z * static_cast<double>(compare_.greatest_depth(pass)), 4.0, "window z");
        compare_.near(got[3] * own.rhw, 1.0, 1e-6, "w");
        check_color(first_color(registers, vertex), real_color(own.diffuse), 1e-7, "first colour");
        for (std::uint32_t stage = 0; stage < 2; ++stage) {
            if (texel_kind(pass.state, bindings, stage) == None) continue;
            const Vec3& uv = stage == 0 ? own.uv0 : own.uv1;
            check_coords(registers, vertex, bindings[stage], stage, {uv.x, uv.y, uv.z},
                         1 + std::abs(uv.x) + std::abs(uv.y) + std::abs(uv.z));
        }
        if (registers.at(0x2a4) != 0)
            compare_.near(fog_of(registers, vertex), real_color(own.specular)[3], 1e-6, "fog");
        if (registers.at(0x3b8) != 0) {
            const RealColor specular = real_color(own.specular);
            const Real4 second       = second_color(registers, vertex);
            compare_.near(second.r, specular[0], 1e-9, "second red");
            compare_.near(second.b, specular[2], 1e-9, "second blue");
        }
    }

    void check_window_triangles(const Nv2aEvent& event, const Pass& pass, const DrawWindowTriangles& draw) {
        compare_.expect(event.primitive == 5, "triangles");
        if (event.elements.size() != draw.index_count / 3 * 3) return compare_.differ("number of indices");
        for (std::size_t i = 0; i < event.elements.size(); ++i)
            check_placed(event.registers, pass, draw.textures,
                         compare_.frame.window_vertices[compare_.frame.indices[draw.first_index + i]],
                         event.elements[i]);
    }

    void check_rectangle(const Nv2aEvent& event, const Pass& pass, const DrawRectangle& draw) {
        compare_.expect(event.primitive == 8, "quads");
        if (event.elements.size() != 4) return compare_.differ("number of corners");
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

    Nv2aComparison& compare_;
};

}  // namespace

void compare_draw(Nv2aComparison& compare, const Nv2aEvent& event, const Pass& pass, const Draw& draw) {
    DrawComparison(compare).run(event, pass, draw);
}

}  // namespace test_support
