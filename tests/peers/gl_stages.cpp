// SPDX-License-Identifier: MIT
#include "tests/peers/gl_stages.h"

#include <optional>

#include "tests/peers/gl_names.h"

namespace peers {

using namespace pipeline;

namespace {

// Where arguments a and b of the frame's op go, as indices of OpenGL's; `third` is one more, in terms of the frame.
struct CombineOp {
    GLenum mode;
    float scale = 1.0f;
    int a = 0, b = 1;  // -1: not used
    std::optional<TextureArg> third;
    int third_index = 2;
};

TextureArg alpha_of(ArgSource source) {
    return {.source = source, .complement = false, .alpha_replicate = true};
}

std::optional<CombineOp> combine_op(TextureOp op, const TextureArg& a) {
    switch (op) {
        case TextureOp::Disable:
            break;
        case TextureOp::SelectArg1:
            return CombineOp{.mode = GL_REPLACE, .b = -1};
        case TextureOp::SelectArg2:
            return CombineOp{.mode = GL_REPLACE, .a = -1, .b = 0};
        case TextureOp::Modulate:
            return CombineOp{.mode = GL_MODULATE};
        case TextureOp::Modulate2X:
            return CombineOp{.mode = GL_MODULATE, .scale = 2.0f};
        case TextureOp::Modulate4X:
            return CombineOp{.mode = GL_MODULATE, .scale = 4.0f};
        case TextureOp::Add:
            return CombineOp{.mode = GL_ADD};
        case TextureOp::AddSigned:
            return CombineOp{.mode = GL_ADD_SIGNED};
        case TextureOp::AddSigned2X:
            return CombineOp{.mode = GL_ADD_SIGNED, .scale = 2.0f};
        case TextureOp::Subtract:
            return CombineOp{.mode = GL_SUBTRACT};
        case TextureOp::BlendDiffuseAlpha:
            return CombineOp{.mode = GL_INTERPOLATE, .third = alpha_of(ArgSource::Diffuse)};
        case TextureOp::BlendTextureAlpha:
            return CombineOp{.mode = GL_INTERPOLATE, .third = alpha_of(ArgSource::Texture)};
        case TextureOp::BlendFactorAlpha:
            return CombineOp{.mode = GL_INTERPOLATE, .third = alpha_of(ArgSource::TFactor)};
        case TextureOp::BlendCurrentAlpha:
            return CombineOp{.mode = GL_INTERPOLATE, .third = alpha_of(ArgSource::Current)};
        case TextureOp::ModulateColorAddAlpha: {
            // Arg0 * Arg2 + Arg1
            TextureArg alpha      = a;
            alpha.alpha_replicate = true;
            return CombineOp{.mode = GL_MODULATE_ADD_ATI, .a = 0, .b = 2, .third = alpha, .third_index = 1};
        }
    }
    return std::nullopt;
}

GLenum gl_source(ArgSource source) {
    switch (source) {
        case ArgSource::Diffuse:
            return GL_PRIMARY_COLOR;
        case ArgSource::Current:
            return GL_PREVIOUS;
        case ArgSource::Texture:
            return GL_TEXTURE;
        case ArgSource::TFactor:
            return GL_CONSTANT;
        case ArgSource::Specular:
            break;  // see cannot_express
    }
    return GL_ZERO;
}

enum class Channel { Color, Alpha };

void set_argument(Channel channel, int index, const TextureArg& arg) {
    if (index < 0) return;
    const bool is_alpha     = channel == Channel::Alpha || arg.alpha_replicate;
    const GLenum operand    = is_alpha ? (arg.complement ? GL_ONE_MINUS_SRC_ALPHA : GL_SRC_ALPHA)
                                       : (arg.complement ? GL_ONE_MINUS_SRC_COLOR : GL_SRC_COLOR);
    const int first_source  = channel == Channel::Color ? GL_SOURCE0_RGB : GL_SOURCE0_ALPHA;
    const int first_operand = channel == Channel::Color ? GL_OPERAND0_RGB : GL_OPERAND0_ALPHA;
    glTexEnvi(GL_TEXTURE_ENV, static_cast<GLenum>(first_source + index), static_cast<GLint>(gl_source(arg.source)));
    glTexEnvi(GL_TEXTURE_ENV, static_cast<GLenum>(first_operand + index), static_cast<GLint>(operand));
}

void set_op(Channel channel, TextureOp op, const TextureArg& a, const TextureArg& b) {
    const std::optional<CombineOp> combine = combine_op(op, a);
    if (!combine) return;
    const bool is_color = channel == Channel::Color;
    glTexEnvi(GL_TEXTURE_ENV, is_color ? GL_COMBINE_RGB : GL_COMBINE_ALPHA, static_cast<GLint>(combine->mode));
    glTexEnvf(GL_TEXTURE_ENV, is_color ? GL_RGB_SCALE : GL_ALPHA_SCALE, combine->scale);
    set_argument(channel, combine->a, a);
    set_argument(channel, combine->b, b);
    if (combine->third) set_argument(channel, combine->third_index, *combine->third);
}

GLint minification_filter(const TextureStage& stage, bool has_levels) {
    const bool is_linear = stage.filter == TextureFilter::Linear;
    switch (has_levels ? stage.mip_filter : MipFilter::None) {
        case MipFilter::None:
            return is_linear ? GL_LINEAR : GL_NEAREST;
        case MipFilter::Point:
            return is_linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST;
        case MipFilter::Linear:
            return is_linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR;
    }
    return GL_NEAREST;
}

// A sampler object for each unit: one texture may be bound to both, with other filters and addresses.
void set_sampling(int unit, const TextureStage& stage, const TextureBinding& binding, const GlMemory& memory) {
    glBindTexture(GL_TEXTURE_2D, memory.texture(binding));
    const GLuint sampler = memory.sampler(unit);
    glBindSampler(static_cast<GLuint>(unit), sampler);
    const auto set = [&](GLenum name, GLint value) { glSamplerParameteri(sampler, name, value); };
    set(GL_TEXTURE_MIN_FILTER, minification_filter(stage, static_cast<bool>(binding.texture)));
    set(GL_TEXTURE_MAG_FILTER, stage.filter == TextureFilter::Linear ? GL_LINEAR : GL_NEAREST);
    set(GL_TEXTURE_WRAP_S, static_cast<GLint>(gl_name(stage.address_u)));
    set(GL_TEXTURE_WRAP_T, static_cast<GLint>(gl_name(stage.address_v)));
}

// (u, v) = (x, y) / z of transform * position: s, t and q are planes in camera space, whose z OpenGL has negated. A
// plane is taken through the modelview matrix of the moment.
void set_generated_coords(const TextureStage& stage, bool on) {
    struct Axis {
        GLenum name, enable;
        int row;
    };
    for (const Axis& axis :
         {Axis{GL_S, GL_TEXTURE_GEN_S, 0}, Axis{GL_T, GL_TEXTURE_GEN_T, 1}, Axis{GL_Q, GL_TEXTURE_GEN_Q, 2}}) {
        if (!on) {
            glDisable(axis.enable);
            continue;
        }
        const Mat4& m         = stage.transform;
        const GLfloat plane[] = {m[0][axis.row], m[1][axis.row], -m[2][axis.row], m[3][axis.row]};
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        glTexGeni(axis.name, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
        glTexGenfv(axis.name, GL_EYE_PLANE, plane);
        glEnable(axis.enable);
    }
}

}  // namespace

int set_stages(const PipelineState& state, const TextureBindings& textures, const GlMemory& memory,
               bool are_triangles) {
    const int count = stage_count(state);
    for (int i = 0; i < kTextureStages; ++i) {
        glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + i));
        const TextureStage& stage = state.stages[i];
        set_generated_coords(stage, i < count && are_triangles && stage.coords == CoordSource::CameraPosition);
        if (i >= count) {
            glDisable(GL_TEXTURE_2D);
            continue;
        }
        glEnable(GL_TEXTURE_2D);
        set_sampling(i, stage, textures[i], memory);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
        glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, gl_color(state.texture_factor).data());
        set_op(Channel::Color, stage.color_op, stage.color_arg1, stage.color_arg2);
        set_op(Channel::Alpha, stage.alpha_op, stage.alpha_arg1, stage.alpha_arg2);
    }
    return count;
}

bool has_op(TextureOp op) {
    return op == TextureOp::Disable || combine_op(op, {}).has_value();
}

}  // namespace peers
