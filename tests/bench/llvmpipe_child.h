// SPDX-License-Identifier: MIT
// Mesa's llvmpipe draws in a child process: it reads how many threads it has from its environment, once, and its
// memory is not ours to count. The child builds the frame by its name, hands all that does not change to OpenGL,
// draws until the shaders are compiled and says "ready"; then it draws once for each line it is sent, and answers
// with the wall time of that drawing, up to glFinish.
#pragma once

#include <string>

#include "tests/bench/child.h"

namespace bench {

class LlvmpipeChild {
  public:
    // Without a name it only tells who it is. Throws std::runtime_error with the reason if there is no llvmpipe.
    LlvmpipeChild(const std::string& frame_case, int threads);

    double draw();  // seconds
    const std::string& description() const { return description_; }

  private:
    Child child_;
    std::string description_;
};

// The child's side, until its standard input ends.
inline constexpr const char* kLlvmpipeArgument = "--llvmpipe";
int serve_llvmpipe(const std::string& frame_case, int threads);

}  // namespace bench
