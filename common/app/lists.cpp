#include <cstdio>
#include <nlohmann/json.hpp>

#include "common/app/headless.h"
#include "common/app/shots.h"
#include "common/base/error.h"
#include "common/base/exercise.h"

namespace lightwalk {
namespace {

using nlohmann::json;

json knobs_json(const Chapter& chapter) {
    json list = json::array();
    for (const KnobBase* knob : chapter.all_knobs()) {
        list.push_back(knob->describe());
        if (knob->preferred) list.back()["alone"] = true;
    }
    return list;
}

json shots_json(const Chapter& chapter) {
    json list = json::array();
    for (const Shot& shot : read_shots(chapter.name))
        list.push_back({{"name", shot.name}, {"caption", shot.caption}, {"scene", shot.scene}});
    return list;
}

json exercises_json(const Chapter& chapter) {
    json list = json::array();
    for (const std::string& id : Exercises::ids())
        if (id.substr(0, 2) <= chapter.name.substr(0, 2))
            list.push_back({{"id", id},
                            {"in_use", Exercises::uses_solution(id) ? "solution" : "exercise"},
                            {"has_solution", Exercises::has_solution(id)}});
    return list;
}

json devices_json() {
    json list = json::array();
    for (const DeviceInfo& d : list_devices())
        list.push_back({{"name", d.name}, {"driver", d.driver}, {"type", d.type}, {"lacks", d.lacks}});
    return list;
}

json named(const json& name, std::initializer_list<std::pair<const char*, json>> values) {
    json entry = {{"name", name}};
    for (const auto& [key, value] : values) entry[key] = value;
    return entry;
}

std::string maps_of(const Material& material) {
    std::string text;
    for (size_t slot = 0; slot < map_slot_count; ++slot)
        if (texture_use(material, static_cast<MapSlot>(slot)))
            text += (text.empty() ? "" : ", ") + map_slots()[slot].name;
    return text;
}

json model_json(const Model& model) {
    json meshes = json::array(), materials = json::array(), left_out = json::array(), lights = json::array();
    size_t vertices = 0, triangles = 0;
    for (const Mesh& mesh : model.meshes) {
        vertices += mesh.vertices.size();
        triangles += mesh.indices.size() / 3;
        meshes.push_back(named(mesh.name, {{"vertices", mesh.vertices.size()},
                                           {"triangles", mesh.indices.size() / 3},
                                           {"colors", !mesh.colors.empty()},
                                           {"second_uvs", !mesh.second_uvs.empty()},
                                           {"morph_targets", mesh.deformation.targets.size()},
                                           {"skin", !mesh.deformation.joints.empty()}}));
    }
    for (const Material& m : model.materials)
        materials.push_back(named(m.name, {{"model", m.unlit         ? "unlit"
                                                     : m.microfacets ? "ggx"
                                                                     : "blinn_phong"},
                                           {"alpha", m.blend               ? "blend"
                                                     : m.alpha_cutoff > 0  ? "mask"
                                                     : m.alpha_cutoff == 0 ? "opaque"
                                                                           : "not said"},
                                           {"sides", m.sides == Sides::both    ? "both"
                                                     : m.sides == Sides::front ? "front"
                                                                               : "not said"},
                                           {"maps", maps_of(m)}}));
    for (const FileLight& light : model.lights) lights.push_back(light.light.name);
    json cameras = json::array();
    for (const FileCamera& camera : model.cameras) cameras.push_back(camera.name);
    for (const LeftOut& one : model.left_out)
        left_out.push_back({{"what", one.what}, {"count", one.count}, {"unit", one.unit}});
    return {{"vertices", vertices},
            {"triangles", triangles},
            {"nodes", model.nodes.size()},
            {"meshes", meshes},
            {"materials", materials},
            {"images_inside", model.images.size()},
            {"moving_nodes", model.motions.size()},
            {"seconds", model.motions_s},
            {"skins", model.skins.size()},
            {"cameras", cameras},
            {"lights", lights},
            {"left_out", left_out}};
}

void print_model(const Model& model, const Options& options) {
    const json all = model_json(model);
    if (options.json) {
        std::printf("%s\n", all.dump(1, ' ', false, json::error_handler_t::replace).c_str());
        return;
    }
    std::printf("%zu meshes, %zu vertices, %zu triangles, %zu nodes, %zu of them moving for %g s\n",
                model.meshes.size(), all["vertices"].get<size_t>(), all["triangles"].get<size_t>(), model.nodes.size(),
                model.motions.size(), double(model.motions_s));
    std::printf("%zu skins, %zu cameras, %zu lights, %zu images inside the file\n", model.skins.size(),
                model.cameras.size(), model.lights.size(), model.images.size());
    for (const json& m : all["materials"]) {
        const auto text = [&](const char* key) { return m[key].get<std::string>(); };
        std::printf("material '%s': %s, alpha %s, sides %s, maps: %s\n", text("name").c_str(), text("model").c_str(),
                    text("alpha").c_str(), text("sides").c_str(), text("maps").empty() ? "none" : text("maps").c_str());
    }
    const std::string left_out = left_out_text(model);
    std::printf("left out: %s\n", left_out.empty() ? "nothing" : left_out.c_str());
}

void print_table(const json& list) {
    for (const json& entry : list) {
        std::string line;
        for (const char* key : {"id", "name", "default", "in_use", "driver", "type", "caption", "help", "lacks"}) {
            if (!entry.contains(key)) continue;
            std::string text = entry[key].is_string() ? entry[key].get<std::string>() : entry[key].dump();
            if (line.empty()) text.resize(std::max<size_t>(text.size(), 28), ' ');
            line += (line.empty() ? "" : "  ") + text;
        }
        std::printf("%s\n", line.c_str());
    }
}

}  // namespace

int print_list(const Options& options, Chapter& chapter) {
    if (options.list == "model") {
        print_model(chapter.load_model(find_asset(options.list_file)), options);
        return 0;
    }
    const json list = options.list == "knobs"       ? knobs_json(chapter)
                      : options.list == "shots"     ? shots_json(chapter)
                      : options.list == "exercises" ? exercises_json(chapter)
                                                    : devices_json();
    if (options.json)
        std::printf("%s\n", list.dump(1, ' ', false, json::error_handler_t::replace).c_str());
    else
        print_table(list);
    return 0;
}

}  // namespace lightwalk
