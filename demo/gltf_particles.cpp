// SPDX-License-Identifier: MIT
#include "demo/gltf_particles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <map>
#include <optional>
#include <string>

#include "demo/cube_root.h"
#include "demo/gltf_animation.h"
#include "demo/gltf_file.h"
#include "demo/gltf_nodes.h"

namespace demo {
namespace {

constexpr double kMaxCoordinate = 1e5, kLeastRadius = 1e-4, kMaxAxis = 1e3, kMaxGlow = 100.0;

// Half the largest side of the box around a mesh's points.
double half_extent(GltfFile& file, const tinygltf::Mesh& mesh, const std::string& name) {
    glm::dvec3 low(1e30), high(-1e30);
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
        const auto position = primitive.attributes.find("POSITION");
        if (position == primitive.attributes.end()) file.fail(name + ": has no POSITION");
        const GltfNumbers points = file.read_numbers(
            position->second, {.what = "POSITION of " + name, .least_components = 3, .most_components = 3});
        for (std::size_t i = 0; i < points.count; ++i) {
            const glm::dvec3 point(points.at(i, 0), points.at(i, 1), points.at(i, 2));
            low  = glm::min(low, point);
            high = glm::max(high, point);
        }
    }
    const glm::dvec3 extent = high - low;
    const double half       = 0.5 * std::max({extent.x, extent.y, extent.z});
    if (!(half > 0.0)) file.fail(name + ": its mesh has no size");
    return half;
}

double number_in(const GltfFile& file, const tinygltf::Value& value, double most, const std::string& what) {
    const double number = value.IsNumber() ? value.GetNumberAsDouble() : -1.0;
    if (!(number >= 0.0 && number <= most)) {
        file.fail(what + " must be a number from 0 to " + std::to_string(static_cast<int>(most)));
    }
    return number;
}

void read_extras(const GltfFile& file, const tinygltf::Node& node, const std::string& name, cloud::Particle& particle) {
    if (node.extras.Has("alpha")) {
        particle.alpha = static_cast<float>(number_in(file, node.extras.Get("alpha"), 1.0, name + ": alpha"));
    }
    if (!node.extras.Has("glow")) return;
    const tinygltf::Value& glow = node.extras.Get("glow");
    const std::string what      = name + ": glow";
    if (!glow.IsArray()) {
        particle.glow = Vec3(static_cast<float>(number_in(file, glow, kMaxGlow, what)));
        return;
    }
    if (glow.ArrayLen() != 3) file.fail(what + " must be one number or three");
    for (int i = 0; i < 3; ++i) particle.glow[i] = static_cast<float>(number_in(file, glow.Get(i), kMaxGlow, what));
}

// The material's colours; radius: of the mesh as it is.
void read_mesh(GltfFile& file, int index, const std::string& name, cloud::Particle& particle) {
    const tinygltf::Mesh& mesh = file.find(file.model().meshes, index, name + " has a mesh that is not there");
    particle.radius            = static_cast<float>(half_extent(file, mesh, name));
    const int first            = mesh.primitives.front().material;
    if (first < 0) return;
    const tinygltf::Material& material =
        file.find(file.model().materials, first, name + " has a material that is not there");
    const std::vector<double>& base = material.pbrMetallicRoughness.baseColorFactor;
    const std::vector<double>& glow = material.emissiveFactor;
    const auto is_share             = [](double factor) { return factor >= 0.0 && factor <= 1.0; };
    if (!std::all_of(base.begin(), base.end(), is_share) || !std::all_of(glow.begin(), glow.end(), is_share)) {
        file.fail(name + ": has a material with a factor that is not from 0 to 1");
    }
    particle.color = glm::dvec3(base[0], base[1], base[2]);
    particle.alpha = static_cast<float>(base[3]);
    particle.glow  = glm::dvec3(glow[0], glow[1], glow[2]);
}

}  // namespace

struct ParticleFile::Contents {
    struct Node {
        int parent = -1;  // in nodes, before this one
        LocalTransform rest;
        std::optional<NodeCurves> curves;
    };
    struct Prototype {
        std::size_t node = 0;
        cloud::Particle particle;  // radius: of the node's own space
        std::string name;
    };

    FileReference file;
    std::vector<Node> nodes;  // particles and their ancestors
    std::vector<Prototype> particles;
    double duration = 0.0;
};

ParticleFile::ParticleFile(const FileReference& reference) {
    GltfFile file(reference);
    const std::vector<SceneNode> nodes     = scene_nodes(file);
    const std::map<int, NodeCurves> curves = read_curves(file);
    const auto name_of                     = [&](const SceneNode& node) -> const std::string& {
        return file.model().nodes[static_cast<std::size_t>(node.index)].name;
    };
    // Children stand after their parents.
    std::vector<bool> is_needed(nodes.size(), false);
    std::size_t count = 0;
    for (std::size_t i = nodes.size(); i-- > 0;) {
        if (is_particle(name_of(nodes[i]))) {
            is_needed[i] = true;
            ++count;
        }
        if (is_needed[i] && nodes[i].parent >= 0) is_needed[static_cast<std::size_t>(nodes[i].parent)] = true;
    }
    if (count == 0) file.fail("has no node whose name starts with 'particle'");
    if (count > std::size_t{kMaxParticlesPerCloud}) {
        file.fail("has " + std::to_string(count) + " particles (at most " + std::to_string(kMaxParticlesPerCloud) +
                  ")");
    }

    auto contents  = std::make_shared<Contents>();
    contents->file = reference;
    std::vector<int> place_of(nodes.size(), -1);
    std::map<int, cloud::Particle> particle_of_mesh;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!is_needed[i]) continue;
        const SceneNode& node = nodes[i];
        const auto moved      = curves.find(node.index);
        place_of[i]           = static_cast<int>(contents->nodes.size());
        Contents::Node& added = contents->nodes.emplace_back();
        added.parent          = node.parent < 0 ? -1 : place_of[static_cast<std::size_t>(node.parent)];
        added.rest            = node.rest;
        if (moved != curves.end()) {
            added.curves       = moved->second;
            contents->duration = std::max(contents->duration, moved->second.duration());
        }
        if (!is_particle(name_of(node))) continue;
        const tinygltf::Node& from = file.model().nodes[static_cast<std::size_t>(node.index)];
        const std::string name     = node_name(file, node.index);
        Contents::Prototype prototype{.node = contents->nodes.size() - 1, .particle = {}, .name = name};
        if (from.mesh >= 0) {
            const auto known = particle_of_mesh.find(from.mesh);
            if (known == particle_of_mesh.end()) read_mesh(file, from.mesh, name, prototype.particle);
            prototype.particle = particle_of_mesh.emplace(from.mesh, prototype.particle).first->second;
        }
        read_extras(file, from, name, prototype.particle);
        contents->particles.push_back(prototype);
    }
    contents_ = contents;
    at(0.0);  // complains now, if the first frame would
}

std::vector<cloud::Particle> ParticleFile::at(double seconds) const {
    std::vector<glm::dmat4> places;
    places.reserve(contents_->nodes.size());
    for (const Contents::Node& node : contents_->nodes) {
        LocalTransform transform = node.rest;
        if (node.curves) node.curves->apply(transform, seconds);
        const glm::dmat4 local = matrix_of(transform);
        places.push_back(node.parent < 0 ? local : places[static_cast<std::size_t>(node.parent)] * local);
    }
    std::vector<cloud::Particle> particles;
    particles.reserve(contents_->particles.size());
    for (const Contents::Prototype& prototype : contents_->particles) {
        const glm::dmat4& place = places[prototype.node];
        const glm::dmat3 axes(place);
        const double volume = glm::dot(axes[0], glm::cross(axes[1], axes[2]));
        const double scale  = cube_root(std::abs(volume));
        const double radius = scale * static_cast<double>(prototype.particle.radius);
        const bool is_far   = !(std::abs(place[3][0]) <= kMaxCoordinate && std::abs(place[3][1]) <= kMaxCoordinate &&
                              std::abs(place[3][2]) <= kMaxCoordinate && radius <= kMaxCoordinate);
        if (is_far) {
            throw SceneError(contents_->file.named_at + ": " + contents_->file.path + ": " + prototype.name +
                             ": reaches beyond 100000 m");
        }
        if (radius < kLeastRadius) continue;
        cloud::Particle particle = prototype.particle;
        const glm::dmat3 shape   = axes / (volume < 0.0 ? -scale : scale);
        double largest           = 0.0;
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(shape[column][row]));
        if (!(largest <= kMaxAxis)) continue;
        particle.center = glm::dvec3(place[3]);
        particle.radius = static_cast<float>(radius);
        particle.shape  = shape;
        particles.push_back(particle);
    }
    return particles;
}

double ParticleFile::duration() const {
    return contents_->duration;
}

}  // namespace demo
