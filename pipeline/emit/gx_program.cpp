// SPDX-License-Identifier: MIT
#include "pipeline/emit/gx_program.h"

#include "pipeline/emit/gx_text.h"

namespace pipeline {

namespace {

constexpr std::string_view kHead = R"(/*
 * One frame for the GameCube, against libogc (github.com/devkitPro/libogc). It draws the frame once and keeps it on the
 * display.
 *
 * Building: with devkitPPC and libogc, from the folder that holds the file of data, which the assembler takes in whole
 * (.incbin), so that nothing is loaded at run time and textures lie at multiples of 32 bytes:
 *     powerpc-eabi-gcc -O2 -mogc -mcpu=750 -meabi -mhard-float -DGEKKO -I$DEVKITPRO/libogc/include \
 *         frame.c -L$DEVKITPRO/libogc/lib/cube -logc -lm -o frame.elf && elf2dol frame.elf frame.dol
 * or with the Makefile of devkitPro's examples, adding -Wa,-I and the folder of the data.
 *
 * The frame buffer: targets that are drawn to are rectangles of the chip's one frame buffer, and lie at one place if they
 * are not needed at one time. Other targets are textures in main memory, written by copies alone.
 * Clears are drawn rectangles, not the clear of GX_CopyTex, which would need a copy of the same pixels and even corners.
 * Targets that a pass uses before anything was written begin as zeros.
 * Depth: Direct3D's clip space has 0 <= z <= w, this chip's -w <= z <= 0, so z' = z - w. GX_SetViewport's 0 and 1 make of
 * it z / w in 24 bits again.
 * Textures: A8 and L8 are I8, which reads as its value in all four channels; their other channels are constants of the TEV.
 * Colours are lit by the chip where its formula is within 2 of 255 of the frame's at every vertex, else in the file of data.
 * Fog by distance from the eye (range), or of a projection that GX_SetFog has no numbers for, is the last stage of the TEV,
 * with its factor in the second vertex colour's alpha; other fog is the chip's own, by pixel.
 * Not known: whether the chip's interpolation of vertex colours is perspective-correct, and its pattern of dither (2x2 in
 * Dolphin, 4x4 in libogc's documentation).
 */
#include <gccore.h>
#include <malloc.h>
#include <string.h>
)";

std::string define(std::string_view name, const std::string& value) {
    return "#define " + std::string(name) + ' ' + value + "u\n";
}

}  // namespace

std::string gx_program_head(const GxProgramFacts& facts) {
    std::string text(kHead);
    text += "\n/* " + c_bytes(facts.data_bytes) + " bytes of data and " + c_bytes(facts.target_bytes) +
            " of copied targets, of the 24 MB that program, stack and display share. Offsets in the data:\n";
    for (const GxBlock& block : facts.blocks) {
        const std::string what = c_comment(block.what);
        text += " *   " + std::to_string(block.offset) + ", " + c_bytes(block.bytes) +
                " bytes: " + what.substr(3, what.size() - 6) + '\n';
    }
    text += " */\n";
    text +=
        "extern const u8 frame_data[];\n__asm__(\n    \".pushsection .rodata\\n\"\n    \"    .balign 32\\n\"\n"
        "    \"    .globl frame_data\\n\"\n    \"frame_data:\\n\"\n    \"    .incbin \\\"" +
        std::string(facts.data_file) + "\\\"\\n\"\n    \"    .popsection\\n\");\n";
    text += define("DATA_BYTES", std::to_string(facts.data_bytes));
    for (const GxArray& array : facts.arrays)
        if (array.is_there) text += define(array.name, std::to_string(array.offset));
    return text;
}

}  // namespace pipeline
