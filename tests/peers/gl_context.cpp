// SPDX-License-Identifier: MIT
#include "tests/peers/gl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdlib>
#include <stdexcept>

#include "tests/peers/gl.h"

namespace peers {
namespace {

void choose(Driver driver, FastPaths fast_paths) {
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("GALLIUM_DRIVER", std::string(driver_name(driver)).c_str(), 1);
    if (fast_paths == FastPaths::On)
        unsetenv("GALLIVM_PERF");
    else
        setenv("GALLIVM_PERF", "no_aos_sampling,no_quad_lod", 1);
}

std::string gl_string(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "";
}

}  // namespace

std::string_view driver_name(Driver driver) {
    switch (driver) {
        case Driver::Llvmpipe:
            return "llvmpipe";
        case Driver::Softpipe:
            return "softpipe";
    }
    return "";
}

std::optional<Driver> find_driver(std::string_view name) {
    for (const Driver driver : {Driver::Llvmpipe, Driver::Softpipe})
        if (driver_name(driver) == name) return driver;
    return std::nullopt;
}

bool is_driver(Driver driver) {
    return gl_string(GL_RENDERER).find(driver_name(driver)) != std::string::npos;
}

GlContext::GlContext(Driver driver, FastPaths fast_paths) {
    choose(driver, fast_paths);
    const auto get_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_display == nullptr) throw std::runtime_error("EGL cannot choose a platform");
    display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr))
        throw std::runtime_error("EGL has no surfaceless platform");
    eglBindAPI(EGL_OPENGL_API);
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
    if (context_ == EGL_NO_CONTEXT || !eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
        throw std::runtime_error("EGL gives no OpenGL context");
    if (!is_driver(driver))
        throw std::runtime_error("the driver is '" + description() + "' in place of " +
                                 std::string(driver_name(driver)));
}

GlContext::~GlContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
}

std::string GlContext::description() const {
    return gl_string(GL_RENDERER) + ", OpenGL " + gl_string(GL_VERSION);
}

}  // namespace peers
