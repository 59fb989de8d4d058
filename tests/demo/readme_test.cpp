// SPDX-License-Identifier: MIT
// What the README quotes is what the program and the scene files say.
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "demo/chip_table.h"
#include "demo/command_profiles.h"
#include "demo/embedded_texts.h"
#include "demo/pass_statistics.h"
#include "demo/scene.h"
#include "pipeline/execute/execute.h"

namespace {

std::string read(const std::string& name) {
    std::ifstream file(std::string(NIMBUS7_SOURCE_DIR "/") + name, std::ios::binary);
    REQUIRE(file);
    return {std::istreambuf_iterator<char>(file), {}};
}

// The code block that follows `fence` (a line) in the README, up to its closing fence.
std::string block_after(const std::string& heading, const std::string& fence) {
    const std::string readme = read("README.md");
    const std::size_t from   = readme.find(heading);
    REQUIRE(from != std::string::npos);
    const std::size_t start = readme.find("\n" + fence + "\n", from);
    REQUIRE(start != std::string::npos);
    const std::size_t text = start + fence.size() + 2;
    return readme.substr(text, readme.find("```", text) - text);
}

// Without the last column, which is time.
std::vector<std::string> timeless_lines(const std::string& table) {
    std::vector<std::string> lines;
    std::istringstream in(table);
    for (std::string line; std::getline(in, line);) {
        const std::size_t end = line.find_last_not_of(' ');
        lines.push_back(line.substr(0, line.find_last_of(' ', end)));
        lines.back().erase(lines.back().find_last_not_of(' ') + 1);
    }
    return lines;
}

}  // namespace

TEST_CASE("the README's scene is the one of the reference pictures", "[readme]") {
    CHECK(block_after("## A scene of your own", "```toml") == read("reference_images/two_clouds.toml"));
}

TEST_CASE("the README's table of passes is what the program prints", "[readme]") {
    const demo::ScenePtr scene = demo::load_scene("canyon");
    std::vector<demo::PassStatistics> passes;
    pipeline::execute(demo::scene_frame(*scene, demo::default_size(*scene), 0), {},
                      [&](const pipeline::FinishedPass& pass) {
                          passes.push_back({pass.pass.label, pass.counts, pass.kernels, 0.0});
                      });
    CHECK(timeless_lines(block_after("## How a frame gets its cloud", "```")) ==
          timeless_lines(demo::to_table(passes)));
}

TEST_CASE("the README's table of four chips is what the program prints", "[readme]") {
    demo::ChipFrameOptions options;
    options.scene  = "canyon";
    options.size   = demo::Size{640, 448};
    options.reduce = true;
    CHECK(read("README.md").find("\n\n" + demo::chip_table(options) + "\n") != std::string::npos);
}

TEST_CASE("the README counts the small frames", "[readme]") {
    const std::string count = std::to_string(demo::embedded_frames().size()) + " small frames";
    const std::string text  = read("README.md");
    CHECK(text.find("on " + count) != std::string::npos);
    CHECK(text.find("counts of all " + count) != std::string::npos);
}

TEST_CASE("the README's table of chips and list of open questions are what the program prints", "[readme]") {
    CHECK(block_after("## How the chips compute", "```") == demo::list_of_profiles());
    CHECK(read("README.md").find("\n\n" + demo::open_questions() + "\n") != std::string::npos);
}
