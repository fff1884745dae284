#include "common/window/exercise_checks.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/starters.h"
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

}  // namespace lightwalk
