// SPDX-License-Identifier: MIT
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <stdexcept>

#include "demo/new_directory.h"
#include "tests/support/child_process.h"

namespace {

using tests::ScratchDirectory;
using Names = std::vector<std::string>;

void make_directory(const std::string& path) {
    REQUIRE(mkdir(path.c_str(), 0777) == 0);
}

Names names_in(const ScratchDirectory& scratch, const std::string& name) {
    const Names all = scratch.files();
    CHECK(std::find(all.begin(), all.end(), name) != all.end());
    Names found;
    for (const char* file : {"a", "b", "c"})
        if (access((scratch / (name + "/" + file)).c_str(), F_OK) == 0) found.push_back(file);
    return found;
}

}  // namespace

TEST_CASE("a directory is made with its files", "[new_directory]") {
    const ScratchDirectory scratch;
    demo::write_directory(scratch / "out", {{"a", "one"}, {"b", "two"}});
    CHECK(tests::read_file(scratch / "out/a") == "one");
    CHECK(tests::read_file(scratch / "out/b") == "two");
    CHECK(scratch.files() == Names{"out"});
    make_directory(scratch / "empty");
    demo::write_directory(scratch / "empty/", {{"a", "three"}});
    CHECK(tests::read_file(scratch / "empty/a") == "three");
}

TEST_CASE("an older directory is replaced as a whole", "[new_directory]") {
    const ScratchDirectory scratch;
    demo::write_directory(scratch / "out", {{"a", "old"}, {"b", "old"}});
    REQUIRE(symlink("out", (scratch / "link").c_str()) == 0);
    demo::write_directory(scratch / "link", {{"a", "new"}, {"b", "new"}});
    CHECK(tests::read_file(scratch / "out/a") == "new");
    CHECK(tests::read_file(scratch / "link/b") == "new");
    CHECK(scratch.files() == Names{"link", "out"});
}

TEST_CASE("what cannot be made whole is not made, and what is there stays", "[new_directory]") {
    const ScratchDirectory scratch;
    demo::write_directory(scratch / "out", {{"a", "old"}});
    tests::write_file(scratch / "out/c", "mine");
    tests::write_file(scratch / "file", "");
    const demo::NamedFiles files{{"a", "new"}, {"b", "new"}};
    CHECK_THROWS_WITH(demo::write_directory(scratch / "out", files),
                      Catch::EndsWith("out: holds c, which would be lost"));
    CHECK_THROWS_WITH(demo::write_directory(scratch / "file", files), Catch::EndsWith("file: is not a directory"));
    CHECK_THROWS_WITH(demo::write_directory(scratch / "no/out", files), Catch::Contains("does not exist"));
    CHECK_THROWS_WITH(demo::write_directory("", files), Catch::Contains("the path is empty"));
    // A file that cannot be written comes when others are there already.
    CHECK_THROWS_AS(demo::write_directory(scratch / "new", {{"a", "x"}, {"b/c", "y"}}), std::runtime_error);
    CHECK(tests::read_file(scratch / "out/a") == "old");
    CHECK(tests::read_file(scratch / "out/c") == "mine");
    CHECK(names_in(scratch, "out") == Names{"a", "c"});
    CHECK(scratch.files() == Names{"file", "out"});
}
