// SPDX-License-Identifier: MIT
// A glTF file, any bytes, as particles and as a mesh: what they promise, or one line that begins with the place where the
// file is named.
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>

#include "demo/gltf_mesh.h"
#include "demo/gltf_particles.h"
#include "tests/fuzz/fuzz.h"

namespace {

// The readers take paths.
demo::FileReference in_memory(const std::uint8_t* data, std::size_t size) {
    static const int file = memfd_create("gltf", MFD_CLOEXEC);
    fuzz::require(file >= 0 && ftruncate(file, 0) == 0 && pwrite(file, data, size, 0) == static_cast<ssize_t>(size),
                  "no file in memory");
    return {.path = "/proc/self/fd/" + std::to_string(file), .named_at = "a.toml:1:1: mesh.file"};
}

template <class Read>
void complain_or(Read&& read) {
    try {
        read();
    } catch (const demo::SceneError& error) {
        fuzz::require_complaint(error.what());
        fuzz::require(std::string_view(error.what()).starts_with("a.toml:1:1: mesh.file: "), error.what());
    }
}

bool is_in_world(const demo::Vec3& at) {
    return std::abs(at.x) <= 1e5f && std::abs(at.y) <= 1e5f && std::abs(at.z) <= 1e5f;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const demo::FileReference file = in_memory(data, size);
    complain_or([&] {
        const demo::ParticleFile particles(file);
        fuzz::require(std::isfinite(particles.duration()) && particles.duration() >= 0.0, "the duration is no number");
        for (const double seconds : {0.0, particles.duration() / 3.0, particles.duration() + 1.0}) {
            const std::vector<cloud::Particle> all = particles.at(seconds);
            fuzz::require(all.size() <= demo::kMaxParticlesPerCloud, "too many particles");
            for (const cloud::Particle& particle : all)
                fuzz::require(is_in_world(particle.center), "a particle is lost");
        }
    });
    complain_or([&] {
        const demo::GltfMesh mesh = demo::read_gltf_mesh(file);
        fuzz::require(!mesh.parts.empty(), "no part and no complaint");
        for (const demo::GltfPart& part : mesh.parts) {
            fuzz::require(!part.indices.empty() && part.indices.size() % 3 == 0, "no whole triangles");
            fuzz::require(part.texture < static_cast<int>(mesh.textures.size()), "no such texture");
            for (const std::uint32_t index : part.indices)
                fuzz::require(index < part.vertices.size(), "no such vertex");
            for (const demo::GltfVertex& vertex : part.vertices) {
                fuzz::require(is_in_world(vertex.position), "a vertex is lost");
                fuzz::require(std::isfinite(vertex.uv.x) && std::isfinite(vertex.uv.y), "uv is no number");
            }
        }
    });
    return 0;
}
