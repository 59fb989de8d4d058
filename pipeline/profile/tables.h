// SPDX-License-Identifier: MIT
// The chips' tables, one file each.
#pragma once

#include "pipeline/profile/profile.h"

namespace pipeline {

Profile make_ideal();
Profile make_dx7();
Profile make_ps2();
Profile make_gamecube();
Profile make_xbox();

}  // namespace pipeline
