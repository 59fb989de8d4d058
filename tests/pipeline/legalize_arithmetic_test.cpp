// SPDX-License-Identifier: MIT
#include "pipeline/legalize/arithmetic.h"

#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

TEST_CASE("a frame computes by the chip's rules, but for those that move the picture") {
    constexpr std::string_view kFrame = R"(
arithmetic { snap TRUNCATE pixel_center 3 filter GS_FLOOR4 }
targets [ "picture" { width 8 height 4 } ]
)";
    check_rewrite(&use_chip_arithmetic, "gamecube", kFrame, R"(
arithmetic { snap TRUNCATE pixel_center 3 filter FLIPPER_FLOOR7 combine TEV fog FLIPPER_FLOOR256 blend FLIPPER_TRUNC256 }
targets [ "picture" { width 8 height 4 } ]
)");
    check_rewrite(&use_chip_arithmetic, "dx7", kFrame, R"(
arithmetic { snap TRUNCATE pixel_center 3 }
targets [ "picture" { width 8 height 4 } ]
)");
}

TEST_CASE("a frame that computes by the chip's rules is left alone") {
    check_left_alone(&use_chip_arithmetic, "dx7",
                     "arithmetic { pixel_center 5 } targets [ \"a\" { width 1 height 1 } ]");
}

TEST_CASE("rules whose one is 0x80 come with the alpha that is counted so, not here") {
    check_rewrite(&use_chip_arithmetic, "ps2", R"(
targets [ "picture" { width 8 height 4 } ]
passes [ "blend" { color "picture" state { blend { source SRCALPHA dest INVSRCALPHA } } } ]
)",
                  R"(
arithmetic { vertex_depth WHOLE_UNITS gouraud FLOOR filter GS_FLOOR4 fog GS_FLOOR256 }
targets [ "picture" { width 8 height 4 } ]
passes [ "blend" { color "picture" state { blend { source SRCALPHA dest INVSRCALPHA } } } ]
)");
    check_rewrite(&use_chip_arithmetic, "ps2", R"(
targets [ "picture" { width 8 height 4 } ]
passes [ "subtract" { color "picture" state { stages [{ color_op SUBTRACT alpha_op SUBTRACT }] } } ]
)",
                  R"(
arithmetic { vertex_depth WHOLE_UNITS gouraud FLOOR filter GS_FLOOR4 fog GS_FLOOR256 }
targets [ "picture" { width 8 height 4 } ]
passes [ "subtract" { color "picture" state { stages [{ color_op SUBTRACT alpha_op SUBTRACT }] } } ]
)");
}
