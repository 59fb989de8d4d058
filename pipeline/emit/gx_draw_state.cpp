// SPDX-License-Identifier: MIT
// The state of one draw: its space, fog, texture stages, coordinates, colour channels and textures.
#include <algorithm>
#include <cmath>

#include "pipeline/emit/gx_names.h"
#include "pipeline/emit/gx_passes.h"

namespace pipeline {

namespace {

template <std::size_t rows>
void emit_matrix(std::string_view type_and_name, const std::array<std::array<float, 4>, rows>& matrix, CText& text) {
    text.open(std::string(type_and_name) + " = {");
    for (const auto& row : matrix)
        text.line("{ " + c_float(row[0]) + ", " + c_float(row[1]) + ", " + c_float(row[2]) + ", " + c_float(row[3]) +
                  " },");
    text.close("};");
}

std::string numbered(std::string_view prefix, std::size_t number) {
    return std::string(prefix) + std::to_string(number);
}

constexpr std::string_view kNoFog = "GX_SetFog(GX_FOG_NONE, 0.0f, 1.0f, 0.1f, 1.0f, (GXColor){ 0, 0, 0, 0 });";

// Of the chip's own fog, with F = (d - start) / (end - start) in 0..1 the share of fog is F, 1 - 2^(-8 F) or 1 - 2^(-8 F^2):
// exp(-density d) has end = 8 ln 2 / density, exp(-(density d)^2) has end = sqrt(8 ln 2) / density.
struct FogCurve {
    std::string_view name;
    float start, end;
};
std::optional<FogCurve> chip_fog(const FogState& fog) {
    constexpr double k8Ln2 = 5.545177444479562;
    switch (fog.mode) {
        case FogMode::None:
            break;
        case FogMode::Linear:
            if (fog.start == fog.end) break;
            return FogCurve{"LIN", fog.start, fog.end};
        case FogMode::Exp:
            if (!(fog.density > 0.0f)) break;
            return FogCurve{"EXP", 0.0f, static_cast<float>(k8Ln2 / fog.density)};
        case FogMode::Exp2:
            if (!(fog.density > 0.0f)) break;
            return FogCurve{"EXP2", 0.0f, static_cast<float>(std::sqrt(k8Ln2) / fog.density)};
    }
    return {};
}

std::string stage_name(std::size_t index) {
    return numbered("GX_TEVSTAGE", index);
}

void emit_unit(std::string_view half, const std::string& stage, const TevUnit& unit, CText& text) {
    const std::string prefix = "GX_SetTev" + std::string(half);
    text.call(prefix + "In", {stage, unit.a, unit.b, unit.c, unit.d});
    text.call(prefix + "Op", {stage, unit.op, unit.bias, unit.scale, "GX_TRUE", unit.out});
}

}  // namespace

GxDraws::Fog GxDraws::fog_of(const GxTransform& transform) const {
    const FogState& fog = pass_.state.fog;
    if (fog.mode == FogMode::None) return {false, std::string(kNoFog)};
    const std::optional<FogCurve> curve = chip_fog(fog);
    if (fog.range || !curve || !transform.fog_range) return {true, std::string(kNoFog)};
    const std::string type =
        (transform.projection.is_perspective ? "GX_FOG_PERSP_" : "GX_FOG_ORTHO_") + std::string(curve->name);
    CText call;
    call.call("GX_SetFog", {type, c_float(curve->start), c_float(curve->end), c_float(transform.fog_range->near),
                            c_float(transform.fog_range->far), c_color(fog.color)});
    std::string text = call.take();
    text.pop_back();
    return {false, text};
}

void GxDraws::space_of_triangles(const DrawTriangles& draw, const GxTransform& transform, const Fog& fog) {
    CText space;
    space.call("GX_SetViewport", {c_float(static_cast<float>(spot_.x + viewport_.x0)),
                                  c_float(static_cast<float>(spot_.y + viewport_.y0)),
                                  c_float(static_cast<float>(viewport_.x1 - viewport_.x0)),
                                  c_float(static_cast<float>(viewport_.y1 - viewport_.y0)), "0.0f", "1.0f"});
    space.open("{");
    emit_matrix("Mtx44 projection", gx_rows(transform.projection), space);
    emit_matrix("Mtx position", transform.position, space);
    space.call("GX_LoadProjectionMtx",
               {"projection", transform.projection.is_perspective ? "GX_PERSPECTIVE" : "GX_ORTHOGRAPHIC"});
    space.call("GX_LoadPosMtxImm", {"position", "GX_PNMTX0"});
    space.close();
    for (std::size_t i = 0; i < kTextureStages; ++i) {
        const TextureStage& stage = pass_.state.stages[i];
        if (stage.coords != CoordSource::CameraPosition || !reads_texture(pass_.state, static_cast<int>(i))) continue;
        const Camera& camera = gx_.frame.cameras[static_cast<std::size_t>(pass_.camera.index)];
        space.open("{");
        emit_matrix("Mtx texture", gx_texture_matrix(camera, draw.world, stage.transform), space);
        space.call("GX_LoadTexMtxImm", {"texture", numbered("GX_TEXMTX", i), "GX_MTX3x4"});
        space.close();
    }
    space.call("GX_SetCullMode", {gx_cull(pass_.state.cull)});
    space.line(fog.call);
    write(last_space_, space);
}

void GxDraws::space_of_rectangle() {
    CText space;
    space.call("window_space", {c_int(spot_.x), c_int(spot_.y), c_int(target_.width), c_int(target_.height)});
    space.call("GX_SetCullMode", {"GX_CULL_NONE"});
    space.line(kNoFog);
    write(last_space_, space);
}

void GxDraws::stages(const TevProgram& program, const TextureBindings& textures) {
    CText tev;
    tev.call("GX_SetNumTevStages", {c_int(static_cast<std::int64_t>(program.stages.size()))});
    std::array<std::size_t, kTextureStages> slot{};
    slot[1] = program.reads(0) ? 1 : 0;
    for (std::size_t i = 0; i < program.stages.size(); ++i) {
        const TevStage& stage  = program.stages[i];
        const std::string name = stage_name(i);
        const bool has_texture = stage.texture >= 0;
        const auto texture     = static_cast<std::size_t>(std::max(stage.texture, 0));
        tev.comment(stage.what);
        tev.call("GX_SetTevOrder", {name, has_texture ? numbered("GX_TEXCOORD", slot[texture]) : "GX_TEXCOORDNULL",
                                    has_texture ? numbered("GX_TEXMAP", texture) : "GX_TEXMAP_NULL", stage.rasterized});
        emit_unit("Color", name, stage.color, tev);
        emit_unit("Alpha", name, stage.alpha, tev);
    }
    write(last_stages_, tev);
    for (std::size_t i = 0; i < textures.size(); ++i) {
        if (!program.reads(static_cast<int>(i))) continue;
        const TextureStage& stage = pass_.state.stages[i];
        const Texture* texture    = find_texture(gx_.frame, textures[i].texture);
        const Target* target      = find_target(gx_.frame, textures[i].target);
        const bool has_mips       = texture != nullptr && texture->levels > 1 && stage.mip_filter != MipFilter::None;
        const MipFilter mips      = has_mips ? stage.mip_filter : MipFilter::None;
        CText bind;
        bind.comment(texture != nullptr ? "'" + texture->name + "'" : "copies in '" + target->name + "'");
        bind.call(
            "bind_texture",
            {numbered("GX_TEXMAP", i),
             texture != nullptr
                 ? "data_at(" + std::to_string(gx_.texels[static_cast<std::size_t>(textures[i].texture.index)]) + "u)"
                 : gx_target_name(static_cast<std::size_t>(textures[i].target.index)),
             c_int(texture != nullptr ? texture->width : target->width),
             c_int(texture != nullptr ? texture->height : target->height),
             texture != nullptr && texture->format != TextureFormat::A8R8G8B8 ? "GX_TF_I8" : "GX_TF_RGBA8",
             gx_wrap(stage.address_u), gx_wrap(stage.address_v), c_int(has_mips ? texture->levels : 1),
             gx_min_filter(stage.filter, mips), gx_mag_filter(stage.filter)});
        write(last_textures_[i], bind);
    }
}

// draw: null for a rectangle, which brings a pair for each stage that reads a texture.
void GxDraws::coordinates(const TevProgram& program, const DrawTriangles* draw) {
    CText text;
    const std::vector<int> sets = uv_sets(program);
    std::size_t slot            = 0;
    CText generators;
    for (std::size_t i = 0; i < kTextureStages; ++i) {
        if (!program.reads(static_cast<int>(i))) continue;
        const CoordSource coords = pass_.state.stages[i].coords;
        const std::string coord  = numbered("GX_TEXCOORD", slot);
        if (draw != nullptr && coords == CoordSource::CameraPosition) {
            generators.call("GX_SetTexCoordGen", {coord, "GX_TG_MTX3x4", "GX_TG_POS", numbered("GX_TEXMTX", i)});
        } else {
            const int set     = coords == CoordSource::Vertex0 ? 0 : 1;
            const auto source = draw == nullptr
                                    ? slot
                                    : static_cast<std::size_t>(std::find(sets.begin(), sets.end(), set) - sets.begin());
            generators.call("GX_SetTexCoordGen", {coord, "GX_TG_MTX2x4", numbered("GX_TG_TEX", source), "GX_IDENTITY"});
        }
        ++slot;
    }
    text.call("GX_SetNumTexGens", {c_int(static_cast<std::int64_t>(slot))});
    const std::string calls = generators.take();
    for (std::size_t at = 0, end = 0; at < calls.size(); at = end + 1) {
        end = calls.find('\n', at);
        text.line(std::string_view(calls).substr(at, end - at));
    }
    write(last_coordinates_, text);
}

void GxDraws::channels(bool has_second, const GxLighting* lighting) {
    CText text;
    text.call("GX_SetNumChans", {has_second ? "2" : "1"});
    if (lighting == nullptr) {
        text.call("GX_SetChanCtrl", {"GX_COLOR0A0", "GX_DISABLE", "GX_SRC_REG", "GX_SRC_VTX", "GX_LIGHTNULL",
                                     "GX_DF_NONE", "GX_AF_NONE"});
    } else {
        std::string lights;
        for (std::size_t i = 0; i < lighting->lights.size(); ++i)
            lights += (i > 0 ? " | " : "") + numbered("GX_LIGHT", i);
        text.open("{");
        emit_matrix("Mtx normal", lighting->normal, text);
        text.call("GX_LoadNrmMtxImm", {"normal", "GX_PNMTX0"});
        text.close();
        for (std::size_t i = 0; i < lighting->lights.size(); ++i) {
            const GxLight& light = lighting->lights[i];
            text.call("load_light", {numbered("GX_LIGHT", i), c_float(light.position.x), c_float(light.position.y),
                                     c_float(light.position.z), c_color(light.color), c_float(light.k.x),
                                     c_float(light.k.y), c_float(light.k.z)});
        }
        text.call("GX_SetChanAmbColor", {"GX_COLOR0A0", c_color(lighting->ambient)});
        text.call("GX_SetChanMatColor", {"GX_COLOR0A0", c_color(lighting->material)});
        text.call("GX_SetChanCtrl",
                  {"GX_COLOR0", "GX_ENABLE", "GX_SRC_REG", lighting->material_from_vertex ? "GX_SRC_VTX" : "GX_SRC_REG",
                   lights.empty() ? "GX_LIGHTNULL" : lights, "GX_DF_CLAMP", "GX_AF_SPOT"});
        text.call("GX_SetChanCtrl",
                  {"GX_ALPHA0", "GX_DISABLE", "GX_SRC_REG", lighting->alpha_from_vertex ? "GX_SRC_VTX" : "GX_SRC_REG",
                   "GX_LIGHTNULL", "GX_DF_NONE", "GX_AF_NONE"});
    }
    if (has_second)
        text.call("GX_SetChanCtrl", {"GX_COLOR1A1", "GX_DISABLE", "GX_SRC_REG", "GX_SRC_VTX", "GX_LIGHTNULL",
                                     "GX_DF_NONE", "GX_AF_NONE"});
    write(last_channels_, text);
}

}  // namespace pipeline
