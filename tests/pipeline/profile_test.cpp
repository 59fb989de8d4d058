// SPDX-License-Identifier: MIT
// The chips' tables: complete, consistent, and each fact with what it rests on.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "pipeline/profile/profile.h"
#include "pipeline/validate/validate.h"

using namespace pipeline;

namespace {

const Profile& profile(std::string_view name) {
    const Profile* found = find_profile(name);
    REQUIRE(found != nullptr);
    return *found;
}

std::set<std::string> topics(const Profile& profile) {
    std::set<std::string> out;
    for (const Evidence& evidence : profile.evidence) {
        INFO(profile.name << ' ' << evidence.topic);
        CHECK(out.insert(std::string(evidence.topic)).second);
    }
    return out;
}

template <class T>
bool has_repetitions(const std::vector<T>& values) {
    return std::set<T>(values.begin(), values.end()).size() != values.size();
}

// The formulas of an enum: there, and no two the same but where `same` says so.
template <class Enum>
void check_formulas(std::size_t distinct) {
    std::set<std::string> formulas;
    for (std::size_t i = 0; i < EnumNames<Enum>::names.size(); ++i) {
        const std::string text(formula(static_cast<Enum>(i)));
        INFO(EnumNames<Enum>::names[i]);
        CHECK(text.size() > 10);
        formulas.insert(text);
    }
    CHECK(formulas.size() == distinct);
}

}  // namespace

TEST_CASE("the profiles are found by name", "[profile]") {
    std::vector<std::string> names;
    for (const Profile& one : profiles()) {
        names.emplace_back(one.name);
        CHECK(find_profile(one.name) == &one);
        CHECK(!one.chip.empty());
    }
    CHECK(names == std::vector<std::string>{"ideal", "dx7", "ps2", "gamecube", "xbox"});
    CHECK(find_profile("voodoo") == nullptr);
    CHECK(find_profile("") == nullptr);
}

TEST_CASE("every topic of a profile has a source and a grade", "[profile]") {
    for (const Profile& one : profiles()) {
        const std::set<std::string> found = topics(one);
        // Every field of Arithmetic, and what every chip has.
        std::set<std::string> expected{"store", "alpha_test", "depth"};
        visit_fields(one.arithmetic, [&](std::string_view name, const auto&) { expected.emplace(name); });
        const std::set<std::string> optional{"dither", "dest_alpha_test", "copy"};
        INFO(one.name);
        CHECK(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
        for (const std::string& topic : found) {
            INFO(topic);
            CHECK((expected.contains(topic) || optional.contains(topic)));
        }
        for (const Evidence& evidence : one.evidence) {
            INFO(evidence.topic);
            CHECK(evidence.source.size() > 10);
            CHECK(static_cast<std::size_t>(evidence.grade) < EnumNames<Grade>::names.size());
            // What was chosen for want of a source says so.
            if (evidence.grade == Grade::Chosen && one.name != "ideal") CHECK(!evidence.open.empty());
        }
    }
    CHECK(topics(profile("ps2")).contains("dither"));
    CHECK(topics(profile("ps2")).contains("dest_alpha_test"));
    CHECK(topics(profile("gamecube")).contains("copy"));
    CHECK(!topics(profile("gamecube")).contains("dest_alpha_test"));
    CHECK(!topics(profile("dx7")).contains("copy"));
}

TEST_CASE("every rule has a formula of its own", "[profile]") {
    check_formulas<SnapRule>(2);
    check_formulas<GouraudRule>(2);
    check_formulas<FilterRule>(5);
    check_formulas<CombineRule>(3);
    check_formulas<FogRule>(4);
    check_formulas<BlendRule>(3);
    check_formulas<BlendSource>(2);
    check_formulas<DitherMode>(3);
    check_formulas<TargetFormat>(10);  // A8R8G8B8 and PSMCT32 hold the same
}

TEST_CASE("the arithmetic of each chip", "[profile]") {
    CHECK(profile("ideal").arithmetic == Arithmetic{});
    CHECK(profile("dx7").arithmetic == Arithmetic{.snap = SnapRule::Truncate, .pixel_center = 0});
    CHECK(profile("ps2").arithmetic == Arithmetic{SnapRule::Truncate, 0, GouraudRule::Floor, FilterRule::GsFloor4,
                                                  CombineRule::GsShift7, FogRule::GsFloor256, BlendRule::GsShift7,
                                                  BlendSource::Bytes});
    CHECK(profile("gamecube").arithmetic ==
          Arithmetic{SnapRule::Nearest, 9, GouraudRule::Nearest, FilterRule::FlipperFloor7, CombineRule::Tev,
                     FogRule::FlipperFloor256, BlendRule::FlipperTrunc256, BlendSource::Bytes});
    CHECK(profile("xbox").arithmetic == Arithmetic{SnapRule::Truncate, 8, GouraudRule::Nearest, FilterRule::Nv2aHalfUp8,
                                                   CombineRule::Nearest255, FogRule::Nearest255, BlendRule::Nearest255,
                                                   BlendSource::TargetBits});
    for (const Profile& one : profiles()) {
        Frame frame;
        frame.output     = {0};
        frame.arithmetic = one.arithmetic;
        for (const TargetFormat format : one.color_formats) frame.targets.push_back({"", format, 4, 4});
        for (const TargetFormat format : one.depth_formats) frame.targets.push_back({"", format, 4, 4});
        INFO(one.name);
        CHECK(validate(frame).empty());
    }
}

TEST_CASE("the formats and functions of each chip", "[profile]") {
    for (const Profile& one : profiles()) {
        INFO(one.name);
        CHECK(!one.color_formats.empty());
        CHECK(!one.depth_formats.empty());
        CHECK(std::none_of(one.color_formats.begin(), one.color_formats.end(), &is_depth));
        CHECK(std::all_of(one.depth_formats.begin(), one.depth_formats.end(), &is_depth));
        CHECK(!has_repetitions(one.color_formats));
        CHECK(!has_repetitions(one.depth_formats));
        CHECK(!has_repetitions(one.depth_funcs));
        CHECK(!has_repetitions(one.alpha_funcs));
        CHECK(one.depth_funcs.size() == (one.name == "ps2" ? 4 : 8));
        CHECK(one.alpha_funcs.size() == 8);
    }
    CHECK(profile("ideal").color_formats.size() + profile("ideal").depth_formats.size() ==
          EnumNames<TargetFormat>::names.size());
    const std::vector<CompareFunc>& funcs = profile("ps2").depth_funcs;
    for (const CompareFunc func :
         {CompareFunc::Less, CompareFunc::LessEqual, CompareFunc::Equal, CompareFunc::NotEqual})
        CHECK(std::find(funcs.begin(), funcs.end(), func) == funcs.end());
    CHECK(profile("gamecube").color_formats.front() == TargetFormat::R6G6B6A6);
}
