// SPDX-License-Identifier: MIT
// The README's program for golden vectors compiles as C99 without a warning, and tells right from wrong.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "demo/vectors/npy_file.h"
#include "demo/vectors/vector_probe.h"
#include "demo/vectors/vector_tables.h"
#include "tests/support/child_process.h"

namespace {

using tests::Ended;

// The text between the line "```c" and the next "```".
std::string c_program(const std::string& readme) {
    const std::string fence = "\n```c\n";
    const std::size_t start = readme.find(fence);
    REQUIRE(start != std::string::npos);
    const std::size_t end = readme.find("\n```\n", start + fence.size());
    REQUIRE(end != std::string::npos);
    CHECK(readme.find(fence, end) == std::string::npos);  // there is one
    return readme.substr(start + fence.size(), end + 1 - start - fence.size());
}

// The file that `nimbus7 vectors --profile ps2` writes.
std::string vectors_file(const std::string& name) {
    const pipeline::Profile& ps2 = *pipeline::find_profile("ps2");
    demo::Prober prober(ps2.arithmetic);
    const auto tables = demo::vector_tables(ps2, prober);
    const auto table  = std::find_if(tables.begin(), tables.end(), [&](const auto& one) { return one.name == name; });
    REQUIRE(table != tables.end());
    std::vector<std::size_t> shape;
    for (const demo::Axis& axis : table->axes) shape.push_back(demo::axis_size(axis));
    return demo::to_npy(shape, table->draw());
}

}  // namespace

TEST_CASE("the README's C program checks a blend against its golden vectors", "[readme]") {
    const tests::ScratchDirectory directory;
    tests::write_file(directory / "check.c", c_program(tests::read_file(NIMBUS7_SOURCE_DIR "/README.md")));
    const Ended compiled = tests::run_program(
        "/usr/bin/env", {"cc", "-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror", "-O1", "-o", "check", "check.c"},
        directory.path());
    INFO(compiled.error);
    REQUIRE(compiled.status == 0);
    const auto check = [&](const std::string& file) {
        return tests::run_program(directory / "check", {file}, directory.path());
    };

    std::string array = vectors_file("blend_44_color");
    tests::write_file(directory / "right.npy", array);
    const Ended right = check("right.npy");
    CHECK(right.status == 0);
    CHECK(right.out == "16777216 of 16777216 agree\n");

    array[demo::kNpyHeaderBytes + (200 * 256 + 100) * 256 + 50] ^= 1;
    tests::write_file(directory / "wrong.npy", array);
    const Ended wrong = check("wrong.npy");
    CHECK(wrong.status == 1);
    CHECK_THAT(wrong.out, Catch::StartsWith("As 200, Cd 100, Cs 50: "));
    CHECK_THAT(wrong.out, Catch::EndsWith("\n16777215 of 16777216 agree\n"));

    tests::write_file(directory / "short.npy", array.substr(0, 1000));
    for (const char* const file : {"short.npy", "none.npy", "check.c"}) {
        const Ended bad = check(file);
        CHECK(bad.status == 2);
        CHECK_THAT(bad.error, Catch::StartsWith("check: "));
    }
}
