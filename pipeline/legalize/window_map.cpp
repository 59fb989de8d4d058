// SPDX-License-Identifier: MIT
#include "pipeline/legalize/window_map.h"

#include "pipeline/check/target_use.h"
#include "pipeline/validate/findings.h"

namespace pipeline {

namespace {

// Rows 0 and 1 of the matrix get their share of row 3.
Mat4 moved(const Mat4& projection, const WindowMap& map) {
    const auto sum = [](double scale, float value, double shift, float w) {
        return static_cast<float>(scale * static_cast<double>(value) + shift * static_cast<double>(w));
    };
    Mat4 result = projection;
    for (glm::length_t column = 0; column < 4; ++column) {
        const float w     = projection[column][3];
        result[column][0] = sum(map.scale_x, projection[column][0], map.shift_x, w);
        result[column][1] = sum(map.scale_y, projection[column][1], map.shift_y, w);
    }
    return result;
}

// One way in which passes of a camera move.
struct CameraUse {
    std::optional<WindowMap> map;
    std::vector<std::size_t> passes;
};

// In the order of the passes, but what stays as it is comes first.
std::vector<CameraUse> uses_of(const Frame& frame, CameraId camera, const std::vector<std::optional<WindowMap>>& maps) {
    std::vector<CameraUse> uses;
    for (std::size_t pass = 0; pass < frame.passes.size(); ++pass) {
        if (frame.passes[pass].camera != camera || !draws_triangles(frame.passes[pass])) continue;
        auto use = uses.begin();
        while (use != uses.end() && use->map != maps[pass]) ++use;
        if (use == uses.end()) use = uses.insert(maps[pass] ? uses.end() : uses.begin(), {maps[pass], {}});
        use->passes.push_back(pass);
    }
    return uses;
}

}  // namespace

void move_triangles(Frame& frame, const std::vector<std::optional<WindowMap>>& maps) {
    const std::size_t cameras = frame.cameras.size();
    for (std::size_t i = 0; i < cameras; ++i) {
        const Camera camera               = frame.cameras[i];
        const CameraId id                 = {static_cast<std::int32_t>(i)};
        const std::vector<CameraUse> uses = uses_of(frame, id, maps);
        for (std::size_t use = 0; use < uses.size(); ++use) {
            CameraId of_use = id;
            if (use > 0) {
                of_use.index = static_cast<std::int32_t>(frame.cameras.size());
                frame.cameras.push_back(camera);
                frame.cameras.back().name += ' ' + std::to_string(use + 1);
            }
            Mat4& projection = frame.cameras[static_cast<std::size_t>(of_use.index)].projection;
            if (uses[use].map) projection = moved(camera.projection, *uses[use].map);
            for (const std::size_t pass : uses[use].passes) frame.passes[pass].camera = of_use;
        }
    }
}

PixelRect viewport_of(const Frame& frame, const Pass& pass) {
    if (pass.state.viewport != PixelRect{}) return pass.state.viewport;
    const Target& target = frame.targets[static_cast<std::size_t>((pass.color ? pass.color : pass.depth).index)];
    return {0, 0, target.width, target.height};
}

std::string place_of(const Frame& frame, std::size_t pass) {
    return Place("pass", pass, frame.passes[pass].label).text();
}

bool covers(const Frame& frame, const Pass& pass, const PixelRect& area) {
    const auto* draw = pass.draws.size() == 1 ? std::get_if<DrawRectangle>(&pass.draws[0]) : nullptr;
    if (draw == nullptr || uses_depth(pass) || !contains(limit_of(frame, pass), area)) return false;
    return draw->x0 <= static_cast<float>(area.x0) && draw->y0 <= static_cast<float>(area.y0) &&
           draw->x1 >= static_cast<float>(area.x1) && draw->y1 >= static_cast<float>(area.y1);
}

}  // namespace pipeline
