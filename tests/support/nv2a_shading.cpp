// SPDX-License-Identifier: MIT
#include "tests/support/nv2a_shading.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace test_support {
namespace {

double clamp(double value, double low, double high) {
    return std::min(std::max(value, low), high);
}

Real4 clamp01(const Real4& c) {
    return {clamp(c.r, 0, 1), clamp(c.g, 0, 1), clamp(c.b, 0, 1), clamp(c.a, 0, 1)};
}

}  // namespace

Nv2aVertex fetch_vertex(const Nv2aRegisters& registers, const Nv2aBytes& memory, std::uint32_t element) {
    const auto attribute = [&](std::uint32_t slot, double* to, std::size_t most) {
        const std::uint32_t format = registers.at(0x1760 + 4 * slot), size = format >> 4 & 15, stride = format >> 8;
        if (size == 0) return;
        const std::uint64_t address = registers.at(0x1720 + 4 * slot) + std::uint64_t{element} * stride;
        if ((format & 15) == 2) {
            for (std::size_t i = 0; i < std::min<std::size_t>(size, most); ++i) to[i] = memory.real(address + 4 * i);
        } else if ((format & 15) == 0 && size == 4) {
            const std::uint32_t argb = memory.word(address);
            to[0]                    = (argb >> 16 & 255) / 255.0;
            to[1]                    = (argb >> 8 & 255) / 255.0;
            to[2]                    = (argb & 255) / 255.0;
            to[3]                    = (argb >> 24) / 255.0;
        } else {
            fail_nv2a("unknown vertex format");
        }
    };
    Nv2aVertex vertex;
    vertex.position[3] = 1.0;
    attribute(0, vertex.position.data(), 4);
    attribute(2, vertex.normal.data(), 3);
    double color[2][4] = {{0, 0, 0, 1}, {0, 0, 0, 1}};
    attribute(3, color[0], 4);
    attribute(4, color[1], 4);
    vertex.diffuse  = {color[0][0], color[0][1], color[0][2], color[0][3]};
    vertex.specular = {color[1][0], color[1][1], color[1][2], color[1][3]};
    for (std::uint32_t unit = 0; unit < 2; ++unit) {
        vertex.coords[unit][3] = 1.0;
        attribute(9 + unit, vertex.coords[unit].data(), 4);
    }
    return vertex;
}

Real4x4 matrix_at(const Nv2aRegisters& registers, std::uint32_t offset) {
    Real4x4 matrix{};
    for (std::uint32_t row = 0; row < 4; ++row)
        for (std::uint32_t column = 0; column < 4; ++column)
            matrix[row][column] = registers.real(offset + 16 * row + 4 * column);
    return matrix;
}

std::array<double, 4> times(const Real4x4& matrix, const std::array<double, 4>& vector) {
    std::array<double, 4> result{};
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) result[row] += matrix[row][column] * vector[column];
    return result;
}

std::array<double, 4> window_of(const Nv2aRegisters& registers, const Nv2aVertex& vertex) {
    std::array<double, 4> window = times(matrix_at(registers, 0x680), vertex.position);
    for (std::size_t i = 0; i < 3; ++i)
        window[i] += registers.real(0xa20 + 4 * static_cast<std::uint32_t>(i)) * window[3];
    return window;
}

namespace {

std::array<double, 4> camera_position(const Nv2aRegisters& registers, const Nv2aVertex& vertex) {
    return times(matrix_at(registers, 0x480), vertex.position);
}

Real4 color_at(const Nv2aRegisters& registers, std::uint32_t offset) {
    return {registers.real(offset), registers.real(offset + 4), registers.real(offset + 8), 0.0};
}

double length(const std::array<double, 3>& v) {
    return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}
std::array<double, 3> unit(std::array<double, 3> v) {
    const double size = length(v);
    if (size > 0.0)
        for (double& x : v) x /= size;
    return v;
}

}  // namespace

std::array<double, 4> coords_of(const Nv2aRegisters& registers, const Nv2aVertex& vertex, std::uint32_t unit_index) {
    std::array<double, 4> coords = vertex.coords[unit_index];
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t gen = registers.at(0x3c0 + 16 * unit_index + 4 * i);
        if (gen == 0) continue;
        if (gen != 0x2400) fail_nv2a("unknown TEXGEN");
        const std::array<double, 4> position = camera_position(registers, vertex);
        coords[i]                            = 0.0;
        for (std::uint32_t j = 0; j < 4; ++j)
            coords[i] += registers.real(0x840 + 64 * unit_index + 16 * i + 4 * j) * position[j];
    }
    if (registers.at(0x420 + 4 * unit_index) == 0) return coords;
    return times(matrix_at(registers, 0x6c0 + 64 * unit_index), coords);
}

// vsh-ff.c: infinite and local lights, materials' colours taken from the registers, no highlights.
Real4 first_color(const Nv2aRegisters& registers, const Nv2aVertex& vertex) {
    if (registers.at(0x314) == 0) return vertex.diffuse;
    const std::uint32_t material = registers.at(0x298);
    if ((material & ~0x30u) != 0) fail_nv2a("unknown COLOR_MATERIAL");
    const std::uint32_t source = material >> 4 & 3;
    const Real4 white{1, 1, 1, registers.real(0x3b4)};
    const Real4& own = source == 0 ? white : source == 1 ? vertex.diffuse : vertex.specular;

    std::array<double, 3> normal{};
    for (std::uint32_t row = 0; row < 3; ++row)
        for (std::uint32_t column = 0; column < 3; ++column)
            normal[row] += registers.real(0x580 + 16 * row + 4 * column) * vertex.normal[column];
    if (registers.at(0x3a4) != 0) normal = unit(normal);
    const std::array<double, 4> at = camera_position(registers, vertex);

    const Real4 scene = color_at(registers, 0xa10), emission = color_at(registers, 0x3a8);
    Real4 sum{scene.r * emission.r + scene.r, scene.g * emission.g + scene.g, scene.b * emission.b + scene.b, own.a};
    for (std::uint32_t i = 0; i < 8; ++i) {
        const std::uint32_t type = registers.at(0x3bc) >> (2 * i) & 3, light = 0x1000 + 128 * i;
        if (type == 0) continue;
        std::array<double, 3> to_light{};
        double attenuation = 1.0;
        const auto real    = [&](std::uint32_t offset) { return static_cast<double>(registers.real(light + offset)); };
        if (type == 1) {
            to_light = unit({real(0x34), real(0x38), real(0x3c)});
        } else if (type == 2) {
            for (std::uint32_t j = 0; j < 3; ++j) to_light[j] = real(0x5c + 4 * j) - at[j] / at[3];
            const double d = length(to_light);
            if (d > real(0x24)) continue;
            to_light    = unit(to_light);
            attenuation = 1.0 / (real(0x68) + real(0x6c) * d + real(0x70) * d * d);
        } else {
            fail_nv2a("a spot light");
        }
        const Real4 ambient = color_at(registers, light), diffuse = color_at(registers, light + 0xc),
                    specular = color_at(registers, light + 0x18);
        if (specular.r != 0 || specular.g != 0 || specular.b != 0) fail_nv2a("a highlight");
        const double facing =
            std::max(0.0, normal[0] * to_light[0] + normal[1] * to_light[1] + normal[2] * to_light[2]);
        sum.r += attenuation * (ambient.r + facing * diffuse.r * own.r);
        sum.g += attenuation * (ambient.g + facing * diffuse.g * own.g);
        sum.b += attenuation * (ambient.b + facing * diffuse.b * own.b);
    }
    return clamp01(sum);
}

Real4 second_color(const Nv2aRegisters& registers, const Nv2aVertex& vertex) {
    if (registers.at(0x3b8) == 0) return {0.0, 0.0, 0.0, 1.0};
    if (registers.at(0x314) != 0) fail_nv2a("highlights of the chip");
    if (registers.at(0x294) != 1) fail_nv2a("the second colour is not kept apart");
    return vertex.specular;
}

double fog_of(const Nv2aRegisters& registers, const Nv2aVertex& vertex) {
    if (registers.at(0x2a4) == 0) return 1.0;
    const std::uint32_t gen = registers.at(0x2a0);
    std::array<double, 4> at{};
    if (gen != 0) at = camera_position(registers, vertex);
    double distance = 0.0;
    switch (gen) {
        case 0:
            distance = vertex.specular.a;
            break;
        case 1:
            distance = length({at[0], at[1], at[2]});
            break;
        case 3:
            distance = registers.real(0x9dc);
            for (std::uint32_t i = 0; i < 3; ++i) distance += registers.real(0x9d0 + 4 * i) * at[i];
            distance = std::abs(distance);
            break;
        default:
            fail_nv2a("unknown FOG_GEN_MODE");
    }
    const double p0 = registers.real(0x9c0), p1 = registers.real(0x9c4);
    switch (registers.at(0x29c)) {
        case 0x2601:
            return clamp(p0 + p1 * distance - 1.0, 0, 1);
        case 0x800:
            return clamp(p0 + std::exp2(16.0 * p1 * distance) - 1.5, 0, 1);
        case 0x801:
            return clamp(p0 + std::exp2(-32.0 * p1 * p1 * distance * distance) - 1.5, 0, 1);
        default:
            fail_nv2a("unknown FOG_MODE");
    }
}

namespace {

struct CombinerRegisters {
    std::array<Real4, 16> values{};
    std::array<bool, 16> is_known{};
};

double channel(const Real4& color, int index) {
    return index == 0 ? color.r : index == 1 ? color.g : index == 2 ? color.b : color.a;
}

// Input byte: mapping, channel, register.
double input(const CombinerRegisters& registers, std::uint32_t byte, int component) {
    const std::uint32_t index = byte & 15;
    if (!registers.is_known[index]) fail_nv2a("unknown combiner register " + std::to_string(index));
    const bool of_alpha = component == 3;
    const int from      = (byte & 16) != 0 ? 3 : of_alpha ? 2 : component;
    const double x      = channel(registers.values[index], from);
    switch (byte >> 5) {
        case 0:
            return std::max(x, 0.0);
        case 1:
            return 1.0 - clamp(x, 0, 1);
        case 2:
            return 2.0 * std::max(x, 0.0) - 1.0;
        case 6:
            return x;
        case 7:
            return -x;
        default:
            fail_nv2a("unknown mapping");
    }
}

double general(const CombinerRegisters& registers, std::uint32_t in, std::uint32_t out, int component) {
    const auto get = [&](int shift) { return input(registers, in >> shift & 255, component); };
    double x       = get(24) * get(16) + get(8) * get(0);
    if ((out & ~0x3ff00u) != 0 || (out >> 8 & 15) != 12 || (out >> 12 & 7) != 0) fail_nv2a("not A B + C D to R0");
    switch (out >> 15) {
        case 0:
            break;
        case 1:
            x -= 0.5;
            break;
        case 2:
            x *= 2.0;
            break;
        case 3:
            x = (x - 0.5) * 2.0;
            break;
        case 4:
            x *= 4.0;
            break;
        default:
            fail_nv2a("unknown output mapping");
    }
    return clamp(x, -1, 1);
}

}  // namespace

Real4 combine(const Nv2aRegisters& registers, const Nv2aInputs& inputs) {
    CombinerRegisters state;
    const auto set = [&](std::size_t index, const Real4& value) {
        state.values[index]   = value;
        state.is_known[index] = true;
    };
    set(0, {});
    set(4, inputs.v0);
    set(5, inputs.v1);
    set(8, inputs.t0);
    set(9, inputs.t1);
    const std::uint32_t control = registers.at(0x1e60), count = control & 255;
    if (count == 0 || count > 8 || control != count) fail_nv2a("unknown COMBINER_CONTROL");
    const std::uint32_t c0 = registers.at(0xa60);
    set(1, {(c0 >> 16 & 255) / 255.0, (c0 >> 8 & 255) / 255.0, (c0 & 255) / 255.0, (c0 >> 24) / 255.0});
    for (std::uint32_t i = 0; i < count; ++i) {
        double out[4];
        for (int component = 0; component < 4; ++component)
            out[component] = component < 3
                                 ? general(state, registers.at(0xac0 + 4 * i), registers.at(0x1e40 + 4 * i), component)
                                 : general(state, registers.at(0x260 + 4 * i), registers.at(0xaa0 + 4 * i), component);
        set(12, {out[0], out[1], out[2], out[3]});
    }
    if (registers.at(0x2a4) != 0) {
        const std::uint32_t fog = registers.at(0x2a8);
        set(3, {(fog & 255) / 255.0, (fog >> 8 & 255) / 255.0, (fog >> 16 & 255) / 255.0, inputs.fog});
    }
    const std::uint32_t abcd = registers.at(0x288), efg = registers.at(0x28c);
    const auto color = [&](int component) {
        const auto get = [&](int shift) { return input(state, abcd >> shift & 255, component); };
        return get(0) + get(24) * get(16) + (1.0 - get(24)) * get(8);
    };
    return clamp01({color(0), color(1), color(2), input(state, efg >> 8 & 255, 3)});
}

}  // namespace test_support
