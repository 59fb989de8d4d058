// SPDX-License-Identifier: MIT
// Reads a GS dump (pipeline/emit/gs_dump.h) by itself and does what it says, with a local memory of 4 MB. It shares no code with
// what writes dumps or draws frames. Stricter than the chip where that shows mistakes: textures and palettes are read from
// memory as it was at the last TEXFLUSH, and what it does not know it refuses.
#pragma once

#include <memory>

#include "tests/support/gs_fill.h"

namespace test_support {

class GsReplay {
  public:
    // Throws std::runtime_error.
    explicit GsReplay(const std::vector<std::uint8_t>& dump);
    ~GsReplay();

    // What circuit 1 reads, 0xAARRGGBB, rows from the top. vsyncs: how many the dump has.
    std::vector<std::uint32_t> shown(int width, int height) const;
    int width_shown() const;
    int height_shown() const;
    int vsyncs() const;

    std::vector<std::uint32_t> pixels(const GsBuffer& buffer, int width, int height) const;

  private:
    std::unique_ptr<struct GsReplayState> state_;
};

}  // namespace test_support
