// SPDX-License-Identifier: MIT
// The program as a user meets it: exit statuses, one-line errors, files that are there whole or not at all.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/support/child_process.h"
#include "tests/support/puff_scene.h"

namespace {

using tests::Ended;
using tests::RunOptions;
using tests::ScratchDirectory;
using Words = std::vector<std::string>;

const std::string kScene = tests::puff_scene({.more = "[camera.orbit]\ndegrees = 40\nframes = 8\n"});

Ended nimbus7(const ScratchDirectory& directory, const Words& arguments, const RunOptions& options = {}) {
    return tests::run_program(NIMBUS7_PROGRAM, arguments, directory.path(), options);
}

// The scene with the first `old` replaced.
std::string scene_with(const std::string& old, const std::string& replacement) {
    std::string scene    = kScene;
    const std::size_t at = scene.find(old);
    REQUIRE(at != std::string::npos);
    return scene.replace(at, old.size(), replacement);
}

bool is_one_line(const std::string& text) {
    return !text.empty() && text.find('\n') == text.size() - 1;
}

bool is_png(const std::string& bytes) {
    return bytes.starts_with("\x89PNG\r\n\x1a\n") && bytes.ends_with(std::string_view("IEND\xae\x42\x60\x82", 8));
}

}  // namespace

TEST_CASE("a scene is drawn to the file asked for, the same each time", "[cli]") {
    const ScratchDirectory directory;
    tests::write_file(directory / "puff.toml", kScene);
    const Ended first = nimbus7(directory, {"render", "puff.toml"});
    CHECK(first.error == "");
    REQUIRE(first.status == 0);
    CHECK_THAT(first.out, Catch::StartsWith("puff.png  48x32  "));
    CHECK(is_png(tests::read_file(directory / "puff.png")));

    REQUIRE(nimbus7(directory, {"render", "puff.toml", "-o", "again.png", "--threads", "3"}).status == 0);
    CHECK(tests::read_file(directory / "again.png") == tests::read_file(directory / "puff.png"));
    CHECK(directory.files() == Words{"again.png", "puff.png", "puff.toml"});

    REQUIRE(nimbus7(directory, {"render", "puff.toml", "-o", "other.png", "--frames", "2"}).status == 0);
    CHECK(tests::read_file(directory / "other.png") != tests::read_file(directory / "puff.png"));
}

TEST_CASE("a dumped frame is drawn to the same bytes as its scene", "[cli]") {
    const ScratchDirectory directory;
    tests::write_file(directory / "puff.toml", kScene);
    REQUIRE(nimbus7(directory, {"dump", "puff.toml", "--size", "40x30", "--frame", "3", "-o", "puff.txt"}).status == 0);
    const Ended printed = nimbus7(directory, {"dump", "puff.toml", "--size", "40x30", "--frame", "3"});
    CHECK(printed.out == tests::read_file(directory / "puff.txt"));
    REQUIRE(nimbus7(directory, {"render", "puff.txt", "-o", "dump.png"}).status == 0);
    REQUIRE(nimbus7(directory, {"render", "puff.toml", "--size", "40x30", "--frames", "3", "-o", "scene.png"}).status ==
            0);
    CHECK(tests::read_file(directory / "dump.png") == tests::read_file(directory / "scene.png"));

    const Ended sized = nimbus7(directory, {"render", "puff.txt", "--size", "9x9"});
    CHECK(sized.status == 2);
    CHECK(is_one_line(sized.error));
}

TEST_CASE("frames, passes and statistics are written as asked", "[cli]") {
    const ScratchDirectory directory;
    tests::write_file(directory / "puff.toml", kScene);
    REQUIRE(nimbus7(directory, {"render", "puff.toml", "--frames", "0-1", "-o", "f.###.png"}).status == 0);
    CHECK(directory.files() == Words{"f.000.png", "f.001.png", "puff.toml"});

    const Ended text = nimbus7(directory, {"render", "puff.toml", "--stats", "--passes", "passes"});
    REQUIRE(text.status == 0);
    for (const char* heading : {"covered", "z-tested", "z-passed", "written", "blended", "texels", "bytes", "ms"}) {
        CHECK_THAT(text.out, Catch::Contains(heading));
    }
    CHECK(is_png(tests::read_file(directory / "passes/contact_sheet.png")));

    // Both spellings; each pass has a picture and its alpha.
    const Ended json   = nimbus7(directory, {"render", "puff.toml", "--stats=json"});
    const Ended spaced = nimbus7(directory, {"render", "--stats", "json", "puff.toml"});
    REQUIRE(json.status == 0);
    CHECK(spaced.status == 0);
    CHECK_THAT(json.out, Catch::StartsWith("{\n"));
    CHECK_THAT(json.out, Catch::EndsWith("}\n"));
    std::size_t labels = 0;
    for (std::size_t at = 0; (at = json.out.find("\"label\"", at)) != std::string::npos; ++at) ++labels;
    CHECK(labels > 3);
    CHECK(std::count(text.out.begin(), text.out.end(), '\n') == static_cast<std::ptrdiff_t>(labels) + 3);
}

TEST_CASE("the built-in scenes are listed and can be dumped by name", "[cli]") {
    const ScratchDirectory directory;
    const Ended list = nimbus7(directory, {"scenes"});
    REQUIRE(list.status == 0);
    CHECK_THAT(list.out, Catch::Contains("canyon  "));
    const Ended nowhere = nimbus7(directory, {"scenes", "--sheet", "no/such/sheet.png"});
    CHECK(nowhere.status == 2);
    CHECK_THAT(nowhere.error, Catch::Contains("no/such"));
    CHECK_THAT(nimbus7(directory, {"--help"}).out, Catch::Contains("render"));
}

TEST_CASE("a bad scene is one line that names the place, and no picture", "[cli]") {
    struct Case {
        std::string text, error;
    };
    const Case bad =
        GENERATE(Case{scene_with("blur = 1", "blurr = 1"), "nimbus7: bad.toml:12:"},
                 Case{scene_with("blur = 1", "blur = -3"), "nimbus7: bad.toml:12:"},
                 Case{scene_with("blur = 1", "blur = nan"), "nimbus7: bad.toml:12:"},
                 Case{scene_with("blur = 1", "blur = inf"), "nimbus7: bad.toml:12:"},
                 Case{scene_with("blur = 1", "blur = \"soft\""), "nimbus7: bad.toml:12:"},
                 Case{scene_with("blur = 1", "blur ="), "nimbus7: bad.toml:12:"},
                 Case{scene_with("0, 10]]", "0, -10]]"), "nimbus7: bad.toml:11:"},
                 Case{scene_with("0, 10]]", "0, nan]]"), "nimbus7: bad.toml:11:"},
                 Case{scene_with("[48, 32]", "[0, 0]"), "nimbus7: bad.toml:3:"},
                 Case{scene_with("[48, 32]", "[48, 99999]"), "nimbus7: bad.toml:3:"},
                 Case{scene_with("target = [0, 5, 0]", "target = [0, 5, 60]"), "nimbus7: bad.toml:"},
                 Case{kScene + "[terrain]\nheight_map = \"none.png\"\n", "nimbus7: bad.toml:"},
                 Case{kScene + "[terrain]\nheight_map = \"bad.toml\"\n", "nimbus7: bad.toml:"},
                 Case{kScene + "[terrain]\nheight_map = \"bad.png\"\n", "nimbus7: bad.toml:"},
                 Case{"", "nimbus7: bad.toml: "}, Case{"nimbus7 frame 1\nnonsense\n", "nimbus7: bad.toml:2:"},
                 Case{std::string(100, '\0'), "nimbus7: bad.toml:1:"});
    const ScratchDirectory directory;
    tests::write_file(directory / "bad.toml", bad.text);
    // The start of a PNG, which the PNG library complains about by itself.
    const std::string older = std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0", 18);
    tests::write_file(directory / "bad.png", older);
    const Ended ended = nimbus7(directory, {"render", "bad.toml"});
    INFO(ended.error << "\nfor\n" << bad.text);
    if (bad.text.empty()) {
        CHECK(ended.status == 0);  // every key may be left out
        return;
    }
    CHECK(ended.status == 2);
    CHECK(ended.out == "");
    CHECK(is_one_line(ended.error));
    CHECK_THAT(ended.error, Catch::StartsWith(bad.error));
    CHECK(tests::read_file(directory / "bad.png") == older);
    CHECK(directory.files() == Words{"bad.png", "bad.toml"});
}

TEST_CASE("bad usage is one line on standard error and status 2", "[cli]") {
    const Words arguments = GENERATE(
        Words{}, Words{"frobnicate"}, Words{"--frobnicate"}, Words{"render"}, Words{"dump"},
        Words{"render", "puff.toml", "more"}, Words{"render", "puff.toml", "--frobnicate"},
        Words{"render", "none.toml"}, Words{"render", "no-such-scene"}, Words{"render", "."}, Words{"scenes", "more"},
        Words{"render", "puff.toml", "--size"}, Words{"render", "puff.toml", "--size", "0x0"},
        Words{"render", "puff.toml", "--size", "-4x4"}, Words{"render", "puff.toml", "--size", "4x-4"},
        Words{"render", "puff.toml", "--size", "8193x4"}, Words{"render", "puff.toml", "--size", "4"},
        Words{"render", "puff.toml", "--size", "4x"}, Words{"render", "puff.toml", "--size", "4.0x4"},
        Words{"render", "puff.toml", "--size", "4x4x4"}, Words{"render", "puff.toml", "--size", "99999999999x4"},
        Words{"render", "puff.toml", "--frames", "3-1"}, Words{"render", "puff.toml", "--frames", "-1"},
        Words{"render", "puff.toml", "--frames", "1-"}, Words{"render", "puff.toml", "--frames", "a-b"},
        Words{"render", "puff.toml", "--frames", ""}, Words{"render", "puff.toml", "--frames", "0-1", "-o", "f.png"},
        Words{"render", "puff.toml", "--frames", "0-1", "--passes", "p"},
        Words{"render", "puff.toml", "--threads", "-1"}, Words{"render", "puff.toml", "--threads", "many"},
        Words{"render", "puff.toml", "--simd", "ENIAC"}, Words{"render", "puff.toml", "--profile", "voodoo"},
        Words{"render", "puff.toml", "--stats=xml"}, Words{"dump", "puff.toml", "--frame", "x"},
        // Where nothing can be written.
        Words{"render", "puff.toml", "-o", ""}, Words{"render", "puff.toml", "-o", "."},
        Words{"render", "puff.toml", "-o", "none/f.png"}, Words{"render", "puff.toml", "-o", "puff.toml/f.png"},
        Words{"render", "puff.toml", "-o", "/proc/f.png"}, Words{"render", "puff.toml", "-o", "/dev/null"},
        Words{"render", "puff.toml", "-o", "f"}, Words{"render", "puff.toml", "-o", "f.unknown"},
        Words{"render", "puff.toml", "-o", "f.term"}, Words{"render", "puff.toml", "--passes", "none/p"},
        Words{"render", "puff.toml", "--passes", "puff.toml"}, Words{"dump", "puff.toml", "-o", "none/f"},
        Words{"dump", "puff.toml", "-o", "."}, Words{"dump", "puff.toml", "-o", "/dev/full"});
    const ScratchDirectory directory;
    tests::write_file(directory / "puff.toml", kScene);
    const Ended ended = nimbus7(directory, arguments);
    std::string line;
    for (const std::string& word : arguments) line += " '" + word + "'";
    INFO("nimbus7" << line << "\n" << ended.error);
    CHECK(ended.status == 2);
    CHECK(ended.out == "");
    CHECK(is_one_line(ended.error));
    CHECK_THAT(ended.error, Catch::StartsWith("nimbus7: "));
    CHECK(directory.files() == Words{"puff.toml"});
}

TEST_CASE("a picture that cannot be finished leaves the older one", "[cli]") {
    const std::string name = GENERATE("f.png", "f.jpg", "f.exr", "f.tif", "f.tga", "f.bmp");
    const ScratchDirectory directory;
    tests::write_file(directory / "puff.toml", kScene);
    tests::write_file(directory / name, "an older picture");
    const Ended ended =
        nimbus7(directory, {"render", "puff.toml", "--size", "64x64", "-o", name}, {.max_file_bytes = 300});
    INFO(name << ": " << ended.error);
    CHECK(ended.status == 2);
    CHECK(is_one_line(ended.error));
    CHECK(tests::read_file(directory / name) == "an older picture");
    CHECK(directory.files() == Words{name, "puff.toml"});

    REQUIRE(nimbus7(directory, {"render", "puff.toml", "--size", "64x64", "-o", name}).status == 0);
    CHECK(tests::read_file(directory / name) != "an older picture");
}

TEST_CASE("Ctrl-C ends the program with 130 and leaves no half file", "[cli]") {
    const int milliseconds = GENERATE(300, 470, 640);
    const ScratchDirectory directory;
    tests::write_file(directory / "puff.toml", kScene);
    const Ended ended = nimbus7(directory, {"render", "puff.toml", "--frames", "0-999999", "-o", "f.#.png"},
                                {.interrupt_after_ms = milliseconds});
    CHECK(ended.status == 130);
    for (const std::string& name : directory.files()) {
        INFO(name);
        const bool is_whole = name == "puff.toml" || is_png(tests::read_file(directory / name));
        CHECK(is_whole);
    }
}
