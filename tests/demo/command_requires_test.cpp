// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/support/child_process.h"

namespace {

using tests::Ended;

Ended require(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "requires");
    const tests::ScratchDirectory directory;
    return tests::run_program(NIMBUS7_PROGRAM, arguments, directory.path());
}

nlohmann::json reports_of(std::vector<std::string> arguments) {
    for (const char* word : {"--size", "160x90", "--format", "json"}) arguments.emplace_back(word);
    const Ended ended = require(arguments);
    CHECK(ended.status == 0);
    return nlohmann::json::parse(ended.out)["reports"];
}

}  // namespace

TEST_CASE("a scene's needs are listed with the names that its frame's text has", "[cli][requires]") {
    const Ended canyon = require({"canyon", "--size", "160x90"});
    CHECK(canyon.status == 0);
    CHECK(canyon.error.empty());
    CHECK_THAT(canyon.out, Catch::StartsWith("canyon, no chip: "));
    for (const char* line : {"state.depth.func ", "SRCALPHA INVSRCALPHA ", "targets.format  ", "mega-particles  ",
                             "LINEAR LINEAR WRAP WRAP", "landscape: texture and detail ", "uv1 "}) {
        CAPTURE(line);
        CHECK_THAT(canyon.out, Catch::Contains(line));
    }
    CHECK_THAT(canyon.out, !Catch::Contains("general") && !Catch::Contains("gs_blend") && !Catch::Contains("NEVER"));
}

TEST_CASE("the needs of several frames are taken together", "[cli][requires]") {
    const nlohmann::json one = reports_of({"plume", "--frame", "14"})[0],
                         two = reports_of({"plume", "--frames", "14-15"})[0];
    CHECK(one["frames"] == 1);
    CHECK(two["frames"] == 2);
    CHECK(two["passes"] > one["passes"]);
    CHECK(two["memory"]["targets"] == one["memory"]["targets"]);
    CHECK(one["memory"]["targets"] >= 160 * 90 * 8);
    CHECK(one["states"]["targets.format"]["D24"] == 1);
    CHECK(one["rewrites"].empty());
    std::size_t draws = 0, filled = 0;
    for (const auto& count : one["draws"]) draws += count.get<std::size_t>();
    for (const auto& kernel : one["kernels"]) {
        CHECK(kernel["special"] == true);
        filled += kernel["draws"].get<std::size_t>();
    }
    CHECK(draws == filled);
}

TEST_CASE("the needs of a scene on each chip say what was rewritten", "[cli][requires]") {
    const nlohmann::json reports = reports_of({"canyon", "--profile", "all"});
    REQUIRE(reports.size() == 5);
    CHECK(reports[0]["profile"] == "ideal");
    CHECK(reports[0]["rewrites"].empty());
    for (std::size_t i = 1; i < reports.size(); ++i) {
        CAPTURE(reports[i]["profile"]);
        CHECK(reports[i]["findings"] == 0);
        CHECK_FALSE(reports[i]["rewrites"].empty());
    }
    CHECK(reports_of({"canyon", "--profile", "ps2"})[0]["blends"].contains("CS CD AS CD"));

    const Ended too_large = require({"canyon", "--profile", "ps2", "--size", "640x448"});
    CHECK(too_large.status == 3);
    CHECK_THAT(too_large.error, Catch::StartsWith("nimbus7: ps2 cannot draw canyon: 1 finding"));
    CHECK_THAT(too_large.out, Catch::StartsWith("canyon, Sony Graphics Synthesizer"));
}

TEST_CASE("needs are asked for in words that are known", "[cli][requires]") {
    CHECK(require({}).status == 2);
    CHECK(require({"canyon", "--profile", "ps3"}).status == 2);
    CHECK(require({"canyon", "--format", "xml"}).status == 2);
    CHECK(require({"canyon", "--frame", "1", "--frames", "1-2"}).status == 2);
    CHECK(require({"no-such"}).status == 2);
}
