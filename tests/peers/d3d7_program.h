// SPDX-License-Identifier: MIT
// The Direct3D 7 program of a frame (pipeline/emit/emit_dx7.h), built with MinGW-w64 and run under Wine, in a scratch
// directory and without a screen. Wine draws by OpenGL, here Mesa's on the processor.
#pragma once

#include <string>
#include <vector>

#include "pipeline/execute/execute.h"
#include "pipeline/legalize/legalize.h"
#include "tests/support/child_process.h"

namespace peers {

// What is looked for in PATH and not there; empty if all is.
std::vector<std::string> missing_d3d7_tools();

class D3d7Runner {
  public:
    // Wine's own files go to WINEPREFIX, if that is set, or else into the scratch directory.
    D3d7Runner();
    ~D3d7Runner();
    D3d7Runner(const D3d7Runner&)            = delete;
    D3d7Runner& operator=(const D3d7Runner&) = delete;

    // Does Wine start here at all? A container may forbid what it needs.
    bool can_run() const;

    // What each pass leaves in its colour target; an empty image for those without one. Throws std::runtime_error with
    // what the compiler or the program said.
    std::vector<pipeline::ColorImage> run(const pipeline::LegalFrame& legal);

  private:
    // A program from PATH, in the scratch directory.
    tests::Ended call(const std::vector<std::string>& words) const;

    tests::ScratchDirectory scratch_;
    std::string prefix_;
    bool owns_prefix_ = false;
};

}  // namespace peers
