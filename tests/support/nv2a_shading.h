// SPDX-License-Identifier: MIT
// What the NV2A does with its registers (nv2a_state.h), in real numbers, as xemu's hw/xbox/nv2a/pgraph has it: vertices fetched,
// placed and lit, and fragments combined.
#pragma once

#include <array>
#include <cstdint>

#include "tests/support/nv2a_state.h"

namespace test_support {

struct Real4 {
    double r = 0.0, g = 0.0, b = 0.0, a = 0.0;
};

struct Nv2aVertex {
    std::array<double, 4> position{};
    std::array<double, 3> normal{};
    Real4 diffuse{0.0, 0.0, 0.0, 1.0}, specular{0.0, 0.0, 0.0, 1.0};
    std::array<std::array<double, 4>, 2> coords{};
};
Nv2aVertex fetch_vertex(const Nv2aRegisters& registers, const Nv2aBytes& memory, std::uint32_t element);

using Real4x4 = std::array<std::array<double, 4>, 4>;
Real4x4 matrix_at(const Nv2aRegisters& registers, std::uint32_t offset);
std::array<double, 4> times(const Real4x4& matrix, const std::array<double, 4>& vector);

// Window x, y, z times w, and w.
std::array<double, 4> window_of(const Nv2aRegisters& registers, const Nv2aVertex& vertex);
// s, t, r, q.
std::array<double, 4> coords_of(const Nv2aRegisters& registers, const Nv2aVertex& vertex, std::uint32_t unit);
// Clamped.
Real4 first_color(const Nv2aRegisters& registers, const Nv2aVertex& vertex);
Real4 second_color(const Nv2aRegisters& registers, const Nv2aVertex& vertex);
double fog_of(const Nv2aRegisters& registers, const Nv2aVertex& vertex);

// The fragment's colour after the final combiner, clamped.
struct Nv2aInputs {
    Real4 v0, v1, t0, t1;
    double fog = 1.0;
};
Real4 combine(const Nv2aRegisters& registers, const Nv2aInputs& inputs);

}  // namespace test_support
