// SPDX-License-Identifier: MIT
// The render states and texture stage states of Direct3D 7 that a pass of the frame asks for. What has no effect keeps its
// default: the factors of a blend that is off, the colour of a fog that is off.
#pragma once

#include <string>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline::dx7 {

// What is drawn, where a state depends on it: rectangles are not culled or fogged, and they and window triangles bring
// their texture coordinates and fog with them.
enum class Geometry { Triangles, WindowTriangles, Rectangles };

// name: the arguments of the call but for the value, "D3DRENDERSTATE_ZFUNC" or "0, D3DTSS_COLOROP".
struct State {
    std::string name, value;
    bool operator==(const State&) const = default;
};

// All states that a frame can ask for, always in one order.
std::vector<State> states_of(const Pass& pass, Geometry geometry);

// Where a pass starts from: the states of a pass that is left at its defaults, and others that no frame changes but that
// must not be on.
std::vector<State> reset_states();

std::string set_state(const State& state);  // TRY(device->SetRenderState(D3DRENDERSTATE_ZFUNC, D3DCMP_LESS));

// Does the alpha of a fragment or a colour read D3DTA_SPECULAR's alpha?
bool reads_specular_alpha(const PipelineState& state);

}  // namespace pipeline::dx7
