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

std::set<std::string> topics(const Profile& profile) {
    std::set<std::string> out;
    for (const Evidence& evidence : profile.evidence) {
        INFO(profile.name << ' ' << evidence.topic);
        CHECK(out.insert(std::string(evidence.topic)).second);
    }
    return out;
}

template <class T>
bool is_among(const T& value, const std::vector<T>& values) {
    return std::find(values.begin(), values.end(), value) != values.end();
}

// Something, and nothing twice.
template <class T>
void check_list(const std::vector<T>& values) {
    CHECK(!values.empty());
    CHECK(std::set<T>(values.begin(), values.end()).size() == values.size());
}

// The formulas of an enum: there, and no two the same but where `same` says so.
template <class Enum>
void check_formulas(std::size_t distinct) {
    std::set<std::string> formulas;
    for (std::size_t i = 0; i < EnumNames<Enum>::names.size(); ++i) {
        const std::string text(formula(static_cast<Enum>(i)));
        INFO(EnumNames<Enum>::names[i]);
        CHECK(!text.empty());
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

TEST_CASE("every topic of a profile has a source, a grade, and what is open where none settles it", "[profile]") {
    // Every field of Arithmetic, and what every chip has.
    std::set<std::string> expected{"store",  "alpha_test", "depth", "copy", "targets",
                                   "states", "stages",     "flat",  "lod"};
    const Arithmetic fields;
    visit_fields(fields, [&](std::string_view name, const auto&) { expected.emplace(name); });
    for (const Profile& one : profiles()) {
        INFO(one.name);
        std::set<std::string> has = expected;
        if (one.states.dithers.size() > 1) has.insert("dither");
        if (one.states.dest_alpha_test) has.insert("dest_alpha_test");
        if (one.arithmetic != Arithmetic{}) has.insert({"limits", "memory"});
        CHECK(topics(one) == has);
        const bool is_exact = one.arithmetic == Arithmetic{};
        for (const Evidence& evidence : one.evidence) {
            INFO(evidence.topic);
            // Where a rule was chosen or defined the source says that; elsewhere it names one.
            const bool is_chosen  = evidence.source.starts_with("chosen: "),
                       is_defined = evidence.source.starts_with("by definition: ");
            CHECK(!evidence.source.empty());
            CHECK(evidence.source.back() != '.');
            CHECK(is_defined == is_exact);
            if (is_chosen || is_defined) CHECK(evidence.grade == Grade::Chosen);
            if (evidence.grade == Grade::Chosen && !is_exact) CHECK(!evidence.open.empty());
            if (is_exact) CHECK(evidence.open.empty());
            if (!evidence.open.empty()) CHECK(evidence.open.back() != '.');  // open_questions ends the sentence
        }
    }
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

TEST_CASE("what a chip has fits together", "[profile]") {
    for (const Profile& one : profiles()) {
        const ChipFormats& formats = one.formats;
        const ChipStates& states   = one.states;
        INFO(one.name);
        check_list(formats.draw);
        check_list(formats.copy_targets);
        check_list(formats.depth);
        check_list(states.depth_funcs);
        check_list(states.source_factors);
        check_list(states.dest_factors);
        check_list(states.dithers);
        check_list(states.alpha_fails);
        check_list(states.arguments);
        check_list(states.addresses);
        check_list(states.mip_filters);
        CHECK(std::none_of(formats.draw.begin(), formats.draw.end(), &is_depth));
        CHECK(std::none_of(formats.copy_targets.begin(), formats.copy_targets.end(), &is_depth));
        CHECK(std::all_of(formats.depth.begin(), formats.depth.end(), &is_depth));
        for (const TargetFormat format : {formats.with_bytes, formats.with_alpha, formats.opaque})
            CHECK(is_among(format, formats.draw));
        CHECK(keeps_bytes(formats.with_bytes));
        CHECK(keeps_bytes(formats.opaque));
        CHECK(formats.with_alpha != formats.opaque);
        for (const TargetFormat color : formats.draw)
            CHECK(std::any_of(formats.depth.begin(), formats.depth.end(),
                              [&](TargetFormat depth) { return go_together(formats, color, depth); }));
        // "Off" is everywhere.
        CHECK(is_among(BlendFactor::One, states.source_factors));
        CHECK(is_among(BlendFactor::Zero, states.dest_factors));
        CHECK(is_among(CompareFunc::Always, states.depth_funcs));
        CHECK(is_among(DitherMode::None, states.dithers));
        CHECK(is_among(AlphaFail::Keep, states.alpha_fails));
        CHECK(is_among(MipFilter::None, states.mip_filters));
        CHECK(states.stages >= 1);
        CHECK(states.stages <= kTextureStages);
        // Dithers are for targets that keep less than bytes.
        if (states.dithers.size() > 1) CHECK(!std::all_of(formats.draw.begin(), formats.draw.end(), &keeps_bytes));
    }
}

TEST_CASE("a topic of a profile is found by name", "[profile]") {
    for (const Profile& one : profiles()) {
        for (const Evidence& evidence : one.evidence) CHECK(find_evidence(one, evidence.topic) == &evidence);
        CHECK(find_evidence(one, "colour") == nullptr);
        CHECK(find_evidence(one, "") == nullptr);
    }
}

TEST_CASE("limits of chips", "[profile]") {
    for (const Profile& one : profiles()) {
        const ChipLimits& limits = one.limits;
        INFO(one.name);
        const bool is_ideal = &one == &profiles().front();
        check_list(limits.texture_formats);
        CHECK((limits.memory == 0) == is_ideal);
        CHECK((limits.texture_width == 0) == is_ideal);
        CHECK((limits.texture_height == 0) == is_ideal);
        CHECK(limits.copy_from_step >= 1);
        CHECK(limits.copy_tile >= 1);
        CHECK(limits.pitch_alignment >= 1);
        CHECK(limits.address_alignment >= 1);
        // What is read from a frame buffer is a copy, and only the layout that has one puts targets there.
        CHECK((limits.frame_buffer_width != 0) == !one.formats.reads_targets);
        CHECK((limits.frame_buffer_width != 0) == (limits.layout == MemoryLayout::FlipperTiles));
        CHECK((limits.frame_buffer_height != 0) == (limits.frame_buffer_width != 0));
        if (limits.frame_buffer_width != 0) {
            CHECK(limits.target_width == limits.frame_buffer_width);
            CHECK(limits.target_height == limits.frame_buffer_height);
            // So that a format says where a target lies.
            for (const TargetFormat format : one.formats.draw) CHECK(!is_among(format, one.formats.copy_targets));
        }
    }
    CHECK(find_profile("ps2")->limits.memory == 4194304);
    CHECK(find_profile("dx7")->limits.memory == 33554432);
    CHECK(find_profile("gamecube")->limits.memory == 25165824);
    CHECK(find_profile("xbox")->limits.memory == 67108864);
}

TEST_CASE("the Graphics Synthesizer's rules and formats are found together", "[profile]") {
    using enum TargetFormat;
    for (const Profile& one : profiles()) {
        INFO(one.name);
        const bool is_gs = one.arithmetic.blend == BlendRule::GsShift7;
        CHECK(is_gs == (one.arithmetic.combine == CombineRule::GsShift7));
        CHECK(is_gs == (one.states.source_factors.size() == 1));
        CHECK(is_gs == (one.states.dest_factors.size() == 1));
        CHECK(is_gs == is_among(DitherMode::GsDimx, one.states.dithers));
        for (const TargetFormat format : one.formats.draw) {
            const bool is_gs_format = format == Psmct32 || format == Psmct24 || format == Psmct16;
            if (one.arithmetic != Arithmetic{}) CHECK(is_gs_format == is_gs);
        }
        const bool is_flipper = one.arithmetic.blend == BlendRule::FlipperTrunc256;
        CHECK(is_flipper == (one.arithmetic.combine == CombineRule::Tev));
        CHECK(is_flipper == (one.arithmetic.fog == FogRule::FlipperFloor256));
        CHECK(is_flipper == is_among(DitherMode::Flipper2x2, one.states.dithers));
    }
}

TEST_CASE("the ideal profile has all formats and states, and every chip less", "[profile]") {
    for (const Profile& one : profiles()) {
        INFO(one.name);
        const bool is_ideal = one.arithmetic == Arithmetic{};
        CHECK(is_ideal == (&one == &profiles().front()));
        CHECK(is_ideal ==
              (one.formats.draw.size() + one.formats.depth.size() == EnumNames<TargetFormat>::names.size()));
        for (const TargetFormat format : one.formats.draw) CHECK(is_among(format, profiles().front().formats.draw));
    }
}

TEST_CASE("a frame of all that a profile draws to is valid", "[profile]") {
    for (const Profile& one : profiles()) {
        Frame frame;
        frame.output     = {0};
        frame.arithmetic = one.arithmetic;
        for (const auto& formats : {one.formats.draw, one.formats.copy_targets, one.formats.depth})
            for (const TargetFormat format : formats) frame.targets.push_back({"", format, 4, 4});
        for (std::size_t i = 0; i < one.formats.draw.size(); ++i)
            for (const DitherMode mode : one.states.dithers) {
                if (mode != DitherMode::None && keeps_bytes(one.formats.draw[i])) continue;
                Pass& pass             = frame.passes.emplace_back();
                pass.color             = {static_cast<std::int32_t>(i)};
                pass.state.dither.mode = mode;
            }
        INFO(one.name);
        for (const Finding& finding : validate(frame)) FAIL_CHECK(finding.where << " " << finding.what);
    }
}
