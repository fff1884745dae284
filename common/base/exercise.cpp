#include "common/base/exercise.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "common/base/epoch.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/names.h"
#include "common/base/text.h"

namespace lightwalk {
namespace {

struct State {
    bool has_solution = true, solution = true, compiles = true, told = false;
};

struct Table {
    std::map<std::string, State, std::less<>> exercises;
    std::string state;
    bool scanned = false;
    uint64_t edited = 0;            ///< epoch of the last edit of a shader
    std::optional<uint64_t> epoch;  ///< of the state and the edits; none: to be computed
    void changed() {
        state.clear();
        epoch.reset();
    }
};

// Function-local, because toggles register during static initialisation.
Table& table() {
    static Table instance;
    return instance;
}

// Whether a file among the exercises is one: in tests/starters.txt, or of a chapter that has none there, a new one.
bool is_listed(const std::filesystem::path& file) {
    static const std::string list = [] {
        const auto path = course_root() / "tests" / "starters.txt";
        return file_exists(path) ? read_file(path) : std::string();
    }();
    const std::string chapter = file.parent_path().parent_path().filename().string();
    return list.find("/" + chapter + "/exercise/" + file.filename().string() + "\n") != list.npos ||
           list.find("/" + chapter + "/exercise/") == list.npos;
}

// Adds undeclared exercises: GLSL, and C++ of chapters that are not linked.
void scan(const char* folder, const char* extension) {
    namespace fs = std::filesystem;
    std::error_code none;
    for (const auto& chapter : fs::directory_iterator(course_root() / folder, none)) {
        if (!fs::is_directory(chapter.path() / "exercise")) continue;
        for (const auto& file : fs::directory_iterator(chapter.path() / "exercise")) {
            if (file.path().extension() != extension || !is_listed(file.path())) continue;
            const std::string id = chapter.path().filename().string().substr(0, 2) + "." + file.path().stem().string();
            const State found{.has_solution = fs::exists(chapter.path() / "solution" / file.path().filename())};
            table().exercises.try_emplace(id, found);
        }
    }
}

Table& scanned_table() {
    Table& t = table();
    if (t.scanned) return t;
    t.scanned = true;
    scan("shaders", ".glsl");
    scan("chapters", ".cpp");
    return t;
}

State& find(std::string_view id) {
    auto& exercises = scanned_table().exercises;
    if (const auto it = exercises.find(id); it != exercises.end()) return it->second;
    std::vector<std::string> known;
    for (const auto& [name, state] : exercises) known.push_back(name);
    throw unknown_name("exercise", id, known, "--list exercises lists all");
}

// Position of the heading "### 02.phong (medium)" in the lesson; exercises without one come last.
size_t place_in_lesson(const std::string& id) {
    namespace fs = std::filesystem;
    std::error_code none;
    for (const auto& file : fs::directory_iterator(course_root() / "docs", none))
        if (file.path().extension() == ".md" && file.path().filename().string().starts_with(id.substr(0, 2) + "_"))
            return read_file(file.path()).find("\n### " + id + " (");
    return std::string::npos;
}

bool is_solution(std::string_view word) {
    if (word == "solution") return true;
    if (word == "exercise") return false;
    throw InputError("--use: '{}' is neither 'solution' nor 'exercise'", word);
}

}  // namespace

bool Exercises::uses_solution(std::string_view id) {
    const State& state = find(id);
    return state.solution && state.has_solution;
}

void Exercises::use(std::string_view which) {
    for (size_t begin = 0; begin <= which.size();) {
        const size_t end = std::min(which.find(',', begin), which.size());
        const std::string_view item = which.substr(begin, end - begin);
        begin = end + 1;
        if (const size_t equals = item.find('='); equals != item.npos) {
            set(item.substr(0, equals), is_solution(item.substr(equals + 1)));
            continue;
        }
        const bool solution = is_solution(item);
        for (auto& [id, state] : scanned_table().exercises) state.solution = solution;
        table().changed();
    }
}

void Exercises::set(std::string_view id, bool solution) {
    find(id).solution = solution;
    table().changed();
}

std::vector<std::string> Exercises::ids() {
    static std::map<std::string, size_t, std::less<>> places;  // cached: lessons do not change at run time
    std::vector<std::string> result;
    for (const auto& [id, state] : scanned_table().exercises) {
        result.push_back(id);
        if (!places.contains(id)) places[id] = place_in_lesson(id);
    }
    std::ranges::stable_sort(result, {},
                             [](const std::string& id) { return std::pair(id.substr(0, 2), places.at(id)); });
    return result;
}

bool Exercises::has_solution(std::string_view id) { return find(id).has_solution; }

void Exercises::declare(std::string_view id, bool has_solution, bool compiles) {
    State& state = table().exercises[std::string(id)];
    state.has_solution = has_solution;
    state.compiles = compiles;
}

bool Exercises::compiles(std::string_view id) { return find(id).compiles; }

void Exercises::stand_in(std::string_view id) {
    State& state = find(id);
    const std::string what = std::string(id) + " does not compile";
    if (!state.has_solution) throw InputError(what + ": ./course check " + std::string(id) + " says why");
    if (!state.told) warn("{}; the reference stands in for it", what);
    state.told = true;
}

uint64_t Exercises::epoch() {
    Table& t = table();
    if (!t.epoch) t.epoch = hash_of(state(), t.edited);
    return *t.epoch;
}

void Exercises::shaders_were_edited() {
    table().edited = Epoch::next();
    table().epoch.reset();
}

const std::string& Exercises::state() {
    Table& t = scanned_table();
    if (t.state.empty()) {
        t.state = "=";
        for (const auto& [id, state] : t.exercises) t.state += state.solution && state.has_solution ? 's' : 'e';
    }
    return t.state;
}

}  // namespace lightwalk
