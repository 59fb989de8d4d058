// SPDX-License-Identifier: MIT
#include "pipeline/emit/dx7_data.h"

#include <bit>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <unordered_map>

#include "pipeline/emit/dx7_states.h"
#include "pipeline/emit/dx7_text.h"
#include "pipeline/validate/check_pass.h"

namespace pipeline::dx7 {

namespace {

constexpr std::size_t kAlignment = 16;

// Which vertices a draw needs. q_of: the pair of coordinates whose q is divided by, -1 for none.
struct MeshKey {
    bool is_window = false, opaque_specular = false;
    int q_of                  = -1;
    std::uint32_t first_index = 0, index_count = 0;
    auto operator<=>(const MeshKey&) const = default;
};

// The fog of a vertex and its own second alpha share D3DTA_SPECULAR's; a stage that reads it gets one, as in the frame,
// unless lights need the alpha that is there.
bool has_opaque_specular(const PipelineState& state) {
    const bool is_source = state.lighting.enabled && state.lighting.diffuse_source == ColorSource::Color2;
    return reads_specular_alpha(state) && !is_source;
}

class Writer {
  public:
    explicit Writer(const Frame& frame) : frame_(frame) {}

    Data take() {
        for (const Texture& texture : frame_.textures) {
            out_.textures.push_back(start());
            out_.bytes.insert(out_.bytes.end(), texture.texels.begin(), texture.texels.end());
        }
        for (std::size_t pass = 0; pass < frame_.passes.size(); ++pass) {
            out_.draws.emplace_back();
            for (const Draw& draw : frame_.passes[pass].draws) {
                const auto key = key_of(pass, draw);
                out_.draws.back().push_back(key ? meshes_of(*key, pass) : MeshRange{});
            }
        }
        return std::move(out_);
    }

  private:
    static std::optional<MeshKey> key_of(const PipelineState& state, const Draw& draw) {
        MeshKey key{.opaque_specular = has_opaque_specular(state)};
        if (const auto* triangles = std::get_if<DrawTriangles>(&draw)) {
            key.first_index = triangles->first_index;
            key.index_count = triangles->index_count;
            return key;
        }
        const auto* window = std::get_if<DrawWindowTriangles>(&draw);
        if (window == nullptr) return std::nullopt;
        key.is_window   = true;
        key.first_index = window->first_index;
        key.index_count = window->index_count;
        for (int stage = kTextureStages - 1; stage >= 0; --stage)
            if (reads_texture(state, stage)) key.q_of = stage;
        return key;
    }
    std::optional<MeshKey> key_of(std::size_t pass, const Draw& draw) const {
        return key_of(frame_.passes[pass].state, draw);
    }

    MeshRange meshes_of(const MeshKey& key, std::size_t pass) {
        check_window(key, pass);
        const auto found = meshes_.find(key);
        if (found != meshes_.end()) return found->second;
        const std::size_t before = out_.meshes.size();
        const std::uint32_t end  = key.first_index + key.index_count;
        for (std::uint32_t first = key.first_index; first < end;) first = add_mesh(key, first, end);
        return meshes_[key] = {before, out_.meshes.size() - before};
    }

    // One q serves both stages: rhw times q, and the coordinates over it.
    void check_window(const MeshKey& key, std::size_t pass) const {
        if (!key.is_window || key.q_of < 0) return;
        const bool both = reads_texture(frame_.passes[pass].state, 0) && reads_texture(frame_.passes[pass].state, 1);
        for (std::uint32_t i = key.first_index; i < key.first_index + key.index_count; ++i) {
            const WindowVertex& vertex = frame_.window_vertices[frame_.indices[i]];
            const float q              = q_of(key, vertex);
            if ((!both || vertex.uv0.z == vertex.uv1.z) && q > 0.0f) continue;
            throw std::invalid_argument("pass " + std::to_string(pass) + ' ' + quoted(frame_.passes[pass].label) +
                                        ": window vertex " + std::to_string(frame_.indices[i]) +
                                        " has coordinates whose q is not above 0, or differs between the stages");
        }
    }

    static float q_of(const MeshKey& key, const WindowVertex& vertex) {
        return key.q_of < 0 ? 1.0f : key.q_of == 0 ? vertex.uv0.z : vertex.uv1.z;
    }

    // Vertices in the order of their first use. Returns where the next mesh starts.
    std::uint32_t add_mesh(const MeshKey& key, std::uint32_t first, std::uint32_t end) {
        std::unordered_map<std::uint32_t, std::uint16_t> places;
        std::vector<std::uint32_t> used;
        std::vector<std::uint16_t> indices;
        std::uint32_t i = first;
        for (; i < end && used.size() + 3 <= kMaxMeshVertices && indices.size() < 3 * kMaxMeshTriangles; i += 3)
            for (std::uint32_t corner = i; corner < i + 3; ++corner) {
                const auto [place, is_new] =
                    places.try_emplace(frame_.indices[corner], static_cast<std::uint16_t>(used.size()));
                if (is_new) used.push_back(frame_.indices[corner]);
                indices.push_back(place->second);
            }
        Mesh mesh{.is_window = key.is_window, .first_index = first};
        mesh.vertices     = start();
        mesh.vertex_count = used.size();
        for (const std::uint32_t vertex : used) {
            if (key.is_window)
                put(key, frame_.window_vertices[vertex]);
            else
                put(key, frame_.vertices[vertex]);
        }
        mesh.indices     = start();
        mesh.index_count = indices.size();
        for (const std::uint16_t index : indices) put_bytes(index, 2);
        out_.meshes.push_back(mesh);
        return i;
    }

    void put(const MeshKey& key, const Vertex& vertex) {
        for (int axis = 0; axis < 3; ++axis) put(vertex.position[axis]);
        for (int axis = 0; axis < 3; ++axis) put(vertex.normal[axis]);
        put_colors(key, vertex.diffuse, vertex.specular);
        for (const Vec2& uv : {vertex.uv0, vertex.uv1}) put(uv.x), put(uv.y);
    }
    void put(const MeshKey& key, const WindowVertex& vertex) {
        const float q = q_of(key, vertex);
        put(vertex.x), put(vertex.y), put(vertex.z), put(vertex.rhw * q);
        put_colors(key, vertex.diffuse, vertex.specular);
        for (const Vec3& uv : {vertex.uv0, vertex.uv1}) put(uv.x / q), put(uv.y / q);
    }
    void put_colors(const MeshKey& key, Argb diffuse, Argb specular) {
        put_bytes(diffuse.value, 4);
        put_bytes(specular.value | (key.opaque_specular && !key.is_window ? 0xff000000u : 0u), 4);
    }
    void put(float value) { put_bytes(std::bit_cast<std::uint32_t>(value), 4); }
    void put_bytes(std::uint32_t value, int count) {
        for (int i = 0; i < count; ++i) out_.bytes.push_back(static_cast<std::uint8_t>(value >> 8 * i));
    }

    std::size_t start() {
        out_.bytes.resize((out_.bytes.size() + kAlignment - 1) / kAlignment * kAlignment);
        return out_.bytes.size();
    }

    const Frame& frame_;
    Data out_;
    std::map<MeshKey, MeshRange> meshes_;
};

}  // namespace

Data make_data(const Frame& frame) {
    return Writer(frame).take();
}

}  // namespace pipeline::dx7
