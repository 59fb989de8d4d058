// SPDX-License-Identifier: MIT
#include "pipeline/legalize/mip_levels.h"

#include <algorithm>
#include <map>

#include "pipeline/check/chip_findings.h"
#include "pipeline/check/target_use.h"
#include "pipeline/legalize/window_map.h"

namespace pipeline {

namespace {

// Texels of level 0 that a pixel spans, squared: the greater of what a step right and a step down do to the coordinates, which are
// taken as linear over the triangle.
double texels_per_pixel_squared(const std::array<WindowVertex, 3>& v, const Texture& texture) {
    const double x1 = v[1].x - v[0].x, y1 = v[1].y - v[0].y, x2 = v[2].x - v[0].x, y2 = v[2].y - v[0].y;
    const double area = x1 * y2 - x2 * y1;
    if (area == 0.0) return 0.0;
    const auto texel = [&](const WindowVertex& vertex, int axis) {
        const double q = std::max(static_cast<double>(vertex.uv0.z), 1e-30);
        return static_cast<double>(vertex.uv0[axis]) / q * (axis == 0 ? texture.width : texture.height);
    };
    double right = 0.0, down = 0.0;
    for (int axis = 0; axis < 2; ++axis) {
        const double t1 = texel(v[1], axis) - texel(v[0], axis), t2 = texel(v[2], axis) - texel(v[0], axis);
        const double per_x = (t1 * y2 - t2 * y1) / area, per_y = (t2 * x1 - t1 * x2) / area;
        right += per_x * per_x;
        down += per_y * per_y;
    }
    return std::max(right, down);
}

// The nearest level, with bounds between n and n + 1 at 2^(n + 1/2) texels a pixel.
int nearest_level(double texels_squared, int levels) {
    int level    = 0;
    double bound = 2.0;
    while (level + 1 < levels && texels_squared >= bound) ++level, bound *= 4.0;
    return level;
}

class Splitter {
  public:
    explicit Splitter(Frame& frame) : frame_(frame) {}

    // Whether something has changed.
    bool split(Pass& pass) {
        bool has_changed = false;
        std::vector<Draw> draws;
        for (const Draw& draw : pass.draws) {
            const TextureId id     = textures_of(draw)[0].texture;
            const Texture* texture = find_texture(frame_, id);
            if (texture == nullptr || texture->levels == 1) {
                draws.push_back(draw);
                continue;
            }
            has_changed = true;
            if (const auto* triangles = std::get_if<DrawWindowTriangles>(&draw)) {
                split(*triangles, draws);
                continue;
            }
            draws.push_back(draw);
            (*bindings_of(draws.back()))[0].texture = level_of(id, rectangle_level(std::get<DrawRectangle>(draw)));
        }
        pass.draws                      = std::move(draws);
        pass.state.stages[0].mip_filter = MipFilter::None;
        return has_changed;
    }

  private:
    // Runs of triangles of one level.
    void split(const DrawWindowTriangles& draw, std::vector<Draw>& draws) {
        const TextureId id = draw.textures[0].texture;
        std::optional<int> running;
        for (std::uint32_t i = 0; i + 2 < draw.index_count; i += 3) {
            const int level = triangle_level(draw.first_index + i, *find_texture(frame_, id));
            if (running != level) {
                DrawWindowTriangles run = draw;
                run.first_index         = draw.first_index + i;
                run.index_count         = 0;
                run.textures[0].texture = level_of(id, level);
                draws.push_back(run);
                running = level;
            }
            std::get<DrawWindowTriangles>(draws.back()).index_count += 3;
        }
    }

    int triangle_level(std::uint32_t first_index, const Texture& texture) const {
        std::array<WindowVertex, 3> corners;
        for (std::uint32_t k = 0; k < 3; ++k) corners[k] = frame_.window_vertices[frame_.indices[first_index + k]];
        return nearest_level(texels_per_pixel_squared(corners, texture), texture.levels);
    }

    int rectangle_level(const DrawRectangle& rectangle) const {
        const Texture& texture = *find_texture(frame_, rectangle.textures[0].texture);
        const UvRect& uv       = rectangle.uv[0];
        const auto texels      = [](float from, float to, std::int32_t size, float width) {
            return width > 0.0f ? static_cast<double>(to - from) * size / static_cast<double>(width) : 0.0;
        };
        const double right = texels(uv.u0, uv.u1, texture.width, rectangle.x1 - rectangle.x0),
                     down  = texels(uv.v0, uv.v1, texture.height, rectangle.y1 - rectangle.y0);
        return nearest_level(std::max(right * right, down * down), texture.levels);
    }

    TextureId level_of(TextureId id, int level) {
        const auto [found, is_new] = levels_.insert({{id.index, level}, {}});
        if (!is_new) return found->second;
        found->second         = {static_cast<std::int32_t>(frame_.textures.size())};
        const Texture& source = frame_.textures[static_cast<std::size_t>(id.index)];
        Texture out{.name   = source.name + ", level " + std::to_string(level),
                    .format = source.format,
                    .width  = std::max(1, source.width >> level),
                    .height = std::max(1, source.height >> level),
                    .texels = {}};
        std::size_t first = 0;
        for (int i = 0; i < level; ++i) first += bytes_of(source, i);
        const auto start = source.texels.begin() + static_cast<std::ptrdiff_t>(first);
        out.texels.assign(start, start + static_cast<std::ptrdiff_t>(bytes_of(source, level)));
        frame_.textures.push_back(std::move(out));
        return found->second;
    }

    static std::size_t bytes_of(const Texture& texture, int level) {
        return static_cast<std::size_t>(std::max(1, texture.width >> level)) *
               static_cast<std::size_t>(std::max(1, texture.height >> level)) *
               static_cast<std::size_t>(bytes_per_texel(texture.format));
    }

    Frame& frame_;
    std::map<std::pair<std::int32_t, int>, TextureId> levels_;
};

bool can_split(const Pass& pass, const Profile& profile) {
    return draws(pass) && reads_texture(pass.state, 0) && !reads_texture(pass.state, 1) &&
           !is_among(pass.state.stages[0].mip_filter, profile.states.mip_filters) &&
           std::none_of(pass.draws.begin(), pass.draws.end(),
                        [](const Draw& draw) { return std::holds_alternative<DrawTriangles>(draw); });
}

}  // namespace

Frame rewrite_mip_levels(Frame frame, const Profile& profile, RewriteNotes& notes) {
    Splitter splitter(frame);
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        if (!can_split(frame.passes[i], profile)) continue;
        const MipFilter filter = frame.passes[i].state.stages[0].mip_filter;
        const bool has_changed = splitter.split(frame.passes[i]);
        if (has_changed || filter != MipFilter::None)
            notes.push_back({"mip_levels", place_of(frame, i),
                             "the chip chooses no level by the texels of a pixel, as mip_filter " + text_of(filter),
                             "one level a triangle, each a texture"});
    }
    return frame;
}

}  // namespace pipeline
