// SPDX-License-Identifier: MIT
// check and the golden vectors agree on what a chip lacks: a frame that the vectors have for a chip gives no finding, and
// one that they leave out does.
#include <catch2/catch.hpp>
#include <set>

#include "demo/vectors/chip_limits.h"
#include "demo/vectors/vector_frames.h"
#include "pipeline/check/check.h"
#include "tests/support/random_frame.h"

using namespace pipeline;

namespace {

// But that triangles are not in window space: the vectors leave it to the program.
std::string first_finding(const Frame& frame, const Profile& chip) {
    std::vector<ChipFinding> findings = check(frame, chip);
    std::erase_if(findings, [](const ChipFinding& finding) { return finding.uses == "triangles"; });
    if (findings.empty()) return {};
    return findings[0].where + " uses " + findings[0].uses + ", has " + findings[0].has;
}

}  // namespace

TEST_CASE("check agrees with the frames of the golden vectors", "[check][vectors]") {
    // States of passes that do nothing but clear, to which none applies.
    const std::set<std::string> only_clears{"ps2 clear_ignores_state", "gamecube clear_ignores_state"};
    int allowed = 0, refused = 0;
    for (const Profile& chip : profiles()) {
        for (const demo::VectorFrame& one : demo::vector_frames(chip, demo::embedded_frames())) {
            const std::string name = std::string(chip.name) + ' ' + one.name;
            INFO(name << ", by the vectors: " << one.why_not);
            const std::string finding = first_finding(one.frame, chip);
            INFO(finding);
            CHECK(finding.empty() == (one.why_not.empty() || only_clears.count(name) == 1));
            ++(finding.empty() ? allowed : refused);
        }
    }
    CHECK(allowed > 200);
    CHECK(refused > 50);
}

TEST_CASE("a random frame that by the vectors a chip has all of meets its limits alone", "[check][vectors]") {
    int allowed = 0;
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        for (const Profile& chip : profiles()) {
            const Frame frame = demo::put_on_chip(test_support::random_frame(seed), chip);
            if (!demo::what_is_missing(frame, chip).empty()) continue;
            ++allowed;
            INFO("seed " << seed << " on " << chip.name);
            for (const ChipFinding& finding : check(frame, chip)) {
                if (finding.uses == "triangles") continue;
                // Sizes, and what a frame buffer alone has, are not in the vectors.
                if (finding.rule == "limits" || finding.rule == "memory") continue;
                INFO(finding.where << " uses " << finding.uses << ", has " << finding.has);
                CHECK(finding.rule == "copy");
                CHECK(chip.name == "gamecube");
            }
        }
    }
    CHECK(allowed > 300);
}
