// SPDX-License-Identifier: MIT
// Many pictures on one: a grid of cells, each with a label above its picture, scaled to the cell in integers only
// (averages when smaller, whole repeats when larger). Pixels are opaque 0xffRRGGBB; an alpha of a picture that is
// added is dropped.
#pragma once

#include <string>
#include <vector>

#include "pipeline/execute/execute.h"

namespace demo {

class ContactSheet {
  public:
    // A cell of two pictures, in order: a pass's colour and alpha, or two moments of a scene. Both may be empty (a pass
    // that draws depth alone).
    void add(const std::string& label, const pipeline::ColorImage& left, const pipeline::ColorImage& right);

    // At most kMaxCells cells; a last line tells how many are left out.
    pipeline::ColorImage draw() const;

    static constexpr std::size_t kMaxCells = 400;

  private:
    struct Cell {
        std::string label;
        pipeline::ColorImage left, right;  // already scaled
    };
    std::vector<Cell> cells_;
    std::size_t left_out_ = 0;
};

}  // namespace demo
