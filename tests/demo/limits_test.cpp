// SPDX-License-Identifier: MIT
// Short texts that ask for all of the memory, or for a day of filling, are refused at once, and --limit raises the limits.
#include <catch2/catch.hpp>

#include "tests/support/child_process.h"

namespace {

using tests::Ended;
using tests::ScratchDirectory;

std::string frame_text(const std::string& targets, const std::string& draws) {
    return "nimbus7 frame 1\noutput #0\ntargets [" + targets + "]\npasses [ { color #0 draws [" + draws + "] } ]\n";
}

std::string repeated(int times, const std::string& text) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
}

}  // namespace

TEST_CASE("a frame beyond a limit is refused in one line, whichever command is given it", "[limits]") {
    struct Case {
        std::string text, what;
    };
    const std::string huge = " { width 8192 height 8192 }";
    const Case big         = GENERATE_COPY(
                Case{frame_text(repeated(31, huge), ""), "must take at most 4294967296 bytes of memory (got 8589934592)"},
                Case{frame_text(" { width 8192 height 8192 }", repeated(300, " rectangle { x1 8192 y1 8192 }")),
             "must fill at most 17179869184 pixels (got 20132659200)"});
    const ScratchDirectory directory;
    tests::write_file(directory / "big.txt", big.text);
    for (const std::vector<std::string>& words : {std::vector<std::string>{"render", "big.txt"},
                                                  {"dump", "big.txt", "-o", "again.txt"},
                                                  {"plan", "big.txt", "--profile", "xbox"},
                                                  {"emit", "big.txt", "--profile", "dx7"},
                                                  {"render", "big.txt", "--limit", "1"}}) {
        const Ended ended = tests::run_program(NIMBUS7_PROGRAM, words, directory.path());
        CHECK(ended.status == 2);
        CHECK(ended.error == "nimbus7: big.txt: frame " + big.what + "; render --limit 2 draws it all the same\n");
        CHECK(directory.files() == std::vector<std::string>{"big.txt"});
    }
}

TEST_CASE("the limits may be exceeded as many times as --limit says", "[limits]") {
    const ScratchDirectory directory;
    tests::write_file(directory / "many.txt", frame_text(" { width 1 height 1 }", " rectangle { }"));
    const auto run = [&](const std::string& limit) {
        return tests::run_program(NIMBUS7_PROGRAM, {"render", "many.txt", "--limit", limit}, directory.path());
    };
    CHECK(run("1").status == 0);
    CHECK(run("1000000").status == 0);
    for (const char* limit : {"0", "-1", "x", "1000001", ""}) {
        const Ended ended = run(limit);
        CHECK(ended.status == 2);
        CHECK(ended.error.starts_with("nimbus7: --limit"));
    }
}
