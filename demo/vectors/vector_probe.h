// SPDX-License-Identifier: MIT
// Frames that try a rule on many inputs at once. A probe is a picture of rows: first each row's `dest` is written to
// it, then its `source` is drawn over that with the band's state. Column x of a texture that the source's stage 0 can
// read holds the byte x in every channel, so a row is a rule with one input running over all bytes.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "demo/vectors/vector_tables.h"
#include "pipeline/execute/execute.h"

namespace demo {

// 0xAARRGGBB. `source` is the DIFFUSE of the row.
struct ProbeRow {
    std::uint32_t dest = 0, source = 0xffffffff;
    bool operator==(const ProbeRow&) const = default;
};
struct ProbeBand {
    pipeline::PipelineState state;
    std::vector<ProbeRow> rows;
};
struct Probe {
    pipeline::TargetFormat format = pipeline::TargetFormat::A8R8G8B8;
    int columns                   = 256;
    bool dest_is_ramp             = false;  // the column's byte in place of each row's dest
    std::vector<ProbeBand> bands;
};

constexpr std::uint32_t grey(std::uint32_t byte) {
    return byte * 0x010101u;
}
constexpr std::uint32_t with_alpha(std::uint32_t rgb, std::uint32_t alpha) {
    return alpha << 24 | rgb;
}
constexpr std::uint32_t all_channels(std::uint32_t byte) {
    return byte * 0x01010101u;
}

// What a state's stage 0 reads from the texture; the rest is DIFFUSE's.
pipeline::TextureStage ramp_color();
pipeline::TextureStage ramp_alpha();
pipeline::TextureStage ramp_color_and_alpha();

// Draws with one arithmetic. observe: is shown each frame before it is drawn.
class Prober {
  public:
    using Observer = std::function<void(const pipeline::Frame&)>;
    explicit Prober(const pipeline::Arithmetic& arithmetic, Observer observe = {})
        : arithmetic_(arithmetic), observe_(std::move(observe)) {}

    // Of every pixel, row by row, the channels named: "r", "a", "rgba".
    Bytes draw(const Probe& probe, std::string_view channels);

    // The bytes that a channel ("r") of the format can hold, in order.
    std::vector<int> levels(pipeline::TargetFormat format, std::string_view channel);

    // The output of a frame to which the arithmetic has been given.
    Bytes draw(pipeline::Frame frame, std::string_view channels);

    // A rectangle over these pixels, whose uv 0..1 spans them exactly: the arithmetic's pixel centre is allowed for.
    pipeline::DrawRectangle rectangle(int x0, int y0, int x1, int y1, std::uint32_t color = 0xffffffff) const;
    // How far from the pixels' edges geometry must lie for that, in pixels.
    float offset() const { return static_cast<float>(arithmetic_.pixel_center - 8) / 16.0f; }

    const pipeline::Arithmetic& arithmetic() const { return arithmetic_; }
    // Another one, shown to the same observer.
    Prober with(const pipeline::Arithmetic& arithmetic) const { return Prober(arithmetic, observe_); }

  private:
    pipeline::Arithmetic arithmetic_;
    Observer observe_;
    pipeline::Executor executor_;
};

// A frame with one colour target, which is the output.
pipeline::Frame probe_frame(pipeline::TargetFormat format, int width, int height);
// The texture of 256 columns, to be texture 0.
pipeline::Texture ramp_texture();

}  // namespace demo
