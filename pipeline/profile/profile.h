// SPDX-License-Identifier: MIT
// A chip as a table: how it computes and which formats and functions it has, each with its source and how sure that is. A
// profile changes no picture by itself: what it says becomes data in a frame (Frame::arithmetic, formats, states), and
// `execute` knows no chip.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline {

// What a fact rests on, the surest first.
enum class Grade : std::uint8_t {
    Measured,   // on the real chip, by who reports it
    Fitted,     // a formula fitted to captures of the real chip
    Emulators,  // emulators agree; no measurement is known
    Document,   // of the maker or of its time
    Chosen,     // sources disagree or are silent: see `open`
};
template <>
struct EnumNames<Grade> {
    static constexpr std::array<std::string_view, 5> names{"measured", "fitted", "emulators", "document", "chosen"};
};

// topic: a field of Arithmetic, or "store", "dither", "alpha_test", "dest_alpha_test", "depth", "copy". open: what is not
// known, or where sources disagree and what the switch is; empty if nothing is.
struct Evidence {
    std::string_view topic;
    std::string_view source;
    Grade grade = Grade::Chosen;
    std::string_view open;
};

struct Profile {
    std::string_view name;  // as on the command line
    std::string_view chip;
    Arithmetic arithmetic;
    std::vector<TargetFormat> color_formats, depth_formats;
    std::vector<CompareFunc> depth_funcs, alpha_funcs;
    std::vector<Evidence> evidence;  // an entry for each topic that the chip has
};

// ideal, dx7, ps2, gamecube, xbox.
std::span<const Profile> profiles();
const Profile* find_profile(std::string_view name);  // null if there is none

// The formula of a rule in words that a reader can program from.
std::string_view formula(SnapRule rule);
std::string_view formula(GouraudRule rule);
std::string_view formula(FilterRule rule);
std::string_view formula(CombineRule rule);
std::string_view formula(FogRule rule);
std::string_view formula(BlendRule rule);
std::string_view formula(BlendSource rule);
std::string_view formula(DitherMode mode);
std::string_view formula(TargetFormat format);

}  // namespace pipeline
