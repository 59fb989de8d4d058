// SPDX-License-Identifier: MIT
#include "pipeline/emit/gs_registers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <stdexcept>

namespace pipeline {

namespace {

using enum GsUnit;
using Names = std::string_view;

constexpr Names kPrimitives[]{"POINT", "LINE", "LINESTRIP", "TRIANGLE", "TRISTRIP", "TRIFAN", "SPRITE"};
constexpr Names kFunctions[]{"MODULATE", "DECAL", "HIGHLIGHT", "HIGHLIGHT2"};
constexpr Names kLoads[]{
    "keep", "load", "load, CBP0 := CBP", "load, CBP1 := CBP", "load if CBP is not CBP0", "load if CBP is not CBP1"};
constexpr Names kWraps[]{"REPEAT", "CLAMP", "REGION_CLAMP", "REGION_REPEAT"};
constexpr Names kColors[]{"Cs", "Cd", "0"};
constexpr Names kAlphas[]{"As", "Ad", "FIX"};
constexpr Names kAlphaTests[]{"NEVER", "ALWAYS", "LESS", "LEQUAL", "EQUAL", "GEQUAL", "GREATER", "NOTEQUAL"};
constexpr Names kFails[]{"KEEP", "FB_ONLY", "ZB_ONLY", "RGB_ONLY"};
constexpr Names kDepthTests[]{"NEVER", "ALWAYS", "GEQUAL", "GREATER"};
constexpr Names kFilters[]{"nearest", "linear"};
constexpr Names kDirections[]{"host to local", "local to host", "local to local", "none"};
constexpr Names kClutModes[]{"CSM1", "CSM2"};

constexpr GsField kPrim[]{{"PRIM", 0, 3, Choice, "primitive", kPrimitives},
                          {"IIP", 3, 1, Flag, "Gouraud"},
                          {"TME", 4, 1, Flag, "texture"},
                          {"FGE", 5, 1, Flag, "fog"},
                          {"ABE", 6, 1, Flag, "blend"},
                          {"AA1", 7, 1, Flag, "antialiased edges"},
                          {"FST", 8, 1, Flag, "UV, not STQ"},
                          {"CTXT", 9, 1, Number, "context 1 or 2"},
                          {"FIX", 10, 1, Flag, "fixed fragment values"}};
constexpr GsField kRgbaq[]{{"R", 0, 8, Byte},
                           {"G", 8, 8, Byte},
                           {"B", 16, 8, Byte},
                           {"A", 24, 8, Byte, "alpha, 0x80 is one"},
                           {"Q", 32, 32, Float}};
constexpr GsField kSt[]{{"S", 0, 32, Float}, {"T", 32, 32, Float}};
constexpr GsField kUv[]{{"U", 0, 14, Texels4}, {"V", 16, 14, Texels4}};
constexpr GsField kXyzf2[]{
    {"X", 0, 16, Pixels4}, {"Y", 16, 16, Pixels4}, {"Z", 32, 24, Number}, {"F", 56, 8, Byte, "fog, 255 is none"}};
constexpr GsField kXyz2[]{{"X", 0, 16, Pixels4}, {"Y", 16, 16, Pixels4}, {"Z", 32, 32, Number}};
constexpr GsField kTex0[]{{"TBP0", 0, 14, Block, "texture"},
                          {"TBW", 14, 6, Width64, "row"},
                          {"PSM", 20, 6, Psm, "format"},
                          {"TW", 26, 4, Log2Texels, "width"},
                          {"TH", 30, 4, Log2Texels, "height"},
                          {"TCC", 34, 1, Flag, "alpha of the texture"},
                          {"TFX", 35, 2, Choice, "function", kFunctions},
                          {"CBP", 37, 14, Block, "palette"},
                          {"CPSM", 51, 4, Psm, "palette's format"},
                          {"CSM", 55, 1, Choice, "palette's order", kClutModes},
                          {"CSA", 56, 5, Number, "first entry / 16"},
                          {"CLD", 61, 3, Choice, "palette's load", kLoads}};
constexpr GsField kClamp[]{{"WMS", 0, 2, Choice, "across", kWraps}, {"WMT", 2, 2, Choice, "down", kWraps},
                           {"MINU", 4, 10, Texels, "least u"},      {"MAXU", 14, 10, Texels, "greatest u"},
                           {"MINV", 24, 10, Texels, "least v"},     {"MAXV", 34, 10, Texels, "greatest v"}};
constexpr GsField kFog[]{{"F", 56, 8, Byte, "fog, 255 is none"}};
constexpr GsField kTex1[]{{"LCM", 0, 1, Flag, "level is K"},
                          {"MXL", 2, 3, Number, "last level"},
                          {"MMAG", 5, 1, Choice, "magnified", kFilters},
                          {"MMIN", 6, 3, Number, "minified"},
                          {"MTBA", 9, 1, Flag, "levels' addresses follow"},
                          {"L", 19, 2, Number, "level's shift"},
                          {"K", 32, 12, Number, "level, in 1/16"}};
constexpr GsField kXyOffset[]{{"OFX", 0, 16, Pixels4, "taken off X"}, {"OFY", 32, 16, Pixels4, "taken off Y"}};
constexpr GsField kPrModeCont[]{{"AC", 0, 1, Flag, "attributes from PRIM"}};
constexpr GsField kTexClut[]{
    {"CBW", 0, 6, Width64, "CSM2 row"}, {"COU", 6, 6, Number, "CSM2 u / 16"}, {"COV", 12, 10, Number, "CSM2 v"}};
constexpr GsField kScanMsk[]{{"MSK", 0, 2, Number, "0: all rows"}};
constexpr GsField kTexA[]{{"TA0", 0, 8, Byte, "alpha of PSMCT24, and where a bit is 0"},
                          {"AEM", 15, 1, Flag, "black is clear"},
                          {"TA1", 32, 8, Byte, "alpha where a bit is 1"}};
constexpr GsField kFogCol[]{{"FCR", 0, 8, Byte, "red"}, {"FCG", 8, 8, Byte, "green"}, {"FCB", 16, 8, Byte, "blue"}};
constexpr GsField kScissor[]{{"SCAX0", 0, 11, Pixels, "first"},
                             {"SCAX1", 16, 11, Pixels, "last"},
                             {"SCAY0", 32, 11, Pixels, "first"},
                             {"SCAY1", 48, 11, Pixels, "last"}};
constexpr GsField kAlpha[]{{"A", 0, 2, Choice, "minuend", kColors},
                           {"B", 2, 2, Choice, "subtrahend", kColors},
                           {"C", 4, 2, Choice, "factor, / 128", kAlphas},
                           {"D", 6, 2, Choice, "added", kColors},
                           {"FIX", 32, 8, Byte, "0x80 is one"}};
constexpr GsField kDimx[]{{"DM00", 0, 3, Signed3, ""},  {"DM01", 4, 3, Signed3, ""},  {"DM02", 8, 3, Signed3, ""},
                          {"DM03", 12, 3, Signed3, ""}, {"DM10", 16, 3, Signed3, ""}, {"DM11", 20, 3, Signed3, ""},
                          {"DM12", 24, 3, Signed3, ""}, {"DM13", 28, 3, Signed3, ""}, {"DM20", 32, 3, Signed3, ""},
                          {"DM21", 36, 3, Signed3, ""}, {"DM22", 40, 3, Signed3, ""}, {"DM23", 44, 3, Signed3, ""},
                          {"DM30", 48, 3, Signed3, ""}, {"DM31", 52, 3, Signed3, ""}, {"DM32", 56, 3, Signed3, ""},
                          {"DM33", 60, 3, Signed3, ""}};
constexpr GsField kDthe[]{{"DTHE", 0, 1, Flag, "dither"}};
constexpr GsField kColClamp[]{{"CLAMP", 0, 1, Flag, "to 0..255, not modulo 256"}};
constexpr GsField kTest[]{{"ATE", 0, 1, Flag, "alpha test"},
                          {"ATST", 1, 3, Choice, "alpha", kAlphaTests},
                          {"AREF", 4, 8, Byte, "reference"},
                          {"AFAIL", 12, 2, Choice, "in spite of it", kFails},
                          {"DATE", 14, 1, Flag, "destination alpha test"},
                          {"DATM", 15, 1, Number, "bit 7 must be"},
                          {"ZTE", 16, 1, Flag, "depth test"},
                          {"ZTST", 17, 2, Choice, "depth", kDepthTests}};
constexpr GsField kPabe[]{{"PABE", 0, 1, Flag, "blend only where As >= 0x80"}};
constexpr GsField kFba[]{{"FBA", 0, 1, Flag, "set bit 7 of alpha"}};
constexpr GsField kFrame[]{{"FBP", 0, 9, Page, "colour"},
                           {"FBW", 16, 6, Width64, "row"},
                           {"PSM", 24, 6, Psm, "format"},
                           {"FBMSK", 32, 32, Hex, "bits that stay, ABGR"}};
constexpr GsField kZbuf[]{
    {"ZBP", 0, 9, Page, "depth"}, {"PSM", 24, 4, DepthPsm, "format"}, {"ZMSK", 32, 1, Flag, "depth stays"}};
constexpr GsField kBitBltBuf[]{{"SBP", 0, 14, Block, "source"},    {"SBW", 16, 6, Width64, "its row"},
                               {"SPSM", 24, 6, Psm, "its format"}, {"DBP", 32, 14, Block, "destination"},
                               {"DBW", 48, 6, Width64, "its row"}, {"DPSM", 56, 6, Psm, "its format"}};
constexpr GsField kTrxPos[]{{"SSAX", 0, 11, Pixels, "source x"},
                            {"SSAY", 16, 11, Pixels, "source y"},
                            {"DSAX", 32, 11, Pixels, "destination x"},
                            {"DSAY", 48, 11, Pixels, "destination y"},
                            {"DIR", 59, 2, Number, "order of pixels"}};
constexpr GsField kTrxReg[]{{"RRW", 0, 12, Pixels, "width"}, {"RRH", 32, 12, Pixels, "height"}};
constexpr GsField kTrxDir[]{{"XDIR", 0, 2, Choice, "transfer", kDirections}};
constexpr GsField kPmode[]{{"EN1", 0, 1, Flag, "circuit 1"},
                           {"EN2", 1, 1, Flag, "circuit 2"},
                           {"CRTMD", 2, 3, Number, ""},
                           {"MMOD", 5, 1, Flag, "mixed by ALP"},
                           {"AMOD", 6, 1, Number, ""},
                           {"SLBG", 7, 1, Number, ""},
                           {"ALP", 8, 8, Byte, "0xff: circuit 1 alone"}};
constexpr GsField kSmode2[]{{"INT", 0, 1, Flag, "interlaced"}, {"FFMD", 1, 1, Flag, "each field all rows"}};
constexpr GsField kRaw[]{{"value", 0, 64, Hex, "timing of the television standard"}};
constexpr GsField kDispFb[]{{"FBP", 0, 9, Page, "shown"},
                            {"FBW", 9, 6, Width64, "row"},
                            {"PSM", 15, 5, Psm, "format"},
                            {"DBX", 32, 11, Pixels, "left"},
                            {"DBY", 43, 11, Pixels, "top"}};
constexpr GsField kDisplay[]{{"DX", 0, 12, Number, "left, in clocks"},
                             {"DY", 12, 11, Number, "top, in rows"},
                             {"MAGH", 23, 4, Number, "clocks a pixel, less one"},
                             {"MAGV", 27, 2, Number, "rows a pixel, less one"},
                             {"DW", 32, 12, Number, "clocks, less one"},
                             {"DH", 44, 11, Number, "rows, less one"}};
constexpr GsField kBgColor[]{{"R", 0, 8, Byte, "red"}, {"G", 8, 8, Byte, "green"}, {"B", 16, 8, Byte, "blue"}};

constexpr GsRegister kRegisters[]{
    {GsReg::Prim, "PRIM", "primitive; drops vertices before it", kPrim},
    {GsReg::Rgbaq, "RGBAQ", "vertex colour", kRgbaq},
    {GsReg::St, "ST", "vertex texture coordinate, with Q", kSt},
    {GsReg::Uv, "UV", "vertex texel", kUv},
    {GsReg::Xyzf2, "XYZF2", "vertex with fog, and kick", kXyzf2},
    {GsReg::Xyz2, "XYZ2", "vertex, and kick", kXyz2},
    {GsReg::Tex0, "TEX0_1", "texture", kTex0},
    {GsReg::Clamp, "CLAMP_1", "texture's edges", kClamp},
    {GsReg::Fog, "FOG", "vertex fog", kFog},
    {GsReg::Tex1, "TEX1_1", "filter", kTex1},
    {GsReg::XyOffset, "XYOFFSET_1", "window's origin", kXyOffset},
    {GsReg::PrModeCont, "PRMODECONT", "where attributes come from", kPrModeCont},
    {GsReg::TexClut, "TEXCLUT", "palettes of CSM2", kTexClut},
    {GsReg::ScanMsk, "SCANMSK", "rows left out", kScanMsk},
    {GsReg::TexA, "TEXA", "alpha of texels that have none", kTexA},
    {GsReg::FogCol, "FOGCOL", "fog's colour", kFogCol},
    {GsReg::TexFlush, "TEXFLUSH", "forget cached texels", {}},
    {GsReg::Scissor, "SCISSOR_1", "pixels that may change", kScissor},
    {GsReg::Alpha, "ALPHA_1", "blend", kAlpha},
    {GsReg::Dimx, "DIMX", "dither matrix, row by row", kDimx},
    {GsReg::Dthe, "DTHE", "", kDthe},
    {GsReg::ColClamp, "COLCLAMP", "", kColClamp},
    {GsReg::Test, "TEST_1", "tests", kTest},
    {GsReg::Pabe, "PABE", "", kPabe},
    {GsReg::Fba, "FBA_1", "", kFba},
    {GsReg::Frame, "FRAME_1", "colour target", kFrame},
    {GsReg::Zbuf, "ZBUF_1", "depth target", kZbuf},
    {GsReg::BitBltBuf, "BITBLTBUF", "transfer's buffers", kBitBltBuf},
    {GsReg::TrxPos, "TRXPOS", "transfer's places", kTrxPos},
    {GsReg::TrxReg, "TRXREG", "transfer's size", kTrxReg},
    {GsReg::TrxDir, "TRXDIR", "starts a transfer", kTrxDir},
    {GsReg::Pmode, "PMODE", "read circuits", kPmode},
    {GsReg::Smode1, "SMODE1", "", kRaw},
    {GsReg::Smode2, "SMODE2", "", kSmode2},
    {GsReg::Srfsh, "SRFSH", "", kRaw},
    {GsReg::Synch1, "SYNCH1", "", kRaw},
    {GsReg::Synch2, "SYNCH2", "", kRaw},
    {GsReg::SyncV, "SYNCV", "", kRaw},
    {GsReg::DispFb1, "DISPFB1", "what circuit 1 reads", kDispFb},
    {GsReg::Display1, "DISPLAY1", "where it shows", kDisplay},
    {GsReg::BgColor, "BGCOLOR", "around it", kBgColor},
};

struct PsmName {
    std::uint64_t psm;
    std::string_view name;
};
constexpr PsmName kPsms[]{{0x00, "PSMCT32"}, {0x01, "PSMCT24"}, {0x02, "PSMCT16"}, {0x0a, "PSMCT16S"}, {0x13, "PSMT8"},
                          {0x14, "PSMT4"},   {0x1b, "PSMT8H"},  {0x24, "PSMT4HL"}, {0x2c, "PSMT4HH"},  {0x30, "PSMZ32"},
                          {0x31, "PSMZ24"},  {0x32, "PSMZ16"},  {0x3a, "PSMZ16S"}};

constexpr std::uint64_t mask_of(const GsField& field) {
    return field.width == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << field.width) - 1;
}
constexpr std::uint64_t value_of(const GsField& field, std::uint64_t register_value) {
    return register_value >> field.shift & mask_of(field);
}

const GsField& field_of(const GsRegister& reg, std::string_view name) {
    const auto found =
        std::find_if(reg.fields.begin(), reg.fields.end(), [&](const GsField& field) { return field.name == name; });
    if (found == reg.fields.end())
        throw std::out_of_range("register " + std::string(reg.name) + " has no field " + std::string(name));
    return *found;
}

const GsRegister& register_at(GsReg address) {
    const GsRegister* reg = find_gs_register(static_cast<std::uint32_t>(address));
    if (reg == nullptr) throw std::out_of_range("there is no register " + std::to_string(static_cast<int>(address)));
    return *reg;
}

// The shortest text that reads back as the same number.
template <class Number>
std::string number_text(Number value) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}
std::string hex_text(std::uint64_t value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, 16).ptr;
    return "0x" + std::string(text.data(), end);
}

std::string quantity(const GsField& field, std::uint64_t value) {
    switch (field.unit) {
        case Number:
        case Byte:
            return std::to_string(value);
        case Flag:
            return value != 0 ? "yes" : "no";
        case Hex:
            return hex_text(value);
        case Pixels:
            return std::to_string(value) + " px";
        case Pixels4:
            return number_text(static_cast<double>(value) / 16.0) + " px";
        case Texels:
            return std::to_string(value) + " texels";
        case Texels4:
            return number_text(static_cast<double>(value) / 16.0) + " texels";
        case Log2Texels:
            return std::to_string(std::uint64_t{1} << value) + " texels";
        case Float:
            return number_text(std::bit_cast<float>(static_cast<std::uint32_t>(value)));
        case Width64:
            return std::to_string(value * 64) + " px";
        case Page:
            return "byte " + std::to_string(value * 8192);
        case Block:
            return "byte " + std::to_string(value * 256);
        case Psm:
            return std::string(psm_name(value));
        case DepthPsm:
            return std::string(psm_name(value | 0x30));
        case Signed3:
            return std::to_string(static_cast<int>(value) - (value >= 4 ? 8 : 0));
        case Choice:
            return value < field.choices.size() ? std::string(field.choices[value]) : "reserved";
    }
    return {};
}

}  // namespace

std::span<const GsRegister> gs_registers() {
    return kRegisters;
}

const GsRegister* find_gs_register(std::uint32_t address) {
    const auto found = std::lower_bound(
        std::begin(kRegisters), std::end(kRegisters), address,
        [](const GsRegister& reg, std::uint32_t wanted) { return static_cast<std::uint32_t>(reg.address) < wanted; });
    return found != std::end(kRegisters) && static_cast<std::uint32_t>(found->address) == address ? found : nullptr;
}

std::uint64_t encode(GsReg address, std::initializer_list<GsFieldValue> fields) {
    const GsRegister& reg = register_at(address);
    std::uint64_t value   = 0;
    for (const GsFieldValue& each : fields) {
        const GsField& field = field_of(reg, each.name);
        if ((each.value & ~mask_of(field)) != 0)
            throw std::out_of_range("field " + std::string(each.name) + " of register " + std::string(reg.name) +
                                    " has " + std::to_string(field.width) + " bits, too few for " +
                                    std::to_string(each.value));
        value |= each.value << field.shift;
    }
    return value;
}

std::uint64_t decode(GsReg address, std::string_view field, std::uint64_t value) {
    return value_of(field_of(register_at(address), field), value);
}

std::string_view psm_name(std::uint64_t psm) {
    for (const PsmName& each : kPsms)
        if (each.psm == psm) return each.name;
    return {};
}

std::string field_text(const GsField& field, std::uint64_t register_value) {
    const std::uint64_t value = value_of(field, register_value);
    std::string text          = std::string(field.name) + ' ' + quantity(field, value);
    if (!field.meaning.empty()) text += " (" + std::string(field.meaning) + ')';
    return text;
}

}  // namespace pipeline
