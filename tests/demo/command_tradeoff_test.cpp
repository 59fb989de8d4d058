// SPDX-License-Identifier: MIT
// nimbus7 tradeoff as a user meets it, and the structure of its page.
#include <algorithm>
#include <catch2/catch.hpp>
#include <regex>
#include <set>

#include "tests/support/child_process.h"
#include "tests/support/puff_scene.h"

namespace {

using tests::Ended;
using tests::ScratchDirectory;
using Words = std::vector<std::string>;

const std::string kScene = tests::puff_scene();

Ended tradeoff(const ScratchDirectory& directory, const Words& arguments) {
    Words words{"tradeoff"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return tests::run_program(NIMBUS7_PROGRAM, words, directory.path());
}

bool is_one_line(const std::string& text) {
    return !text.empty() && text.find('\n') == text.size() - 1;
}

Words matches(const std::string& text, const std::string& pattern) {
    Words found;
    const std::regex regex(pattern);
    for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at) found.push_back((*at)[1]);
    return found;
}

std::string without(const std::string& text, const std::string& from, const std::string& to) {
    std::string out = text;
    for (std::size_t at = 0; (at = out.find(from, at)) != std::string::npos;) {
        const std::size_t end = out.find(to, at);
        REQUIRE(end != std::string::npos);
        out.erase(at, end + to.size() - at);
    }
    return out;
}

// The first element that is closed where another is open, or never: "" if there is none.
std::string unbalanced(const std::string& html) {
    const std::set<std::string> empty{"meta", "img", "input", "br", "link"};
    Words open;
    const std::regex tag("<(/?)([a-zA-Z][a-zA-Z0-9]*)[^>]*?(/?)>");
    for (std::sregex_iterator at(html.begin(), html.end(), tag), end; at != end; ++at) {
        const std::string name = (*at)[2];
        if (empty.count(name) > 0 || (*at)[3].length() > 0) continue;
        if ((*at)[1].length() == 0) {
            open.push_back(name);
            continue;
        }
        if (open.empty() || open.back() != name) return name;
        open.pop_back();
    }
    return open.empty() ? "" : open.back();
}

}  // namespace

TEST_CASE("a trade-off is a directory of a table, a chart and a page", "[tradeoff]") {
    const ScratchDirectory directory;
    tests::write_file(directory / "puff.toml", kScene);
    const Words wanted{"puff.toml", "-o", "out", "--size", "64x64", "--runs", "1"};
    const Ended first = tradeoff(directory, wanted);
    CHECK(first.error == "");
    REQUIRE(first.status == 0);
    CHECK(first.out == "out\n");
    CHECK(directory.files() == Words{"out", "puff.toml"});
    CHECK(tests::read_file(directory / "out/tradeoff.png").starts_with("\x89PNG\r\n\x1a\n"));
    CHECK_THAT(tests::read_file(directory / "out/tradeoff.svg"),
               Catch::StartsWith("<svg ") && Catch::EndsWith("</svg>\n"));
    const std::string csv = tests::read_file(directory / "out/tradeoff.csv");
    CHECK_THAT(csv, Catch::StartsWith("setting,") && Catch::Contains("\nexact,"));

    const std::string page = tests::read_file(directory / "out/index.html");
    const std::string tags = without(without(page, "<script>", "</script>"), "<!--", "-->");
    CHECK(unbalanced(without(tags, "<style>", "</style>")) == "");
    CHECK(page.find("{{") == std::string::npos);
    CHECK_THAT(page, Catch::StartsWith("<!DOCTYPE html>") && Catch::Contains("<html lang=\"en\">") &&
                         Catch::Contains("name=\"viewport\"") && Catch::Contains("prefers-color-scheme: dark"));
    // It needs nothing from elsewhere.
    CHECK(matches(page, "(?:src|href)=\"((?!data:image/png;base64,)[^\"]{0,40})").empty());
    CHECK(matches(page, "(https?://(?!www\\.w3\\.org/2000/svg)[^\"]*)").empty());
    // Each name once; what refers to one finds it.
    Words ids = matches(tags, " id=\"([^\"]*)\"");
    std::sort(ids.begin(), ids.end());
    CHECK(std::adjacent_find(ids.begin(), ids.end()) == ids.end());
    Words named = matches(tags, " (?:for|aria-labelledby)=\"([^\"]*)\"");
    for (const std::string& id : matches(tags, "<option value=\"([^\"]*)\"")) named.push_back(id);
    for (const std::string& id : matches(page, "\\bat\\(\"([^\"]*)\"\\)")) named.push_back(id);
    CHECK(named.size() > 8);
    for (const std::string& id : named) {
        INFO(id);
        CHECK(std::binary_search(ids.begin(), ids.end(), id));
    }
    CHECK(matches(tags, "<img((?![^>]* alt=)[^>]{0,40})").empty());
    // A row for each setting, a picture for each on a front, and the truth.
    const auto rows = std::count(csv.begin(), csv.end(), '\n') - 1;
    CHECK(static_cast<std::ptrdiff_t>(matches(tags, "(<th scope=\"row\">)").size()) == rows);
    const std::size_t on_front = matches(tags, "(<tr class=\"front\">)").size();
    CHECK(on_front >= 1);
    CHECK(matches(tags, "<img id=\"(picture-)").size() == on_front + 1);
    CHECK(matches(tags, "(<option )").size() == 2 * (on_front + 1));

    // Again, over what is there.
    CHECK(tradeoff(directory, wanted).status == 0);
    CHECK(directory.files() == Words{"out", "puff.toml"});
}

TEST_CASE("a trade-off's front is printed as Markdown", "[tradeoff]") {
    const ScratchDirectory directory;
    tests::write_file(directory / "puff.toml", kScene);
    const Ended printed =
        tradeoff(directory, {"puff.toml", "--table", "--size", "64x64", "--runs", "1", "--threads", "2"});
    REQUIRE(printed.status == 0);
    CHECK_THAT(printed.out,
               Catch::StartsWith("| scene | setting | time |") && Catch::Contains("\n| puff | exact | 1.00 |"));
    CHECK(directory.files() == Words{"puff.toml"});
}

TEST_CASE("a trade-off that cannot be is one line, and no directory", "[tradeoff]") {
    const ScratchDirectory directory;
    tests::write_file(directory / "puff.toml", kScene);
    tests::write_file(directory / "file", "");
    const Words bad =
        GENERATE(Words{"puff.toml"}, Words{"-o", "out"}, Words{"nowhere.toml", "-o", "out"},
                 Words{"puff.toml", "-o", "out", "--size", "63x64"}, Words{"puff.toml", "-o", "out", "--size", "64"},
                 Words{"puff.toml", "-o", "out", "--size", "2048x1025"}, Words{"puff.toml", "-o", "out", "--runs", "0"},
                 Words{"puff.toml", "-o", "out", "--runs", "many"}, Words{"puff.toml", "-o", "out", "--threads", "-1"},
                 Words{"puff.toml", "-o", "out", "--frame", "x"}, Words{"puff.toml", "-o", "file"},
                 Words{"puff.toml", "-o", "no/such/out"}, Words{"puff.toml", "-o", "."}, Words{"puff.toml", "-o", ""});
    const Ended ended = tradeoff(directory, bad);
    INFO(Catch::rangeToString(bad));
    CHECK(ended.status == 2);
    CHECK(ended.out == "");
    CHECK(is_one_line(ended.error));
    CHECK(directory.files() == Words{"file", "puff.toml"});
}
