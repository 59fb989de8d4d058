// SPDX-License-Identifier: MIT
#include "pipeline/emit/emit_nv2a.h"

#include <algorithm>
#include <stdexcept>

#include "pipeline/check/target_use.h"
#include "pipeline/emit/nv2a_draw.h"
#include "pipeline/emit/nv2a_pixels.h"
#include "pipeline/validate/findings.h"

namespace pipeline {
namespace {

void require_legal(const LegalFrame& legal) {
    const std::vector<ChipFinding> found = legal.left.empty() ? check(legal.frame, *find_profile("xbox")) : legal.left;
    if (found.empty()) return;
    const ChipFinding& first = found.front();
    throw std::invalid_argument("the frame is not legal on the NV2A: " + first.where + ": uses " + first.uses +
                                "; the chip has " + first.has +
                                (found.size() > 1 ? ", and " + std::to_string(found.size() - 1) + " more" : ""));
}

std::string draw_text(const Draw& draw) {
    if (const auto* triangles = std::get_if<DrawTriangles>(&draw))
        return std::to_string(triangles->index_count / 3) + " triangles";
    if (const auto* triangles = std::get_if<DrawWindowTriangles>(&draw))
        return std::to_string(triangles->index_count / 3) + " triangles in window space";
    const auto& rectangle = std::get<DrawRectangle>(draw);
    return "rectangle from (" + numbers({{rectangle.x0}}) + ", " + numbers({{rectangle.y0}}) + ") to (" +
           numbers({{rectangle.x1}}) + ", " + numbers({{rectangle.y1}}) + ")";
}

class Emitter {
  public:
    explicit Emitter(const Frame& frame) : frame_(frame), memory_(frame) {
        if (has_any<DrawTriangles>() && !frame.vertices.empty())
            arrays_.vertices = memory_.add(vertex_bytes(frame.vertices),
                                           "vertices, " + std::to_string(frame.vertices.size()) + " of 48 bytes");
        if (has_any<DrawWindowTriangles>() && !frame.window_vertices.empty())
            arrays_.window_vertices =
                memory_.add(vertex_bytes(frame.window_vertices),
                            "window vertices, " + std::to_string(frame.window_vertices.size()) + " of 56 bytes");
    }

    void emit() {
        clear_to_zeros(out_, frame_, memory_);
        for (std::size_t i = 0; i < frame_.passes.size(); ++i) emit(i);
        out_.section("end");
        out_.act(nv097::WAIT_FOR_IDLE, 0, "the picture is in " + memory_.of(frame_.output).what);
    }

    Nv2aMemory& memory() { return memory_; }
    std::string take_methods() { return out_.take(); }

  private:
    template <class Kind>
    bool has_any() const {
        return std::any_of(frame_.passes.begin(), frame_.passes.end(), [](const Pass& pass) {
            return std::any_of(pass.draws.begin(), pass.draws.end(),
                               [](const Draw& draw) { return std::holds_alternative<Kind>(draw); });
        });
    }

    void emit(std::size_t index) {
        const Pass& pass       = frame_.passes[index];
        const std::string name = Place("pass", index, pass.label).text();
        out_.section(name);
        out_.forget();
        out_.act(nv097::WAIT_FOR_IDLE, 0, "what was drawn before is in memory");
        const PixelRect part = drawn_part(frame_, pass);
        if (part == PixelRect{}) {
            out_.note("Viewport and scissor have no pixel in common: nothing is cleared or drawn.");
        } else if (draws(pass) || pass.clear != Clear{}) {
            set_surfaces(out_, frame_, memory_, pass.color, pass.depth);
            set_window_clip(out_, part);
            clear(out_, frame_, pass, part);
            emit_draws(pass, name);
        }
        emit_copies(pass);
    }

    void emit_draws(const Pass& pass, const std::string& name) {
        if (!draws(pass)) return;
        set_unused_state(out_);
        set_pixel_state(out_, pass);
        for (std::size_t i = 0; i < pass.draws.size(); ++i) {
            if (is_copy(pass.draws[i])) continue;
            const Nv2aDraw draw{frame_, pass, pass.draws[i], memory_, arrays_, name + ", draw " + std::to_string(i)};
            out_.line("");
            out_.note("draw " + std::to_string(i) + ": " + draw_text(draw.draw));
            set_culling(out_, draw.rectangle() != nullptr ? CullMode::None : pass.state.cull);
            set_textures(out_, draw);
            set_combiners(out_, draw);
            set_transform(out_, draw);
            set_arrays_and_draw(out_, draw);
        }
    }

    void emit_copies(const Pass& pass) {
        for (const Draw& draw : pass.draws) {
            if (!is_copy(draw)) continue;
            out_.line("");
            out_.act(nv097::WAIT_FOR_IDLE, 0, "before the class NV09F copies");
            copy(out_, frame_, memory_, std::get<CopyRectangle>(draw), pass.color);
        }
    }

    const Frame& frame_;
    Nv2aMemory memory_;
    Nv2aVertexArrays arrays_;
    Nv2aStream out_;
};

// What the reader must know before the first line.
constexpr std::string_view kHead[] = {
    "<offset>[*] <name>[<entry>] <value> ... ; <meaning>",
    "Values go to the push buffer for the offset and the words after it, or with * all to that offset (bit 30 of the "
    "packet's header, nxdk's NV2A_SUPPRESS_COMMAND_INCREMENT). Methods whose names begin with NV062 and NV09F go to the "
    "subchannels that hold those classes. Every pass writes all that it needs; draws after the first, what differs.",
    "The program sets up, once: the objects of SET_CONTEXT_DMA_A, _COLOR, _ZETA and _VERTEX_A, and for NV062 "
    "SET_CONTEXT_DMA_IMAGE_SOURCE and _DESTIN, so that they cover the memory below from its address 0 on; their handles are "
    "its own. It loads the blocks `data` of <bytes> from byte <from> of the side file to their addresses, before the first "
    "method.",
    "Not known: how the texture cache is told that a target has changed (methods wait for idle between passes); whether "
    "zeta is untouched where no test and no write is on, as here where a pass has no depth target; the largest number of "
    "indices between BEGIN and END (games are known to send 266506).",
    "A8 reads as (1, 1, 1, a) in the chip, by xemu, and as (0, 0, 0, a) in the frame: combiners read 0 for its colour. A "
    "stage that reads a texture with nothing bound reads 1. Clears of R5G6B5 give 16 bits; whether the chip wants them "
    "twice in the word is not known.",
};

std::string head(const Nv2aMemory& memory, std::string_view data_file) {
    Nv2aStream out;
    out.line("# NVIDIA NV2A (Microsoft Xbox): methods of the class NV097");
    for (const std::string_view text : kHead) {
        out.line("#");
        out.note(text);
    }
    out.section("memory: " + std::to_string(memory.used()) + " bytes; side file: " + std::string(data_file));
    out.line("# surface <address> <bytes> ; <what>");
    out.line("# data <address> <bytes> <from> ; <what>");
    return out.take();
}

}  // namespace

Emitted emit_nv2a(const LegalFrame& legal, std::string_view data_file) {
    require_legal(legal);
    Emitter emitter(legal.frame);
    emitter.emit();
    Emitted emitted;
    emitted.text = head(emitter.memory(), data_file) + emitter.memory().take_table() + emitter.take_methods();
    emitted.data = emitter.memory().take_data();
    return emitted;
}

}  // namespace pipeline
