// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "demo/frame_source.h"
#include "tests/support/gs_frames.h"

using namespace pipeline;
using namespace test_support;

TEST_CASE("Scenes come out of their dumps as they are drawn") {
    for (const std::string scene : {"canyon", "smoke"}) {
        INFO(scene);
        const LegalFrame legal =
            legalize(demo::FrameSource(scene).frame(demo::Size{160, 120}, 0), *find_profile("ps2"));
        REQUIRE(legal.left.empty());
        CHECK(difference_of(legal.frame, replayed(legal.frame, emit_gs(legal))) == "");
    }
}
