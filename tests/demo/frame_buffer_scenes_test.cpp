// SPDX-License-Identifier: MIT
// The built-in scenes in the GameCube's one frame buffer: nothing is left to be lacking, and what shares it changes no
// picture but by how copies halve.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "demo/scene.h"
#include "pipeline/check/needed_pixels.h"
#include "pipeline/execute/execute.h"
#include "pipeline/legalize/copies.h"
#include "pipeline/legalize/dest_alpha_test.h"
#include "pipeline/legalize/formats.h"
#include "pipeline/legalize/frame_buffer.h"
#include "pipeline/legalize/halving_copy.h"
#include "tests/support/image_match.h"
#include "tests/support/one_buffer.h"

namespace {

using namespace pipeline;

const Profile& gamecube() {
    return *find_profile("gamecube");
}

Frame scene_frame(const demo::SceneInfo& info, demo::Size size) {
    const demo::ScenePtr scene = demo::load_scene(info.name);
    return demo::scene_frame(*scene, size, demo::frame_count(*scene) / 5);
}

// With the chip's formats.
Frame with_formats(const Frame& frame) {
    RewriteNotes notes;
    const Frame masked = test_by_texture(frame, gamecube(), notes);
    return draw_copies(rewrite_formats(masked, gamecube(), notes), gamecube(), notes);
}

Frame shared(const Frame& frame) {
    RewriteNotes notes;
    return share_frame_buffer(frame, gamecube(), notes);
}

// Rectangles that halve lie a sixteenth of a pixel to the right, so that no copy can stand for them.
int move_halvings(Frame& frame) {
    int moved = 0;
    for (Pass& pass : frame.passes) {
        if (!halving_copy(frame, pass, limit_of(frame, pass))) continue;
        auto& draw = std::get<DrawRectangle>(pass.draws[0]);
        draw.x0 += 0.0625f;
        draw.x1 += 0.0625f;
        ++moved;
    }
    return moved;
}

}  // namespace

TEST_CASE("the GameCube can draw all scenes as they are", "[frame_buffer]") {
    for (const demo::SceneInfo& info : demo::built_in_scenes()) {
        INFO(info.name);
        for (const ChipFinding& left : legalize(scene_frame(info, {640, 448}), gamecube()).left)
            FAIL_CHECK(left.where << " uses " << left.uses << ", has " << left.has);
    }
}

TEST_CASE("scenes in one frame buffer are the same to the bit, but for what is halved", "[frame_buffer]") {
    int moved = 0;
    for (const demo::SceneInfo& info : demo::built_in_scenes()) {
        INFO(info.name);
        const Frame frame      = with_formats(scene_frame(info, {160, 90}));
        const Frame got        = shared(frame);
        const auto want        = execute(frame).output;
        const auto with_halves = execute(got).output;
        CHECK(test_support::mean_difference(with_halves, want) < 0.8);
        CHECK((execute(test_support::with_one_buffer(got, gamecube())).output == with_halves));

        Frame without_halves = frame;
        moved += move_halvings(without_halves);
        const auto drawn = execute(without_halves).output;
        const Frame kept = shared(without_halves);
        CHECK((execute(kept).output == drawn));
        CHECK((execute(test_support::with_one_buffer(kept, gamecube())).output == drawn));
        // It would show.
        CHECK((execute(test_support::with_one_buffer(without_halves, gamecube())).output != drawn));
    }
    CHECK(moved > 4);
}
