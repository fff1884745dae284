#include "common/check/run_checks.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>

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

CheckOptions given;

void print_check(const ExerciseCheck& exercise, const Check& check) {
    nlohmann::ordered_json line = {{"exercise", exercise.id}, {"ok", check.failed == 0},  {"passed", check.passed},
                                   {"failed", check.failed},  {"first_failure", nullptr}, {"hint", nullptr}};
    if (check.failed) {
        line["first_failure"] = check.first_failure;
        line["hint"] = check.hint.empty() ? exercise.hint : check.hint;
    }
    if (!check.note.empty()) line["note"] = check.note;
    if (check.lost) line["lost"] = true;
    if (!check.looked_for) line["looked_for"] = false;
    if (!given.nonce.empty()) line["nonce"] = given.nonce;
    std::printf("%s\n", line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    std::fflush(stdout);
}

bool check(const ExerciseCheck& exercise, bool solution) {
    const auto report = [&exercise](const std::string& message) {
        Check check;
        check.lost = true;
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

// Handles requests on stdin, one per line: {"exercise": id, "variant": C++ answer (variants.h), "overlay": folder that
// replaces shaders}; the last two are optional.
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
    std::string exercise, tables, use = "exercise";
    bool requests = false;
};

int run(int argc, char** argv) {
    Options options;
    CLI::App app("Checks the exercises of a chapter; one JSON object a line");
    app.add_option("--exercise", options.exercise, "NN.name; default: all of the chapter");
    app.add_option("--use", options.use, "whose version")->check(CLI::IsMember({"exercise", "solution"}));
    app.add_option("--tables", options.tables,
                   "write the probes of each check to this folder, for pages, and check nothing");
    app.add_flag("--requests", options.requests, "check what standard input asks for, a line of JSON each");
    app.add_option("--nonce", given.nonce, "for ./course grade: a word that each line repeats");
    app.add_option("--worker", given.worker, "for ./course grade: pipes to the process that has the answer");
    app.add_flag("--strict", given.strict, "an exercise that cannot be instrumented is a failure");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == 0) return app.exit(e);
        throw InputError(e.what());
    }
    // Bounds endless loops of students more tightly than the default minute.
    setenv("LIGHTWALK_TIMEOUT_S", std::to_string(call_limit_s()).c_str(), 0);
    bool ok = true;
    if (options.requests) answer_requests();
    if (!options.exercise.empty()) find_check(options.exercise);
    for (const ExerciseCheck& exercise : all_checks()) {
        if (options.requests || (!options.exercise.empty() && exercise.id != options.exercise)) continue;
        if (options.tables.empty())
            ok = check(exercise, options.use == "solution") && ok;
        else
            write_tables(exercise, options.tables);
    }
    if (!options.tables.empty()) write_undefined(options.tables);
    on_abandoned_device() = nullptr;
    release_check_device();
    return ok ? 0 : 1;
}

}  // namespace

const CheckOptions& check_options() { return given; }

int run_checks(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& e) { return report_exception(e); }
}

}  // namespace lightwalk
