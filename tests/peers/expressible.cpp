// SPDX-License-Identifier: MIT
#include "tests/peers/expressible.h"

#include <algorithm>
#include <glm/matrix.hpp>

#include "tests/peers/gl_lighting.h"
#include "tests/peers/gl_stages.h"

namespace peers {

using namespace pipeline;

namespace {

template <class Of>
const Of& at(const std::vector<Of>& list, Id<Of> id) {
    return list[static_cast<std::size_t>(id.index)];
}

template <class Predicate>
bool any_draw(const Pass& pass, Predicate&& predicate) {
    return std::any_of(pass.draws.begin(), pass.draws.end(), predicate);
}

// predicate(stage, the two ops' arguments that they use)
template <class Predicate>
bool any_stage(const Pass& pass, Predicate&& predicate) {
    const auto& stages = pass.state.stages;
    return std::any_of(stages.begin(), stages.begin() + stage_count(pass.state), predicate);
}

bool reads_specular(const TextureStage& stage) {
    const auto reads = [](TextureOp op, const TextureArg& a, const TextureArg& b) {
        return (op != TextureOp::SelectArg2 && a.source == ArgSource::Specular) ||
               (op != TextureOp::SelectArg1 && b.source == ArgSource::Specular);
    };
    return reads(stage.color_op, stage.color_arg1, stage.color_arg2) ||
           reads(stage.alpha_op, stage.alpha_arg1, stage.alpha_arg2);
}

// OpenGL rounds to a format with few bits; the frame keeps the top ones.
bool is_whole_bytes(TargetFormat format) {
    return format == TargetFormat::A8R8G8B8 || format == TargetFormat::X8R8G8B8 || is_depth(format);
}

bool halves(const Draw& draw) {
    const auto* copy = std::get_if<CopyRectangle>(&draw);
    return copy != nullptr && copy->halve;
}

bool moves_channels(const Draw& draw) {
    const auto* copy = std::get_if<CopyRectangle>(&draw);
    return copy != nullptr && copy->channels != CopyChannels::All;
}

bool is_in_window(const Draw& draw) {
    return std::holds_alternative<DrawWindowTriangles>(draw);
}

bool lights_by_singular_matrix(const Frame& frame, const Pass& pass, const Draw& draw) {
    const auto* triangles = std::get_if<DrawTriangles>(&draw);
    if (!pass.state.lighting.enabled || triangles == nullptr) return false;
    const glm::dmat4 matrix = glm::dmat4(at(frame.cameras, pass.camera).view) * glm::dmat4(triangles->world);
    return glm::determinant(glm::dmat3(matrix)) == 0.0;
}

// The frame takes a q that is not positive for the least that is; OpenGL divides by it.
bool projects_from_behind(const Frame& frame, const Pass& pass) {
    const auto is_behind = [&](const TextureStage& stage, const DrawTriangles& draw) {
        const Mat4 to_texture = stage.transform * at(frame.cameras, pass.camera).view * draw.world;
        const auto first      = frame.indices.begin() + draw.first_index;
        return std::any_of(first, first + draw.index_count, [&](std::uint32_t index) {
            return (to_texture * Vec4(frame.vertices[index].position, 1.0f)).z <= 0.0f;
        });
    };
    return any_stage(pass, [&](const TextureStage& stage) {
        return stage.coords == CoordSource::CameraPosition && any_draw(pass, [&](const Draw& draw) {
                   const auto* triangles = std::get_if<DrawTriangles>(&draw);
                   return triangles != nullptr && is_behind(stage, *triangles);
               });
    });
}

// The frame takes w of the position in camera space for 1; OpenGL multiplies by it.
bool projects_by_projective_matrix(const Frame& frame, const Pass& pass) {
    const auto is_affine = [](const Mat4& m) {
        return m[0][3] == 0.0f && m[1][3] == 0.0f && m[2][3] == 0.0f && m[3][3] == 1.0f;
    };
    return any_stage(pass, [&](const TextureStage& stage) {
        return stage.coords == CoordSource::CameraPosition && any_draw(pass, [&](const Draw& draw) {
                   const auto* triangles = std::get_if<DrawTriangles>(&draw);
                   return triangles != nullptr &&
                          !(is_affine(triangles->world) && is_affine(at(frame.cameras, pass.camera).view));
               });
    });
}

// One thing that the API does not have.
struct Limit {
    const char* what;
    bool (*is_exceeded)(const Frame& frame, const Pass& pass);
};

constexpr Limit kLimits[] = {
    {"no blend of the Graphics Synthesizer's",
     [](const Frame&, const Pass& pass) { return pass.state.gs_blend != GsBlend{}; }},
    {"no such dither", [](const Frame&, const Pass& pass) { return pass.state.dither.mode != DitherMode::None; }},
    {"no fragments that fail the alpha test and are written",
     [](const Frame&, const Pass& pass) { return pass.state.alpha_test.fail != AlphaFail::Keep; }},
    {"no test of destination alpha",
     [](const Frame&, const Pass& pass) { return pass.state.dest_alpha_test != DestAlphaTest::Off; }},
    {"no such texture op",
     [](const Frame&, const Pass& pass) {
         return any_stage(pass, [](const TextureStage& s) { return !has_op(s.color_op) || !has_op(s.alpha_op); });
     }},
    {"no texture stage that reads the specular colour",
     [](const Frame&, const Pass& pass) { return any_stage(pass, reads_specular); }},
    {"no texture projected from behind", projects_from_behind},
    {"no texture projected by a projective matrix", projects_by_projective_matrix},
    {"no copy that halves", [](const Frame&, const Pass& pass) { return any_draw(pass, halves); }},
    {"no copy from one channel to another",
     [](const Frame&, const Pass& pass) { return any_draw(pass, moves_channels); }},
    {"no triangles in window space", [](const Frame&, const Pass& pass) { return any_draw(pass, is_in_window); }},
    {"no lighting by a matrix without inverse",
     [](const Frame& frame, const Pass& pass) {
         return any_draw(pass, [&](const Draw& draw) { return lights_by_singular_matrix(frame, pass, draw); });
     }},
};

}  // namespace

std::optional<std::string> cannot_express(const Frame& frame) {
    if (frame.arithmetic != Arithmetic{}) return "no such arithmetic";
    for (const Target& target : frame.targets)
        if (!is_whole_bytes(target.format))
            return "no " + std::string(enum_name(target.format)) + " that keeps top bits";
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        const Pass& pass        = frame.passes[i];
        const std::string place = "pass " + std::to_string(i) + " '" + pass.label + "': ";
        for (const Limit& limit : kLimits)
            if (limit.is_exceeded(frame, pass)) return place + limit.what;
        if (const auto reason = cannot_light(pass.state.lighting)) return place + *reason;
    }
    return std::nullopt;
}

void make_expressible(Frame& frame) {
    frame.arithmetic = {};
    for (Target& target : frame.targets)
        if (!is_whole_bytes(target.format)) target.format = TargetFormat::A8R8G8B8;
    for (Pass& pass : frame.passes) {
        const auto is_copy = [](const Draw& draw) { return std::holds_alternative<CopyRectangle>(draw); };
        if (std::any_of(pass.draws.begin(), pass.draws.end(), is_copy)) continue;  // it has no state
        PipelineState& state  = pass.state;
        state.gs_blend        = {};
        state.dither          = {};
        state.alpha_test.fail = AlphaFail::Keep;
        state.dest_alpha_test = DestAlphaTest::Off;
        for (TextureStage& stage : state.stages)
            for (TextureArg* arg : {&stage.color_arg1, &stage.color_arg2, &stage.alpha_arg1, &stage.alpha_arg2})
                if (arg->source == ArgSource::Specular) arg->source = ArgSource::Diffuse;
        // OpenGL's alpha is a fraction, which is never equal to a byte's 255th (gl_state.cpp).
        CompareFunc& alpha = state.alpha_test.func;
        if (alpha == CompareFunc::Equal) alpha = CompareFunc::LessEqual;
        if (alpha == CompareFunc::NotEqual) alpha = CompareFunc::Greater;
        make_expressible(state.lighting);
        // Mesa does not clamp the sum of the two colours before fog.
        if (state.fog.mode != FogMode::None) state.lighting.specular_enable = false;
        if (projects_from_behind(frame, pass) || projects_by_projective_matrix(frame, pass))
            for (TextureStage& stage : state.stages) stage.coords = CoordSource::Vertex0;
        // How fast coordinates change at a pixel of a triangle, and so the level of detail, is left to the driver.
        if (pass.camera)
            for (TextureStage& stage : state.stages) stage.mip_filter = MipFilter::None;
    }
}

}  // namespace peers
