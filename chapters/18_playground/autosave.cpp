// Autosaves: unsaved changes, beside a person's scene or in the state folder for one of the course's tree, and their recovery.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "18_playground/saving.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/own_files.h"
#include "common/scene/scene.h"

namespace lightwalk {
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
