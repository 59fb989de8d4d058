// SPDX-License-Identifier: MIT
// The pictures in reference_images are, to the last bit, what the commands in its index.md make.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>
#include <sstream>

#include "demo/image_file.h"
#include "tests/golden/scene_inputs.h"
#include "tests/support/child_process.h"
#include "tests/support/image_match.h"

namespace {

namespace fs = std::filesystem;

const std::string kPictures = std::string(NIMBUS7_SOURCE_DIR) + "/reference_images";

// Where failures leave their pictures: golden_failures of the build directory.
std::string failures_folder() {
    return (fs::path(NIMBUS7_PROGRAM).parent_path().parent_path() / "golden_failures").string();
}

// A row of the table: "| [canyon.png](canyon.png) | ... | `demo/run render canyon -o reference_images/canyon.png` |".
struct Golden {
    std::string picture;
    std::vector<std::string> arguments;  // of the program
};

std::string between(const std::string& text, const std::string& before, const std::string& after) {
    const std::size_t start = text.find(before);
    if (start == std::string::npos) return "";
    const std::size_t from = start + before.size(), end = text.find(after, from);
    return end == std::string::npos ? "" : text.substr(from, end - from);
}

std::vector<Golden> read_index() {
    std::istringstream index(tests::read_file(kPictures + "/index.md"));
    std::vector<Golden> goldens;
    for (std::string line; std::getline(index, line);) {
        if (!line.starts_with("| [")) continue;
        Golden golden{between(line, "| [", "]"), {}};
        std::istringstream words(between(line, "| `demo/run ", "` |"));
        for (std::string word; words >> word;) golden.arguments.push_back(word);
        INFO(line);
        REQUIRE(!golden.picture.empty());
        REQUIRE(std::count(golden.arguments.begin(), golden.arguments.end(), "reference_images/" + golden.picture) ==
                1);
        goldens.push_back(golden);
    }
    return goldens;
}

// What the scenes in reference_images name, and the scenes.
std::set<std::string> inputs() {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(kPictures)) {
        if (entry.path().extension() != ".toml") continue;
        names.insert(entry.path().filename());
        const std::string scene = tests::read_file(entry.path());
        for (const fs::directory_entry& image : fs::directory_iterator(kPictures)) {
            const std::string name = image.path().filename();
            if (scene.find('"' + name + '"') != std::string::npos) names.insert(name);
        }
    }
    return names;
}

}  // namespace

TEST_CASE("the reference pictures are exactly what their commands make", "[golden]") {
    const std::vector<Golden> goldens = read_index();
    REQUIRE(goldens.size() >= 4);
    for (const Golden& golden : goldens) {
        // The commands work at the repository's top; here that is a folder with nothing but the inputs.
        const tests::ScratchDirectory top;
        fs::create_directory(top / "reference_images");
        for (const std::string& name : inputs()) fs::copy(kPictures + "/" + name, top / "reference_images");
        const tests::Ended ended = tests::run_program(NIMBUS7_PROGRAM, golden.arguments, top.path());
        INFO(golden.picture << ": " << ended.error);
        REQUIRE(ended.status == 0);
        const pipeline::ColorImage got  = demo::read_image(top / "reference_images/" + golden.picture);
        const pipeline::ColorImage want = demo::read_image(kPictures + "/" + golden.picture);
        const std::string stem          = golden.picture.substr(0, golden.picture.rfind('.'));
        CHECK(test_support::compare_pictures(got, want, failures_folder(), stem) == "");
    }
}

TEST_CASE("reference_images holds nothing that no command makes or reads", "[golden]") {
    std::set<std::string> known = inputs();
    known.insert("index.md");
    for (const Golden& golden : read_index()) {
        known.insert(golden.picture);
        CHECK(fs::exists(kPictures + "/" + golden.picture));
    }
    for (const fs::directory_entry& entry : fs::directory_iterator(kPictures))
        CHECK(known.count(entry.path().filename()) == 1);
}

TEST_CASE("the images of the two-clouds scene follow their rules", "[golden]") {
    const struct {
        const char* name;
        std::string bytes;
    } files[] = {{"two_clouds_heights.png", tests::two_clouds_heights_png()},
                 {"two_clouds_grass.png", tests::two_clouds_grass_png()},
                 {"two_clouds_rock.png", tests::two_clouds_rock_png()}};
    for (const auto& [name, bytes] : files) {
        const bool is_same = tests::read_file(kPictures + "/" + name) == bytes;
        if (!is_same) {
            fs::create_directories(failures_folder());
            tests::write_file(failures_folder() + "/" + name, bytes);
        }
        INFO(name << " is not what its rule gives; that lies in " << failures_folder());
        CHECK(is_same);
    }
    const demo::HeightMap map    = demo::read_height_map(kPictures + "/two_clouds_heights.png");
    const auto [lowest, highest] = std::minmax_element(map.heights.begin(), map.heights.end());
    CHECK(map.width == 129);
    CHECK(map.height == 129);
    CHECK(*lowest == 0.0f);
    CHECK(*highest == 1.0f);
}
