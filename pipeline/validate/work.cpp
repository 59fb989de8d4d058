// SPDX-License-Identifier: MIT
#include "pipeline/validate/work.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pipeline/validate/check_pass.h"
#include "pipeline/validate/findings.h"

namespace pipeline {
namespace {

constexpr std::uint64_t kPixelBytes = 4;  // of a target, whatever its format

std::uint64_t product(std::int64_t a, std::int64_t b) {
    return static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b);
}

std::uint64_t area(const PixelRect& rect) {
    return rect.x0 < rect.x1 && rect.y0 < rect.y1
               ? product(std::int64_t{rect.x1} - rect.x0, std::int64_t{rect.y1} - rect.y0)
               : 0;
}

PixelRect common(const PixelRect& a, const PixelRect& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

PixelRect whole_if_empty(const PixelRect& rect, const PixelRect& whole) {
    return rect == PixelRect{} ? whole : rect;
}

// Beside the texels that the frame holds: those of one byte are expanded to four, and those of A8 also kept by fours.
std::uint64_t texture_bytes(const Texture& texture) {
    std::uint64_t bytes = texture.texels.size();
    if (texture.format == TextureFormat::A8R8G8B8) return bytes;
    for (int level = 0; level < texture.levels; ++level) {
        const std::int64_t width  = std::max(1, texture.width >> level);
        const std::int64_t height = std::max(1, texture.height >> level);
        bytes += product(width, height) * (1 + kPixelBytes);
        if (texture.format == TextureFormat::A8) bytes += product(width + 1, height + 1) * kPixelBytes;
    }
    return bytes;
}

// The pixels around some points, a pixel more on each side for snapping and rounding.
class Bounds {
  public:
    void add(double x, double y) {
        x0_ = std::min(x0_, x), x1_ = std::max(x1_, x);
        y0_ = std::min(y0_, y), y1_ = std::max(y1_, y);
    }
    std::uint64_t area_within(const PixelRect& region) const {
        const auto side = [](double least, double greatest, std::int32_t first, std::int32_t end) {
            return std::max(0.0, std::min(std::ceil(greatest) + 1.0, static_cast<double>(end)) -
                                     std::max(std::floor(least) - 1.0, static_cast<double>(first)));
        };
        return static_cast<std::uint64_t>(side(x0_, x1_, region.x0, region.x1) * side(y0_, y1_, region.y0, region.y1));
    }

  private:
    double x0_ = HUGE_VAL, x1_ = -HUGE_VAL, y0_ = HUGE_VAL, y1_ = -HUGE_VAL;
};

// Where the viewport puts a vertex, and beyond which of the viewport's sides and the near plane it is.
struct Placed {
    double x = 0.0, y = 0.0;
    std::uint8_t outside = 0;
    bool is_placed       = false;  // in front of the eye
    bool was_looked_at   = false;
};

class Projection {
  public:
    Projection(const Frame& frame, const Pass& pass, const DrawTriangles& draw, const PixelRect& viewport)
        : frame_(frame),
          viewport_(viewport),
          matrix_(to_double(camera(frame, pass).projection) * to_double(camera(frame, pass).view) *
                  to_double(draw.world)) {}

    Placed place(std::uint32_t index) const {
        const Vec3& position  = frame_.vertices[index].position;
        const glm::dvec4 clip = matrix_ * glm::dvec4(double{position.x}, double{position.y}, double{position.z}, 1.0);
        Placed placed{.was_looked_at = true};
        placed.outside   = static_cast<std::uint8_t>((clip.x < -clip.w ? 1 : 0) | (clip.x > clip.w ? 2 : 0) |
                                                   (clip.y < -clip.w ? 4 : 0) | (clip.y > clip.w ? 8 : 0) |
                                                   (clip.z < 0.0 ? 16 : 0) | (clip.z > clip.w ? 32 : 0));
        // Single precision may see the eye's plane elsewhere; and what it cannot hold it drops.
        placed.is_placed = clip.w > 1e-4 * (std::abs(clip.x) + std::abs(clip.y));
        placed.x         = viewport_.x0 + (1.0 + clip.x / clip.w) * 0.5 * (viewport_.x1 - viewport_.x0);
        placed.y         = viewport_.y0 + (1.0 - clip.y / clip.w) * 0.5 * (viewport_.y1 - viewport_.y0);
        return placed;
    }

  private:
    static const Camera& camera(const Frame& frame, const Pass& pass) {
        return frame.cameras[static_cast<std::size_t>(pass.camera.index)];
    }
    static glm::dmat4 to_double(const Mat4& matrix) { return glm::dmat4(matrix); }

    const Frame& frame_;
    PixelRect viewport_;
    glm::dmat4 matrix_;
};

// One pass: within its region, what its draws fill.
class PassWork {
  public:
    // triangles_before: of the passes before it.
    PassWork(const Frame& frame, const Pass& pass, std::uint64_t triangles_before, std::vector<Placed>& places)
        : frame_(frame), pass_(pass), triangles_before_(triangles_before), places_(places) {
        const Target& target = *find_target(frame, pass.color ? pass.color : pass.depth);
        const PixelRect whole{0, 0, target.width, target.height};
        viewport_ = whole_if_empty(pass.state.viewport, whole);
        region_   = common(common(whole, viewport_), whole_if_empty(pass.state.scissor, whole));
    }

    Work operator()() {
        work_.pixels = area(region_) * ((pass_.clear.color ? 1 : 0) + (pass_.clear.depth ? 1 : 0));
        for (const Draw& draw : pass_.draws) {
            work_.bytes += kDrawBytes;
            std::visit([&](const auto& one) { add(one); }, draw);
        }
        return work_;
    }

  private:
    void add(const CopyRectangle& draw) { work_.pixels += area(draw.from); }

    void add(const DrawRectangle& draw) {
        Bounds bounds;
        bounds.add(double{draw.x0}, double{draw.y0});
        bounds.add(double{draw.x1}, double{draw.y1});
        work_.pixels += bounds.area_within(region_);
    }

    void add(const DrawWindowTriangles& draw) {
        if (!add_triangles(draw.index_count)) return;
        for_each_triangle(draw, [&](const std::array<std::uint32_t, 3>& corners) {
            Bounds bounds;
            for (const std::uint32_t corner : corners) {
                const WindowVertex& vertex = frame_.window_vertices[corner];
                bounds.add(double{vertex.x}, double{vertex.y});
            }
            work_.pixels += bounds.area_within(region_);
        });
    }

    void add(const DrawTriangles& draw) {
        if (!add_triangles(draw.index_count) || area(region_) == 0) return;
        const Projection projection(frame_, pass_, draw, viewport_);
        places_.assign(frame_.vertices.size() <= draw.index_count ? frame_.vertices.size() : 0, {});
        const auto place = [&](std::uint32_t index) {
            if (places_.empty()) return projection.place(index);
            Placed& placed = places_[index];
            if (!placed.was_looked_at) placed = projection.place(index);
            return placed;
        };
        for_each_triangle(draw, [&](const std::array<std::uint32_t, 3>& corners) {
            const std::array placed{place(corners[0]), place(corners[1]), place(corners[2])};
            if (placed[0].outside & placed[1].outside & placed[2].outside) return;
            Bounds bounds;
            bool are_placed = true;
            for (const Placed& one : placed) {
                are_placed = are_placed && one.is_placed;
                bounds.add(one.x, one.y);
            }
            work_.pixels += are_placed ? bounds.area_within(region_) : area(region_);
        });
    }

    template <class AnyDraw, class Use>
    void for_each_triangle(const AnyDraw& draw, Use&& use) const {
        // The last indices may not make a triangle.
        for (std::uint64_t i = draw.first_index; i + 3 <= std::uint64_t{draw.first_index} + draw.index_count; i += 3)
            use({frame_.indices[i], frame_.indices[i + 1], frame_.indices[i + 2]});
    }

    // Are they to be looked at one by one? A text of a megabyte can ask for more than could be in an hour.
    bool add_triangles(std::uint32_t indices) {
        work_.triangles += indices / 3;
        work_.bytes += indices / 3 * kTriangleBytes;
        if (triangles_before_ + work_.triangles <= kMostWork.triangles) return true;
        work_.pixels += indices / 3 * area(region_);
        return false;
    }

    const Frame& frame_;
    const Pass& pass_;
    std::uint64_t triangles_before_;
    std::vector<Placed>& places_;
    PixelRect viewport_, region_;
    Work work_;
};

}  // namespace

Work work_of(const Frame& frame) {
    Work work;
    for (const Target& target : frame.targets) work.bytes += product(target.width, target.height) * kPixelBytes;
    if (const Target* output = find_target(frame, frame.output))
        work.bytes += product(output->width, output->height) * kPixelBytes;
    for (const Texture& texture : frame.textures) work.bytes += texture_bytes(texture);
    std::vector<Placed> places;
    for (const Pass& pass : frame.passes) {
        const Work of_pass = PassWork(frame, pass, work.triangles, places)();
        work.bytes += of_pass.bytes;
        work.triangles += of_pass.triangles;
        work.pixels += of_pass.pixels;
    }
    return work;
}

std::vector<Finding> check_work(const Work& work, int times) {
    Findings findings;
    const auto check = [&](std::uint64_t value, std::uint64_t most, const char* start, const char* what) {
        const std::uint64_t limit = most * static_cast<std::uint64_t>(times);
        if (value <= limit) return;
        report(findings, Place("frame"),
               std::string(start) + " at most " + std::to_string(limit) + ' ' + what + " (got " +
                   std::to_string(value) + ')');
    };
    check(work.bytes, kMostWork.bytes, "must take", "bytes of memory");
    check(work.triangles, kMostWork.triangles, "must draw", "triangles");
    check(work.pixels, kMostWork.pixels, "must fill", "pixels");
    return findings;
}

std::uint64_t needed_limit(const Work& work) {
    const auto times = [](std::uint64_t value, std::uint64_t most) { return (value + most - 1) / most; };
    return std::max({times(work.bytes, kMostWork.bytes), times(work.triangles, kMostWork.triangles),
                     times(work.pixels, kMostWork.pixels), std::uint64_t{1}});
}

}  // namespace pipeline
