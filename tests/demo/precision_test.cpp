// SPDX-License-Identifier: MIT
// nimbus7 --precision: all that it changes stands in the frame.
#include <catch2/catch.hpp>

#include "demo/precision.h"
#include "tests/support/child_process.h"
#include "tests/support/puff_scene.h"

namespace {

using tests::Ended;
using tests::ScratchDirectory;
using Words = std::vector<std::string>;

const std::string kScene = tests::puff_scene({.size = "96, 64", .radius = "14", .blur = "1.5"});

Ended nimbus7(const ScratchDirectory& directory, const Words& arguments) {
    return tests::run_program(NIMBUS7_PROGRAM, arguments, directory.path());
}

}  // namespace

TEST_CASE("a fast frame is what its dump says", "[precision]") {
    const ScratchDirectory directory;
    tests::write_file(directory / "puff.toml", kScene);
    const auto picture = [&](const Words& more) {
        Words words{"render"};
        words.insert(words.end(), more.begin(), more.end());
        words.insert(words.end(), {"-o", "out.png"});
        REQUIRE(nimbus7(directory, words).status == 0);
        return tests::read_file(directory / "out.png");
    };
    const std::string exact = picture({"puff.toml"}), fast = picture({"puff.toml", "--precision", "fast"});
    CHECK(picture({"puff.toml", "--precision", "exact"}) == exact);
    CHECK(fast != exact);
    REQUIRE(nimbus7(directory, {"dump", "puff.toml", "--precision", "fast", "-o", "fast.txt"}).status == 0);
    CHECK(picture({"fast.txt"}) == fast);
}

TEST_CASE("precision is of scenes, and one of two", "[precision]") {
    const ScratchDirectory directory;
    tests::write_file(directory / "puff.toml", kScene);
    REQUIRE(nimbus7(directory, {"dump", "puff.toml", "-o", "puff.txt"}).status == 0);
    const Ended of_dump = nimbus7(directory, {"render", "puff.txt", "--precision", "fast"});
    CHECK(of_dump.status == 2);
    CHECK_THAT(of_dump.error, Catch::Contains("--precision: puff.txt is a dumped frame"));
    for (const char* command : {"render", "dump"}) {
        const Ended unknown = nimbus7(directory, {command, "puff.toml", "--precision", "faster"});
        CHECK(unknown.status == 2);
        CHECK_THAT(unknown.error, Catch::Contains("--precision faster: expected exact or fast"));
    }
    for (const char* command : {"plan", "emit"}) {
        const Words wanted{command, "puff.toml", "--profile", "ps2"};
        Words fast = wanted;
        fast.insert(fast.end(), {"--precision", "fast"});
        CHECK(nimbus7(directory, wanted).out != nimbus7(directory, fast).out);
    }
}

TEST_CASE("an exact precision changes no option", "[precision]") {
    CHECK(demo::with_precision({}).mega_particles == cloud::MegaParticleOptions{});
    const demo::FrameOptions fast = demo::with_precision({.precision = demo::Precision::Fast});
    CHECK(fast.precision == demo::Precision::Exact);
    CHECK_FALSE(fast.mega_particles == cloud::MegaParticleOptions{});
}
