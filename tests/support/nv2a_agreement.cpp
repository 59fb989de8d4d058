// SPDX-License-Identifier: MIT
#include "tests/support/nv2a_agreement.h"

#include "tests/support/nv2a_draws.h"
#include "tests/support/stage_colors.h"

namespace test_support {

using namespace pipeline;

namespace {

class Walk {
  public:
    Walk(const Frame& frame, const Emitted& emitted) : compare_(frame, emitted), emitted_(emitted) {}

    std::vector<std::string> run() {
        list_expected();
        run_nv2a(emitted_.text, [&](const Nv2aEvent& event) { visit(event); });
        if (next_ != expected_.size()) compare_.differ("clears, draws or copies are missing");
        return compare_.differences;
    }

  private:
    // draw -1: the pass's clear.
    struct Expected {
        Nv2aEvent::Kind kind;
        std::size_t pass;
        std::ptrdiff_t draw = -1;
    };

    void list_expected() {
        for (std::size_t i = 0; i < compare_.frame.passes.size(); ++i) {
            const Pass& pass     = compare_.frame.passes[i];
            const PixelRect rect = compare_.part(pass);
            const bool is_empty  = rect.x0 >= rect.x1 || rect.y0 >= rect.y1;
            expected_.push_back({Nv2aEvent::Pass, i});
            if (!is_empty && (pass.clear.color || pass.clear.depth)) expected_.push_back({Nv2aEvent::Clear, i});
            for (std::size_t d = 0; d < pass.draws.size(); ++d) {
                const Draw& draw      = pass.draws[d];
                const auto* triangles = std::get_if<DrawTriangles>(&draw);
                const auto* window    = std::get_if<DrawWindowTriangles>(&draw);
                const bool has_none = (triangles && triangles->index_count < 3) || (window && window->index_count < 3);
                const bool copies   = std::holds_alternative<CopyRectangle>(draw);
                if (copies || (!is_empty && !has_none))
                    expected_.push_back(
                        {copies ? Nv2aEvent::Copy : Nv2aEvent::Draw, i, static_cast<std::ptrdiff_t>(d)});
            }
        }
    }

    void visit(const Nv2aEvent& event) {
        if (next_ == 0 && event.kind == Nv2aEvent::Clear) return check_zeros(event);
        if (next_ == expected_.size() || expected_[next_].kind != event.kind) {
            compare_.differ("an event that the frame has not");
            return;
        }
        const Expected& expected = expected_[next_++];
        const Pass& pass         = compare_.frame.passes[expected.pass];
        compare_.where = "pass " + std::to_string(expected.pass) + " draw " + std::to_string(expected.draw) + ": ";
        if (event.kind == Nv2aEvent::Clear) check_clear(event, pass);
        if (event.kind == Nv2aEvent::Copy)
            check_copy(event, pass, std::get<CopyRectangle>(pass.draws[static_cast<std::size_t>(expected.draw)]));
        if (event.kind == Nv2aEvent::Draw) {
            check_surfaces(event.registers, pass);
            compare_draw(compare_, event, pass, pass.draws[static_cast<std::size_t>(expected.draw)]);
        }
    }

    void check_zeros(const Nv2aEvent& event) {
        compare_.where = "before the passes: ";
        compare_.expect(event.registers.at(0x1d90) == 0 && event.registers.at(0x1d8c) == 0, "not cleared to zero");
    }

    void check_surfaces(const Nv2aRegisters& registers, const Pass& pass) {
        const Target& size         = compare_.frame.targets[index_of(pass.color ? pass.color : pass.depth)];
        const std::uint32_t format = registers.at(0x208);
        compare_.expect(registers.at(0x200) == static_cast<std::uint32_t>(size.width) << 16, "surface clip x");
        compare_.expect(registers.at(0x204) == static_cast<std::uint32_t>(size.height) << 16, "surface clip y");
        compare_.expect((format & ~0xffu) == 0x100, "surface type");
        const auto check = [&](TargetId id, std::uint32_t offset, std::uint32_t pitch, std::uint32_t code) {
            const Target& target        = compare_.frame.targets[index_of(id)];
            const MemoryBlock& block    = compare_.map.blocks[index_of(id)];
            const std::uint32_t codes[] = {8, 4, 3, 0, 0, 0, 0, 0, 1, 2, 0};
            compare_.expect(offset == block.address, "surface offset");
            compare_.expect(compare_.memory.is_surface(block.address, block.bytes), "surface in the table");
            compare_.expect(pitch == block.pitch * static_cast<std::uint64_t>(bytes_per_pixel(target.format)),
                            "surface pitch");
            compare_.expect(code == codes[index_of(target.format)], "surface format");
        };
        if (pass.color) check(pass.color, registers.at(0x210), registers.at(0x20c) & 0xffff, format & 15);
        if (pass.depth) check(pass.depth, registers.at(0x214), registers.at(0x20c) >> 16, format >> 4 & 15);
        compare_.expect(registers.at(0x290) == 0x100000, "CONTROL0");
        compare_.expect(registers.real(0x394) == 0.0f, "CLIP_MIN");
        if (pass.depth) compare_.expect(registers.real(0x398) == compare_.greatest_depth(pass), "CLIP_MAX");
        const PixelRect rect = compare_.part(pass);
        const auto word      = [](std::int32_t from, std::int32_t to) {
            return static_cast<std::uint32_t>(from) | static_cast<std::uint32_t>(to - 1) << 16;
        };
        compare_.expect(registers.at(0x2b4) == 0, "window clip type");
        for (std::uint32_t i = 0; i < 8; ++i) {
            compare_.expect(registers.at(0x2c0 + 4 * i) == word(rect.x0, rect.x1), "window clip x");
            compare_.expect(registers.at(0x2e0 + 4 * i) == word(rect.y0, rect.y1), "window clip y");
        }
    }

    void check_clear(const Nv2aEvent& event, const Pass& pass) {
        check_surfaces(event.registers, pass);
        const PixelRect rect = compare_.part(pass);
        compare_.expect(event.registers.at(0x1d98) ==
                            (static_cast<std::uint32_t>(rect.x0) | static_cast<std::uint32_t>(rect.x1 - 1) << 16),
                        "clear rect x");
        compare_.expect(event.registers.at(0x1d9c) ==
                            (static_cast<std::uint32_t>(rect.y0) | static_cast<std::uint32_t>(rect.y1 - 1) << 16),
                        "clear rect y");
        compare_.expect((event.flags & 0xf0) == (pass.clear.color ? 0xf0u : 0u), "clears colour");
        compare_.expect((event.flags & 1) == (pass.clear.depth ? 1u : 0u), "clears depth");
        if (pass.clear.color) {
            const std::uint32_t value = event.registers.at(0x1d90);
            const RealColor wanted    = real_color(*pass.clear.color);
            if (compare_.frame.targets[index_of(pass.color)].format == TargetFormat::R5G6B5) {
                compare_.near((value >> 11 & 31) / 31.0, wanted[0], 1 / 31.0, "clear red");
                compare_.near((value >> 5 & 63) / 63.0, wanted[1], 1 / 63.0, "clear green");
                compare_.near((value & 31) / 31.0, wanted[2], 1 / 31.0, "clear blue");
            } else {
                compare_.expect(value == pass.clear.color->value, "clear colour");
            }
        }
        if (pass.clear.depth) {
            const bool is_16 = compare_.frame.targets[index_of(pass.depth)].format == TargetFormat::D16;
            compare_.near(is_16 ? event.registers.at(0x1d8c) : event.registers.at(0x1d8c) >> 8,
                          *pass.clear.depth * (is_16 ? 65535.0 : 16777215.0), 1.0, "clear depth");
        }
    }

    void check_copy(const Nv2aEvent& event, const Pass& pass, const CopyRectangle& copy) {
        const Nv2aRegisters& blit = event.blit;
        const auto pair           = [](std::int32_t low, std::int32_t high) {
            return static_cast<std::uint32_t>(low) | static_cast<std::uint32_t>(high) << 16;
        };
        compare_.expect(blit.at(0x308) == pair(copy.from.x1 - copy.from.x0, copy.from.y1 - copy.from.y0), "copy size");
        compare_.expect(blit.at(0x304) == pair(copy.x, copy.y), "copy to");
        compare_.expect(blit.at(0x30c) == compare_.map.blocks[index_of(pass.color)].address, "copy destination");
    }

    Nv2aComparison compare_;
    const Emitted& emitted_;
    std::vector<Expected> expected_;
    std::size_t next_ = 0;
};

}  // namespace

std::vector<std::string> nv2a_differences(const Frame& frame, const Emitted& emitted) {
    return Walk(frame, emitted).run();
}

}  // namespace test_support
