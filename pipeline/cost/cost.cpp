// SPDX-License-Identifier: MIT
#include "pipeline/cost/cost.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "pipeline/cost/fill_cost.h"
#include "pipeline/cost/pass_work.h"

namespace pipeline {

namespace {

constexpr double kMega = 1e6, kGiga = 1e9, kMsPerSecond = 1e3;
constexpr double kRegisterBytes = 16.0;  // a register in a packet to the Graphics Synthesizer, PACKED

// What a texture gives in one pass.
struct Fetched {
    TextureBinding binding;
    Range bytes;
};

std::vector<Fetched> fetched_textures(const PassWork& work) {
    std::vector<Fetched> all;
    for (const DrawWork& draw : work.draws)
        for (const TextureRead& read : draw.textures) {
            const Range bytes = read.fresh * (draw.fragments * read.bytes * work.texel_scale);
            const auto found =
                std::find_if(all.begin(), all.end(), [&](const Fetched& one) { return one.binding == read.binding; });
            if (found == all.end())
                all.push_back({read.binding, bytes});
            else
                found->bytes += bytes;
        }
    return all;
}

class CostModel {
  public:
    CostModel(const Frame& frame, const ChipRates& rates) : frame_(frame), rates_(rates) {}

    FrameCost run(const std::vector<PassCounts>& counts) {
        for (std::size_t i = 0; i < counts.size(); ++i) {
            cost_.passes.push_back(cost_of(frame_.passes[i], counts[i]));
            cost_.total += cost_.passes.back();
        }
        cost_.verdict = verdict_of(cost_.total.ms);
        return std::move(cost_);
    }

  private:
    PassCost cost_of(const Pass& pass, const PassCounts& counts) {
        const PassWork work = pass_work(frame_, pass, counts);
        PassCost cost;
        cost.pixels = static_cast<double>(counts.covered + counts.cleared) + work.copied;
        cost.texels = static_cast<double>(counts.texels);
        cost.bytes  = static_cast<double>(counts.bytes);
        set_fill(work, pass.state, cost);
        set_memory(work, cost);
        set_geometry(work, counts, cost);
        set_upload(work, cost);
        ms(cost, CostUnit::Copy) = time(exactly(work.copied), rates_.copies, kMega);
        cost.ms                  = together(cost);
        return cost;
    }

    void set_fill(const PassWork& work, const PipelineState& state, PassCost& cost) {
        ms(cost, CostUnit::Fill) = time(fill_clocks(work, state, rates_), rates_.clock, kMega);
        if (state.fog.mode != FogMode::None && has_triangles(work)) need(rates_.fogged_pixels);
        if (!rates_.page_breaks) return;
        const PageBreakCost breaks     = page_break_cost(work, *rates_.page_breaks);
        cost.page_breaks               = breaks.count;
        ms(cost, CostUnit::PageBreaks) = time(breaks.clocks, rates_.clock, kMega);
    }

    void set_memory(const PassWork& work, PassCost& cost) {
        const Range fetched = fetched_bytes(work);
        Range frame         = exactly(work.frame_bytes), main;
        switch (rates_.memory) {
            case MemoryKind::Separate:
                frame += exactly(work.copied_bytes);
                break;
            case MemoryKind::Embedded:
                main = fetched + exactly(work.copied_bytes);
                break;
            case MemoryKind::Shared:
                main = frame + fetched + exactly(work.copied_bytes);
                break;
        }
        ms(cost, CostUnit::FrameMemory)   = time(frame, rates_.frame_bandwidth, kGiga);
        ms(cost, CostUnit::TextureMemory) = time(fetched, rates_.texture_bandwidth, kGiga);
        ms(cost, CostUnit::MainMemory)    = time(main, rates_.memory_bandwidth, kGiga);
    }

    Range fetched_bytes(const PassWork& work) const {
        Range sum;
        double once = 0.0;
        for (const Fetched& texture : fetched_textures(work)) {
            const double all = bytes_of(frame_, texture.binding);
            sum += {std::min(texture.bytes.least, all), texture.bytes.most};
            once += std::min(texture.bytes.most, all);
        }
        if (once <= rates_.texture_cache.low) sum.most = std::max(sum.least, once);
        return sum;
    }

    void set_geometry(const PassWork& work, const PassCounts& counts, PassCost& cost) {
        const auto triangles      = static_cast<double>(counts.triangles_drawn),
                   rectangles     = static_cast<double>(counts.rectangles);
        ms(cost, CostUnit::Setup) = time(exactly(triangles + rectangles), rates_.setup, kMega);
        const auto vertices       = static_cast<double>(counts.vertices);
        const Range shaded{vertices, std::max(vertices, 3.0 * static_cast<double>(counts.triangles_in))};
        ms(cost, CostUnit::Vertices) = time(shaded, rates_.vertices, kMega);
        if (!rates_.uploads_vertices) return;
        const bool is_textured = std::any_of(work.draws.begin(), work.draws.end(),
                                             [](const DrawWork& draw) { return !draw.textures.empty(); });
        const double of_vertex = (is_textured ? 3.0 : 2.0) * kRegisterBytes;
        const double of_sprite = (is_textured ? 5.0 : 3.0) * kRegisterBytes;
        const Range bytes      = Range{triangles, 3.0 * triangles} * of_vertex + exactly(rectangles * of_sprite);
        ms(cost, CostUnit::VertexUpload) = time(bytes, rates_.upload, kGiga);
    }

    // Targets are made on the chip.
    void set_upload(const PassWork& work, PassCost& cost) {
        for (const DrawWork& draw : work.draws) {
            if (draw.fragments <= 0.0) continue;
            for (const TextureRead& read : draw.textures) {
                if (!read.binding.texture || is_uploaded(read.binding.texture)) continue;
                uploaded_.push_back(read.binding.texture);
                cost.uploaded_bytes += {0.0, bytes_of(frame_, read.binding)};
            }
        }
        ms(cost, CostUnit::Upload) = time(cost.uploaded_bytes, rates_.upload, kGiga);
    }

    bool is_uploaded(TextureId id) const {
        return std::find(uploaded_.begin(), uploaded_.end(), id) != uploaded_.end();
    }

    static bool has_triangles(const PassWork& work) {
        return std::any_of(work.draws.begin(), work.draws.end(),
                           [](const DrawWork& draw) { return !draw.is_rectangle && draw.fragments > 0.0; });
    }

    static Range& ms(PassCost& cost, CostUnit unit) { return cost.unit_ms[static_cast<std::size_t>(unit)]; }

    // Milliseconds of an amount at a rate of `scale` a second.
    Range time(const Range& amount, const Rate& rate, double scale) {
        if (amount.most > 0.0) need(rate);
        return divided(amount, rate) * (kMsPerSecond / scale);
    }

    void need(const Rate& rate) {
        if (is_known(rate)) return;
        const auto same = [&](const Evidence& one) { return one.topic == rate.evidence.topic; };
        if (std::none_of(cost_.unknown.begin(), cost_.unknown.end(), same)) cost_.unknown.push_back(rate.evidence);
    }

    static Range together(const PassCost& cost) {
        Range longest = cost.of(CostUnit::Fill) + cost.of(CostUnit::PageBreaks);
        for (const CostUnit unit : {CostUnit::FrameMemory, CostUnit::TextureMemory, CostUnit::MainMemory,
                                    CostUnit::Copy, CostUnit::Setup, CostUnit::Vertices, CostUnit::VertexUpload})
            longest = slower(longest, cost.of(unit));
        const Range& upload = cost.of(CostUnit::Upload);
        return {std::max(longest.least, upload.least), longest.most + upload.most};
    }

    const Frame& frame_;
    const ChipRates& rates_;
    FrameCost cost_;
    std::vector<TextureId> uploaded_;
};

}  // namespace

PassCost& PassCost::operator+=(const PassCost& more) {
    pixels += more.pixels;
    texels += more.texels;
    bytes += more.bytes;
    page_breaks += more.page_breaks;
    uploaded_bytes += more.uploaded_bytes;
    for (std::size_t i = 0; i < kCostUnits; ++i) unit_ms[i] += more.unit_ms[i];
    ms += more.ms;
    return *this;
}

Verdict verdict_of(const Range& ms) {
    if (ms.most <= kFrameBudgetMs) return Verdict::Fits;
    return ms.least > kFrameBudgetMs ? Verdict::TooLong : Verdict::Depends;
}

CostUnit slowest_unit(const PassCost& cost) {
    CostUnit slowest = CostUnit::Fill;
    double most      = cost.of(CostUnit::Fill).most + cost.of(CostUnit::PageBreaks).most;
    for (std::size_t i = 0; i < kCostUnits; ++i) {
        const auto unit = static_cast<CostUnit>(i);
        if (unit == CostUnit::Upload || unit == CostUnit::Fill || cost.unit_ms[i].most <= most) continue;
        if (unit == CostUnit::PageBreaks) continue;
        slowest = unit;
        most    = cost.unit_ms[i].most;
    }
    return slowest;
}

FrameCost cost(const Frame& frame, const std::vector<PassCounts>& counts, const ChipRates& rates) {
    if (counts.size() != frame.passes.size())
        throw std::invalid_argument("counts of " + std::to_string(counts.size()) + " passes for a frame of " +
                                    std::to_string(frame.passes.size()));
    return CostModel(frame, rates).run(counts);
}

}  // namespace pipeline
