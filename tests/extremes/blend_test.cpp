// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "tests/extremes/blends.h"

using namespace extremes;
using pipeline::BlendRule;

TEST_CASE("extremes: ten thousand blends drift no further than their rule lets them", "[extremes]") {
    for (const Blender& blender : blenders())
        for (const BlendKind kind : {BlendKind::Over, BlendKind::Multiply}) {
            if (!has_kind(blender, kind)) continue;
            INFO(blender.name << (kind == BlendKind::Over ? ", over" : ", multiply"));
            const Drift found = drift(blender, kind, blended(blender, kind));
            CHECK(found.greatest > 0.0);
            CHECK(found.of_bound <= 1.0 + 1e-6);
        }
}

// With d what is there, a blend changes nothing once its rule gives d again:
//   NEAREST255        black d A <= 127, white (255 - d) A <= 127
//   FLIPPER_TRUNC256  black d A' < 1, as the floor takes at least 1; white (255 - d) A' <= 255
//   GS_SHIFT7         black d A < 1 likewise; white (255 - d) A <= 127
TEST_CASE("extremes: where fades to black and to white get stuck", "[extremes]") {
    for (const Blender& blender : blenders()) {
        if (blender.bits != 8) continue;
        const Ends ends = blended(blender, BlendKind::Over);
        const int most  = blender.rule == BlendRule::FlipperTrunc256 ? 255 : 127;
        for (int alpha = 1; alpha < 256; ++alpha) {
            if (blender.rule == BlendRule::GsShift7 && alpha > 128) break;
            INFO(blender.name << ", alpha " << alpha);
            const int factor     = blender.rule == BlendRule::FlipperTrunc256 ? alpha + (alpha >> 7) : alpha;
            const int black      = ends[1][0][static_cast<std::size_t>(alpha)];
            const int from_white = 255 - ends[0][3][static_cast<std::size_t>(alpha)];
            CHECK(black == (blender.rule == BlendRule::Nearest255 ? most / factor : 0));
            CHECK(from_white <= most / factor);
            // And not before: one step earlier the rule still moves.
            if (factor < 16) CHECK(from_white == most / factor);
        }
    }
}
