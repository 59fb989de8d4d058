// SPDX-License-Identifier: MIT
#include "tests/peers/gl_names.h"

namespace peers {

using namespace pipeline;

GLenum gl_name(CompareFunc func) {
    switch (func) {
        case CompareFunc::Always:
            return GL_ALWAYS;
        case CompareFunc::LessEqual:
            return GL_LEQUAL;
        case CompareFunc::Less:
            return GL_LESS;
        case CompareFunc::GreaterEqual:
            return GL_GEQUAL;
        case CompareFunc::Greater:
            return GL_GREATER;
        case CompareFunc::Equal:
            return GL_EQUAL;
        case CompareFunc::NotEqual:
            return GL_NOTEQUAL;
        case CompareFunc::Never:
            return GL_NEVER;
    }
    return GL_ALWAYS;
}

GLenum gl_name(BlendFactor factor) {
    switch (factor) {
        case BlendFactor::Zero:
            return GL_ZERO;
        case BlendFactor::One:
            return GL_ONE;
        case BlendFactor::SourceColor:
            return GL_SRC_COLOR;
        case BlendFactor::InvSourceColor:
            return GL_ONE_MINUS_SRC_COLOR;
        case BlendFactor::DestColor:
            return GL_DST_COLOR;
        case BlendFactor::InvDestColor:
            return GL_ONE_MINUS_DST_COLOR;
        case BlendFactor::SourceAlpha:
            return GL_SRC_ALPHA;
        case BlendFactor::InvSourceAlpha:
            return GL_ONE_MINUS_SRC_ALPHA;
        case BlendFactor::DestAlpha:
            return GL_DST_ALPHA;
        case BlendFactor::InvDestAlpha:
            return GL_ONE_MINUS_DST_ALPHA;
    }
    return GL_ONE;
}

GLenum gl_name(TextureAddress address) {
    switch (address) {
        case TextureAddress::Wrap:
            return GL_REPEAT;
        case TextureAddress::Clamp:
            return GL_CLAMP_TO_EDGE;
        case TextureAddress::Mirror:
            return GL_MIRRORED_REPEAT;
    }
    return GL_REPEAT;
}

std::array<float, 4> gl_color(Argb color) {
    const auto channel = [&](int shift) { return static_cast<float>(color.value >> shift & 255) / 255.0f; };
    return {channel(16), channel(8), channel(0), channel(24)};
}

}  // namespace peers
