// SPDX-License-Identifier: MIT
#include "pipeline/cost/rates.h"

#include <algorithm>
#include <array>

namespace pipeline {

namespace {

void set_range(Rate& rate, std::string_view unit, double low, double high, const Evidence& evidence) {
    rate = {unit, low, high, evidence};
}
void set(Rate& rate, std::string_view unit, double value, const Evidence& evidence) {
    set_range(rate, unit, value, value, evidence);
}
void set_no_limit(Rate& rate, std::string_view unit, const Evidence& evidence) {
    set(rate, unit, kNoLimit, evidence);
}
void set_not_known(Rate& rate, std::string_view unit, std::string_view topic, std::string_view open) {
    set(rate, unit, 0.0, {topic, "none", Grade::Chosen, open});
}

// Sources. clearbench: github.com/F0bes/clearbench, ps2_results.txt, on an SCPH-39001; its cycles are the main
// processor's, of which two are a clock of the chip. Each clear, less a clock for 16 pixels, over the pages it changes:
//   640x448 as one sprite, colour and depth apart       39972 - 17920 clocks over 2240 spans:   9.84
//   the same in half the height, two halves at once     19600 -  8960 clocks over 1120 spans:   9.50
//   140 sprites of a page                               20248 - 17920 clocks over  140 pages:  16.6
//   70 sprites of a page, two halves at once            10233 -  8960 clocks over   70 pages:  18.2
//   sprites of 64x2048, a page under the other          20284 - 17920 clocks over  140 pages:  16.9
//   140 sprites of 32x32, colour and depth in one page   9200 -  8960 clocks over  140 pages:   1.7
//   sprites of 32x2048, colour and depth in one page     9257 -  8960 clocks over  140 pages:   2.1
constexpr std::string_view kClearbench = "fitted to F0bes/clearbench, ps2_results.txt (SCPH-39001)";
constexpr std::string_view kGsPeaks =
    "Sony, 2 March 1999 (75 M small polygons a second, 20 M with Z, texture, light and alpha); PS2 Linux kit "
    "handbook (25 to 75 M triangles)";

PageBreakRates gs_page_breaks() {
    PageBreakRates rates;
    set_range(rates.span_one, "clk", 1.7, 9.85,
              {"span_one", "clearbench, from the cheapest page entered to the spans of two pages", Grade::Chosen,
               "Spans that cross pages of colour alone were not measured"});
    set_range(rates.span_two, "clk", 9.5, 9.85,
              {"span_two", kClearbench, Grade::Fitted,
               "jbit.net, \"PS2 Graphics Synthesizer Fill Performance\", guesses dozens to hundreds of clocks"});
    set_range(
        rates.entry_one, "clk", 1.7, 2.15,
        {"entry_one", kClearbench, Grade::Fitted, "Measured with colour and depth in one page, not with colour alone"});
    set_range(rates.entry_two, "clk", 16.6, 18.2,
              {"entry_two", kClearbench, Grade::Fitted,
               "Why a page entered costs more than a span that crosses one is not known"});
    set_range(
        rates.texture, "clk", 1.7, 18.2,
        {"texture_page",
         "chosen: from the cheapest to the dearest change of a frame page; that textures have them is jbit.net's, "
         "and RenderWare 3.5's PS2 reference's (fill-rate considerations)",
         Grade::Chosen, "Not measured, nor whether it runs beside the frame's"});
    return rates;
}

ChipRates ps2_rates() {
    ChipRates rates{.profile = "ps2",
                    .chip    = "Graphics Synthesizer; bandwidths from its clock to the rounded 150 MHz of the press",
                    .memory  = MemoryKind::Separate,
                    .uploads_vertices   = true,
                    .footprint          = {8, 2},
                    .textured_footprint = {4, 2},
                    .page_breaks        = gs_page_breaks()};
    set(rates.clock, "MHz", 147.456,
        {"clock", "techpowerup.com, PlayStation 2; wdic.org, Graphics Synthesizer", Grade::Document, ""});
    set(rates.pixels, "pixels/clk", 16.0,
        {"pixels",
         "jbit.net, \"PS2 Graphics Synthesizer Fill Performance\": 8x2 pixels; blending and depth test cost "
         "nothing: Sony, \"Using the Z Buffer for Visual and Special Effects\"; nor does writing depth: clearbench",
         Grade::Document, "That blends read the target without a loss is inferred, from a port of its own"});
    set(rates.textured_pixels, "pixels/clk", 8.0,
        {"textured_pixels", "jbit.net, as above: 4x2 pixels; linear filters cost nothing: Sony, as above",
         Grade::Document, ""});
    set_not_known(
        rates.fogged_pixels, "pixels/clk", "fogged_pixels",
        "Sony, \"Using the Z Buffer for Visual and Special Effects\": vertex fog lowers the fill rate. By how much "
        "is not said, and no other source confirms it");
    set(rates.samples, "samples/clk", 8.0, {"samples", "as textured_pixels: one texture a pass", Grade::Document, ""});
    set_no_limit(rates.stages, "stages/clk", {"stages", "there is one", Grade::Emulators, ""});
    set_range(
        rates.frame_bandwidth, "GB/s", 37.75, 38.4,
        {"frame_bandwidth",
         "Sony, 2 March 1999; techpowerup.com; wdic.org: 1024 bits read and 1024 written a clock, colour and depth",
         Grade::Document, "The sources' 38.4 is for 150 MHz, 37.75 for the clock above"});
    set_range(
        rates.texture_bandwidth, "GB/s", 9.43, 9.6,
        {"texture_bandwidth", "the same: 512 bits a clock", Grade::Document,
         "9.6 is for 150 MHz, 9.43 for the clock above. The chip keeps a page of a texture; how it fills it is not "
         "known"});
    set_no_limit(rates.memory_bandwidth, "GB/s",
                 {"memory_bandwidth", "targets and textures lie in the chip", Grade::Document, ""});
    set_not_known(rates.texture_cache, "bytes", "texture_cache",
                  "A page of a texture; how the chip replaces it is not known");
    set_not_known(
        rates.copies, "Mpixels/s", "copies",
        "The rate of transfers within the local memory (TRXDIR 2) is not known; the memory's bandwidth alone is "
        "counted");
    set_range(
        rates.setup, "Mprimitives/s", 20.0, 75.0,
        {"setup", kGsPeaks, Grade::Document,
         "Which unit the smaller figures are of is not said. clearbench draws 140 sprites in the time of 3: setup "
         "runs beside filling"});
    set_range(
        rates.vertices, "Mvertices/s", 20.0, 75.0,
        {"vertices", kGsPeaks, Grade::Document,
         "Triangles, taken as the vertices of strips: the program of vector unit 1 decides, and no measurement of "
         "one is known"});
    set_range(rates.upload, "GB/s", 1.18, 1.2,
              {"upload", "PS2 Linux kit handbook; wdic.org: 64 bits a clock to the chip", Grade::Document,
               "1.2 is for 150 MHz, 1.18 for the clock above"});
    return rates;
}

constexpr std::string_view kCards =
    "GeForce 256: amdarea51.de, tecchannel, guru3d; GeForce2 GTS: guru3d, planethardware, tommti-systems";

ChipRates dx7_rates() {
    ChipRates rates{
        .profile = "dx7", .chip = "from GeForce 256 with SDR memory to GeForce2 GTS", .memory = MemoryKind::Shared};
    set_range(rates.clock, "MHz", 120.0, 200.0, {"clock", kCards, Grade::Document, ""});
    set(rates.pixels, "pixels/clk", 4.0,
        {"pixels", kCards, Grade::Document,
         "Peaks of 480 and 800 Mpixels/s, which the memory seldom feeds: see memory_bandwidth"});
    set(rates.textured_pixels, "pixels/clk", 4.0, {"textured_pixels", kCards, Grade::Document, ""});
    set_no_limit(rates.fogged_pixels, "pixels/clk",
                 {"fogged_pixels", "none", Grade::Chosen, "No source says that fog costs pixels"});
    set_range(rates.samples, "samples/clk", 4.0, 8.0,
              {"samples", kCards, Grade::Document,
               "One texture a pipeline and clock, and two. That linear mips take two samples is chosen"});
    set_no_limit(rates.stages, "stages/clk",
                 {"stages", "Mesa 7.10, NV10_TEXTURE_UNITS: 2 texture units, 2 combiners", Grade::Document,
                  "Whether two stages with one texture cost a clock more is not known"});
    set_no_limit(rates.frame_bandwidth, "GB/s", {"frame_bandwidth", "in memory_bandwidth", Grade::Document, ""});
    set_no_limit(rates.texture_bandwidth, "GB/s",
                 {"texture_bandwidth", "in memory_bandwidth", Grade::Chosen, "The caches' bandwidth is not known"});
    set_range(rates.memory_bandwidth, "GB/s", 2.66, 5.31,
              {"memory_bandwidth", kCards, Grade::Document,
               "Peaks; 4.8 for GeForce 256 with DDR memory. What a memory gives in practice is not known"});
    set_not_known(rates.texture_cache, "bytes", "texture_cache", "Not known");
    set_not_known(rates.copies, "Mpixels/s", "copies",
                  "The rate of a blit is not known; the memory's bandwidth alone is counted");
    set_not_known(rates.setup, "Mprimitives/s", "setup", "Not known for NV10 and NV15");
    set(rates.vertices, "Mvertices/s", 20.0,
        {"vertices",
         "chosen: 20 M triangles a second of the GeForce2 MX (sharkyextreme, October 2000; guru3d; computerbase), "
         "as the vertices of strips",
         Grade::Chosen, "Not known for NV10 and NV15, nor what each light costs"});
    set_not_known(rates.upload, "GB/s", "upload", "The bandwidth from the computer to the card is not known");
    return rates;
}

ChipRates gamecube_rates() {
    ChipRates rates{.profile            = "gamecube",
                    .chip               = "Flipper",
                    .memory             = MemoryKind::Embedded,
                    .footprint          = {2, 2},
                    .textured_footprint = {2, 2}};
    set(rates.clock, "MHz", 162.0, {"clock", "nintendo.co.uk, \"Technical Details\"", Grade::Document, ""});
    set(rates.pixels, "pixels/clk", 4.0,
        {"pixels", "Wikipedia, GameCube specifications: 4 pipelines, 648 Mpixels/s; in quads of 2x2: libogc, gx.h",
         Grade::Document, "No source of the maker. What blending costs is not known"});
    set(rates.textured_pixels, "pixels/clk", 4.0,
        {"textured_pixels", "as pixels: one texture unit a pipeline", Grade::Document, ""});
    set_no_limit(rates.fogged_pixels, "pixels/clk",
                 {"fogged_pixels", "none", Grade::Chosen, "No source says that fog costs pixels"});
    set(rates.samples, "samples/clk", 4.0,
        {"samples", "as textured_pixels", Grade::Document, "That linear mips take two samples is chosen"});
    set_range(rates.stages, "stages/clk", 1.0, 2.0,
              {"stages", "chosen: commonly said to be one, without a primary source", Grade::Chosen,
               "Whether another stage costs another clock was not measured"});
    set_range(
        rates.frame_bandwidth, "GB/s", 7.6, kNoLimit,
        {"frame_bandwidth", "chosen: 7.6 is quoted on fan pages alone", Grade::Chosen,
         "No source for an upper limit. Formats of 4 bytes are counted as such, where the embedded memory holds 3"});
    set(rates.texture_bandwidth, "GB/s", 10.4,
        {"texture_bandwidth", "nintendo.co.uk, \"Technical Details\": peak of texture reads", Grade::Document, ""});
    set(rates.memory_bandwidth, "GB/s", 2.6,
        {"memory_bandwidth", "nintendo.co.uk, \"Technical Details\": peak of main memory", Grade::Document,
         "The share of the processor is not known"});
    set(rates.texture_cache, "bytes", 1048576.0,
        {"texture_cache", "nintendo.co.uk, \"Technical Details\"; Dolphin, TextureDecoder.h", Grade::Document,
         "libogc splits it into regions; all of it is taken for one"});
    set_not_known(
        rates.copies, "Mpixels/s", "copies",
        "What a copy costs, and a change of the frame buffer's format before it, is not known; what it writes to "
        "main memory alone is counted");
    set_not_known(rates.setup, "Mprimitives/s", "setup", "Not known");
    set_not_known(rates.vertices, "Mvertices/s", "vertices", "Not known");
    set_no_limit(rates.upload, "GB/s",
                 {"upload", "textures lie in main memory, where the chip reads them", Grade::Document, ""});
    return rates;
}

ChipRates xbox_rates() {
    ChipRates rates{.profile = "xbox",
                    .chip    = "NV2A; memory with and without what its processor can take",
                    .memory  = MemoryKind::Shared};
    set(rates.clock, "MHz", 233.0, {"clock", "Wikipedia, Xbox specifications", Grade::Document, ""});
    set(rates.pixels, "pixels/clk", 4.0,
        {"pixels", "envytools, gpu.rst: 4 pipelines; Wikipedia and tomshardware: 932 and 933 Mpixels/s",
         Grade::Document, "Wikipedia calls 250 to 700 Mpixels/s realistic with depth, blending and texture"});
    set(rates.textured_pixels, "pixels/clk", 4.0, {"textured_pixels", "as pixels", Grade::Document, ""});
    set_no_limit(rates.fogged_pixels, "pixels/clk",
                 {"fogged_pixels", "none", Grade::Chosen, "No source says that fog costs pixels"});
    set(rates.samples, "samples/clk", 8.0,
        {"samples", "envytools, gpu.rst: 8 texture units; Wikipedia: 1864 Mtexels/s", Grade::Document,
         "That linear mips take two samples is chosen"});
    set_no_limit(rates.stages, "stages/clk",
                 {"stages", "8 register combiners (xemu, nv2a_regs.h)", Grade::Emulators,
                  "How many of them a pixel passes in a clock is not known"});
    set_no_limit(rates.frame_bandwidth, "GB/s", {"frame_bandwidth", "in memory_bandwidth", Grade::Document, ""});
    set_no_limit(rates.texture_bandwidth, "GB/s",
                 {"texture_bandwidth", "in memory_bandwidth", Grade::Chosen, "The caches' bandwidth is not known"});
    set_range(rates.memory_bandwidth, "GB/s", 5.3, 6.4,
              {"memory_bandwidth", "tomshardware, Wikipedia: 6.4 in all, of which the processor's bus can take 1.06",
               Grade::Document, "What compressed depth and tiles save is not known"});
    set_not_known(rates.texture_cache, "bytes", "texture_cache", "Not known");
    set_not_known(rates.copies, "Mpixels/s", "copies",
                  "The rate of a blit is not known; the memory's bandwidth alone is counted");
    set_not_known(rates.setup, "Mprimitives/s", "setup", "Not known");
    set_not_known(rates.vertices, "Mvertices/s", "vertices",
                  "2 vertex units (envytools, gpu.rst); their rate is not known");
    set_no_limit(rates.upload, "GB/s",
                 {"upload", "textures lie in the memory that the chip reads", Grade::Document, ""});
    return rates;
}

}  // namespace

std::span<const ChipRates> chip_rates() {
    static const std::array<ChipRates, 4> all{dx7_rates(), ps2_rates(), gamecube_rates(), xbox_rates()};
    return all;
}

const ChipRates* find_rates(std::string_view profile) {
    const auto all = chip_rates();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const ChipRates& one) { return one.profile == profile; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace pipeline
