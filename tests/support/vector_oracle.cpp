// SPDX-License-Identifier: MIT
#include "tests/support/vector_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace test_support {
namespace {

using Place = VectorPlace;

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

int byte(int value) {
    return std::clamp(value, 0, 255);
}

// The greatest whole number not above numerator / denominator.
int floored(int numerator, int denominator) {
    int quotient = numerator / denominator;
    if (quotient * denominator > numerator) --quotient;
    return quotient;
}
// Half up.
int nearest(int numerator, int denominator) {
    return floored(2 * numerator + denominator, 2 * denominator);
}

int of(const Place& at, const std::string& axis) {
    const auto found = at.number.find(axis);
    if (found == at.number.end()) throw std::runtime_error("no axis " + axis);
    return found->second;
}
int of(const Place& at, const std::string& axis, int otherwise) {
    const auto found = at.number.find(axis);
    return found == at.number.end() ? otherwise : found->second;
}

// Bits of red, green, blue, alpha; whether zeros follow them; what a channel without bits reads as.
struct Format {
    std::string name;
    std::array<int, 4> bits;
    bool zeros  = false;
    int missing = 255;
};
const std::vector<Format> kFormats{
    {"A8R8G8B8", {8, 8, 8, 8}},           {"X8R8G8B8", {8, 8, 8, 0}},           {"R5G6B5", {5, 6, 5, 0}},
    {"A1R5G5B5", {5, 5, 5, 1}},           {"R6G6B6A6", {6, 6, 6, 6}},           {"PSMCT32", {8, 8, 8, 8}},
    {"PSMCT24", {8, 8, 8, 0}, true, 128}, {"PSMCT16", {5, 5, 5, 1}, true, 128},
};

const Format& format_in(const std::string& text) {
    const auto found = std::find_if(kFormats.begin(), kFormats.end(),
                                    [&](const Format& format) { return contains(text, format.name); });
    if (found == kFormats.end()) throw std::runtime_error("no format in '" + text + "'");
    return *found;
}

int kept(int value, int bits) {
    return floored(value, 1 << (8 - bits));
}

int stored(int value, const Format& format, int channel) {
    const int bits = format.bits[static_cast<std::size_t>(channel)];
    if (bits == 0) return format.missing;
    if (format.zeros) return kept(value, bits) * (1 << (8 - bits));
    // The bits, from the highest on, over and over.
    int read = 0;
    for (int i = 0; i < 8; ++i) read = 2 * read + kept(value, bits) / (1 << (bits - 1 - i % bits)) % 2;
    return read;
}

// 0..255 to 0..256.
int widened(int value) {
    return value < 128 ? value : value + 1;
}

int factor(const std::string& name, int s, int d, int sa, int da) {
    if (name == "zero") return 0;
    if (name == "one") return 255;
    if (name.starts_with("inv")) return 255 - factor(name.substr(3), s, d, sa, da);
    if (name == "srccolor") return s;
    if (name == "destcolor") return d;
    if (name == "srcalpha") return sa;
    if (name == "destalpha") return da;
    throw std::runtime_error("no factor " + name);
}

int factor_blend(const std::string& name, const std::string& rule, const std::string& what, const Place& at) {
    // blend_SOURCE_DEST_...
    const std::size_t first = name.find('_') + 1, second = name.find('_', first) + 1;
    const std::string source = name.substr(first, second - 1 - first),
                      dest   = name.substr(second, name.find('_', second) - second);
    const bool is_alpha      = contains(name, "_alpha");
    const int channel        = is_alpha ? 3 : contains(name, "_green") ? 1 : 0;
    const Format& format     = format_in(what);

    int s        = of(at, at.number.contains("source_s") ? "source_s" : "source_alpha_s");
    const int d  = of(at, is_alpha ? "destination_alpha_d" : "destination_d");
    const int sa = of(at, "source_alpha_a", s), da = of(at, "destination_alpha_a", d);
    if (contains(rule, "TARGET_BITS") && !is_alpha) {
        const int step = 1 << (8 - format.bits[static_cast<std::size_t>(channel)]);
        s              = s / step * step;
    }
    const int fs = factor(source, s, d, sa, da), fd = factor(dest, s, d, sa, da);
    const int blended =
        contains(rule, "NEAREST255") ? nearest(s * fs + d * fd, 255) : floored(s * widened(fs) + d * widened(fd), 256);
    return stored(byte(blended), format, channel);
}

int gs_blend(const std::string& name, const std::string& what, const Place& at) {
    const Format& format = format_in(what);
    if (contains(name, "_alpha")) {
        const int s = of(at, "source_alpha_s");
        return stored(contains(name, "_fba") ? s % 128 + 128 : s, format, 3);
    }
    const int alpha_byte = std::stoi(name.substr(6, 2), nullptr, 16);
    const int s = of(at, "source_s", 0), d = of(at, "destination_d", 0);
    int c = of(at, "source_alpha_c", -1);
    if (c < 0) c = of(at, "destination_alpha_c", -1);
    if (c < 0) c = of(at, "fix_c", format.missing);
    const auto operand = [&](int place) {
        const int code = alpha_byte / place % 4;
        return code == 0 ? s : code == 1 ? d : 0;
    };
    int blended = floored((operand(1) - operand(4)) * c, 128) + operand(64);
    if (contains(what, "PABE 1") && c < 128) blended = s;
    blended = contains(what, "COLCLAMP 0") ? (blended % 256 + 256) % 256 : byte(blended);
    return stored(blended, format, 0);
}

int channel_number(const Place& at) {
    const std::vector<std::string> names{"red", "green", "blue", "alpha"};
    return static_cast<int>(std::find(names.begin(), names.end(), at.text.at("channel")) - names.begin());
}

int store(const std::string& name, const std::string& what, const Place& at) {
    const Format& format = format_in(what);
    const int channel    = channel_number(at);
    int value            = of(at, "value");
    if (!contains(name, "_dither") || channel == 3) return stored(value, format, channel);
    const int x = of(at, "x"), y = of(at, "y");
    if (format.name == "R6G6B6A6") {
        const int offsets[2][2] = {{0, 2}, {3, 1}};
        return stored(byte(value - value / 64 + offsets[y][x]), format, channel);
    }
    // The matrix stands in the description.
    const std::string start = "row by row, ";
    std::string numbers     = what.substr(what.find(start) + start.size());
    int offset              = 0;
    for (int i = 0; i <= 4 * y + x; ++i) {
        std::size_t end = 0;
        offset          = std::stoi(numbers, &end);
        numbers         = numbers.substr(end);
    }
    value += offset;
    return stored(contains(what, "COLCLAMP 0") ? (value + 256) % 256 : byte(value), format, channel);
}

int texture_function(const std::string& name, const std::string& rule, const Place& at) {
    const std::string op = name.substr(8);
    const bool is_lerp   = op == "blenddiffusealpha";
    const bool is_alpha  = at.number.contains("vertex_alpha_a");
    const int a          = of(at, is_lerp    ? "texel_a"
                                  : is_alpha ? "vertex_alpha_a"
                                             : "vertex_color_a"),
              b          = of(at, is_lerp    ? "vertex_color_b"
                                  : is_alpha ? "texel_alpha_b"
                                             : "texel_b"),
              x          = of(at, "vertex_alpha_x", 0);
    const bool tev = rule == "TEV", gs = rule == "GS_SHIFT7";
    const auto product = [&](int k) {
        return tev ? nearest(k * a * widened(b), 256) : gs ? floored(k * a * b, 128) : nearest(k * a * b, 255);
    };
    if (op == "selectarg1") return a;
    if (op == "modulate") return byte(product(1));
    if (op == "modulate2x") return byte(product(2));
    if (op == "modulate4x") return byte(product(4));
    if (op == "add") return byte(a + b);
    if (op == "subtract") return byte(a - b);
    // One half of 255 is 127.5, of the TEV's 256 it is 128.
    if (op == "addsigned") return byte(tev ? a + b - 128 : nearest(2 * a + 2 * b - 255, 2));
    if (op == "addsigned2x") return byte(2 * a + 2 * b - (tev ? 256 : 255));
    if (op == "modulatecolor_addalpha") return byte(product(1) + x);
    if (is_lerp)
        return tev ? nearest(a * widened(x) + b * (256 - widened(x)), 256) : nearest(a * x + b * (255 - x), 255);
    throw std::runtime_error("no texture function " + op);
}

// Texels t00 t10 t01 t11.
int filter(const std::string& rule, const std::array<int, 4>& t, int fu, int fv) {
    const auto exact = [&](int one, int u, int v) {
        return (one - v) * ((one - u) * t[0] + u * t[1]) + v * ((one - u) * t[2] + u * t[3]);
    };
    if (rule == "REFERENCE8") return nearest(exact(256, fu, fv), 256 * 256);
    if (rule == "GS_NEAREST4") return nearest(exact(16, fu / 16, fv / 16), 16 * 16);
    if (rule == "FLIPPER_FLOOR7") return floored(exact(128, fu / 2, fv / 2), 128 * 128);
    if (rule == "GS_FLOOR4") {
        const auto lerp = [](int a, int b, int f) { return a + floored((b - a) * f, 16); };
        return lerp(lerp(t[0], t[1], fu / 16), lerp(t[2], t[3], fu / 16), fv / 16);
    }
    if (rule == "NV2A_HALFUP8") {
        const auto lerp = [](int a, int b, int f) { return nearest(a * (256 - f) + b * f, 256); };
        return lerp(lerp(t[0], t[1], fu), lerp(t[2], t[3], fu), fv);
    }
    throw std::runtime_error("no filter " + rule);
}

int fog(const std::string& rule, const Place& at) {
    const int k = of(at, "fog_color_k"), f = of(at, "factor_f"), c = of(at, "color_c");
    if (rule == "NEAREST255") return nearest(f * c + (255 - f) * k, 255);
    if (rule == "GS_FLOOR256") return floored(f * c + (256 - f) * k, 256);
    if (rule == "GS_TWO_FLOORS") return floored(f * c, 256) + floored((255 - f) * k, 256);
    const int expanded = f < 128 ? f : f + 1;
    if (rule == "FLIPPER_FLOOR256") return floored(expanded * c + (256 - expanded) * k, 256);
    throw std::runtime_error("no fog " + rule);
}

template <class T>
bool passes(const std::string& func, T fragment, T there) {
    if (func == "ALWAYS") return true;
    if (func == "NEVER") return false;
    if (func == "LESS") return fragment < there;
    if (func == "LESSEQUAL") return fragment <= there;
    if (func == "GREATER") return fragment > there;
    if (func == "GREATEREQUAL") return fragment >= there;
    if (func == "EQUAL") return fragment == there;
    if (func == "NOTEQUAL") return fragment != there;
    throw std::runtime_error("no function " + func);
}

double depth_units(double depth, const std::string& rule) {
    const double units30 = std::nearbyint(depth * 1073741823.0);
    if (rule == "D16") return std::floor(units30 / 16384.0);
    if (rule == "D24") return std::floor(units30 / 64.0);
    if (rule == "D32") return units30 * 4.0 + std::floor(units30 / 268435456.0);
    throw std::runtime_error("no depth format " + rule);
}

int alpha_fail(const Place& at) {
    const Format& format   = format_in(at.text.at("format"));
    const std::string fail = at.text.at("fail"), part = at.text.at("part");
    if (part == "depth") return fail == "ZB_ONLY" ? 255 : 0;
    if (part == "red") return fail == "FB_ONLY" || fail == "RGB_ONLY" ? stored(255, format, 0) : 0;
    const bool is_written = fail == "FB_ONLY" || (fail == "RGB_ONLY" && format.bits[3] != 8);
    return stored(is_written ? 255 : 0, format, 3);
}

int dest_alpha_test(const Place& at) {
    const Format& format = format_in(at.text.at("format"));
    if (format.bits[3] == 0) return 0;
    const bool top = stored(of(at, "written_alpha"), format, 3) >= 128;
    return top == (at.text.at("test") == "ONE") ? stored(255, format, 0) : 0;
}

int halved(const std::string& name, const Place& at) {
    const int first = of(at, "first"), second = of(at, "second");
    if (name == "halve_x8r8g8b8") return floored(first + 3 * second, 4);
    const int sum = kept(first, 6) + 3 * kept(second, 6);
    return sum + floored(sum, 64);
}

}  // namespace

int expected_entry(const std::string& name, const std::string& rule, const std::string& what, const Place& at) {
    if (name.starts_with("blend_"))
        return contains(rule, "GS_SHIFT7") ? gs_blend(name, what, at) : factor_blend(name, rule, what, at);
    if (name.starts_with("store_")) return store(name, what, at);
    if (name.starts_with("halve_")) return halved(name, at);
    if (name.starts_with("texture_")) return texture_function(name, rule, at);
    if (name == "filter" || name == "filter_gs_nearest4")
        return filter(rule, {of(at, "t00"), of(at, "t10"), of(at, "t01"), of(at, "t11")}, of(at, "fraction_u"),
                      of(at, "fraction_v"));
    if (name == "fog" || name == "fog_gs_two_floors") return fog(rule, at);
    if (name == "alpha_test") return passes(at.text.at("func"), of(at, "alpha"), of(at, "reference")) ? 255 : 0;
    if (name == "alpha_fail") return alpha_fail(at);
    if (name == "dest_alpha_test") return dest_alpha_test(at);
    if (name.starts_with("depth_test_"))
        return passes(at.text.at("func"), depth_units(at.real.at("fragment"), rule),
                      depth_units(at.real.at("stored"), rule))
                   ? 255
                   : 0;
    throw std::runtime_error("no array " + name);
}

}  // namespace test_support
