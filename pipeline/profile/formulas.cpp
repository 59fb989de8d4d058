// SPDX-License-Identifier: MIT
#include "pipeline/profile/profile.h"

namespace pipeline {

std::string_view formula(SnapRule rule) {
    switch (rule) {
        case SnapRule::Nearest:
            return "X = 16 * x rounded to the nearest integer, ties to even, for a window coordinate x in pixels; Y "
                   "likewise";
        case SnapRule::Truncate:
            return "X = 16 * x with its fraction dropped, toward zero, for a window coordinate x in pixels; Y likewise";
    }
    return {};
}

std::string_view formula(VertexDepth rule) {
    switch (rule) {
        case VertexDepth::Fine:
            return "z * (2^30 - 1) rounded to the nearest integer at each vertex; what is interpolated is shifted right "
                   "to the bits of the depth buffer";
        case VertexDepth::WholeUnits:
            return "as FINE, but at each vertex the bits that the depth buffer has not are zero";
    }
    return {};
}

std::string_view formula(GouraudRule rule) {
    switch (rule) {
        case GouraudRule::Nearest:
            return "the plane through the three vertices' bytes, at the pixel's sample point, rounded to the nearest "
                   "byte, half up";
        case GouraudRule::Floor:
            return "the plane through the three vertices' bytes, at the pixel's sample point, in 1/2^15, plus 1/256, "
                   "floored to a byte";
    }
    return {};
}

std::string_view formula(FilterRule rule) {
    switch (rule) {
        case FilterRule::Reference8:
            return "fractions fu, fv in 1/256 texel: (((256 - fv) * ((256 - fu) * t00 + fu * t10) + fv * ((256 - fu) "
                   "* t01 + fu * t11)) + 32768) >> 16; two mip levels a, b with fraction f in 1/256: (a * (256 - f) + "
                   "b * f + 128) >> 8";
        case FilterRule::GsFloor4:
            return "fractions f in 1/16 texel, that is the fraction in 1/256 >> 4; lerp(a, b, f) = a + ((b - a) * f "
                   ">> 4), >> flooring: lerp(lerp(t00, t10, fu), lerp(t01, t11, fu), fv); two mip levels likewise";
        case FilterRule::GsNearest4:
            return "fractions fu, fv in 1/16 texel, that is the fractions in 1/256 >> 4: (((16 - fv) * ((16 - fu) * "
                   "t00 + fu * t10) + fv * ((16 - fu) * t01 + fu * t11)) + 128) >> 8; two mip levels: (a * (16 - f) + "
                   "b * f) >> 4";
        case FilterRule::FlipperFloor7:
            return "fractions fu, fv in 1/128 texel, that is the fractions in 1/256 >> 1: ((128 - fv) * ((128 - fu) * "
                   "t00 + fu * t10) + fv * ((128 - fu) * t01 + fu * t11)) >> 14; two mip levels, f in 1/16: (a * (16 "
                   "- f) + b * f) >> 4";
        case FilterRule::Nv2aHalfUp8:
            return "fractions f in 1/256 texel; lerp(a, b, f) = ((256 - f) * a + f * b + 128) >> 8: lerp(lerp(t00, "
                   "t10, fu), lerp(t01, t11, fu), fv); two mip levels likewise";
    }
    return {};
}

std::string_view formula(CombineRule rule) {
    switch (rule) {
        case CombineRule::Nearest255:
            return "nearest(v) = floor((v + 127) / 255). MODULATE nearest(min(65025, k * a * b)), k = 1, 2X 2, 4X 4; "
                   "ADD min(255, a + b); SUBTRACT max(0, a - b); ADDSIGNED clamp(a + b - 127); ADDSIGNED2X clamp(2 * "
                   "a + 2 * b - 255); BLENDxALPHA nearest(a * x + b * (255 - x)); MODULATECOLOR_ADDALPHA min(255, "
                   "nearest(a * b) + alpha of a)";
        case CombineRule::GsShift7:
            return "0x80 is one. MODULATE min(255, a * b >> 7); ADD min(255, a + b); MODULATECOLOR_ADDALPHA min(255, "
                   "(a * b >> 7) + alpha of a), with the vertex colour for a";
        case CombineRule::Tev:
            return "e(v) = v + (v >> 7), 0..256. MODULATE min(255, (k * a * e(b) + 128) >> 8), k = 1, 2X 2, 4X 4; ADD "
                   "min(255, a + b); SUBTRACT max(0, a - b); ADDSIGNED clamp(a + b - 128); ADDSIGNED2X clamp(2 * a + "
                   "2 * b - 256); BLENDxALPHA (a * e(x) + b * (256 - e(x)) + 128) >> 8; MODULATECOLOR_ADDALPHA "
                   "min(255, ((a * e(b) + 128) >> 8) + alpha of a)";
    }
    return {};
}

std::string_view formula(FogRule rule) {
    switch (rule) {
        case FogRule::Nearest255:
            return "colour c, fog colour k, factor f with 255 for no fog: floor((f * c + (255 - f) * k + 127) / 255)";
        case FogRule::GsFloor256:
            return "colour c, fog colour k, factor f with 255 for no fog: (f * c + (256 - f) * k) >> 8";
        case FogRule::GsTwoFloors:
            return "colour c, fog colour k, factor f with 255 for no fog: (f * c >> 8) + ((255 - f) * k >> 8)";
        case FogRule::FlipperFloor256:
            return "colour c, fog colour k, factor f with 255 for no fog, e = f + (f >> 7): (e * c + (256 - e) * k) >> 8";
    }
    return {};
}

std::string_view formula(BlendRule rule) {
    switch (rule) {
        case BlendRule::Nearest255:
            return "per channel, factors Fs, Fd of 0..255: floor((min(65025, s * Fs + d * Fd) + 127) / 255); ONE is "
                   "255, INV* is 255 - x";
        case BlendRule::GsShift7:
            return "red, green, blue: ((A - B) * C >> 7) + D, >> flooring negative products too; then COLCLAMP 1 "
                   "clamps to 0..255, COLCLAMP 0 keeps the low 8 bits; PABE 1 leaves fragments of alpha below 0x80 as they are. "
                   "Alpha: the fragment's as it is, FBA 1 setting its bit 7";
        case BlendRule::FlipperTrunc256:
            return "per channel, e(F) = F + (F >> 7), 0..256: min(255, (s * e(Fs) + d * e(Fd)) >> 8); ONE is 255, "
                   "INV* is 255 - x before e";
    }
    return {};
}

std::string_view formula(BlendSource rule) {
    switch (rule) {
        case BlendSource::Bytes:
            return "the blender sees the source's whole bytes";
        case BlendSource::TargetBits:
            return "of the source's red, green and blue the blender sees the n bits that the target keeps: s >> (8 - "
                   "n) << (8 - n)";
    }
    return {};
}

std::string_view formula(DitherMode mode) {
    switch (mode) {
        case DitherMode::None:
            return "nothing is added";
        case DitherMode::Flipper2x2:
            return "red, green, blue: c - (c >> 6) + m[y & 1][x & 1] with m = {0, 2; 3, 1}, then the top bits";
        case DitherMode::GsDimx:
            return "red, green, blue: the blend's result + DIMX[y & 3][x & 3], -4..3, then COLCLAMP, then the top bits";
    }
    return {};
}

std::string_view formula(TargetFormat format) {
    switch (format) {
        case TargetFormat::A8R8G8B8:
        case TargetFormat::Psmct32:
            return "four whole bytes";
        case TargetFormat::X8R8G8B8:
            return "red, green, blue whole bytes; alpha reads as 255";
        case TargetFormat::Psmct24:
            return "red, green, blue whole bytes; alpha reads as 0x80";
        case TargetFormat::R5G6B5:
            return "red, blue: k = v >> 3, read as k << 3 | k >> 2; green: k = v >> 2, read as k << 2 | k >> 4; alpha "
                   "reads as 255";
        case TargetFormat::A1R5G5B5:
            return "red, green, blue: k = v >> 3, read as k << 3 | k >> 2; alpha: 255 if v >= 128, else 0";
        case TargetFormat::R6G6B6A6:
            return "each channel: k = v >> 2, read as k << 2 | k >> 4";
        case TargetFormat::Psmct16:
            return "red, green, blue: v & 0xf8; alpha: v & 0x80";
        case TargetFormat::D16:
            return "depth z of 0..1: floor(v / 2^14), v = z * (2^30 - 1) as a double, to the nearest integer, ties to even";
        case TargetFormat::D24:
            return "depth z of 0..1: floor(v / 2^6), v = z * (2^30 - 1) as a double, to the nearest integer, ties to even";
        case TargetFormat::D32:
            return "depth z of 0..1: v << 2 | v >> 28, v = z * (2^30 - 1) as a double, to the nearest integer, ties to even";
    }
    return {};
}

}  // namespace pipeline
