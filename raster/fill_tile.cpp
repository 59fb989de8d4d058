// SPDX-License-Identifier: MIT
#include "raster/fill_tile.h"

#include <algorithm>
#include <cstddef>

#include "raster/settled_pixels.h"

namespace raster {
namespace {

// What only asks for memory is always inline: gcc takes a function of nothing but prefetches for one without effect, and leaves
// out its calls.
[[gnu::always_inline]] inline void prefetch(const Image* image, const Rect& tile) {
    if (!image) return;
    constexpr int kLinePixels = 64 / sizeof(std::uint32_t);
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; x += kLinePixels) __builtin_prefetch(image->row(y) + x, 1);
}

// Triangles were set up long ago and maybe by another thread. They are asked for kAhead commands before those of their parts
// to which they point.
constexpr std::size_t kAhead = 4;
template <class Part>
[[gnu::always_inline]] inline void prefetch(const Part& part) {
    const char* const bytes = reinterpret_cast<const char*>(&part);
    for (std::size_t line = 0; line < sizeof(Part); line += 64) __builtin_prefetch(bytes + line);
    __builtin_prefetch(bytes + sizeof(Part) - 1);
}
[[gnu::always_inline]] inline void prefetch(const Command& command) {
    if (!command.triangle) return;
    const SetUpTriangle& triangle = *command.triangle;
    const SetupNeeds& needs       = command.plan->needs;
    prefetch(triangle.bounds);
    prefetch(triangle.edges);
    if (needs.diffuse) prefetch(triangle.diffuse);
    if (needs.fog) prefetch(triangle.specular[3]);
    if (needs.specular) prefetch(triangle.specular);
    if (needs.texture[0] || needs.texture[1]) prefetch(triangle.textures);
}
[[gnu::always_inline]] inline void prefetch_textures(const Command& command) {
    if (!command.triangle) return;
    const SetupNeeds& needs = command.plan->needs;
    for (int i = 0; i < kMaxTextures; ++i)
        if (needs.texture[i]) prefetch(command.triangle->textures[i]);
}

// Of the commands from `first` on, how many only show where they are the last.
std::size_t count_last_words(std::span<const Command* const> commands, std::size_t first) {
    const auto is_last_word = [](const Command* command) {
        return command->triangle && command->plan->program.is_last_word();
    };
    const auto begin = commands.begin() + static_cast<std::ptrdiff_t>(first);
    return static_cast<std::size_t>(std::find_if_not(begin, commands.end(), is_last_word) - begin);
}

void fill(const Command& command, const Rect& tile, const FillTarget& target, std::span<KernelCounts> counts,
          SettledPixels* settled) {
    const FillPlan& plan    = *command.plan;
    const bool is_special   = command.triangle ? plan.kernel.special_triangle : plan.kernel.special_rectangle;
    KernelCounts* const by  = counts.empty() ? nullptr : &counts[command.pass];
    FillCounts* const added = !by ? nullptr : is_special ? &by->special : &by->general;
    if (command.triangle)
        plan.kernel.triangle(plan, *command.triangle, tile, target, {added, settled});
    else
        plan.kernel.rectangle(plan, *command.rectangle, tile, target, {added, nullptr});
}

}  // namespace

void prefetch_tile(const FillTarget& target, const Rect& tile) {
    prefetch(target.color, tile);
    prefetch(target.depth, tile);
}

void fill_tile(std::span<const Command* const> commands, const Rect& tile, const FillTarget& target,
               std::span<KernelCounts> counts) {
    SettledPixels settled;
    for (std::size_t first = 0; first < commands.size();) {
        // All fragments have to be counted, where they are, even those that a later one hides.
        const std::size_t in_reverse = counts.empty() ? count_last_words(commands, first) : 0;
        if (in_reverse < 2) {
            if (first + 2 * kAhead < commands.size()) prefetch(*commands[first + 2 * kAhead]);
            if (first + kAhead < commands.size()) prefetch_textures(*commands[first + kAhead]);
            fill(*commands[first++], tile, target, counts, nullptr);
            continue;
        }
        settled.clear();
        for (std::size_t i = first + in_reverse; i-- > first;) {
            if (i >= first + 2 * kAhead) prefetch(*commands[i - 2 * kAhead]);
            if (i >= first + kAhead) prefetch_textures(*commands[i - kAhead]);
            fill(*commands[i], tile, target, counts, &settled);
        }
        first += in_reverse;
    }
}

}  // namespace raster
