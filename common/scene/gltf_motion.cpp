// glTF animations.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "common/scene/gltf_parts.h"

namespace lightwalk {
namespace {
using nlohmann::json;

void set_numbers(glm::vec3& value, const float* from, size_t) { value = glm::make_vec3(from); }
void set_numbers(glm::quat& value, const float* from, size_t) { value = glm::quat(from[3], from[0], from[1], from[2]); }
void set_key(glm::quat& value, const float* from, size_t) { value = unit_rotation(glm::make_vec4(from)); }
void set_numbers(std::vector<float>& value, const float* from, size_t count) { value.assign(from, from + count); }

template <class T>
void set_key(T& value, const float* from, size_t count) {
    set_numbers(value, from, count);
}

template <class T>
KeyTrack<T> track_of(const GltfFile& file, const json& sampler, size_t components, size_t size) {
    KeyTrack<T> track;
    const std::string between = value_or<std::string>(sampler, "interpolation", "LINEAR");
    if (between != "LINEAR" && between != "STEP" && between != "CUBICSPLINE")
        file.refuse("interpolation '{}', expected LINEAR, STEP or CUBICSPLINE", between);
    track.between = between == "STEP" ? Between::step : between == "CUBICSPLINE" ? Between::cubic : Between::linear;
    const std::vector<float> times = file.floats(sampler.at("input").get<size_t>(), 1);
    const std::vector<float> numbers = file.floats(sampler.at("output").get<size_t>(), components);
    const bool cubic = track.between == Between::cubic;
    if (size == 0 || numbers.size() < times.size() * size * (cubic ? 3 : 1))
        file.refuse("an animation has {} numbers for {} times", numbers.size(), times.size());
    for (size_t i = 0; i < times.size(); ++i) {
        if (!(std::isfinite(times[i])) || (i > 0 && times[i] <= times[i - 1]))
            file.refuse("an animation's times do not rise");
        const float* from = numbers.data() + i * size * (cubic ? 3 : 1);
        TimedValue<T>& key = track.emplace_back();
        key.time_s = times[i];
        set_key(key.value, from + (cubic ? size : 0), size);
        if (!cubic) continue;
        set_numbers(track.slopes.emplace_back(), from, size);
        set_numbers(track.slopes.emplace_back(), from + 2 * size, size);
    }
    return track;
}

template <class T>
void fill(KeyTrack<T>& track, const T& value) {
    if (track.empty()) track.push_back({0, value});
}

// Missing channels keep the node's own value.
void fill_from_node(const json& node, NodeMotion& motion) {
    if (motion.position.empty() && motion.scale.empty() && motion.rotation.empty()) return;
    fill(motion.position, vector_or(node, "translation", glm::vec3(0)));
    fill(motion.scale, vector_or(node, "scale", glm::vec3(1)));
    fill(motion.rotation, unit_rotation(vector_or(node, "rotation", glm::vec4(0, 0, 0, 1))));
}

// The most of a primitive: some have fewer, or none.
size_t target_count(const GltfFile& file, const json& node) {
    size_t most = 0;
    if (!node.contains("mesh")) return most;
    for (const json& primitive : file.entry("meshes", node.at("mesh").get<size_t>()).at("primitives"))
        if (const auto targets = primitive.find("targets"); targets != primitive.end())
            most = std::max(most, targets->size());
    return most;
}

// Animation without a duration: one pose, for all times.
void hold_pose(Model& model) {
    for (const NodeMotion& motion : model.motions) {
        if (!motion.position.empty()) {
            const glm::mat4 moved = glm::translate(glm::mat4(1), motion.position.back().value);
            model.nodes[motion.node].local =
                glm::scale(moved * glm::mat4_cast(motion.rotation.back().value), motion.scale.back().value);
        }
        for (Mesh& mesh : model.meshes) {
            Deformation& how = mesh.deformation;
            if (!how || how.node != motion.node || motion.weights.empty()) continue;
            how.weights = motion.weights.back().value;
            how.weights.resize(how.targets.size());
        }
    }
    model.motions.clear();
}

}  // namespace

void read_gltf_motions(const GltfFile& file, const std::vector<int>& nodes, Model& model) {
    if (file.count("animations") == 0) return;
    for (size_t i = 1; i < file.count("animations"); ++i) leave_out(model, "further animations", "animation");
    const json& from = file.entry("animations", 0);
    std::map<size_t, NodeMotion> motions;
    for (const json& channel : from.at("channels")) {
        const json& target = channel.at("target");
        if (!target.contains("node")) continue;  // from an extension, reported separately
        const size_t number = target.at("node").get<size_t>();
        const json& node = file.entry("nodes", number);
        if (nodes[number] < 0) continue;
        const size_t sampler_index = channel.at("sampler").get<size_t>();
        if (sampler_index >= from.at("samplers").size()) file.refuse("animation sampler {} is missing", sampler_index);
        const json& sampler = from.at("samplers").at(sampler_index);
        const std::string path = target.at("path");
        NodeMotion& motion = motions[number];
        motion.node = static_cast<uint32_t>(nodes[number]);
        if (path == "translation")
            motion.position = track_of<glm::vec3>(file, sampler, 3, 3);
        else if (path == "scale")
            motion.scale = track_of<glm::vec3>(file, sampler, 3, 3);
        else if (path == "rotation")
            motion.rotation = track_of<glm::quat>(file, sampler, 4, 4);
        else if (path == "weights" && target_count(file, node) > 0)
            motion.weights = track_of<std::vector<float>>(file, sampler, 1, target_count(file, node));
    }
    for (auto& [number, motion] : motions) {
        for (const auto& list : {motion.position, motion.scale})
            if (!list.empty()) model.motions_s = std::max(model.motions_s, list.back().time_s);
        if (!motion.rotation.empty()) model.motions_s = std::max(model.motions_s, motion.rotation.back().time_s);
        if (!motion.weights.empty()) model.motions_s = std::max(model.motions_s, motion.weights.back().time_s);
        fill_from_node(file.entry("nodes", number), motion);
        model.motions.push_back(std::move(motion));
    }
    if (!(model.motions_s > 0)) hold_pose(model);
}

}  // namespace lightwalk
