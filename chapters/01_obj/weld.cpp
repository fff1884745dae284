// Welding: from index triples to the single index per vertex that a GPU uses.
#include <algorithm>
#include <glm/glm.hpp>
#include <unordered_map>
#include <utility>

#include "01_obj/obj.h"
#include "common/base/progress.h"
#include "common/image/image.h"

namespace lightwalk {
namespace {

constexpr size_t reported_corners = 1 << 16;  // between two reports of progress

glm::vec3 at3(const std::vector<float>& values, uint32_t i) {
    return {values[3 * size_t{i}], values[3 * size_t{i} + 1], values[3 * size_t{i} + 2]};
}

glm::vec3 unit(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 ? glm::vec3(v / length) : glm::vec3(0.0f, 1.0f, 0.0f);
}

// Finds the vertex made for an index triple before. The index of the position is its own hash, without collisions; a
// chain behind it holds the few vertices that share the position and differ in uv or normal. Where they are not few,
// the rest is in a hash table, so that no file takes a time that grows with its square.
class VertexTable {
  public:
    explicit VertexTable(size_t positions) : first_(positions, none) {}
    void next_mesh() {
        mesh_start_ = static_cast<uint32_t>(entries_.size());
        crowd_.clear();
    }

    // [find]
    /// Number of the vertex in the mesh; `is_new` tells whether it was added.
    uint32_t find(const Corner& corner, bool& is_new) {
        int length = 0;
        // In the chain, entries of earlier meshes follow all entries of this one.
        for (uint32_t i = first_[corner.position]; i != none && i >= mesh_start_; i = entries_[i].next) {
            if (entries_[i].uv == corner.uv && entries_[i].normal == corner.normal) {
                is_new = false;
                return i - mesh_start_;
            }
            if (++length == longest_chain) return find_in_crowd(corner, is_new);
        }
        const uint32_t i = static_cast<uint32_t>(entries_.size());
        entries_.push_back({corner.uv, corner.normal, first_[corner.position]});
        first_[corner.position] = i;
        is_new = true;
        return i - mesh_start_;
    }
    // [/find]

  private:
    static constexpr int longest_chain = 16;
    struct Entry {
        uint32_t uv, normal, next;
    };
    struct Hash {
        size_t operator()(const Corner& c) const {
            return ((size_t{c.position} * 0x9E3779B97F4A7C15u ^ c.uv) * 0x9E3779B97F4A7C15u ^ c.normal) *
                       0x9E3779B97F4A7C15u >>
                   16;
        }
    };
    uint32_t find_in_crowd(const Corner& corner, bool& is_new) {
        const auto [place, added] = crowd_.try_emplace(corner, static_cast<uint32_t>(entries_.size()));
        if (added) entries_.push_back({corner.uv, corner.normal, none});
        is_new = added;
        return place->second - mesh_start_;
    }
    std::vector<uint32_t> first_;
    std::vector<Entry> entries_;
    std::unordered_map<Corner, uint32_t, Hash> crowd_;
    uint32_t mesh_start_ = 0;
};

// A range of triangles and where it goes.
struct Stretch {
    uint32_t mesh, material, smoothing;
    size_t begin, end;
};

// Normals of faces that give none and have a smoothing statement: of group 0 each triangle's own, of others the sum over
// the group's triangles at a position. They get numbers behind the file's normals.
class Smoothing {
  public:
    explicit Smoothing(const ObjData& data) : data_(data), given_(data.normals.size() / 3) {
        for (size_t i = 0; i < data.runs.size(); ++i) {
            const Run& run = data.runs[i];
            if (run.smoothing == none || run.smoothing == 0) continue;
            const size_t end = i + 1 < data.runs.size() ? data.runs[i + 1].first_triangle : data.triangles();
            for (size_t k = 3 * size_t{run.first_triangle}; k < 3 * end; ++k) {
                const Corner& c = data.corners[k];
                if (c.normal != none) continue;
                const auto [at, is_new] = groups_.try_emplace(key(c.position, run.smoothing), sums_.size());
                if (is_new) sums_.emplace_back(0.0);
                sums_[at->second] += weighted(k / 3);
            }
        }
    }

    Corner corner(size_t k, uint32_t smoothing) const {
        Corner c = data_.corners[k];
        if (c.normal != none || smoothing == none) return c;
        const size_t number = smoothing == 0 ? sums_.size() + k / 3 : groups_.at(key(c.position, smoothing));
        c.normal = static_cast<uint32_t>(given_ + number);
        return c;
    }

    glm::dvec3 normal(uint32_t number) const {
        if (number < given_) return at3(data_.normals, number);
        const size_t own = number - given_;
        return own < sums_.size() ? sums_[own] : weighted(own - sums_.size());
    }

  private:
    static uint64_t key(uint32_t position, uint32_t group) { return uint64_t{group} << 32 | position; }
    // The cross product of two edges is twice the area long.
    glm::dvec3 weighted(size_t triangle) const {
        const Corner* t = data_.corners.data() + 3 * triangle;
        const glm::dvec3 a = at3(data_.positions, t[0].position);
        return glm::cross(glm::dvec3(at3(data_.positions, t[1].position)) - a,
                          glm::dvec3(at3(data_.positions, t[2].position)) - a);
    }
    const ObjData& data_;
    const size_t given_;
    std::unordered_map<uint64_t, size_t> groups_;
    std::vector<glm::dvec3> sums_;
};

// Whether seven numbers are x y z r g b a: unless every fourth is 1, as w is, and the last ones are no opacity of 1.
bool have_opacity(const ObjData& data) {
    bool fourths_are_1 = true, lasts_are_1 = true;
    for (const ColoredPosition& one : data.colors) {
        if (one.fourth == no_fourth) continue;
        fourths_are_1 &= one.fourth == 1.0f;
        lasts_are_1 &= one.color.b == 1.0f;
    }
    return !fourths_are_1 || lasts_are_1;
}

// Linear; white where a position has none, and nothing where no position has one. Some programs count to 255.
std::vector<glm::vec4> colors_of(const ObjData& data) {
    if (data.colors.empty()) return {};
    const bool opacity = have_opacity(data);
    const auto given = [&](const ColoredPosition& one) {
        return opacity && one.fourth != no_fourth ? glm::vec4(one.fourth, one.color) : glm::vec4(one.color, -1);
    };
    float most = 0, most_alpha = 0;
    for (const ColoredPosition& one : data.colors) {
        const glm::vec4 c = given(one);
        most = std::max({most, c.r, c.g, c.b});
        most_alpha = std::max(most_alpha, c.a);
    }
    std::vector<glm::vec4> colors(data.positions.size() / 3, glm::vec4(1.0f));
    for (const ColoredPosition& one : data.colors) {
        const glm::vec4 c = given(one);
        for (int i = 0; i < 3; ++i)
            colors[one.position][i] = srgb_to_linear(std::clamp(most > 2.0f ? c[i] / 255.0f : c[i], 0.0f, 1.0f));
        // Opacity 0 everywhere would make it vanish.
        if (most_alpha > 0 && c.a >= 0)
            colors[one.position].a = std::clamp(most_alpha > 2.0f ? c.a / 255.0f : c.a, 0.0f, 1.0f);
    }
    return colors;
}

// For each position, the sum of the normals of the faces that give none, weighted by area: the cross product of two
// edges is twice the area long. Empty where every corner has a normal.
std::vector<glm::dvec3> smooth_normals(const ObjData& data) {
    std::vector<glm::dvec3> sums;
    for (size_t i = 0; i < data.corners.size(); i += 3) {
        const Corner* t = data.corners.data() + i;
        if (t[0].normal != none && t[1].normal != none && t[2].normal != none) continue;
        if (sums.empty()) sums.resize(data.positions.size() / 3, glm::dvec3(0.0));
        const glm::dvec3 a = at3(data.positions, t[0].position), b = at3(data.positions, t[1].position),
                         c = at3(data.positions, t[2].position);
        const glm::dvec3 weighted = glm::cross(b - a, c - a);
        for (int k = 0; k < 3; ++k) sums[t[k].position] += weighted;
    }
    return sums;
}

bool has_zero_normal(const ObjData& data) {
    for (uint32_t i = 0; i < data.normals.size() / 3; ++i)
        if (at3(data.normals, i) == glm::vec3(0.0f)) return true;
    return false;
}

// A normal of length 0 is none.
ObjData without_zero_normals(ObjData data) {
    for (Corner& c : data.corners)
        if (c.normal != none && at3(data.normals, c.normal) == glm::vec3(0.0f)) c.normal = none;
    return data;
}

// One stretch for each run, grouped by mesh and material, in order of first use.
std::vector<Stretch> stretches_by_mesh(const ObjData& data, Model& model, const std::string& name) {
    std::vector<uint32_t> mesh_of(data.objects.size() + 1, none);
    std::vector<Stretch> stretches;
    for (size_t i = 0; i < data.runs.size(); ++i) {
        const Run& run = data.runs[i];
        const size_t end = i + 1 < data.runs.size() ? data.runs[i + 1].first_triangle : data.triangles();
        if (end <= run.first_triangle) continue;
        uint32_t& mesh = mesh_of[run.object == none ? data.objects.size() : run.object];
        if (mesh == none) {
            mesh = static_cast<uint32_t>(model.meshes.size());
            model.meshes.emplace_back().name = run.object == none ? name : data.objects[run.object];
            model.nodes.push_back({.name = model.meshes.back().name, .meshes = {mesh}});
        }
        const uint32_t material = run.material == none ? static_cast<uint32_t>(data.materials.size()) : run.material;
        stretches.push_back({mesh, material, run.smoothing, run.first_triangle, end});
    }
    std::stable_sort(stretches.begin(), stretches.end(), [](const Stretch& a, const Stretch& b) {
        return std::pair(a.mesh, a.material) < std::pair(b.mesh, b.material);
    });
    return stretches;
}

Model welded(const ObjData& data, std::vector<Material> materials, const std::string& name) {
    Model model;
    model.materials = std::move(materials);
    const std::vector<Stretch> stretches = stretches_by_mesh(data, model, name);
    for (const Stretch& s : stretches)
        if (s.material >= model.materials.size()) model.materials.resize(s.material + 1);
    const std::vector<glm::dvec3> smooth = smooth_normals(data);
    VertexTable table(data.positions.size() / 3);
    const Smoothing smoothing(data);
    const std::vector<glm::vec4> colors = colors_of(data);
    const auto vertex = [&](const Corner& c) {
        const glm::dvec3 given = c.normal == none ? glm::dvec3(0.0) : smoothing.normal(c.normal);
        const bool has_normal = given != glm::dvec3(0.0);
        const size_t uv = 2 * size_t{c.uv};
        return Vertex{at3(data.positions, c.position), unit(has_normal || smooth.empty() ? given : smooth[c.position]),
                      c.uv == none ? glm::vec2(0.0f) : glm::vec2(data.uvs[uv], data.uvs[uv + 1])};
    };
    Progress* const waited_for = progress();
    if (waited_for) waited_for->begin("joining vertices", data.corners.size());
    for (size_t i = 0; i < stretches.size(); ++i) {
        const Stretch& s = stretches[i];
        Mesh& mesh = model.meshes[s.mesh];
        const bool new_mesh = i == 0 || stretches[i - 1].mesh != s.mesh;
        if (new_mesh) table.next_mesh();
        if (new_mesh || mesh.parts.back().material != s.material)
            mesh.parts.push_back({static_cast<uint32_t>(mesh.indices.size()), 0, s.material});
        if (new_mesh) mesh.indices.reserve(3 * (s.end - s.begin));
        for (size_t k = 3 * s.begin; k < 3 * s.end; ++k) {
            if (waited_for && k % reported_corners == 0) waited_for->step(reported_corners);
            bool is_new;
            const Corner corner = smoothing.corner(k, s.smoothing);
            mesh.indices.push_back(table.find(corner, is_new));
            if (!is_new) continue;
            mesh.vertices.push_back(vertex(corner));
            if (!colors.empty()) mesh.colors.push_back(colors[corner.position]);
            mesh.bounds.add(mesh.vertices.back().position);
        }
        mesh.parts.back().index_count = static_cast<uint32_t>(mesh.indices.size()) - mesh.parts.back().first_index;
    }
    return model;
}

}  // namespace

Model weld(const ObjData& data, std::vector<Material> materials, const std::string& name) {
    if (has_zero_normal(data)) return welded(without_zero_normals(data), std::move(materials), name);
    return welded(data, std::move(materials), name);
}

}  // namespace lightwalk
