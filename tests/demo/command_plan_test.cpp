// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/support/child_process.h"

namespace {

using tests::Ended;

constexpr const char* kSize = "160x90";

Ended nimbus7(const std::vector<std::string>& arguments) {
    const tests::ScratchDirectory directory;
    return tests::run_program(NIMBUS7_PROGRAM, arguments, directory.path());
}

}  // namespace

TEST_CASE("a plan says what the chip lacks, where all lies, and what it costs", "[cli][plan]") {
    const Ended plan = nimbus7({"plan", "canyon", "--profile", "ps2", "--size", kSize});
    CHECK(plan.status == 3);
    CHECK_THAT(plan.error, Catch::StartsWith("nimbus7: ps2 cannot draw canyon: ") && Catch::EndsWith("findings\n"));
    CHECK_THAT(plan.out, Catch::Contains("reversed_depth: "));
    CHECK_THAT(plan.out, Catch::Contains("state.cull: uses CW; the chip has NONE [states]"));
    CHECK_THAT(plan.out, Catch::Contains("[states] ps2tek"));
    CHECK_THAT(plan.out, Catch::Contains("texture 0"));
    CHECK_THAT(plan.out, Catch::Contains(" of 4,194,304"));
    CHECK_THAT(plan.out, Catch::Contains("total"));
    CHECK_THAT(plan.out, Catch::EndsWith("fits\n") || Catch::EndsWith("depends\n") || Catch::EndsWith("too long\n"));
}

TEST_CASE("a plan for a machine without limits finds nothing", "[cli][plan]") {
    const Ended plan = nimbus7({"plan", "canyon", "--profile", "ideal", "--size", kSize});
    CHECK(plan.status == 0);
    CHECK(plan.error.empty());
    CHECK_THAT(plan.out, Catch::Contains("nothing: it can draw this frame"));
}

TEST_CASE("a plan in JSON has every finding, block and pass", "[cli][plan]") {
    const std::string profile = GENERATE("dx7", "gamecube", "xbox");
    const Ended plan          = nimbus7({"plan", "canyon", "--profile", profile, "--size", kSize, "--format", "json"});
    const auto json           = nlohmann::json::parse(plan.out);
    CHECK(plan.status == (json["findings"].empty() ? 0 : 3));
    CHECK(json["profile"] == profile);
    CHECK_FALSE(json["rewrites"].empty());
    CHECK(json["findings"].empty() == (profile == "xbox"));
    for (const auto& finding : json["findings"]) {
        CAPTURE(finding.dump());
        CHECK_FALSE(finding["source"].get<std::string>().empty());
        CHECK(finding["uses"] != finding["has"]);
    }
    CHECK_FALSE(json["memory"]["blocks"].empty());
    double least = 0.0;
    for (const auto& pass : json["cost"]["passes"]) {
        least += pass["ms"]["least"].get<double>();
        CHECK(pass["ms"]["least"].get<double>() <= pass["ms"]["most"].get<double>());
    }
    CHECK(least > 0.0);
    CHECK(json["cost"]["total"]["ms"]["least"].get<double>() == Approx(least));
}

TEST_CASE("a plan needs a chip that is known, and a format that is", "[cli][plan]") {
    CHECK(nimbus7({"plan", "canyon"}).status == 2);
    CHECK(nimbus7({"plan", "canyon", "--profile", "ps3"}).status == 2);
    CHECK(nimbus7({"plan", "canyon", "--profile", "ps2", "--format", "xml"}).status == 2);
    CHECK(nimbus7({"plan", "no-such", "--profile", "ps2"}).status == 2);
}
