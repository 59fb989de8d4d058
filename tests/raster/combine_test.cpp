// SPDX-License-Identifier: MIT
// Texture stages, specular and fog against their rules in exact integers: every pair of bytes for operations on two,
// every triple for those on three. On all instruction sets, as compiled for any state, and on every 61st batch the
// scalar reference. The special programs' colours, compiled for themselves, against both.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "raster/fill_plan.h"
#include "raster/reference_color.h"
#include "tests/raster/exact.h"
#include "tests/raster/fill_steps.h"
#include "tests/raster/simd_kernels.h"
#include "tests/raster/special_parts.h"
#include "tests/raster/special_state.h"
#include "tests/support/random.h"

namespace {

using namespace raster;
using exact::floor_quotient;
using exact::nearest_255th;
using exact::Pixel;
using fill_steps::Colors;
using simd_kernels::kLanes;
using Source = CombineArg::Source;

constexpr CombineArg kTexel{.source = Source::Texel}, kDiffuse{.source = Source::Diffuse},
    kConstant{.source = Source::Constant};

// The products of a rule: k * a * b and a mix of a and b, and what AddSigned takes off.
struct Products {
    int (*product)(int k, int a, int b);
    int (*lerp)(int a, int b, int c);
    int half, one;
};
Products products_of(CombineRule rule) {
    switch (rule) {
        case CombineRule::Nearest255:
            return {[](int k, int a, int b) { return nearest_255th(k * a * b); },
                    [](int a, int b, int c) { return nearest_255th(a * c + b * (255 - c)); }, 127, 255};
        case CombineRule::Expanded256:
            return {[](int k, int a, int b) { return floor_quotient(k * a * exact::to_256(b) + 128, 256); },
                    [](int a, int b, int c) {
                        const int f = exact::to_256(c);
                        return floor_quotient(a * f + b * (256 - f) + 128, 256);
                    },
                    128, 256};
        case CombineRule::Shift7:
            break;
    }
    return {[](int, int a, int b) { return floor_quotient(a * b, 128); }, nullptr, 0, 0};
}

int combined(CombineOp op, const Products& rule, int a, int b, int c) {
    const auto value = [&] {
        switch (op) {
            case CombineOp::Select:
                return a;
            case CombineOp::Modulate:
                return rule.product(1, a, b);
            case CombineOp::Modulate2X:
                return rule.product(2, a, b);
            case CombineOp::Modulate4X:
                return rule.product(4, a, b);
            case CombineOp::Add:
                return a + b;
            case CombineOp::AddSigned:
                return a + b - rule.half;
            case CombineOp::AddSigned2X:
                return 2 * a + 2 * b - rule.one;
            case CombineOp::Subtract:
                return a - b;
            case CombineOp::Lerp:
                return rule.lerp(a, b, c);
            case CombineOp::MultiplyAdd:
                return rule.product(1, a, b) + c;
        }
        return -1;
    };
    return std::clamp(value(), 0, 255);
}

bool is_ternary(CombineOp op) {
    return op == CombineOp::Lerp || op == CombineOp::MultiplyAdd;
}

std::vector<CombineOp> ops_of(CombineRule rule) {
    if (rule == CombineRule::Shift7)
        return {CombineOp::Select, CombineOp::Modulate, CombineOp::Add, CombineOp::MultiplyAdd};
    std::vector<CombineOp> all;
    for (int op = 0; op <= static_cast<int>(CombineOp::MultiplyAdd); ++op) all.push_back(static_cast<CombineOp>(op));
    return all;
}

std::string hex(std::uint32_t argb) {
    std::array<char, 12> text{};
    std::snprintf(text.data(), text.size(), "%08x", argb);
    return text.data();
}

// 256 pixels whose texel 0 has all values of a byte, in each channel in its own order.
class Bench {
  public:
    Bench() {
        for (int i = 0; i < kLanes; ++i) {
            Pixel p;
            for (int channel = 0; channel < 4; ++channel) p.c[channel] = exact::shuffled(channel, i);
            inputs->texels[0][i] = p.argb();
        }
    }

    // A state whose stage 0, if there is one, may read a texture.
    static FillState state() {
        static constexpr std::uint32_t kTexels[1]{};  // never read: the texels are those of `inputs`
        FillState state;
        state.samplers[0].levels = {{kTexels, 1, 1, 1}};
        return state;
    }

    // want(channel, x): of the value x of that channel.
    template <class Want>
    void want_channels(Want&& want) {
        std::array<std::array<int, 256>, 4> rows{};
        for (int channel = 0; channel < 4; ++channel)
            for (int x = 0; x < 256; ++x) rows[channel][x] = want(channel, x);
        for (int i = 0; i < kLanes; ++i) {
            const Pixel x = Pixel::of(inputs->texels[0][i]);
            wanted[i]     = Pixel{{rows[0][x.c[0]], rows[1][x.c[1]], rows[2][x.c[2]], rows[3][x.c[3]]}}.argb();
        }
    }

    // Is the state's colour what is wanted?
    void check(const FillState& state) {
        const FillPlan plan = plan_fill(state, true, {}, 24, true);
        for (const auto& [name, make_colors, fallback] : targets_) {
            make_colors(plan, *inputs, *colors_);
            if (*colors_ == wanted) continue;
            for (int i = 0; i < kLanes; ++i) check_lane(name, state, i, (*colors_)[i]);
        }
        if (batches_++ % 61 == 0)
            for (int i = 0; i < kLanes; ++i)
                check_lane("reference", state, i,
                           reference::combined_color(state, {.diffuse  = inputs->diffuse[i],
                                                             .specular = inputs->specular[i],
                                                             .texels   = {inputs->texels[0][i]}}));
    }

    std::size_t batches() const { return batches_; }

    std::unique_ptr<fill_steps::ColorInputs> inputs = std::make_unique<fill_steps::ColorInputs>();
    Colors wanted{};

  private:
    void check_lane(const std::string& name, const FillState& state, int i, std::uint32_t got) const {
        if (got == wanted[i]) return;
        FAIL(name << ": colour op " << static_cast<int>(state.stages[0].color.op) << ", alpha op "
                  << static_cast<int>(state.stages[0].alpha.op) << ", rule " << static_cast<int>(state.combine_rule)
                  << ", fog rule " << static_cast<int>(state.fog_rule) << ", fog colour " << hex(state.fog_color)
                  << ": texel " << hex(inputs->texels[0][i]) << " diffuse " << hex(inputs->diffuse[i]) << " constant "
                  << hex(state.constant) << " specular " << hex(inputs->specular[i]) << ": got " << hex(got) << " want "
                  << hex(wanted[i]));
    }

    std::vector<simd_kernels::Named<fill_steps::MakeColors>> targets_ =
        simd_kernels::on_every_target([] { return fill_steps::make_colors_step({}, fill_steps::Kind::General); });
    std::unique_ptr<Colors> colors_ = std::make_unique<Colors>();
    std::size_t batches_            = 0;
};

// All texels a with these b and c.
void check_stage(Bench& bench, CombineRule rule, CombineOp color, CombineOp alpha, const Pixel& b, const Pixel& c) {
    FillState state    = Bench::state();
    state.stage_count  = 1;
    state.stages[0]    = {{color, kTexel, kDiffuse, kConstant}, {alpha, kTexel, kDiffuse, kConstant}};
    state.combine_rule = rule;
    state.constant     = c.argb();
    bench.inputs->diffuse.fill(b.argb());
    const Products products = products_of(rule);
    bench.want_channels([&](int channel, int a) {
        return combined(channel == 3 ? alpha : color, products, a, b.c[channel], c.c[channel]);
    });
    bench.check(state);
}

void check_operations(CombineRule rule) {
    Bench bench;
    for (const CombineOp op : ops_of(rule))
        for (const int x : simd_kernels::swept_bytes()) {
            const Pixel b{{x, (x + 64) & 255, (x + 128) & 255, (x + 192) & 255}};
            for (int c = 0; c < (is_ternary(op) ? 256 : 4);
                 c += 4 * simd_kernels::kStride)  // four values of c in the four channels
                check_stage(bench, rule, op, op, b, {{c, c + 1, c + 2, c + 3}});
        }
    CHECK(bench.batches() >= ops_of(rule).size() * simd_kernels::kEdges.size());
}

}  // namespace

TEST_CASE("Nearest255: every operation of a stage is exact", "[raster][exhaustive]") {
    check_operations(CombineRule::Nearest255);
}

TEST_CASE("Expanded256: every operation of a stage is exact", "[raster][exhaustive]") {
    check_operations(CombineRule::Expanded256);
}

TEST_CASE("Shift7: every operation of a stage is exact", "[raster][exhaustive]") {
    check_operations(CombineRule::Shift7);
}

TEST_CASE("alpha has its own operation in a stage", "[raster]") {
    Bench bench;
    for (const CombineRule rule : {CombineRule::Nearest255, CombineRule::Expanded256, CombineRule::Shift7})
        for (const CombineOp color : ops_of(rule))
            for (const CombineOp alpha : ops_of(rule))
                for (const int x : simd_kernels::kEdges)
                    check_stage(bench, rule, color, alpha, {{x, 255 - x, 77, x}}, {{200, x, 3, 255 - x}});
}

TEST_CASE("complement and alpha replicate change what an operation reads", "[raster]") {
    Bench bench;
    bench.inputs->diffuse.fill(Pixel{{40, 30, 20, 10}}.argb());
    bench.inputs->specular.fill(Pixel{{4, 3, 2, 1}}.argb());
    const auto read = [&](CombineArg arg, auto want) {
        FillState state   = Bench::state();
        state.stage_count = 1;
        state.constant    = 0xa0b0c0d0;
        state.stages[0]   = {{CombineOp::Select, arg, arg, arg}, {CombineOp::Select, arg, arg, arg}};
        for (int i = 0; i < kLanes; ++i) bench.wanted[i] = want(Pixel::of(bench.inputs->texels[0][i])).argb();
        bench.check(state);
    };
    const auto not_of = [](int x) { return 255 - x; };
    read({Source::Texel, true, false}, [&](const Pixel& t) {
        return Pixel{{not_of(t.c[0]), not_of(t.c[1]), not_of(t.c[2]), not_of(t.c[3])}};
    });
    read({Source::Texel, false, true}, [](const Pixel& t) { return Pixel{{t.c[3], t.c[3], t.c[3], t.c[3]}}; });
    read({Source::Texel, true, true}, [&](const Pixel& t) {
        const int x = not_of(t.c[3]);
        return Pixel{{x, x, x, x}};
    });
    read({Source::Current}, [](const Pixel&) { return Pixel{{40, 30, 20, 10}}; });  // diffuse, in stage 0
    read({Source::Diffuse}, [](const Pixel&) { return Pixel{{40, 30, 20, 10}}; });
    read({Source::Constant}, [](const Pixel&) { return Pixel::of(0xa0b0c0d0); });
    read({Source::Specular}, [](const Pixel&) { return Pixel{{4, 3, 2, 255}}; });  // its alpha is the fog factor
}

TEST_CASE("specular is added to every byte and leaves alpha alone", "[raster][exhaustive]") {
    Bench bench;
    bench.inputs->diffuse = bench.inputs->texels[0];  // the colour without a stage
    FillState state;
    state.add_specular = true;
    for (int x = 0; x < 256; ++x) {
        const Pixel specular{{x, 255 - x, (x + 128) & 255, x}};
        bench.inputs->specular.fill(specular.argb());
        bench.want_channels(
            [&](int channel, int color) { return channel == 3 ? color : std::min(255, color + specular.c[channel]); });
        bench.check(state);
    }
}

TEST_CASE("fog is exact for every factor, colour and fog colour and leaves alpha alone", "[raster][exhaustive]") {
    struct Rule {
        FogRule rule;
        int (*mix)(int f, int c, int k);
    };
    static constexpr std::array<Rule, 4> kRules{
        {{FogRule::Nearest255, [](int f, int c, int k) { return nearest_255th(f * c + (255 - f) * k); }},
         {FogRule::Floor256, [](int f, int c, int k) { return floor_quotient(f * c + (256 - f) * k, 256); }},
         {FogRule::TwoFloors,
          [](int f, int c, int k) { return floor_quotient(f * c, 256) + floor_quotient((255 - f) * k, 256); }},
         {FogRule::Expanded256, [](int f, int c, int k) {
              const int expanded = f < 128 ? f : f + 1;
              return floor_quotient(expanded * c + (256 - expanded) * k, 256);
          }}}};
    Bench bench;
    bench.inputs->diffuse = bench.inputs->texels[0];
    FillState state;
    state.fog = true;
    for (const auto& [rule, mix] : kRules)
        for (const int f : simd_kernels::swept_bytes()) {
            bench.inputs->specular.fill(Pixel{{1, 2, 3, f}}.argb());
            for (int k = 0; k < 256; k += 3 * simd_kernels::kStride) {  // three fog colours in the three channels
                const Pixel fog{{k, (k + 1) & 255, (k + 2) & 255, 99}};
                state.fog_rule  = rule;
                state.fog_color = fog.argb();
                bench.want_channels(
                    [&, m = mix](int channel, int c) { return channel == 3 ? c : m(f, c, fog.c[channel]); });
                bench.check(state);
            }
        }
}

TEST_CASE("special programs make the colours of the reference", "[raster][exhaustive]") {
    test_support::Random random(12);
    auto inputs = std::make_unique<fill_steps::ColorInputs>();
    auto colors = std::make_unique<Colors>();
    for (const FillProgram& program : special_parts::kPrograms) {
        special_state::SpecialState special(program, random.bits());
        const FillPlan plan = special.plan(true);
        const auto kernels  = simd_kernels::of_every_kind(
            [&](fill_steps::Kind kind) { return fill_steps::make_colors_step(plan.program, kind); });
        REQUIRE(kernels.size() == 2 * pipeline::simd_targets().size());
        for (const int x : simd_kernels::swept_bytes()) {
            // All pairs of bytes of texel 0 with diffuse and with texel 1, beside any fog.
            Colors want;
            for (int i = 0; i < kLanes; ++i) {
                Pixel t0, t1, d;
                for (int channel = 0; channel < 4; ++channel) {
                    t0.c[channel] = exact::shuffled(channel, i);
                    t1.c[channel] = exact::shuffled(channel, i ^ x);
                    d.c[channel]  = exact::shuffled((channel + 1) & 3, i + x);
                }
                inputs->texels[0][i] = program.textures[0].has_texels ? t0.argb() : 0xffffffff;
                inputs->texels[1][i] = t1.argb();
                inputs->diffuse[i]   = d.argb();
                inputs->specular[i]  = random.bits();
                want[i] =
                    reference::combined_color(special.state, {.diffuse  = inputs->diffuse[i],
                                                              .specular = inputs->specular[i],
                                                              .texels = {inputs->texels[0][i], inputs->texels[1][i]}});
            }
            for (const auto& [name, make_colors, fallback] : kernels) {
                make_colors(plan, *inputs, *colors);
                if (*colors == want) continue;
                for (int i = 0; i < kLanes; ++i) {
                    CAPTURE(name, i, hex(inputs->texels[0][i]), hex(inputs->texels[1][i]), hex(inputs->diffuse[i]),
                            hex(inputs->specular[i]));
                    REQUIRE(hex((*colors)[i]) == hex(want[i]));
                }
            }
        }
    }
}
