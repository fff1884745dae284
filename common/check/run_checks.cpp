#include "common/check/run_checks.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/base/text.h"
#include "common/check/check.h"
#include "common/check/guard.h"
#include "common/check/tables.h"
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
    if (!given.nonce.empty()) line["nonce"] = given.nonce;
    std::printf("%s\n", line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    std::fflush(stdout);
}

int run(int argc, char** argv) {
    CLI::App app("Checks the exercises of a chapter; one JSON object a line");
    std::string wanted, use = "exercise", tables;
    app.add_option("--exercise", wanted, "NN.name; default: all of the chapter");
    app.add_option("--use", use, "whose version")->check(CLI::IsMember({"exercise", "solution"}));
    app.add_option("--tables", tables, "write the probes of each check to this folder, for pages, and check nothing");
    app.add_option("--nonce", given.nonce, "for ./course grade: a word that each line repeats");
    app.add_option("--worker", given.worker, "for ./course grade: pipes to the process that has the answer");
    app.add_option("--probe-log", given.probe_log, "append a hash of each probe's results to this file");
    app.add_flag("--strict", given.strict, "an exercise that cannot be instrumented is a failure");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == 0) return app.exit(e);
        throw InputError(e.what());
    }
    // A student's loop without an end must not hold everything up for a minute.
    setenv("LIGHTWALK_TIMEOUT_S", std::to_string(call_limit_s()).c_str(), 0);
    bool found = false, ok = true;
    for (const ExerciseCheck& exercise : all_checks()) {
        if (!wanted.empty() && exercise.id != wanted) continue;
        found = true;
        if (!tables.empty()) {
            write_tables(exercise, tables);
            continue;
        }
        const auto report = [&exercise](const std::string& message) {
            Check check;
            check.expect(false, message, "try that one call on paper, line by line");
            print_check(exercise, check);
        };
        on_abandoned_device() = report;
        guard_calls(report);
        const Check check = run_check(exercise, use == "solution");
        print_check(exercise, check);
        ok = ok && check.failed == 0;
    }
    if (!tables.empty()) write_undefined(tables);
    on_abandoned_device() = nullptr;
    release_check_device();
    if (!found) throw InputError("no check of an exercise '" + wanted + "' here");
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
