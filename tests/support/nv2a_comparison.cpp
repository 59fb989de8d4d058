// SPDX-License-Identifier: MIT
#include "tests/support/nv2a_comparison.h"

#include <algorithm>

#include "pipeline/profile/profile.h"

namespace test_support {

using namespace pipeline;

Nv2aComparison::Nv2aComparison(const Frame& of, const Emitted& emitted)
    : frame(of), memory(emitted), map(lay_out(of, *find_profile("xbox"))) {}

PixelRect Nv2aComparison::viewport(const Pass& pass) const {
    if (pass.state.viewport != PixelRect{}) return pass.state.viewport;
    const Target& target = frame.targets[index_of(pass.color ? pass.color : pass.depth)];
    return {0, 0, target.width, target.height};
}

PixelRect Nv2aComparison::part(const Pass& pass) const {
    PixelRect rect     = viewport(pass);
    const PixelRect& s = pass.state.scissor;
    if (s != PixelRect{})
        rect = {std::max(rect.x0, s.x0), std::max(rect.y0, s.y0), std::min(rect.x1, s.x1), std::min(rect.y1, s.y1)};
    return rect;
}

float Nv2aComparison::greatest_depth(const Pass& pass) const {
    return pass.depth && frame.targets[index_of(pass.depth)].format == TargetFormat::D16 ? 65535.0f : 16777215.0f;
}

}  // namespace test_support
