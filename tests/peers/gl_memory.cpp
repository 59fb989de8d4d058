// SPDX-License-Identifier: MIT
#include "tests/peers/gl_memory.h"

#include <algorithm>
#include <stdexcept>

namespace peers {

using namespace pipeline;

namespace {

GLenum color_format(TargetFormat format) {
    return format == TargetFormat::X8R8G8B8 ? GL_RGB8 : GL_RGBA8;
}

GLenum depth_format(TargetFormat format) {
    switch (format) {
        case TargetFormat::D16:
            return GL_DEPTH_COMPONENT16;
        case TargetFormat::D24:
            return GL_DEPTH_COMPONENT24;
        default:
            return GL_DEPTH_COMPONENT32;
    }
}

struct TexelLayout {
    GLenum internal, format, type;
};
TexelLayout layout_of(TextureFormat format) {
    switch (format) {
        case TextureFormat::A8:
            return {GL_ALPHA8, GL_ALPHA, GL_UNSIGNED_BYTE};
        case TextureFormat::L8:
            return {GL_LUMINANCE8, GL_LUMINANCE, GL_UNSIGNED_BYTE};
        case TextureFormat::A8R8G8B8:
            break;
    }
    return {GL_RGBA8, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV};
}

GLuint new_texture(int levels) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, levels - 1);
    return name;
}

}  // namespace

GlMemory::GlMemory(const Frame& frame) : frame_(frame) {
    glActiveTexture(GL_TEXTURE0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (const Target& target : frame.targets) make_target(target);
    for (const Texture& texture : frame.textures) make_texture(texture);
    white_                    = new_texture(1);
    const std::uint32_t white = 0xffffffff;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, &white);
    glGenSamplers(kTextureStages, samplers_.data());
    clear_targets();
}

GlMemory::~GlMemory() {
    for (const auto& [targets, framebuffer] : framebuffers_) glDeleteFramebuffers(1, &framebuffer);
    for (std::size_t i = 0; i < targets_.size(); ++i) {
        if (is_depth(frame_.targets[i].format))
            glDeleteRenderbuffers(1, &targets_[i]);
        else
            glDeleteTextures(1, &targets_[i]);
    }
    glDeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
    glDeleteTextures(1, &white_);
    glDeleteSamplers(kTextureStages, samplers_.data());
}

void GlMemory::make_target(const Target& target) {
    GLuint name = 0;
    if (is_depth(target.format)) {
        glGenRenderbuffers(1, &name);
        glBindRenderbuffer(GL_RENDERBUFFER, name);
        glRenderbufferStorage(GL_RENDERBUFFER, depth_format(target.format), target.width, target.height);
    } else {
        name = new_texture(1);
        glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(color_format(target.format)), target.width, target.height, 0,
                     GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, nullptr);
    }
    targets_.push_back(name);
}

void GlMemory::make_texture(const Texture& texture) {
    textures_.push_back(new_texture(texture.levels));
    const TexelLayout layout   = layout_of(texture.format);
    const std::uint8_t* texels = texture.texels.data();
    for (int level = 0; level < texture.levels; ++level) {
        const int width = std::max(1, texture.width >> level), height = std::max(1, texture.height >> level);
        glTexImage2D(GL_TEXTURE_2D, level, static_cast<GLint>(layout.internal), width, height, 0, layout.format,
                     layout.type, texels);
        texels += static_cast<std::ptrdiff_t>(width) * height * bytes_per_texel(texture.format);
    }
}

void GlMemory::clear_targets() {
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClearDepth(0.0);
    for (std::size_t i = 0; i < targets_.size(); ++i) {
        const TargetId id{static_cast<std::int32_t>(i)};
        if (is_depth(frame_.targets[i].format)) {
            bind({}, id);
            glClear(GL_DEPTH_BUFFER_BIT);
        } else {
            bind(id, {});
            glClear(GL_COLOR_BUFFER_BIT);
        }
    }
}

GLuint GlMemory::texture(const TextureBinding& binding) const {
    if (binding.target) return targets_[binding.target.index];
    if (binding.texture) return textures_[binding.texture.index];
    return white_;
}

void GlMemory::bind(TargetId color, TargetId depth) {
    GLuint& framebuffer = framebuffers_[{color.index, depth.index}];
    const bool is_new   = framebuffer == 0;
    if (is_new) glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    if (!is_new) return;
    if (color) {
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, targets_[color.index], 0);
    } else {
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
    }
    if (depth) glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, targets_[depth.index]);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("OpenGL refuses a framebuffer");
}

// Without a format in between: the target takes the other's bytes.
void GlMemory::copy(const CopyRectangle& draw, TargetId into) {
    const PixelRect& from = draw.from;
    bind(draw.source, {});
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, targets_[into.index]);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, draw.x, draw.y, from.x0, from.y0, from.x1 - from.x0, from.y1 - from.y0);
    bind(into, {});
}

ColorImage GlMemory::read(TargetId color) {
    const Target& target = frame_.targets[color.index];
    bind(color, {});
    ColorImage picture{target.width, target.height, {}};
    picture.pixels.resize(static_cast<std::size_t>(target.width) * static_cast<std::size_t>(target.height));
    glReadPixels(0, 0, target.width, target.height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, picture.pixels.data());
    return picture;
}

void GlMemory::write(TargetId color, const ColorImage& picture) {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, targets_[color.index]);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, picture.width, picture.height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                    picture.pixels.data());
}

}  // namespace peers
