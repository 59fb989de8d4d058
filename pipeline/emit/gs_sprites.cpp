// SPDX-License-Identifier: MIT
#include "pipeline/emit/gs_sprites.h"
#include "pipeline/legalize/window_map.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "pipeline/validate/check_pass.h"

namespace pipeline {

namespace {

constexpr std::int32_t kPageWidth = 64, kLargestStrip = 256;

std::int64_t to_integer(double value) {
    return static_cast<std::int64_t>(std::nearbyint(std::clamp(value, -0x1p62, 0x1p62)));
}
std::uint32_t rounded16(std::uint64_t value) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(value + 0x8000) >> 16);
}

// The coordinate in texels at the left or top edge of a pixel, which is where the chip samples it.
double line_at(const GsAxis& axis, std::int32_t pixel) {
    return axis.texel0 + static_cast<double>(16 * std::int64_t{pixel} - axis.x0) * (axis.texel1 - axis.texel0) /
                             static_cast<double>(axis.x1 - axis.x0);
}

// Do the pixels of `strip` read the same, if its coordinates are these?
bool reads_the_same(const GsAxis& axis, const GsStrip& strip, double from, double to) {
    const GsAxis written{16 * std::int64_t{strip.first}, 16 * std::int64_t{strip.end}, from, to, axis.across};
    for (std::int32_t pixel = strip.first; pixel < strip.end; ++pixel)
        if (sixteenths_at(axis, pixel) != sixteenths_at(written, pixel)) return false;
    return true;
}

// Where the strip that begins at `first` ends: at a page's edge, and after a power of two.
std::int32_t strip_end(const GsAxis& axis, std::int32_t first, std::int32_t end) {
    const std::int32_t limit = axis.across ? std::min(end, (first / kPageWidth + 1) * kPageWidth) : end;
    const auto length        = static_cast<std::int32_t>(std::bit_floor(static_cast<std::uint32_t>(limit - first)));
    return first + std::min(length, kLargestStrip);
}

struct Corner {
    std::uint32_t x = 0, y = 0;
};

std::uint64_t st_value(const Corner& corner) {
    return encode(GsReg::St, {{"S", corner.x}, {"T", corner.y}});
}
std::uint64_t uv_value(const Corner& corner) {
    return encode(GsReg::Uv, {{"U", corner.x}, {"V", corner.y}});
}

std::uint64_t colour_value(Argb color) {
    return encode(GsReg::Rgbaq, {{"R", color.value >> 16 & 255},
                                 {"G", color.value >> 8 & 255},
                                 {"B", color.value & 255},
                                 {"A", color.value >> 24},
                                 {"Q", std::bit_cast<std::uint32_t>(1.0f)}});
}

void emit_textured(const std::vector<GsStrip>& columns, const std::vector<GsStrip>& rows, bool by_uv,
                   std::uint32_t depth, GsBuilder& out) {
    const auto write = [&](const Corner& texel, std::int32_t x, std::int32_t y) {
        if (by_uv)
            out.write(GsReg::Uv, uv_value(texel));
        else
            out.write(GsReg::St, st_value(texel));
        emit_corner(x, y, depth, out);
    };
    for (const GsStrip& column : columns) {
        for (const GsStrip& row : rows) {
            write({column.from, row.from}, column.first, row.first);
            write({column.to, row.to}, column.end, row.end);
        }
    }
}

// Pixels whose left or top edge lies within the rectangle.
std::int32_t first_pixel(std::int64_t sixteenths) {
    return static_cast<std::int32_t>((sixteenths + 15) >> 4);
}

}  // namespace

std::int64_t window_sixteenths(float pixels) {
    return static_cast<std::int64_t>(std::trunc(pixels * 16.0f));
}

std::uint32_t depth_units(float depth, TargetFormat format) {
    const auto fine = static_cast<std::uint32_t>(std::nearbyint(static_cast<double>(depth) * ((1 << 30) - 1)));
    return format == TargetFormat::D16 ? fine >> 14 : format == TargetFormat::D24 ? fine >> 6 : fine << 2 | fine >> 28;
}
std::uint32_t depth_units(const Frame& frame, const Pass& pass, float depth) {
    const Target* target = find_target(frame, pass.depth);
    return target == nullptr ? 0 : depth_units(depth, target->format);
}

std::int32_t sixteenths_at(const GsAxis& axis, std::int32_t pixel) {
    const double slope        = (axis.texel1 - axis.texel0) * 0x1p36 / static_cast<double>(axis.x1 - axis.x0);
    const auto step           = static_cast<std::uint64_t>(to_integer(slope));
    const std::int64_t origin = to_integer(axis.texel0 * 0x1p32 + static_cast<double>(-axis.x0) / 16.0 * slope);
    const auto plane          = [&](std::int32_t at) {
        return static_cast<std::uint64_t>(origin) + static_cast<std::uint64_t>(std::int64_t{at}) * step;
    };
    if (!axis.across) return static_cast<std::int32_t>(rounded16(plane(pixel))) >> 12;
    const std::int32_t block = pixel / 16 * 16;
    return static_cast<std::int32_t>(rounded16(plane(block)) +
                                     static_cast<std::uint32_t>(pixel - block) * rounded16(step)) >>
           12;
}

std::vector<GsStrip> strips_by_uv(const GsAxis& axis, std::int32_t first, std::int32_t end) {
    std::vector<GsStrip> strips;
    const auto fits = [](double sixteenths) {
        return sixteenths >= 0.0 && sixteenths < 16384.0 && sixteenths == std::floor(sixteenths);
    };
    while (first < end) {
        GsStrip strip{first, strip_end(axis, first, end)};
        const double from = line_at(axis, strip.first) * 16.0, to = line_at(axis, strip.end) * 16.0;
        if (!fits(from) || !fits(to) || !reads_the_same(axis, strip, from / 16.0, to / 16.0)) return {};
        strip.from = static_cast<std::uint32_t>(from);
        strip.to   = static_cast<std::uint32_t>(to);
        first      = strip.end;
        strips.push_back(strip);
    }
    return strips;
}

std::vector<GsStrip> strips_by_st(const GsAxis& axis, std::int32_t first, std::int32_t end, std::uint32_t log2_size) {
    std::vector<GsStrip> strips;
    const double size    = std::ldexp(1.0, static_cast<int>(log2_size));
    const auto in_bits   = [](float value) { return std::bit_cast<std::uint32_t>(value); };
    std::int32_t longest = kLargestStrip;
    while (first < end) {
        GsStrip strip{first, std::min(strip_end(axis, first, end), first + longest)};
        auto from = static_cast<float>(line_at(axis, strip.first) / size),
             to   = static_cast<float>(line_at(axis, strip.end) / size);
        if (strip.end == first + 1) {
            // The middle of the sixteenth, over the whole pixel.
            from = to = static_cast<float>((sixteenths_at(axis, first) + 0.5) / 16.0 / size);
        } else if (!reads_the_same(axis, strip, double{from} * size, double{to} * size)) {
            longest = (strip.end - first) / 2;
            continue;
        }
        strip.from = in_bits(from);
        strip.to   = in_bits(to);
        first      = strip.end;
        longest    = kLargestStrip;
        strips.push_back(strip);
    }
    return strips;
}

void emit_corner(std::int32_t x, std::int32_t y, std::uint32_t depth, GsBuilder& out) {
    out.write(GsReg::Xyz2, {{"X", static_cast<std::uint64_t>(16 * x + kGsWindowOrigin)},
                            {"Y", static_cast<std::uint64_t>(16 * y + kGsWindowOrigin)},
                            {"Z", depth}});
}

void emit_sprites(const PixelRect& pixels, std::uint32_t depth, Argb color, GsBuilder& out) {
    out.write(GsReg::Rgbaq, colour_value(color));
    for (std::int32_t x = pixels.x0; x < pixels.x1;) {
        const std::int32_t end = std::min(pixels.x1, (x / kPageWidth + 1) * kPageWidth);
        emit_corner(x, pixels.y0, depth, out);
        emit_corner(end, pixels.y1, depth, out);
        x = end;
    }
}

void emit_rectangle(const Frame& frame, const GsMemory& memory, const Pass& pass, const DrawRectangle& draw,
                    GsBuilder& out) {
    const PixelRect part  = limit_of(frame, pass);
    const std::int64_t x0 = window_sixteenths(draw.x0), x1 = window_sixteenths(draw.x1),
                       y0 = window_sixteenths(draw.y0), y1 = window_sixteenths(draw.y1);
    const PixelRect pixels{std::max(part.x0, first_pixel(x0)), std::max(part.y0, first_pixel(y0)),
                           std::min(part.x1, first_pixel(x1)), std::min(part.y1, first_pixel(y1))};
    if (pixels.x0 >= pixels.x1 || pixels.y0 >= pixels.y1) return;  // none of it shows

    const std::uint32_t depth                = depth_units(frame, pass, draw.depth);
    const std::optional<GsFunction> function = texture_function(pass.state);
    const auto begin                         = [&](bool by_uv) {
        constexpr std::uint64_t kSprite = 6;
        out.write(
                                    GsReg::Prim,
                                    {{"PRIM", kSprite}, {"TME", function.has_value()}, {"ABE", blends(pass.state.gs_blend)}, {"FST", by_uv}});
    };
    if (!function) {
        begin(false);
        return emit_sprites(pixels, depth, draw.color, out);
    }

    const TextureStage& stage = pass.state.stages[0];
    const GsTexture texture   = bound_texture(frame, memory, draw.textures[0]);
    const GsSurface& surface  = texture.surface;
    set_texture(texture, *function, stage.filter == TextureFilter::Linear, stage.address_u == TextureAddress::Wrap,
                stage.address_v == TextureAddress::Wrap, out);
    const GsAxis across{x0, x1, double{draw.uv[0].u0} * surface.width, double{draw.uv[0].u1} * surface.width, true};
    const GsAxis down{y0, y1, double{draw.uv[0].v0} * surface.height, double{draw.uv[0].v1} * surface.height, false};
    std::vector<GsStrip> columns = strips_by_uv(across, pixels.x0, pixels.x1),
                         rows    = strips_by_uv(down, pixels.y0, pixels.y1);
    const bool by_uv             = !columns.empty() && !rows.empty();
    if (!by_uv) {
        columns = strips_by_st(across, pixels.x0, pixels.x1, log2_size(surface.width));
        rows    = strips_by_st(down, pixels.y0, pixels.y1, log2_size(surface.height));
    }
    begin(by_uv);
    out.write(GsReg::Rgbaq, colour_value(draw.color));
    emit_textured(columns, rows, by_uv, depth, out);
}

}  // namespace pipeline
