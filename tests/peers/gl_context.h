// SPDX-License-Identifier: MIT
// An OpenGL context without a window or a surface, on one of Mesa's two software drivers: llvmpipe compiles shaders
// to machine code, softpipe interprets them, and they share no rasterizer. The driver is chosen through Mesa's
// environment variables, which it reads once: one driver in a process. llvmpipe has fast paths that filter in 8 bits
// instead of in float (off by as much as 2 of 255) and compute one level of detail for each 2x2 pixels: pictures are
// compared without them, times with them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace peers {

enum class Driver { Llvmpipe, Softpipe };
std::string_view driver_name(Driver driver);
std::optional<Driver> find_driver(std::string_view name);

enum class FastPaths { Off, On };

// Of the current context.
bool is_driver(Driver driver);

class GlContext {
  public:
    // Current on the calling thread until it is destroyed. Throws std::runtime_error if Mesa does not give that
    // driver.
    explicit GlContext(Driver driver, FastPaths fast_paths = FastPaths::Off);
    ~GlContext();
    GlContext(const GlContext&)            = delete;
    GlContext& operator=(const GlContext&) = delete;

    // As OpenGL names itself: driver, compiler, Mesa's version.
    std::string description() const;

  private:
    void* display_ = nullptr;
    void* context_ = nullptr;
};

}  // namespace peers
