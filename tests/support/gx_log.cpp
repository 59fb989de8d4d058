// SPDX-License-Identifier: MIT
#include "tests/support/gx_log.h"

#include <bit>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace test_support {

namespace {

namespace fs = std::filesystem;

class Reader {
  public:
    explicit Reader(const std::vector<std::uint8_t>& data) : data_(data) {}

    void line(const std::string& text) {
        std::istringstream words(text);
        std::string name, word;
        words >> name;
        std::vector<double> values;
        while (words >> word) values.push_back(std::strtod(word.c_str(), nullptr));
        call(name, values);
    }
    std::vector<GxEvent> take() { return std::move(events_); }

  private:
    template <std::size_t count, class T>
    static void set(std::array<T, count>& out, const std::vector<double>& values, std::size_t first = 0) {
        if (values.size() < first + count) throw std::runtime_error("too few arguments");
        for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<T>(values[first + i]);
    }

    void call(const std::string& name, const std::vector<double>& v) {
        const auto integer = [&](std::size_t i) { return static_cast<int>(v.at(i)); };
        GxRegisters& r     = registers_;
        if (name == "GX_SetPixelFmt")
            r.pixel_format = integer(0);
        else if (name == "GX_SetColorUpdate")
            r.color_update = integer(0);
        else if (name == "GX_SetAlphaUpdate")
            r.alpha_update = integer(0);
        else if (name == "GX_SetDither")
            r.dither = integer(0);
        else if (name == "GX_SetZCompLoc")
            r.z_before_texture = integer(0);
        else if (name == "GX_SetCullMode")
            r.cull = integer(0);
        else if (name == "GX_SetNumChans")
            r.channels = integer(0);
        else if (name == "GX_SetNumTexGens")
            r.texgens = integer(0);
        else if (name == "GX_SetNumTevStages")
            r.tev_stages = integer(0);
        else if (name == "GX_SetNumIndStages")
            r.indirect_stages = integer(0);
        else if (name == "GX_SetDstAlpha")
            r.dst_alpha = integer(0);
        else if (name == "GX_SetBlendMode")
            set(r.blend, v);
        else if (name == "GX_SetScissor")
            set(r.scissor, v);
        else if (name == "GX_SetZMode")
            set(r.z, v);
        else if (name == "GX_SetAlphaCompare")
            set(r.alpha_compare, v);
        else if (name == "GX_SetViewport")
            set(r.viewport, v, 1);
        else if (name == "GX_LoadProjectionMtx")
            r.projection_type = integer(0), set(r.projection, v, 1);
        else if (name == "GX_LoadPosMtxImm")
            set(r.matrices[integer(0)], v, 1);
        else if (name == "GX_LoadTexMtxImm")
            set(r.matrices[integer(0)], v, 1);
        else if (name == "GX_LoadNrmMtxImm")
            set(r.matrices[1000], v, 1);
        else if (name == "GX_SetChanCtrl")
            channel(v);
        else if (name == "GX_SetChanAmbColor")
            set(r.ambient[integer(0)], v, 1);
        else if (name == "GX_SetChanMatColor")
            set(r.material[integer(0)], v, 1);
        else if (name == "GX_SetTevColor")
            set(r.tev_color[integer(0)], v, 1);
        else if (name == "GX_LoadLightObj")
            light(r.lights[integer(0)], v);
        else if (name == "GX_SetTexCoordGen")
            set(r.texgen[integer(0)], v, 1);
        else if (name == "GX_LoadTexObj")
            texture(r.textures[integer(0)], v);
        else if (name == "GX_SetTevOrder")
            set(r.tev.at(static_cast<std::size_t>(integer(0))).order, v, 1);
        else if (name == "GX_SetTevColorIn")
            set(r.tev.at(static_cast<std::size_t>(integer(0))).color_in, v, 1);
        else if (name == "GX_SetTevAlphaIn")
            set(r.tev.at(static_cast<std::size_t>(integer(0))).alpha_in, v, 1);
        else if (name == "GX_SetTevColorOp")
            set(r.tev.at(static_cast<std::size_t>(integer(0))).color_op, v, 1);
        else if (name == "GX_SetTevAlphaOp")
            set(r.tev.at(static_cast<std::size_t>(integer(0))).alpha_op, v, 1);
        else if (name == "GX_SetFog")
            set(r.fog, v);
        else
            vertex_or_copy(name, v);
    }

    // 0, 1: colour; 2, 3: alpha; 4, 5 both.
    void channel(const std::vector<double>& v) {
        const int which = static_cast<int>(v.at(0));
        if (which != 5) set(registers_.channel[which & 3], v, 1);
        if (which == 4) set(registers_.channel[2], v, 1);
        if (which == 5) set(registers_.channel[1], v, 1), set(registers_.channel[3], v, 1);
    }
    static void light(GxLightRead& light, const std::vector<double>& v) {
        set(light.position, v, 1), set(light.color, v, 4), set(light.a, v, 7), set(light.k, v, 10);
    }
    static void texture(GxTextureRead& t, const std::vector<double>& v) {
        t.address = static_cast<long long>(v.at(1));
        std::array<int, 10> of{};
        set(of, v, 2);
        t.width = of[0], t.height = of[1], t.format = of[2], t.wrap_s = of[3], t.wrap_t = of[4], t.mipmap = of[5];
        t.min_filter = of[6], t.mag_filter = of[7], t.min_lod = of[8], t.max_lod = of[9];
    }

    void vertex_or_copy(const std::string& name, const std::vector<double>& v) {
        const auto integer = [&](std::size_t i) { return static_cast<int>(v.at(i)); };
        if (name == "GX_ClearVtxDesc")
            types_.clear();
        else if (name == "GX_SetVtxDesc")
            types_[integer(0)] = integer(1);
        else if (name == "GX_SetArray")
            arrays_[integer(0)] = {static_cast<long long>(v.at(1)), integer(2)};
        else if (name == "GX_Begin")
            begin(integer(0), integer(2));
        else if (name == "GX_End")
            end();
        else if (name == "GX_Position3f32")
            attribute(9, 1), vertices_.emplace_back(), set(vertices_.back().position, v, 1);
        else if (name == "GX_Position1x16")
            attribute(9, 3), vertices_.emplace_back(), floats(9, integer(0), vertices_.back().position);
        else if (name == "GX_Normal1x16")
            attribute(10, 3), floats(10, integer(0), vertices_.back().normal);
        else if (name == "GX_Color1u32")
            attribute(11, 1), color_word(static_cast<std::uint32_t>(v.at(0)));
        else if (name == "GX_Color1x16")
            color(integer(0));
        else if (name == "GX_TexCoord2f32")
            set(vertices_.back().tex.at(next_tex(1)), v, 1);
        else if (name == "GX_TexCoord1x16")
            tex(integer(0));
        else if (name == "GX_SetTexCopySrc")
            set(copy_.copy_from, v);
        else if (name == "GX_SetTexCopyDst")
            set(copy_.copy_to, v);
        else if (name == "GX_CopyTex")
            copy(v);
        else if (name == "GX_PixModeSync")
            is_waited_ = true;
        else if (name == "GX_InvalidateTexAll")
            is_synced_ = is_waited_;
        else if (name == "GX_SetDispCopySrc")
            set(display_.copy_from, v);
        else if (name == "GX_CopyDisp")
            display_.kind = GxEvent::Kind::Display, display_.registers = registers_, events_.push_back(display_);
    }

    void begin(int primitive, int count) {
        primitive_ = primitive, count_ = count;
        vertices_.clear();
        next_ = 9;
    }
    void end() {
        if (static_cast<int>(vertices_.size()) != count_) throw std::runtime_error("GX_Begin says another count");
        GxEvent event;
        event.registers = registers_, event.primitive = primitive_, event.vertices = vertices_,
        event.is_synced = is_synced_;
        events_.push_back(event);
    }
    // Attributes must come in their order, as the description of vertices says.
    void attribute(int which, int type) {
        if (which == 9) next_ = 9;
        while (next_ < which)
            if (types_[next_++] != 0) throw std::runtime_error("an attribute is missing");
        if (types_[which] != type) throw std::runtime_error("an attribute has another type");
        next_ = which + 1;
    }
    template <std::size_t count>
    void floats(int which, int index, std::array<double, count>& out) const {
        const auto& [address, stride] = arrays_.at(which);
        for (std::size_t i = 0; i < count; ++i) {
            const auto at      = static_cast<std::size_t>(address) + static_cast<std::size_t>(index * stride) + 4 * i;
            std::uint32_t bits = 0;
            for (std::size_t byte = 0; byte < 4; ++byte) bits = bits << 8 | data_.at(at + byte);
            out[i] = static_cast<double>(std::bit_cast<float>(bits));
        }
    }
    void color(int index) {
        const int which = next_ <= 11 ? 11 : 12;
        attribute(which, 3);
        const auto& [address, stride] = arrays_.at(which);
        std::array<int, 4>& out       = which == 11 ? vertices_.back().color0 : vertices_.back().color1;
        for (std::size_t i = 0; i < 4; ++i) out[i] = data_.at(static_cast<std::size_t>(address + index * stride) + i);
    }
    void color_word(std::uint32_t rgba) {
        for (std::size_t i = 0; i < 4; ++i) vertices_.back().color0[i] = static_cast<int>(rgba >> (24 - 8 * i) & 0xffu);
    }
    std::size_t next_tex(int type) {
        const int which = next_ <= 13 ? 13 : 14;
        attribute(which, type);
        return static_cast<std::size_t>(which - 13);
    }
    void tex(int index) {
        const std::size_t which = next_tex(3);
        floats(13 + static_cast<int>(which), index, vertices_.back().tex.at(which));
    }
    void copy(const std::vector<double>& v) {
        copy_.kind = GxEvent::Kind::Copy, copy_.registers = registers_, copy_.address = static_cast<long long>(v.at(0));
        if (v.at(1) != 0.0) throw std::runtime_error("the copy clears");
        events_.push_back(copy_);
        is_waited_ = is_synced_ = false;
    }

    const std::vector<std::uint8_t>& data_;
    GxRegisters registers_;
    std::map<int, int> types_;
    std::map<int, std::pair<long long, int>> arrays_;
    std::vector<GxVertexRead> vertices_;
    GxEvent copy_, display_;
    int primitive_ = 0, count_ = 0, next_ = 9;
    bool is_waited_ = false, is_synced_ = false;
    std::vector<GxEvent> events_;
};

void write_file(const fs::path& path, std::string_view bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string read_file(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

// A folder of its own for each run, removed at the end.
struct Folder {
    fs::path path;
    Folder() {
        std::string name = (fs::temp_directory_path() / "nimbus7_gx_XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
        path = name;
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
};

}  // namespace

std::vector<GxEvent> run_gx(const std::string& text, const std::vector<std::uint8_t>& data) {
    const Folder folder;
    write_file(folder.path / "frame.c", text);
    write_file(folder.path / "frame.bin", {reinterpret_cast<const char*>(data.data()), data.size()});
    write_file(folder.path / "gccore.h", "#include \"" NIMBUS7_SOURCE_DIR "/tests/support/gx_stub.h\"\n");
    const std::string at = "cd '" + folder.path.string() + "' && ";
    const std::string compile =
        at + "cc -std=gnu11 -Wall -Wextra -Werror -I. frame.c -o frame > errors 2>&1 && ./frame > log 2>> errors";
    if (std::system(compile.c_str()) != 0) throw std::runtime_error(read_file(folder.path / "errors"));
    Reader reader(data);
    std::ifstream log(folder.path / "log");
    for (std::string line; std::getline(log, line);) reader.line(line);
    return reader.take();
}

}  // namespace test_support
