// SPDX-License-Identifier: MIT
// Every command that writes, where it cannot: a full disk, a path that is none, Ctrl-C in the midst. An older file stays
// as it was, no other is left, and there is one line that says why.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/support/child_process.h"
#include "tests/support/puff_scene.h"

namespace {

using tests::Ended;
using tests::Midst;
using tests::ScratchDirectory;
using Words = std::vector<std::string>;

const std::string kScene = tests::puff_scene();

// A command, the files that it makes, and where the first of them is named among its words.
struct Writer {
    Words words;
    Words files;
    std::size_t path;
};

const std::vector<Writer>& writers() {
    static const std::vector<Writer> all{
        {{"render", "puff.toml", "-o", "f.png"}, {"f.png"}, 3},
        {{"dump", "puff.toml", "-o", "f.txt"}, {"f.txt"}, 3},
        {{"emit", "puff.toml", "--profile", "ps2", "-o", "f.gs"}, {"f.gs"}, 5},
        {{"emit", "puff.toml", "--profile", "ps2", "--text", "-o", "f.gs.txt"}, {"f.gs.txt"}, 6},
        {{"emit", "puff.toml", "--profile", "dx7", "-o", "f.cpp"}, {"f.bin", "f.cpp"}, 5},
        {{"emit", "puff.toml", "--profile", "gamecube", "-o", "f.c"}, {"f.bin", "f.c"}, 5},
        {{"emit", "puff.toml", "--profile", "xbox", "-o", "f.nv2a.txt"}, {"f.nv2a.bin", "f.nv2a.txt"}, 5},
        {{"bench", "--from", "figures.json", "--json", "f.json"}, {"f.json"}, 4},
        {{"bench", "--from", "figures.json", "--plot", "f.svg"}, {"f.svg"}, 4},
    };
    return all;
}

// As nimbus7_bench writes them.
const std::string kFigures = R"({"context": {}, "benchmarks": [
  {"name": "growth/spheres/16", "run_name": "growth/spheres/16", "run_type": "iteration", "size": 16,
   "real_time": 1.5, "time_unit": "ms"},
  {"name": "growth/spheres/64", "run_name": "growth/spheres/64", "run_type": "iteration", "size": 64,
   "real_time": 4.5, "time_unit": "ms"}]})";

// The program beside nimbus7 is there only with Google Benchmark.
bool is_there(const Writer& writer) {
    return writer.words[0] != "bench" ||
           std::filesystem::exists(std::filesystem::path(NIMBUS7_PROGRAM).parent_path() / "nimbus7_bench");
}

class Place {
  public:
    Place() {
        tests::write_file(directory_ / "puff.toml", kScene);
        tests::write_file(directory_ / "figures.json", kFigures);
    }

    void put_older(const Writer& writer) const {
        for (const std::string& file : writer.files) tests::write_file(directory_ / file, "older " + file);
    }

    Ended run(const Words& words, const tests::RunOptions& options = {}) const {
        return tests::run_program(NIMBUS7_PROGRAM, words, directory_.path(), options);
    }

    void check_older(const Writer& writer) const {
        Words files = writer.files;
        files.insert(files.end(), {"figures.json", "puff.toml"});
        std::sort(files.begin(), files.end());
        CHECK(directory_.files() == files);
        for (const std::string& file : writer.files)
            CHECK((tests::read_file(directory_ / file) == "older " + file));  // not printed: it may be long
    }

    std::string operator/(const std::string& name) const { return directory_ / name; }

  private:
    ScratchDirectory directory_;
};

std::string line_of(const Words& words) {
    std::string line = "nimbus7";
    for (const std::string& word : words) line += ' ' + word;
    return line;
}

void check_refused(const Ended& ended) {
    INFO(ended.error);
    CHECK(ended.status == 2);
    CHECK((!ended.error.empty() && ended.error.find('\n') == ended.error.size() - 1));
    CHECK(ended.error.starts_with("nimbus7"));
}

}  // namespace

TEST_CASE("a command that writes does so, and replaces what was there", "[output]") {
    for (const Writer& writer : writers()) {
        if (!is_there(writer)) continue;
        INFO(line_of(writer.words));
        const Place place;
        place.put_older(writer);
        const Ended ended = place.run(writer.words);
        INFO(ended.error);
        CHECK(ended.status == 0);
        for (const std::string& file : writer.files) CHECK(tests::read_file(place / file) != "older " + file);
    }
}

TEST_CASE("on a full disk older files stay, both or none of two", "[output]") {
    for (const Writer& writer : writers()) {
        if (!is_there(writer)) continue;
        // There is room for an error message alone; or, where there are two files, for the smaller one.
        for (const std::int64_t most : {std::int64_t{256}, std::int64_t{0}}) {
            const Place place;
            std::int64_t bytes = most;
            if (most == 0) {
                if (writer.files.size() < 2) continue;
                REQUIRE(place.run(writer.words).status == 0);
                const auto size = [&](std::size_t i) {
                    return static_cast<std::int64_t>(std::filesystem::file_size(place / writer.files[i]));
                };
                bytes = std::max(size(0), size(1)) - 1;
            }
            INFO(line_of(writer.words) << " with at most " << bytes << " bytes a file");
            place.put_older(writer);
            check_refused(place.run(writer.words, {.max_file_bytes = bytes}));
            place.check_older(writer);
        }
    }
}

TEST_CASE("Ctrl-C in the midst of a file leaves older ones and no other", "[output]") {
    for (const Writer& writer : writers()) {
        if (!is_there(writer)) continue;
        for (const Midst midst : {Midst::Made, Midst::Written}) {
            INFO(line_of(writer.words) << (midst == Midst::Made ? ", made" : ", written"));
            const Place place;
            place.put_older(writer);
            const Ended ended = place.run(writer.words, {.interrupt_in_midst = midst});
            CHECK(ended.status == 130);
            CHECK(ended.error == "");
            place.check_older(writer);
        }
    }
}

TEST_CASE("what cannot be a file is refused before anything is done", "[output]") {
    for (const Writer& writer : writers()) {
        if (!is_there(writer)) continue;
        for (const std::string& parent : {std::string("none/"), std::string("puff.toml/"), std::string("/proc/")}) {
            const Place place;
            Words words        = writer.words;
            words[writer.path] = parent + words[writer.path];
            INFO(line_of(words));
            check_refused(place.run(words));
        }
        const Place place;
        std::filesystem::create_directory(place / writer.words[writer.path]);
        INFO(line_of(writer.words) << ", which is a directory");
        check_refused(place.run(writer.words));
    }
}

TEST_CASE("pictures of passes, vectors and the sheet are whole or not there", "[output]") {
    const Place place;
    // Passes: those that were finished stay.
    check_refused(place.run({"render", "puff.toml", "--passes", "p", "-o", "f.png"}, {.max_file_bytes = 200}));
    CHECK_FALSE(std::filesystem::exists(place / "f.png"));
    for (const auto& entry : std::filesystem::directory_iterator(place / "p"))
        CHECK(tests::read_file(entry.path()).ends_with(std::string_view("IEND\xae\x42\x60\x82", 8)));
    // Vectors: no manifest, where not all that it lists is there.
    check_refused(place.run({"vectors", "--profile", "ps2", "-o", "v"}, {.max_file_bytes = 100}));
    CHECK_FALSE(std::filesystem::exists(place / "v/manifest.json"));
    const Ended ended = place.run({"vectors", "--profile", "ps2", "-o", "v"}, {.interrupt_in_midst = Midst::Written});
    CHECK(ended.status == 130);
    CHECK_FALSE(std::filesystem::exists(place / "v/manifest.json"));
    for (const auto& entry : std::filesystem::recursive_directory_iterator(place / "v"))
        CHECK(entry.path().filename().string().starts_with(".") == false);
    for (const char* path : {"none/s.png", "/proc/s.png", "p", "s"})
        check_refused(place.run({"scenes", "--sheet", path}));
}

TEST_CASE("a standard output that is full is an error", "[output]") {
    const Words words = GENERATE(Words{"fields"}, Words{"scenes"}, Words{"profiles"}, Words{"dump", "puff.toml"},
                                 Words{"render", "puff.toml"}, Words{"plan", "puff.toml", "--profile", "xbox"});
    INFO(line_of(words));
    const Place place;
    const Ended ended = place.run(words, {.has_full_output = true});
    check_refused(ended);
    CHECK(ended.error == "nimbus7: standard output: No space left on device\n");
}
