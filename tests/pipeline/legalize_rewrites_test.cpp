// SPDX-License-Identifier: MIT
// What holds of the rewrites for any frame: what they give back is valid, a chip that has all is given its frame back, and so is
// one that is given its own frame again.
#include "pipeline/frame/frame_text.h"
#include "pipeline/legalize/formats.h"
#include "pipeline/legalize/gs_alpha.h"
#include "pipeline/legalize/gs_blend.h"
#include "pipeline/legalize/reversed_depth.h"
#include "pipeline/legalize/stages.h"
#include "pipeline/legalize/vertex_constants.h"
#include "pipeline/validate/validate.h"
#include "tests/support/random_frame.h"
#include "tests/support/small_frame.h"

using namespace pipeline;

namespace {

constexpr std::array<Rewrite, 6> kInOrder{&rewrite_stages,         &rewrite_vertex_constants, &rewrite_formats,
                                          &rewrite_reversed_depth, &rewrite_gs_alpha,         &rewrite_gs_blend};

}  // namespace

TEST_CASE("legalize: random frames stay valid, and as they are for a chip that has all", "[legalize]") {
    std::size_t notes_in_all = 0, counted_anew = 0;
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        const Frame frame = test_support::random_frame(seed);
        for (const Profile& profile : profiles()) {
            INFO("seed " << seed << ", " << profile.name);
            Frame rewritten = frame;
            RewriteNotes notes;
            for (const Rewrite rewrite : kInOrder) {
                rewritten = rewrite(std::move(rewritten), profile, notes);
                for (const Finding& finding : validate(rewritten)) FAIL_CHECK(finding.where << ": " << finding.what);
            }
            if (profile.name == "ideal") CHECK(rewritten == frame);
            CHECK((rewritten == frame) == notes.empty());
            notes_in_all += notes.size();
            counted_anew += rewritten.arithmetic != frame.arithmetic;
            Frame again = rewritten;
            for (const Rewrite rewrite : kInOrder) again = rewrite(std::move(again), profile, notes);
            CHECK(diff(rewritten, again) == std::vector<std::string>{});
        }
    }
    CHECK(notes_in_all > 500);
    CHECK(counted_anew > 0);
}

TEST_CASE("legalize: constants in vertices' colours give the same bytes in random frames", "[legalize]") {
    std::size_t changed = 0;
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        INFO("seed " << seed);
        const Frame frame = test_support::random_frame(seed);
        RewriteNotes notes;
        const Frame other = rewrite_vertex_constants(frame, *find_profile("ps2"), notes);
        changed += !notes.empty();
        CHECK(execute(other).output == execute(frame).output);
    }
    CHECK(changed > 20);
}
