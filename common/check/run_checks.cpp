#include "common/check/run_checks.h"

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <span>

#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/base/text.h"
#include "common/check/check.h"
#include "common/check/guard.h"
#include "common/check/tables.h"
#include "common/check/variants.h"
#include "common/gpu/gpu.h"

namespace lightwalk {
namespace {

void print_check(const ExerciseCheck& exercise, const Check& check) {
    nlohmann::ordered_json line = {{"exercise", exercise.id}, {"ok", check.failed == 0},  {"passed", check.passed},
                                   {"failed", check.failed},  {"first_failure", nullptr}, {"hint", nullptr}};
    if (check.failed) {
        line["first_failure"] = check.first_failure;
        line["hint"] = check.hint.empty() ? exercise.hint : check.hint;
    }
    if (!check.note.empty()) line["note"] = check.note;
    // The grader's, which says that this line is of this program.
    if (const char* nonce = std::getenv("LIGHTWALK_NONCE")) line["nonce"] = nonce;
    std::printf("%s\n", line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    std::fflush(stdout);
}

/// Prints the verdict, which a crash has as well. Returns whether it is right.
bool check(const ExerciseCheck& exercise, bool solution) {
    const auto report = [&exercise](const std::string& message) {
        Check check;
        check.expect(false, message, "try that one call on paper, line by line");
        print_check(exercise, check);
    };
    on_abandoned_device() = report;
    guard_calls(report);
    const Check check = run_check(exercise, solution);
    print_check(exercise, check);
    return check.failed == 0;
}

const ExerciseCheck& find_check(const std::string& id) {
    for (const ExerciseCheck& exercise : all_checks())
        if (exercise.id == id) return exercise;
    throw InputError("no check of an exercise '" + id + "' here");
}

/// Checks an exercise for each line of standard input: {"exercise": its id, "variant": a C++ answer (variants.h), "overlay":
/// a folder of shaders in place of the tree's}; the last two may be missing.
void answer_requests() {
    for (std::string line; std::getline(std::cin, line);) {
        const nlohmann::json request = nlohmann::json::parse(line);
        if (request.contains("variant")) choose_variant(request["variant"]);
        if (request.contains("overlay")) {
            setenv("LIGHTWALK_OVERLAY", std::string(request["overlay"]).c_str(), 1);
            check_device().pipelines.clear();
            Exercises::shaders_were_edited();
        }
        check(find_check(request["exercise"]), false);
    }
}

struct Options {
    std::string exercise, tables;
    bool solution = false, requests = false;
};

Options parse(std::span<char*> words) {
    Options options;
    for (size_t i = 1; i < words.size(); ++i) {
        const std::string word = words[i], value = i + 1 < words.size() ? words[i + 1] : "";
        if (word == "--requests") {
            options.requests = true;
            continue;
        }
        if (word == "--exercise" && !value.empty())
            options.exercise = value;
        else if (word == "--tables" && !value.empty())
            options.tables = value;
        else if (word == "--use" && (value == "exercise" || value == "solution"))
            options.solution = value == "solution";
        else
            throw InputError(
                "'{} {}'; usage: check_NN_name [--exercise NN.name] [--use exercise|solution] [--tables FOLDER, which "
                "gets "
                "the probes of each check, for pages] [--requests, which takes them from standard input]",
                word, value);
        ++i;
    }
    return options;
}

int run(const Options& options) {
    // A student's loop without an end must not hold everything up for a minute.
    setenv("LIGHTWALK_TIMEOUT_S", std::to_string(call_limit_s()).c_str(), 0);
    bool ok = true;
    if (options.requests) answer_requests();
    if (!options.exercise.empty()) find_check(options.exercise);
    for (const ExerciseCheck& exercise : all_checks()) {
        if (options.requests || (!options.exercise.empty() && exercise.id != options.exercise)) continue;
        if (options.tables.empty())
            ok = check(exercise, options.solution) && ok;
        else
            write_tables(exercise, options.tables);
    }
    if (!options.tables.empty()) write_undefined(options.tables);
    on_abandoned_device() = nullptr;
    release_check_device();
    return ok ? 0 : 1;
}

}  // namespace

int run_checks(int argc, char** argv) {
    try {
        return run(parse({argv, static_cast<size_t>(argc)}));
    } catch (const std::exception& e) { return report_exception(e); }
}

}  // namespace lightwalk
