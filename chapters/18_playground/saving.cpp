#include "18_playground/saving.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/own_files.h"
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

void SceneStore::take(const Document& document, const fs::path& file, std::vector<std::string> includes,
                      uint64_t hash) {
    path = file;
    includes_ = std::move(includes);
    included_ = includes_.empty() ? "" : content(part_of(document, true));
    saved_state_ = autosaved_state_ = document.state();
    hash_ = hash;
    own_.reset();
    left_.reset();
}

Document SceneStore::open(const fs::path& given) {
    const fs::path file = find_asset(given);
    if (file.extension() != ".json") {
        Document document(scene_of_model(file, {}));
        take(document, {}, {}, 0);
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
    take(document, file, std::move(includes), hash_bytes(text));
    return document;
}

Document SceneStore::open_empty() {
    Document document;
    take(document, {}, {}, 0);
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

namespace fs = std::filesystem;

// Locked while this lives, and no longer than the program, however that ends.
struct SceneStore::HeldFile {
    fs::path file;
    int descriptor;
    HeldFile(fs::path path, int opened) : file(std::move(path)), descriptor(opened) {}
    HeldFile(const HeldFile&) = delete;
    ~HeldFile() { close(descriptor); }

    // The file has its name still: somebody else may have removed or replaced it.
    bool is_there() const {
        struct stat own {
        }, named{};
        return fstat(descriptor, &own) == 0 && stat(file.c_str(), &named) == 0 && own.st_dev == named.st_dev &&
               own.st_ino == named.st_ino;
    }

    // Null where another editor holds it. A file system without locks has nobody who holds one.
    static std::shared_ptr<HeldFile> take(const fs::path& path) {
        const int opened = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
        if (opened < 0) return nullptr;
        auto held = std::make_shared<HeldFile>(path, opened);
        const bool taken = flock(opened, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
        return taken && held->is_there() ? held : nullptr;
    }
};

namespace {

// Its new path, to which nothing is written; the same one where it cannot be renamed.
fs::path move_aside(const fs::path& file) {
    fs::path kept;
    for (int i = 1; kept.empty() || file_exists(kept); ++i) kept = file.string() + "." + std::to_string(i);
    std::error_code error;
    fs::rename(file, kept, error);
    return error ? file : kept;
}

// The course's tree stays as it is: of its scenes, and of one without a name while the tree is the current folder, the
// autosave lies in the person's state folder, known by the whole path.
fs::path autosave_stem(const fs::path& scene) {
    std::error_code error;
    const fs::path beside = scene.empty() ? fs::path("untitled.json") : scene;
    const fs::path whole = fs::weakly_canonical(fs::absolute(beside, error), error);
    if (error || !lies_below(whole, course_root())) return beside;
    const fs::path state = state_folder();
    const fs::path folder = state.empty() ? course_root() / "build" / "autosaves" : state / "autosaves";
    fs::create_directories(folder, error);
    return folder / fmt::format("{}.{:016x}.json", whole.stem().string(), hash_bytes(whole.string()));
}

}  // namespace

fs::path SceneStore::autosave_name(int number) const {
    return autosave_stem(path).string() + (number == 1 ? "" : "." + std::to_string(number)) + ".unsaved";
}

fs::path SceneStore::autosave_file() const { return own_ ? own_->file : autosave_name(1); }

// A name that no other editor holds. An earlier crash's file that was not offered keeps another name.
fs::path SceneStore::free_autosave_file(Said* said) const {
    bool others = false;
    for (int i = 1;; ++i) {
        const fs::path file = autosave_name(i);
        if (file_exists(file)) {
            if (left_ && left_->file == file) continue;
            if (!HeldFile::take(file)) {
                others = true;
                continue;
            }
            const fs::path kept = move_aside(file);
            if (kept == file) continue;
            if (said) *said = "an autosave that was left is kept as " + kept.filename().string();
        } else if (said && others && !path.empty()) {
            *said = path.filename().string() + " is open in another editor: this one's autosave is " +
                    file.filename().string();
        }
        return file;
    }
}

bool SceneStore::autosave(const Document& document, Said* said) {
    if (!has_unsaved(document) || document.state() == autosaved_state_) return false;
    const fs::path file = own_ && own_->is_there() ? own_->file : free_autosave_file(said);
    const fs::path fresh = file.string() + ".new";
    write_file(fresh, text(document));
    auto held = HeldFile::take(fresh);  // before it has its name: nobody sees it unlocked
    std::error_code error;
    if (held) fs::rename(fresh, file, error);
    if (!held || error) throw InputError("{}: cannot be replaced", file.string());
    held->file = file;
    own_ = std::move(held);
    autosaved_state_ = document.state();
    return true;
}

bool SceneStore::has_recovery(Said* said) {
    constexpr int most_editors = 9;
    std::error_code error;
    for (int i = 1; i <= most_editors && !left_; ++i) {
        const fs::path file = autosave_name(i);
        if ((own_ && own_->file == file) || !fs::is_regular_file(file, error)) continue;
        auto held = HeldFile::take(file);
        if (!held && said && !path.empty()) *said = path.filename().string() + " is open in another editor, too";
        if (held && (path.empty() || !fs::exists(path, error) ||
                     fs::last_write_time(file, error) >= fs::last_write_time(path, error)))
            left_ = std::move(held);
    }
    return left_ != nullptr;
}

namespace {

// Removes missing files from a scene and names them: an object keeps its place and its children.
std::string drop_gone_files(nlohmann::json& scene) {
    std::string gone;
    const auto drop = [&](nlohmann::json& from, const std::string& key) {
        const auto found = from.find(key);
        if (found == from.end() || !found->is_string()) return false;
        const fs::path file = found->get<std::string>();
        try {
            find_asset(file);
            return false;
        } catch (const InputError&) {
            gone += (gone.empty() ? "" : ", ") + file.filename().string();
            from.erase(found);
            return true;
        }
    };
    if (!scene.is_object()) return gone;
    if (const auto objects = scene.find("objects"); objects != scene.end() && objects->is_array())
        for (nlohmann::json& object : *objects) {
            if (!object.is_object()) continue;
            drop(object, "model");
            for (const MapSlotInfo& slot : map_slots())
                if (const nlohmann::json::json_pointer maps("/material/maps"); object.contains(maps))
                    drop(object[maps], slot.name);
        }
    for (const char* key : {"environment", "music"})
        if (!drop(scene, key))
            if (const auto found = scene.find(key); found != scene.end() && drop(*found, "image")) scene.erase(found);
    return gone;
}

}  // namespace

Document SceneStore::recover(Said* said) {
    if (!has_recovery()) throw InputError("{}: nothing was left of it", path.string());
    const fs::path copy = path.empty() ? fs::path("untitled.json") : path;
    std::string bytes = read_file(left_->file);
    nlohmann::json scene = nlohmann::json::parse(bytes, nullptr, false);
    if (const std::string gone = drop_gone_files(scene); !gone.empty()) {
        bytes = scene.dump();
        if (said) *said = "restored without files that are gone: " + gone;
    }
    Document document(parse_scene(bytes, copy));
    saved_state_ = 0;  // none of its states is in the file
    includes_.clear();
    own_ = std::move(left_);
    return document;
}

fs::path SceneStore::set_aside() {
    if (!has_recovery()) return {};
    const fs::path kept = move_aside(left_->file);
    left_.reset();
    return kept;
}

void SceneStore::forget_recovery() {
    std::error_code error;
    if (left_ && left_->is_there()) fs::remove(left_->file, error);
    left_.reset();
}

void SceneStore::forget_autosave() {
    std::error_code error;
    if (own_ && own_->is_there()) fs::remove(own_->file, error);
    own_.reset();
    autosaved_state_ = 0;
}

}  // namespace lightwalk
