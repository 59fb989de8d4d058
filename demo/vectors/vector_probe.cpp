// SPDX-License-Identifier: MIT
#include "demo/vectors/vector_probe.h"

#include <algorithm>
#include <set>

namespace demo {

using namespace pipeline;

namespace {

constexpr int kRowsPerFrame = kMaxTargetSize;

std::uint8_t channel_of(std::uint32_t argb, char channel) {
    const int shift = channel == 'a' ? 24 : channel == 'r' ? 16 : channel == 'g' ? 8 : 0;
    return static_cast<std::uint8_t>(argb >> shift);
}

// A part of the probe's rows that fits a target, and the frame that draws it.
class FrameBuilder {
  public:
    FrameBuilder(const Prober& prober, const Probe& probe, int rows)
        : prober_(prober), probe_(probe), frame_(probe_frame(probe.format, probe.columns, rows)) {
        frame_.textures.push_back(ramp_texture());
        if (probe.dest_is_ramp) {
            Pass& pass           = add_pass({});
            pass.state.stages[0] = ramp_color_and_alpha();
            add_rectangle(pass, 0, rows, 0xffffffff);
        }
    }

    void add(const PipelineState& state, std::span<const ProbeRow> rows) {
        if (!probe_.dest_is_ramp) add_runs(add_pass({}), rows, &ProbeRow::dest);
        add_runs(add_pass(state), rows, &ProbeRow::source);
        y_ += static_cast<int>(rows.size());
    }

    Frame take() { return std::move(frame_); }

  private:
    Pass& add_pass(const PipelineState& state) {
        Pass& pass = frame_.passes.emplace_back();
        pass.color = {0};
        pass.state = state;
        return pass;
    }

    // Rows of one colour are one rectangle.
    void add_runs(Pass& pass, std::span<const ProbeRow> rows, std::uint32_t ProbeRow::*color) {
        for (std::size_t i = 0; i < rows.size();) {
            std::size_t end = i + 1;
            while (end < rows.size() && rows[end].*color == rows[i].*color) ++end;
            add_rectangle(pass, y_ + static_cast<int>(i), y_ + static_cast<int>(end), rows[i].*color);
            i = end;
        }
    }

    void add_rectangle(Pass& pass, int y0, int y1, std::uint32_t color) {
        DrawRectangle draw = prober_.rectangle(0, y0, probe_.columns, y1, color);
        // The ramp has a row: v does not matter.
        draw.uv[0].u1      = static_cast<float>(probe_.columns) / 256.0f;
        draw.textures[0]   = {.texture = {0}, .target = {}};
        pass.draws.emplace_back(draw);
    }

    const Prober& prober_;
    const Probe& probe_;
    Frame frame_;
    int y_ = 0;
};

}  // namespace

TextureStage ramp_color() {
    return {.color_op = TextureOp::SelectArg1, .alpha_op = TextureOp::SelectArg2};
}
TextureStage ramp_alpha() {
    return {.color_op = TextureOp::SelectArg2, .alpha_op = TextureOp::SelectArg1};
}
TextureStage ramp_color_and_alpha() {
    return {.color_op = TextureOp::SelectArg1, .alpha_op = TextureOp::SelectArg1};
}

Bytes Prober::draw(const Probe& probe, std::string_view channels) {
    std::size_t rows = 0;
    for (const ProbeBand& band : probe.bands) rows += band.rows.size();
    Bytes out;
    out.reserve(rows * static_cast<std::size_t>(probe.columns) * channels.size());
    std::size_t band = 0, first = 0;  // the next row
    while (rows > 0) {
        std::size_t left = std::min<std::size_t>(rows, kRowsPerFrame);
        rows -= left;
        FrameBuilder frame(*this, probe, static_cast<int>(left));
        while (left > 0) {
            const std::span<const ProbeRow> remaining = std::span(probe.bands[band].rows).subspan(first);
            const std::size_t count                   = std::min(left, remaining.size());
            if (count > 0) frame.add(probe.bands[band].state, remaining.first(count));
            left -= count;
            first += count;
            if (first == probe.bands[band].rows.size()) ++band, first = 0;
        }
        const Bytes part = draw(frame.take(), channels);
        out.insert(out.end(), part.begin(), part.end());
    }
    return out;
}

std::vector<int> Prober::levels(TargetFormat format, std::string_view channel) {
    Probe probe{.format = format, .bands = {{.state = {}, .rows = {{}}}}};
    probe.bands[0].state.stages[0] = ramp_color_and_alpha();
    const Bytes bytes              = draw(probe, channel);
    const std::set<int> distinct(bytes.begin(), bytes.end());
    return {distinct.begin(), distinct.end()};
}

Bytes Prober::draw(Frame frame, std::string_view channels) {
    frame.arithmetic = arithmetic_;
    if (observe_) observe_(frame);
    const ColorImage image = executor_.execute(frame).output;
    Bytes out;
    out.reserve(image.pixels.size() * channels.size());
    for (const std::uint32_t pixel : image.pixels)
        for (const char channel : channels) out.push_back(channel_of(pixel, channel));
    return out;
}

DrawRectangle Prober::rectangle(int x0, int y0, int x1, int y1, std::uint32_t color) const {
    DrawRectangle draw;
    draw.x0    = static_cast<float>(x0) + offset();
    draw.y0    = static_cast<float>(y0) + offset();
    draw.x1    = static_cast<float>(x1) + offset();
    draw.y1    = static_cast<float>(y1) + offset();
    draw.color = {color};
    return draw;
}

Frame probe_frame(TargetFormat format, int width, int height) {
    Frame frame;
    frame.output = {0};
    frame.targets.push_back({.name = "out", .format = format, .width = width, .height = height});
    return frame;
}

Texture ramp_texture() {
    Texture ramp{
        .name = "ramp", .format = TextureFormat::A8R8G8B8, .width = 256, .height = 1, .levels = 1, .texels = {}};
    for (int x = 0; x < 256; ++x) ramp.texels.insert(ramp.texels.end(), 4, static_cast<std::uint8_t>(x));
    return ramp;
}

}  // namespace demo
