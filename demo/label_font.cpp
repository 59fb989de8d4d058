// SPDX-License-Identifier: MIT
#include "demo/label_font.h"

#include <iterator>

namespace demo {
namespace {

constexpr int kGlyphsInBand = 16;
constexpr char kFirst = ' ', kLast = '~';

// Bands of 16 glyphs from the space on, in the order of ASCII; each glyph is kGlyphAdvance wide.
constexpr std::string_view kBands[] = {
    // clang-format off
    "        #    # #   # #    #   ##  #  ##     #      #   #                                      # ",
    "        #    # #   # #   #### ## #  #  #    #     #     #     #     #                        #  ",
    "        #         ##### # #      #  # #          #       #  # # #   #                        #  ",
    "        #          # #   ###    #    #           #       #   ###  #####        ###          #   ",
    "        #         #####   # #  #    # # #        #       #  # # #   #     ##               #    ",
    "                   # #  ####   # ## #  #          #     #     #     #     #          ##    #    ",
    "        #          # #    #   #  ##  ## #          #   #                 #           ##   #     ",
    " ###    #    ###   ###     #  #####   ##  #####  ###   ###                  #       #      ###  ",
    "#   #  ##   #   # #   #   ##  #      #        # #   # #   #  ##     ##     #         #    #   # ",
    "#  ##   #       #     #  # #  ####  #        #  #   # #   #  ##     ##    #   #####   #       # ",
    "# # #   #     ##    ##  #  #      # ####    #    ###   ####              #             #    ##  ",
    "##  #   #    #        # #####     # #   #   #   #   #     #  ##     ##    #   #####   #     #   ",
    "#   #   #   #     #   #    #  #   # #   #  #    #   #    #   ##     #      #         #          ",
    " ###   ###  #####  ###     #   ###   ###   #     ###   ##          #        #       #       #   ",
    " ###   ###  ####   ###  ####  ##### #####  ###  #   #  ###    ### #   # #     #   # #   #  ###  ",
    "#   # #   # #   # #   # #   # #     #     #   # #   #   #      #  #  #  #     ## ## ##  # #   # ",
    "# ### #   # #   # #     #   # #     #     #     #   #   #      #  # #   #     # # # ##  # #   # ",
    "# # # ##### ####  #     #   # ####  ####  # ### #####   #      #  ##    #     # # # # # # #   # ",
    "# ### #   # #   # #     #   # #     #     #   # #   #   #      #  # #   #     #   # #  ## #   # ",
    "#     #   # #   # #   # #   # #     #     #   # #   #   #   #  #  #  #  #     #   # #  ## #   # ",
    " ###  #   # ####   ###  ####  ##### #      #### #   #  ###   ##   #   # ##### #   # #   #  ###  ",
    "####   ###  ####   #### ##### #   # #   # #   # #   # #   # #####  ###  #      ###    #         ",
    "#   # #   # #   # #       #   #   # #   # #   # #   # #   #     #  #     #       #   # #        ",
    "#   # #   # #   # #       #   #   # #   # #   #  # #   # #     #   #     #       #  #   #       ",
    "####  #   # ####   ###    #   #   #  # #  # # #   #     #     #    #      #      #              ",
    "#     # # # # #       #   #   #   #  # #  # # #  # #    #    #     #       #     #              ",
    "#     #  #  #  #      #   #   #   #  # #  ## ## #   #   #   #      #       #     #              ",
    "#      ## # #   # ####    #    ###    #   #   # #   #   #   #####  ###      #  ###        ##### ",
    " #          #               #         ##        #       #      #  #      ##                     ",
    "  #         #               #        #          #                 #       #                     ",
    "       ###  ####   ####  ####  ###  ####   #### # ##   ##     ##  #  #    #   ## #  # ##   ###  ",
    "          # #   # #     #   # #   #  #    #   # ##  #   #      #  # #     #   # # # ##  # #   # ",
    "       #### #   # #     #   # #####  #     #### #   #   #      #  ##      #   # # # #   # #   # ",
    "      #   # #   # #     #   # #      #        # #   #   #      #  # #     #   # # # #   # #   # ",
    "       #### ####   ####  ####  ###   #     ###  #   #  ###   ##   #  #   ###  # # # #   #  ###  ",
    "                         #                                           #    #    #                ",
    "                         #                                          #     #     #               ",
    "####   #### # ##   #### ####  #   # #   # #   # #   # #   # #####   #     #     #    #          ",
    "#   # #   # ##  # #      #    #   # #   # # # #  # #  #   #    #   #      #      #  # # #       ",
    "####   #### #      ###   #    #   #  # #  # # #   #    ####   #     #     #     #      #        ",
    "#         # #         #  #    #  ##  # #  # # #  # #      #  #      #     #     #               ",
    "#         # #     ####    ##   ## #   #    # #  #   #  ###  #####    #    #    #                ",
    // clang-format on
};
static_assert(std::size(kBands) == 6 * kGlyphHeight);

}  // namespace

void draw_label(pipeline::ColorImage& image, std::string_view text, int left, int top, std::uint32_t color) {
    for (const char c : text) {
        const int glyph = (c < kFirst || c > kLast ? '?' : c) - kFirst;
        for (int y = 0; y < kGlyphHeight; ++y) {
            const std::string_view row = kBands[glyph / kGlyphsInBand * kGlyphHeight + y];
            for (int x = 0; x < kGlyphWidth; ++x) {
                const bool is_inside =
                    left + x >= 0 && left + x < image.width && top + y >= 0 && top + y < image.height;
                if (!is_inside || row[static_cast<std::size_t>(glyph % kGlyphsInBand * kGlyphAdvance + x)] != '#')
                    continue;
                image.pixels[static_cast<std::size_t>(top + y) * image.width + (left + x)] = color;
            }
        }
        left += kGlyphAdvance;
    }
}

}  // namespace demo
