#include "common/window/exercise_checks.h"

#include <fmt/core.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/window/event_log.h"

namespace lightwalk {

namespace {

using Json = nlohmann::json;

constexpr const char* state_names[] = {"running", "passed", "open", "invalid", "failed"};

std::string text_of(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

int number_of(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_number_integer() ? found->get<int>() : 0;
}

}  // namespace

CheckVerdict read_check(const std::string& exercise, const std::string& said, int code) {
    CheckVerdict check{.state = CheckVerdict::State::failed};
    std::istringstream lines(said);
    for (std::string line; std::getline(lines, line);) {
        const Json verdict = line.starts_with('{') ? Json::parse(line, nullptr, false) : Json();
        if (!verdict.is_object() || text_of(verdict, "exercise") != exercise) {
            check.words += line + "\n";
            continue;
        }
        check.passed = number_of(verdict, "passed");
        check.cases = check.passed + number_of(verdict, "failed");
        check.words = text_of(verdict, "first_failure");
        check.state = code == 0                                        ? CheckVerdict::State::passed
                      : check.words.starts_with("it does not compile") ? CheckVerdict::State::invalid
                                                                       : CheckVerdict::State::open;
        check.hint = code == 0 ? "" : text_of(verdict, "hint");
        if (const std::string note = text_of(verdict, "note"); !note.empty())
            check.words += (check.words.empty() ? "" : "\n") + note;
        return check;
    }
    while (check.words.ends_with('\n')) check.words.pop_back();
    if (check.words.empty()) check.words = "./course check ended with code " + std::to_string(code);
    return check;
}

void ExerciseChecks::start(const std::string& exercise) {
    jobs_.erase(exercise);  // two at once would say the same of two versions of the file
    CheckVerdict& check = checks_[exercise] = {.of = answer_digest(exercise)};
    try {
        jobs_[exercise] = std::make_unique<ChildProcess>(
            course_root() / "course", std::vector<std::string>{"check", exercise, "--json"}, ChildProcess::Kind::job);
    } catch (const Failure& e) {
        jobs_.erase(exercise);
        check = {.state = CheckVerdict::State::failed, .of = check.of, .words = e.what()};
    }
    log_event("check " + exercise + " " + state_names[static_cast<int>(check.state)]);
}

bool ExerciseChecks::poll() {
    bool ended = false;
    for (auto job = jobs_.begin(); job != jobs_.end();) {
        const std::optional<int> code = job->second->poll();
        if (!code) {
            ++job;
            continue;
        }
        CheckVerdict& check = checks_[job->first];
        const uint64_t of = check.of;
        check = read_check(job->first, job->second->said(), *code);
        check.of = of;
        log_event("check " + job->first + " " + state_names[static_cast<int>(check.state)]);
        job = jobs_.erase(job);
        ended = true;
    }
    return ended;
}

const CheckVerdict* ExerciseChecks::find(const std::string& exercise) const {
    const auto found = checks_.find(exercise);
    return found == checks_.end() ? nullptr : &found->second;
}

namespace {

namespace fs = std::filesystem;

// Ignores white space, since editors change line ends.
uint64_t digest_of(const fs::path& file) {
    std::string text = read_file(file);
    std::erase_if(text, [](char c) { return std::string_view(" \t\n\r\v\f").find(c) != std::string_view::npos; });
    return hash_bytes(text);
}

struct Starter {
    fs::path file;
    uint64_t digest = 0;
    fs::file_time_type written{};
    uintmax_t bytes = 0;
    uint64_t answer = 0;
};

// Lines of tests/starters.txt: hexadecimal digest and path NN_name/exercise/name.
std::map<std::string, Starter, std::less<>> read_starters() {
    std::map<std::string, Starter, std::less<>> found;
    const fs::path list = course_root() / "tests" / "starters.txt";
    if (!file_exists(list)) return found;
    std::istringstream lines(read_file(list));
    for (std::string digest, name; lines >> digest >> name;) {
        const fs::path file(name), chapter = file.parent_path().parent_path().filename();
        found[chapter.string().substr(0, 2) + "." + file.stem().string()] = {
            .file = course_root() / file, .digest = std::strtoull(digest.c_str(), nullptr, 16)};
    }
    return found;
}

std::map<std::string, Starter, std::less<>>& all_starters() {
    static auto starters = read_starters();
    return starters;
}

const Starter* find(std::string_view id) {
    auto& starters = all_starters();
    const auto found = starters.find(id);
    if (found == starters.end()) return nullptr;
    Starter& starter = found->second;
    std::error_code gone;
    const auto written = fs::last_write_time(starter.file, gone);
    const uintmax_t bytes = gone ? 0 : fs::file_size(starter.file, gone);
    if (!gone && written == starter.written && bytes == starter.bytes) return &starter;
    try {
        starter.answer = digest_of(starter.file);
        starter.written = written;
        starter.bytes = bytes;
    } catch (const InputError&) { starter.answer = 0; }
    return &starter;
}

}  // namespace

uint64_t answer_digest(std::string_view id) {
    const Starter* starter = find(id);
    return starter ? starter->answer : 0;
}

// The file that common/course/check/verdicts.py writes, read again when it has changed.
std::optional<bool> kept_verdict(std::string_view id) {
    static Json known;
    static fs::file_time_type read{};
    const fs::path file = course_root() / "build" / "live" / "verdicts.json";
    std::error_code gone;
    const auto written = fs::last_write_time(file, gone);
    if (gone) return {};
    if (std::exchange(read, written) != written) try {
            known = Json::parse(read_file(file), nullptr, false);
        } catch (const InputError&) { known = {}; }
    const auto found = known.is_object() ? known.find(std::string(id)) : known.end();
    if (found == known.end() || !found->is_object()) return {};
    const uint64_t digest = answer_digest(id);
    if (digest == 0 || text_of(*found, "of") != fmt::format("{:016x}", digest)) return {};
    const auto ok = found->find("ok");
    return ok != found->end() && *ok == true;
}

Solved solved_of(std::string_view chapter) {
    Solved count;
    for (const auto& [id, starter] : all_starters())
        if (starter.file.parent_path().parent_path().filename() == chapter) {
            ++count.exercises;
            count.solved += kept_verdict(id).value_or(false);
        }
    return count;
}

bool is_untouched(std::string_view id) {
    const Starter* starter = find(id);
    return starter && starter->answer == starter->digest;
}

}  // namespace lightwalk
