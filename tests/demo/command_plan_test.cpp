// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
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
    const Ended plan = nimbus7({"plan", "canyon", "--profile", "ps2", "--size", "640x448"});
    CHECK(plan.status == 3);
    CHECK_THAT(plan.error, Catch::StartsWith("nimbus7: ps2 cannot draw canyon: 1 finding"));
    CHECK_THAT(plan.out, Catch::Contains("reversed_depth: "));
    CHECK_THAT(plan.out, Catch::Contains("window_triangles: the chip takes triangles in window space alone"));
    CHECK_THAT(plan.out, Catch::Contains("bytes of local memory [memory]"));
    CHECK_THAT(plan.out, Catch::Contains("[memory] parallel-gs"));
    CHECK_THAT(plan.out, Catch::Contains("texture 0"));
    CHECK_THAT(plan.out, Catch::Contains(" of 4,194,304"));
    CHECK_THAT(plan.out, Catch::Contains("total"));
    CHECK_THAT(plan.out, Catch::EndsWith("fits\n") || Catch::EndsWith("depends\n") || Catch::EndsWith("too long\n"));
}

TEST_CASE("a plan has the passes in the chip's own words", "[cli][plan]") {
    const auto words = [](const char* profile) {
        const Ended plan = nimbus7({"plan", "canyon", "--profile", profile, "--size", kSize, "--words"});
        CHECK(plan.status == 0);
        const std::size_t start = plan.out.find("Passes in its own words");
        REQUIRE(start != std::string::npos);
        return plan.out.substr(start);
    };
    CHECK_THAT(words("ps2"), Catch::Contains("pass 0 'walls'") && Catch::Contains("42 ALPHA_1 ") &&
                                 Catch::Contains("4c FRAME_1 ") && !Catch::Contains(" XYZF2 "));
    CHECK_THAT(words("xbox"), Catch::Contains("NV097_SET_BLEND_FUNC_SFACTOR") && !Catch::Contains("ARRAY_ELEMENT"));
    CHECK_THAT(words("dx7"), Catch::Contains("D3DRENDERSTATE_SRCBLEND"));
    CHECK_THAT(words("gamecube"), Catch::Contains("GX_SetBlendMode"));
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

TEST_CASE("what does not fit is reduced until it does, and drawn and written so", "[cli][plan]") {
    const tests::ScratchDirectory directory;
    const auto run = [&](const std::vector<std::string>& arguments) {
        return tests::run_program(NIMBUS7_PROGRAM, arguments, directory.path());
    };
    const Ended plan = run({"plan", "canyon", "--profile", "ps2", "--size", "640x448", "--fit", "--format", "json"});
    CHECK(plan.status == 0);
    const auto json = nlohmann::json::parse(plan.out);
    CHECK(json["findings"].empty());
    CHECK(json["memory"]["regions"][0]["over"] == 0);
    const int width = json["reduction"]["width"], height = json["reduction"]["height"];
    CHECK(width < 640);
    CHECK(width >= 320);

    const Ended too_large = run({"render", "canyon", "--profile", "ps2", "--size", "640x448", "-o", "a.png"});
    CHECK(too_large.status == 3);
    CHECK_THAT(too_large.error, Catch::Contains("--fit"));
    CHECK_FALSE(std::filesystem::exists(directory / "a.png"));
    const Ended drawn = run({"render", "canyon", "--profile", "ps2", "--size", "640x448", "--fit", "-o", "b.png"});
    CHECK(drawn.status == 0);
    CHECK_THAT(drawn.out, Catch::Contains("b.png  " + std::to_string(width) + "x" + std::to_string(height)));
}

TEST_CASE("a frame is written in each chip's words, whole or not at all", "[cli][plan]") {
    const tests::ScratchDirectory directory;
    const auto run = [&](const std::vector<std::string>& arguments) {
        return tests::run_program(NIMBUS7_PROGRAM, arguments, directory.path());
    };
    const auto start_of = [&](const char* name) {
        std::ifstream file(directory / name, std::ios::binary);
        std::string text(4, '\0');
        file.read(text.data(), 4);
        return text;
    };
    const auto emit = [&](const char* profile, const char* name) {
        return run({"emit", "canyon", "--profile", profile, "--size", kSize, "-o", name});
    };
    CHECK(emit("ps2", "c.gs").status == 0);
    CHECK(start_of("c.gs") == "\xff\xff\xff\xff");
    CHECK(emit("dx7", "c.cpp").status == 0);
    CHECK(start_of("c.cpp").substr(0, 2) == "//");
    CHECK(std::filesystem::exists(directory / "c.bin"));
    CHECK(emit("xbox", "x.txt").status == 0);
    CHECK(std::filesystem::exists(directory / "x.bin"));
    CHECK(emit("ideal", "i.txt").status == 2);
    CHECK_FALSE(std::filesystem::exists(directory / "i.txt"));
    CHECK(run({"emit", "canyon", "--profile", "xbox", "--text", "--size", kSize}).status == 2);
    CHECK(emit("xbox", "y.bin").status == 2);
    CHECK(emit("xbox", "missing/x.txt").status == 2);
    CHECK(run({"emit", "blast", "--profile", "ps2", "--size", "640x448", "-o", "large.gs"}).status == 3);
    CHECK_FALSE(std::filesystem::exists(directory / "large.gs"));
}

TEST_CASE("a plan needs a chip that is known, and a format that is", "[cli][plan]") {
    CHECK(nimbus7({"plan", "canyon"}).status == 2);
    CHECK(nimbus7({"plan", "canyon", "--profile", "ps3"}).status == 2);
    CHECK(nimbus7({"plan", "canyon", "--profile", "ps2", "--format", "xml"}).status == 2);
    CHECK(nimbus7({"plan", "canyon", "--profile", "all", "--format", "json"}).status == 2);
    CHECK(nimbus7({"render", "canyon", "--fit"}).status == 2);
    CHECK(nimbus7({"plan", "no-such", "--profile", "ps2"}).status == 2);
}
