// SPDX-License-Identifier: MIT
#include "raster/fill_tile.h"

namespace raster {
namespace {

// Asks for the tile's pixels before the first of them is needed: rows lie far apart, and no processor guesses them.
void prefetch(const Image* image, const Rect& tile) {
    if (!image) return;
    constexpr int kLinePixels = 64 / sizeof(std::uint32_t);
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; x += kLinePixels) __builtin_prefetch(image->row(y) + x, 1);
}

// Triangles were set up long ago and maybe by another thread.
constexpr std::size_t kAhead = 3;
void prefetch(const Command& command) {
    if (!command.triangle) return;
    const char* const bytes = reinterpret_cast<const char*>(command.triangle);
    for (std::size_t line = 0; line < sizeof(SetUpTriangle); line += 64) __builtin_prefetch(bytes + line);
}

}  // namespace

void fill_tile(std::span<const Command* const> commands, const Rect& tile, const FillTarget& target,
               std::span<KernelCounts> counts) {
    if (commands.empty()) return;
    prefetch(target.color, tile);
    prefetch(target.depth, tile);
    for (std::size_t i = 0; i < commands.size(); ++i) {
        if (i + kAhead < commands.size()) prefetch(*commands[i + kAhead]);
        const Command& command = *commands[i];
        const FillPlan& plan   = *command.plan;
        KernelCounts& by       = counts[command.pass];
        if (command.triangle)
            plan.kernel.triangle(plan, *command.triangle, tile, target,
                                 plan.kernel.special_triangle ? by.special : by.general);
        else
            plan.kernel.rectangle(plan, *command.rectangle, tile, target,
                                  plan.kernel.special_rectangle ? by.special : by.general);
    }
}

}  // namespace raster
