#include "18_playground/saving.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/scene/scene.h"

namespace lightwalk {
namespace fs = std::filesystem;

Light light_of(const Entry& entry) {
    Light light = *entry.light();
    light.locked = entry.locked;
    return light;
}

namespace {

void give(SceneFile& scene, const SceneSettings& settings) {
    scene.camera = settings.camera;
    scene.ambient = settings.ambient;
    scene.background = settings.background;
    scene.environment = settings.environment;
    scene.music = settings.music;
    scene.knobs = settings.knobs;
    scene.bare = settings.bare;
    scene.emission = settings.emission;
    if (!scene.knobs.empty()) scene.knobs_of = "18_playground";
}

}  // namespace

Said cannot_be_saved(const Entry& entry, const fs::path& file) {
    SceneFile alone;
    if (const SceneSettings* settings = entry.settings()) give(alone, *settings);
    if (entry.light()) alone.lights.push_back(light_of(entry));
    if (const SceneObject* object = entry.object()) {
        alone.objects.push_back(*object);
        alone.objects[0].parent.clear();  // entries that are not looked at here
        alone.objects[0].shows.clear();
    }
    const fs::path scene = file.empty() ? fs::path("scene.json") : file;
    try {
        parse_scene(scene_text(alone), scene);
    } catch (const InputError& e) {  // file:line: message; the line exists only in memory
        const std::string said = e.what();
        const size_t place = said.find(": ", std::min(said.size(), scene.string().size()));
        return place == said.npos ? said : said.substr(place + 2);
    }
    return "";
}

Exported exported(const Document& document) {
    Exported result;
    SceneFile& scene = result.scene;
    give(scene, document.settings());
    for (const EntryId id : with_children(document, root_entry)) {
        const Entry& entry = document.at(id);
        if (const SceneObject* object = entry.object()) {
            scene.objects.push_back(*object);
            scene.objects.back().hidden = entry.hidden;
            scene.objects.back().locked = entry.locked;
            if (entry.parent != root_entry) scene.objects.back().parent = document.at(entry.parent).name();
            result.objects.push_back(id);
        } else if (entry.light() && entry.hidden) {
            scene.hidden_lights.push_back({scene.lights.size(), light_of(entry)});
        } else if (entry.light()) {
            scene.lights.push_back(light_of(entry));
            result.lights.push_back(id);
        }
    }
    return result;
}

namespace {

// Objects and lights of included entries only, or of the others.
SceneFile part_of(const Document& document, bool included) {
    Exported all = exported(document);
    SceneFile part = std::move(all.scene);
    std::vector<SceneObject> objects;
    for (size_t i = 0; i < all.objects.size(); ++i)
        if (document.at(all.objects[i]).included == included) objects.push_back(std::move(part.objects[i]));
    part.objects = std::move(objects);
    part.lights.clear();
    part.hidden_lights.clear();
    for (const EntryId id : document.at(root_entry).children) {
        const Entry& entry = document.at(id);
        if (!entry.light() || entry.included != included) continue;
        if (entry.hidden)
            part.hidden_lights.push_back({part.lights.size(), light_of(entry)});
        else
            part.lights.push_back(light_of(entry));
    }
    return part;
}

std::string content(const SceneFile& scene) {
    SceneFile bare;
    bare.objects = scene.objects;
    bare.lights = scene.lights;
    bare.hidden_lights = scene.hidden_lights;
    return scene_text(bare);
}

}  // namespace

// [open]
Document SceneStore::open(const fs::path& given) {
    const fs::path file = find_asset(given);
    if (file.extension() != ".json") {
        Document document(scene_of_model(file, {}));
        path.clear();
        includes_.clear();
        included_.clear();
        saved_state_ = document.state();
        hash_ = 0;
        own_.reset();
        left_.reset();
        return document;
    }
    const std::string text = read_file(file);
    SceneFile scene = parse_scene(text, file);  // the same bytes as are looked at below
    std::vector<std::string> includes;
    SceneFile base;
    const nlohmann::json json = nlohmann::json::parse(text);
    if (const auto list = json.find("include"); list != json.end()) {
        includes = list->get<std::vector<std::string>>();
        base = parse_scene(nlohmann::json{{"include", includes}}.dump(), file);
    }
    Document document(scene);
    // Included entries come before the file's own; children follow their parents here, in either part.
    std::map<std::string, bool> names;
    for (const SceneObject& object : base.objects) names[object.name] = true;
    size_t lights = base.lights.size() + base.hidden_lights.size(), unnamed = 0;
    for (const SceneObject& object : base.objects) unnamed += object.name.empty();
    document.begin("open");
    for (const EntryId id : with_children(document, root_entry)) {
        const Entry& entry = document.at(id);
        const bool is_included = entry.object()
                                     ? entry.name().empty() ? unnamed > 0 && unnamed-- : names.contains(entry.name())
                                 : entry.light() ? lights > 0 && lights--
                                                 : false;
        if (is_included) document.edit(id).included = true;
    }
    document.commit();
    document.forget_steps();
    path = file;
    includes_ = std::move(includes);
    included_ = includes_.empty() ? "" : content(part_of(document, true));
    saved_state_ = autosaved_state_ = document.state();
    own_.reset();
    left_.reset();
    hash_ = hash_bytes(text);
    return document;
}
// [/open]

Document SceneStore::open_empty() {
    Document document;
    path.clear();
    includes_.clear();
    included_.clear();
    saved_state_ = autosaved_state_ = document.state();
    hash_ = 0;
    own_.reset();
    left_.reset();
    return document;
}

bool SceneStore::changed_on_disk() const {
    std::error_code error;
    if (path.empty() || !fs::is_regular_file(path, error)) return false;
    return hash_ != hash_bytes(read_file(path));
}

bool SceneStore::includes_changed_on_disk() const {
    if (includes_.empty()) return false;
    SceneStore now;
    try {
        now.open(path);
    } catch (const InputError&) { return true; }
    return now.included_ != included_;
}

std::string SceneStore::text(const Document& document, Said* said) const {
    const bool keeps = !includes_.empty() && content(part_of(document, true)) == included_;
    SceneFile scene = keeps ? part_of(document, false) : exported(document).scene;
    if (camera) scene.camera = *camera;
    if (!keeps && !includes_.empty() && said)
        *said = "what the scene includes was changed here: it now stands in the file itself";
    return scene_text(scene, keeps ? includes_ : std::vector<std::string>());
}

// [save]
Said SceneStore::save(const Document& document) {
    Said said;
    const std::string bytes = text(document, &said);
    parse_scene(bytes, path);  // verifies that the text can be read back
    write_file_to_disk(path, bytes);
    hash_ = hash_bytes(bytes);
    saved_state_ = document.state();
    if (!said.empty()) includes_.clear();
    forget_autosave();
    return said;
}
// [/save]

Said SceneStore::save_as(const Document& document, const fs::path& file) {
    const fs::path before = std::exchange(path, file.extension() == ".json" ? file : fs::path(file.string() + ".json"));
    const auto includes = includes_;
    if (before.parent_path() != path.parent_path()) includes_.clear();  // they are named from the file's folder
    try {
        Said said = save(document);
        if (includes_ != includes) said = "included files now stand in the file itself: it lies in another folder";
        return said;
    } catch (...) {
        path = before;
        includes_ = includes;
        throw;
    }
}

}  // namespace lightwalk
