// SPDX-License-Identifier: MIT
// Random pipeline state, valid for a pass with the given targets. Enumerators come from EnumNames, fields from
// visit_fields: a new one takes part by itself.
#pragma once

#include <optional>

#include "pipeline/frame/frame.h"
#include "tests/support/random.h"

namespace test_support {

// Near the identity; sometimes mirrored, projective or singular.
pipeline::Mat4 random_matrix(Random& random);

pipeline::Arithmetic random_arithmetic(Random& random);

pipeline::PipelineState random_state(const pipeline::Arithmetic& arithmetic, Random& random, int width, int height,
                                     std::optional<pipeline::TargetFormat> color, bool has_depth);

}  // namespace test_support
