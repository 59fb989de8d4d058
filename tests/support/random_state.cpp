// SPDX-License-Identifier: MIT
#include "tests/support/random_state.h"

#include "pipeline/frame/field_traits.h"

namespace test_support {

using namespace pipeline;

namespace {

// Sets every plain value but integers, which stand for pixels and are set by who knows the target. Enums and flags
// often keep their default, so that not every frame has everything on at once.
template <class T>
void scramble(T& value, Random& random) {
    if constexpr (FieldStruct<T>) {
        visit_fields(value, [&](std::string_view, auto& field) { scramble(field, random); });
    } else if constexpr (kIsArray<T>) {
        for (auto& element : value) scramble(element, random);
    } else if constexpr (NamedEnum<T>) {
        if (random.chance(60)) value = random.any<T>();
    } else if constexpr (std::same_as<T, bool>) {
        if (random.chance(30)) value = !value;
    } else if constexpr (std::same_as<T, Argb>) {
        value.value = random.bits();
    } else if constexpr (std::same_as<T, std::uint8_t>) {
        value = static_cast<std::uint8_t>(random.bits());
    } else if constexpr (std::same_as<T, float>) {
        value = random.real(0.0f, 2.0f);
    } else if constexpr (std::same_as<T, Mat4>) {
        if (random.chance(60)) value = random_matrix(random);
    } else if constexpr (kIsVec<T>) {
        for (glm::length_t i = 0; i < value.length(); ++i) value[i] = random.real(-0.3f, 1.2f);
    }
}

Light random_light(Random& random) {
    Light light;
    scramble(light, random);
    for (int i = 0; i < 3; ++i) {
        light.position[i]  = random.real(-6.0f, 6.0f);
        light.direction[i] = random.real(-1.0f, 1.0f);
    }
    if (light.direction == Vec3(0.0f)) light.direction.z = 1.0f;
    light.range       = random.chance(70) ? random.real(2.0f, 30.0f) : random.one_of({0.0f, 1e9f});
    light.attenuation = {random.real(0.2f, 1.5f), random.real(0.0f, 0.5f), random.real(0.0f, 0.1f)};
    if (random.chance(20)) light.attenuation = Vec3(0.0f, 0.0f, random.real(0.01f, 0.5f));
    if (random.chance(15)) light.diffuse = -light.diffuse;
    return light;
}

// Only what the frame's arithmetic has rules for.
void fix_arithmetic(const Arithmetic& arithmetic, PipelineState& state, Random& random) {
    const bool gs_blend = arithmetic.blend == BlendRule::GsShift7;
    if (gs_blend) {
        state.blend = {};
    } else {
        state.gs_blend = {};
    }
    if (random.chance(60) || state.dither.mode == (gs_blend ? DitherMode::Flipper2x2 : DitherMode::GsDimx)) {
        state.dither.mode = DitherMode::None;
    }
    for (std::int32_t& offset : state.dither.matrix) offset = random.from(-4, 3);
}

void fix_stages(const Arithmetic& arithmetic, std::array<TextureStage, kTextureStages>& stages, Random& random) {
    const bool shift7 = arithmetic.combine == CombineRule::GsShift7;
    const int enabled = random.chance(15) ? 0 : random.from(1, shift7 ? 1 : kTextureStages);
    for (int i = 0; i < kTextureStages; ++i) {
        TextureStage& stage = stages[static_cast<std::size_t>(i)];
        for (TextureOp* op : {&stage.color_op, &stage.alpha_op}) {
            if (i >= enabled) {
                *op = TextureOp::Disable;
            } else {
                while (*op == TextureOp::Disable || !has_rule(arithmetic.combine, *op)) *op = random.any<TextureOp>();
            }
        }
        if (random.chance(50)) stage.color_arg1.source = ArgSource::Texture;
        for (TextureArg* arg : {&stage.color_arg1, &stage.color_arg2, &stage.alpha_arg1, &stage.alpha_arg2}) {
            if (shift7) arg->complement = false;
        }
    }
}

// All zeros, or a part of the target that is not empty.
PixelRect random_part(Random& random, int width, int height) {
    PixelRect part;
    if (random.chance(60)) return part;
    part.x0 = random.from(0, (width - 1) / 2);
    part.y0 = random.from(0, (height - 1) / 2);
    part.x1 = random.from(part.x0 + 1, width);
    part.y1 = random.from(part.y0 + 1, height);
    if (random.chance(10)) part.x1 = part.x0 + 1;
    return part;
}

}  // namespace

Mat4 random_matrix(Random& random) {
    Mat4 matrix(1.0f);
    const float size = random.real(0.6f, 1.4f);
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            matrix[column][row] = size * (matrix[column][row] + random.real(-0.2f, 0.2f));
        }
        matrix[3][column] = random.real(-0.4f, 0.4f);
    }
    if (random.chance(10)) matrix[0] = -matrix[0];
    if (random.chance(4)) matrix[1] = Vec4(0.0f);
    if (random.chance(10)) matrix[2][3] = random.real(-0.1f, 0.1f);
    return matrix;
}

// The ideal chip, a known one's mixture of rules, or any.
Arithmetic random_arithmetic(Random& random) {
    Arithmetic arithmetic;
    if (random.chance(30)) return arithmetic;
    // vertex_depth follows what is drawn anyway, so that the numbers of older seeds stay what they were.
    visit_fields(arithmetic, [&](std::string_view name, auto& field) {
        if (name != "vertex_depth") scramble(field, random);
    });
    arithmetic.vertex_depth = arithmetic.gouraud == GouraudRule::Floor ? VertexDepth::WholeUnits : VertexDepth::Fine;
    arithmetic.pixel_center = random.chance(40) ? random.one_of({0, 8, 9}) : random.from(0, 15);
    return arithmetic;
}

PipelineState random_state(const Arithmetic& arithmetic, Random& random, int width, int height,
                           std::optional<TargetFormat> color, bool has_depth) {
    PipelineState state;
    scramble(state, random);
    fix_arithmetic(arithmetic, state, random);
    fix_stages(arithmetic, state.stages, random);
    if (random.chance(30)) state.blend = kReplace;
    if (!color || keeps_bytes(*color)) state.dither.mode = DitherMode::None;
    if (!color || random.chance(70)) state.dest_alpha_test = DestAlphaTest::Off;
    if (random.chance(60)) state.color_mask = {};
    if (random.chance(65)) state.alpha_test.func = CompareFunc::Always;
    if (random.chance(60)) state.cull = CullMode::None;
    if (random.chance(45)) state.depth = {.func = CompareFunc::LessEqual, .write = true};
    if (!has_depth) state.depth = {};
    state.fog.start   = random.real(0.0f, 6.0f);
    state.fog.end     = state.fog.start + random.real(0.5f, 12.0f);
    state.fog.density = random.real(0.0f, 0.4f);
    if (random.chance(10)) std::swap(state.fog.start, state.fog.end);
    state.lighting.enabled = random.chance(50);
    const int lights       = random.chance(10) ? kMaxLights : random.from(0, 3);
    for (int i = 0; i < lights; ++i) state.lighting.lights.push_back(random_light(random));
    state.lighting.material.power = random.one_of({0.0f, 1.0f, 3.5f, 20.0f});
    state.viewport                = random_part(random, width, height);
    state.scissor                 = random_part(random, width, height);
    return state;
}

}  // namespace test_support
