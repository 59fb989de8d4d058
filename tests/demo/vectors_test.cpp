// SPDX-License-Identifier: MIT
// `nimbus7 vectors`: every array against formulas of this test's own (support/vector_oracle.h), files against the
// manifest, and all files, last, against the checksums in tests/golden/vectors, which tests/golden/update_vectors makes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "demo/vectors/chip_limits.h"
#include "demo/vectors/npy_file.h"
#include "demo/vectors/sha256.h"
#include "pipeline/execute/execute.h"
#include "pipeline/frame/frame_text.h"
#include "pipeline/profile/profile.h"
#include "tests/support/child_process.h"
#include "tests/support/vector_oracle.h"

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using tests::Ended;
using tests::ScratchDirectory;
using Words = std::vector<std::string>;

struct Npy {
    std::vector<std::size_t> shape;
    std::string values;
};

Npy parse_npy(const std::string& file) {
    REQUIRE(file.size() >= 128);
    CHECK(file.substr(0, 10) == std::string("\x93NUMPY\x01\x00\x76\x00", 10));
    const std::string header = file.substr(10, 118);
    CHECK_THAT(header, Catch::StartsWith("{'descr': '|u1', 'fortran_order': False, 'shape': ("));
    CHECK(header.back() == '\n');
    Npy npy;
    std::size_t at = header.find("'shape': (") + 10;
    while (header[at] != ')') {
        std::size_t end = 0;
        npy.shape.push_back(std::stoul(header.substr(at), &end));
        at += end;
        while (header[at] == ',' || header[at] == ' ') ++at;
    }
    npy.values = file.substr(128);
    CHECK(npy.values.size() ==
          std::accumulate(npy.shape.begin(), npy.shape.end(), std::size_t{1}, std::multiplies<>()));
    return npy;
}

// The file that a manifest's entry names, after a check that it is the one meant.
Npy read_npy(const std::string& directory, const json& entry) {
    const std::string file = tests::read_file(directory + "/" + entry["file"].get<std::string>());
    CHECK(demo::sha256(file) == entry["sha256"].get<std::string>());
    CHECK(entry["dtype"] == "uint8");
    Npy npy = parse_npy(file);
    CHECK(npy.shape == entry["shape"].get<std::vector<std::size_t>>());
    return npy;
}

// Sets the value of `axis` at `index`.
void set_place(test_support::VectorPlace& at, const json& axis, std::size_t index) {
    const std::string name = axis["name"];
    if (axis.contains("first")) {
        at.number[name] = axis["first"].get<int>() + static_cast<int>(index);
        return;
    }
    const json& value = axis["values"][index];
    if (value.is_string()) {
        at.text[name] = value;
    } else if (value.is_number_integer()) {
        at.number[name] = value;
    } else {
        at.real[name] = value;
    }
}

// Every entry of a small array, and of a large one at most 20000, a prime number apart. quads: of the filters.
void check_array(const json& entry, const Npy& npy, const Npy& quads) {
    const std::string file = entry["file"], name = file.substr(0, file.size() - 4);
    const std::vector<std::size_t> primes{1, 3, 7, 13, 53, 211};
    const auto prime =
        std::find_if(primes.begin(), primes.end(), [&](std::size_t each) { return npy.values.size() / each <= 20000; });
    const std::size_t step = prime != primes.end() ? *prime : 839;
    std::size_t wrong      = 0;
    for (std::size_t i = 0; i < npy.values.size(); i += step) {
        test_support::VectorPlace at;
        std::size_t rest = i;
        for (std::size_t axis = npy.shape.size(); axis-- > 0; rest /= npy.shape[axis])
            set_place(at, entry["axes"][axis], rest % npy.shape[axis]);
        if (at.number.contains("quad")) {
            const auto first = static_cast<std::size_t>(at.number["quad"]) * 4;
            for (std::size_t t = 0; t < 4; ++t)
                at.number[(const char* const[]){"t00", "t10", "t01", "t11"}[t]] =
                    static_cast<std::uint8_t>(quads.values[first + t]);
        }
        const int got = static_cast<std::uint8_t>(npy.values[i]);
        const int expected =
            test_support::expected_entry(name, entry["rule"].get<std::string>(), entry["what"].get<std::string>(), at);
        if (got != expected && wrong++ == 0) {
            INFO(file << ", entry " << i);
            CHECK(got == expected);
        }
    }
    INFO(file);
    CHECK(wrong == 0);
}

void check_frame(const std::string& directory, const json& entry, const pipeline::Profile& profile) {
    const std::string path = entry["frame"], text = tests::read_file(directory + "/" + path);
    INFO(path);
    CHECK(demo::sha256(text) == entry["frame_sha256"].get<std::string>());
    const pipeline::Frame frame = pipeline::parse_frame(text);
    CHECK(frame.arithmetic == profile.arithmetic);
    CHECK(!entry["what"].get<std::string>().empty());
    // The answer of the ideal profile stands where the frame is as it was written, and so is its own.
    const bool is_own   = path.starts_with("frames/" + std::string(profile.name) + "_");
    const bool is_ideal = profile.arithmetic == pipeline::Arithmetic{};
    CHECK((text.find("Ideal answer") != std::string::npos) == is_ideal);
    CHECK((text.find(" Answer: ") != std::string::npos) == is_own);
    CHECK(demo::what_is_missing(frame, profile) == "");
    CHECK_THAT(text, Catch::Contains("// " + entry["what"].get<std::string>() + "\n"));

    const pipeline::ColorImage image = pipeline::execute(frame).output;
    const Npy npy                    = read_npy(directory, entry);
    REQUIRE(npy.shape ==
            std::vector<std::size_t>{static_cast<std::size_t>(image.height), static_cast<std::size_t>(image.width), 4});
    std::string bytes;
    for (const std::uint32_t argb : image.pixels)
        for (const int shift : {16, 8, 0, 24}) bytes += static_cast<char>(argb >> shift & 0xff);
    CHECK(npy.values == bytes);
}

void check_evidence(const json& entry) {
    CHECK(!entry["source"].get<std::string>().empty());
    const auto& names = pipeline::EnumNames<pipeline::Grade>::names;
    CHECK(std::find(names.begin(), names.end(), entry["grade"].get<std::string>()) != names.end());
    CHECK(entry["open"].is_string());
}

void check_profile(const std::string& name) {
    const ScratchDirectory directory;
    const Ended ended =
        tests::run_program(NIMBUS7_PROGRAM, {"vectors", "--profile", name, "-o", "out"}, directory.path());
    CHECK(ended.error == "");
    REQUIRE(ended.status == 0);
    CHECK_THAT(ended.out, Catch::StartsWith("out/manifest.json  "));
    const std::string out                  = directory / "out";
    const std::string text                 = tests::read_file(out + "/manifest.json");
    const json manifest                    = json::parse(text);
    const pipeline::Profile* const profile = pipeline::find_profile(name);

    CHECK(manifest["profile"] == name);
    CHECK(manifest["chip"] == std::string(profile->chip));
    for (const pipeline::Evidence& evidence : profile->evidence) {
        REQUIRE(manifest["evidence"].contains(evidence.topic));
        check_evidence(manifest["evidence"][std::string(evidence.topic)]);
    }
    std::set<std::string> listed{"manifest.json"};
    Npy quads;
    for (const json& entry : manifest["arrays"])
        if (entry["file"] == "filter_quads.npy") quads = read_npy(out, entry);
    REQUIRE(quads.shape == std::vector<std::size_t>{32, 4});
    for (const json& entry : manifest["arrays"]) {
        const std::string file = entry["file"];
        INFO(file);
        CHECK(listed.insert(file).second);
        for (const char* key : {"rule", "what", "value", "formula"}) CHECK(!entry[key].get<std::string>().empty());
        check_evidence(entry);
        CHECK(entry["axes"].size() == entry["shape"].size());
        const Npy npy = read_npy(out, entry);
        if (file != "filter_quads.npy") check_array(entry, npy, quads);
    }
    CHECK(manifest["frames"].size() > 20);
    for (const json& entry : manifest["frames"]) {
        CHECK(listed.insert(entry["file"].get<std::string>()).second);
        CHECK(listed.insert(entry["frame"].get<std::string>()).second);
        check_frame(out, entry, *profile);
    }
    listed.insert(manifest["fields"]["file"].get<std::string>());
    CHECK(manifest["fields"]["sha256"] == demo::sha256(tests::read_file(out + "/frames/FIELDS.txt")));
    for (const json& entry : manifest["left_out"])
        CHECK_THAT(entry["why"].get<std::string>(), Catch::StartsWith(name + " has no "));
    const bool is_ideal = profile->arithmetic == pipeline::Arithmetic{};
    CHECK(manifest["left_out"].empty() == is_ideal);
    CHECK((text.find("Ideal answer") != std::string::npos) == is_ideal);

    std::set<std::string> written;
    std::string checksums;  // as sha256sum writes them
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(out))
        if (entry.is_regular_file()) written.insert(fs::relative(entry.path(), out).string());
    CHECK(written == listed);
    for (const std::string& file : written)
        if (file != "manifest.json") checksums += demo::sha256(tests::read_file(out + '/' + file)) + "  " + file + '\n';
    INFO("if the difference is meant, run tests/golden/update_vectors");
    CHECK(checksums == tests::read_file(NIMBUS7_SOURCE_DIR "/tests/golden/vectors/" + name + ".sha256"));
}

bool is_one_line(const std::string& text) {
    return !text.empty() && text.find('\n') == text.size() - 1;
}

}  // namespace

TEST_CASE("the golden vectors of ideal", "[vectors]") {
    check_profile("ideal");
}
TEST_CASE("the golden vectors of dx7", "[vectors]") {
    check_profile("dx7");
}
TEST_CASE("the golden vectors of ps2", "[vectors]") {
    check_profile("ps2");
}
TEST_CASE("the golden vectors of gamecube", "[vectors]") {
    check_profile("gamecube");
}
TEST_CASE("the golden vectors of xbox", "[vectors]") {
    check_profile("xbox");
}

TEST_CASE("SHA-256 of the standard's examples", "[vectors]") {
    CHECK(demo::sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    CHECK(demo::sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(demo::sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
          "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST_CASE("an array's file says its shape", "[vectors]") {
    const std::vector<std::uint8_t> values{0, 1, 127, 128, 254, 255};
    const std::vector<std::vector<std::size_t>> shapes{{6}, {2, 3}, {3, 1, 2}, {1, 1, 1, 1, 1, 1, 1, 6}};
    for (const std::vector<std::size_t>& shape : shapes) {
        const Npy npy = parse_npy(demo::to_npy(shape, values));
        CHECK(npy.shape == shape);
        CHECK(npy.values == std::string(values.begin(), values.end()));
    }
}

TEST_CASE("vectors: bad usage is one line and status 2, and writes nothing", "[vectors]") {
    const Words arguments = GENERATE(
        Words{"vectors"}, Words{"vectors", "--profile", "ps2"}, Words{"vectors", "-o", "out"},
        Words{"vectors", "--profile", "voodoo", "-o", "out"}, Words{"vectors", "--profile", "", "-o", "out"},
        Words{"vectors", "--profile", "PS2", "-o", "out"}, Words{"vectors", "ps2", "-o", "out"},
        Words{"vectors", "--profile", "ps2", "-o", ""}, Words{"vectors", "--profile", "ps2", "-o", "file"},
        Words{"vectors", "--profile", "ps2", "-o", "file/out"}, Words{"vectors", "--profile", "ps2", "-o", "none/out"},
        Words{"vectors", "--profile", "ps2", "-o", "/proc/out"},
        Words{"vectors", "--profile", "ps2", "-o", "/dev/null"});
    const ScratchDirectory directory;
    tests::write_file(directory / "file", "text");
    const Ended ended = tests::run_program(NIMBUS7_PROGRAM, arguments, directory.path());
    INFO(ended.error);
    CHECK(ended.status == 2);
    CHECK(ended.out == "");
    CHECK(is_one_line(ended.error));
    CHECK_THAT(ended.error, Catch::StartsWith("nimbus7: "));
    CHECK(directory.files() == Words{"file"});
}

TEST_CASE("vectors that cannot be finished have no manifest and no half file", "[vectors]") {
    const ScratchDirectory directory;
    fs::create_directory(directory / "out");
    tests::write_file(directory / "out/manifest.json", "of older vectors");
    const Ended ended = tests::run_program(NIMBUS7_PROGRAM, {"vectors", "--profile", "gamecube", "-o", "out"},
                                           directory.path(), {.max_file_bytes = 100000});
    INFO(ended.error);
    CHECK(ended.status == 2);
    CHECK(is_one_line(ended.error));
    std::size_t whole = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(directory.path())) {
        if (!entry.is_regular_file()) continue;
        INFO(entry.path());
        CHECK(entry.path().extension() == ".npy");
        parse_npy(tests::read_file(entry.path()));
        ++whole;
    }
    CHECK(whole > 0);
}
