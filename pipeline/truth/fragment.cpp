// SPDX-License-Identifier: MIT
#include "pipeline/truth/fragment.h"

#include <cmath>

namespace pipeline::truth {
namespace {

bool passes(CompareFunc func, double fragment, double reference) {
    switch (func) {
        case CompareFunc::Always:
            return true;
        case CompareFunc::LessEqual:
            return fragment <= reference;
        case CompareFunc::Less:
            return fragment < reference;
        case CompareFunc::GreaterEqual:
            return fragment >= reference;
        case CompareFunc::Greater:
            return fragment > reference;
        case CompareFunc::Equal:
            return fragment == reference;
        case CompareFunc::NotEqual:
            return fragment != reference;
        case CompareFunc::Never:
            return false;
    }
    return false;
}

double nearest_byte(double value) {
    return std::floor(value * 255.0 + 0.5);
}

bool keeps_eight_bits_of_alpha(TargetFormat format) {
    return format == TargetFormat::A8R8G8B8 || format == TargetFormat::Psmct32;
}

struct Writes {
    bool depth = true;
    ColorMask color;
};

Writes writes_in_spite(AlphaFail fail, TargetFormat format, Writes writes) {
    if (fail != AlphaFail::ZbOnly) writes.depth = false;
    if (fail == AlphaFail::ZbOnly || fail == AlphaFail::Keep) writes.color = {false, false, false, false};
    if (fail == AlphaFail::RgbOnly && keeps_eight_bits_of_alpha(format)) writes.color.alpha = false;
    return writes;
}

bool passes_dest_alpha(const FragmentSetup& setup, std::size_t at) {
    const DestAlphaTest test = setup.state.dest_alpha_test;
    if (test == DestAlphaTest::Off || setup.color == nullptr) return true;
    if (!has_alpha(setup.format)) return false;
    return (nearest_byte(setup.color->color[at].a) >= 128.0) == (test == DestAlphaTest::One);
}

void write(const ColorMask& mask, const Color& from, Color& to) {
    if (mask.red) to.r = from.r;
    if (mask.green) to.g = from.g;
    if (mask.blue) to.b = from.b;
    if (mask.alpha) to.a = from.a;
}

}  // namespace

void draw_fragment(const FragmentSetup& setup, const Fragment& fragment, std::size_t at) {
    const PipelineState& state = setup.state;
    double* const depth        = setup.depth ? &setup.depth->depth[at] : nullptr;
    // No test changes what another sees, and this one is the cheapest.
    if (depth && !passes(state.depth.func, fragment.depth, *depth)) return;
    const Color source = combined(setup, fragment);

    Writes writes{state.depth.write, state.color_mask};
    if (!passes(state.alpha_test.func, nearest_byte(source.a), state.alpha_test.reference))
        writes = writes_in_spite(state.alpha_test.fail, setup.format, writes);
    if (!passes_dest_alpha(setup, at)) return;
    if (depth && writes.depth) *depth = fragment.depth;
    if (!setup.color) return;
    if (!has_alpha(setup.format)) writes.color.alpha = false;
    Color& there = setup.color->color[at];
    write(writes.color, blended(setup.arithmetic, state, source, there), there);
}

}  // namespace pipeline::truth
