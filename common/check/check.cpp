#include "common/check/check.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <memory>
#include <random>

#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/check/guard.h"
#include "common/check/tables.h"
#include "common/check/undefined.h"
#include "common/gpu/glsl.h"

namespace lightwalk {
namespace {

std::vector<ExerciseCheck>& registry() {
    static std::vector<ExerciseCheck> list;
    return list;
}

// Never destroyed implicitly: NVIDIA's driver is unloaded by exit handlers before static destructors run.
std::unique_ptr<Gpu>& device() {
    static auto& gpu = *new std::unique_ptr<Gpu>;
    return gpu;
}

std::string device_name() {
    const char* value = std::getenv("LIGHTWALK_DEVICE");
    return value ? value : "";
}

double seconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double sorting_s(size_t count) {
    std::mt19937 engine;
    std::vector<double> numbers(count);
    for (double& number : numbers) number = double(engine());
    return seconds([&] { std::sort(numbers.begin(), numbers.end()); });
}

}  // namespace

RegisterCheck::RegisterCheck(const char* id, const char* hint, void (*run)(Check&)) {
    auto& list = registry();
    list.push_back({id, hint, run});
    std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
}

const std::vector<ExerciseCheck>& all_checks() { return registry(); }

Gpu& check_device() {
    if (!device()) device() = std::make_unique<Gpu>(DeviceOptions{.name = device_name(), .surface_extensions = {}});
    return *device();
}

void release_check_device() {
    if (!device()) return;
    device()->device.check_validation();
    device().reset();
}

void Check::expect(bool right, const std::string& otherwise, const std::string& hint_for_it) {
    ++(right ? passed : failed);
    if (right || !first_failure.empty()) return;
    first_failure = otherwise;
    hint = hint_for_it;
}

void Check::call(const std::string& what, const std::function<std::string()>& wrong, const std::string& hint_for_it) {
    std::string found;
    guard_call(what);
    try {
        found = wrong();
    } catch (const Lost& e) { found = e.what(), lost = true; } catch (const std::bad_alloc&) {
        found = what + " threw an exception: std::bad_alloc, there is no more memory";
        lost = true;
    } catch (const std::exception& e) { found = what + " threw an exception: " + e.what(); }
    guard_call("");
    expect(found.empty(), found, hint_for_it);
}

void Check::expect_no_square(const std::string& what, size_t few, const std::function<void(size_t)>& run) {
    const auto run_s = [&](size_t n) {
        return seconds([&] {
            call(fmt::format("{} of {}", what, n), [&] {
                run(n);
                return std::string();
            });
        });
    };
    // Interleaved, so that other load affects all three equally. At least three rounds to pass, six to fail.
    const double noise_s = 0.005, most_growth = 40, most_sorts = 25;
    double few_s = std::numeric_limits<double>::infinity(), many_s = few_s, sort_s = few_s;
    const auto grows_evenly = [&] { return many_s < most_growth * few_s + noise_s; };
    const auto is_quick = [&] { return many_s < most_sorts * sort_s + noise_s; };
    for (int round = 0; round < 6 && !(round >= 3 && grows_evenly() && is_quick()); ++round) {
        few_s = std::min(few_s, run_s(few));
        if (failed == 0) many_s = std::min(many_s, run_s(10 * few));
        if (failed > 0) return;
        sort_s = std::min(sort_s, sorting_s(10 * few));
    }
    const std::string took = fmt::format("{} took {:.2g} s for {}", what, many_s, 10 * few);
    expect(grows_evenly(),
           fmt::format("{}, and {:.2g} s for {}: its time grows with the square of their number", took, few_s, few));
    // Detects idle waiting that hides the growth.
    expect(is_quick(), fmt::format("{}, {:.0f} times as long as std::sort takes for as many numbers: its time grows "
                                   "with the square of their number, or it waits",
                                   took, many_s / sort_s));
}

void Check::expect_quick(const std::string& what, const std::string& of, double times, double most_s,
                         const std::function<void()>& work, const std::string& hint_for_it) {
    constexpr size_t sorted = 500000;
    constexpr double sorting_there_s = 0.045;  // of so many numbers, on the machine that limits are measured on
    double work_s = 0, sort_s = std::numeric_limits<double>::infinity(), slower = 1;
    const auto is_quick = [&] { return times * work_s < slower * most_s; };
    for (int round = 0; round < 8 && !(round >= 2 && is_quick()) && times * work_s < 4 * slower * most_s; ++round) {
        const double took_s = seconds([&] {
            call(what, [&] {
                work();
                return std::string();
            });
        });
        work_s = round == 0 ? took_s : std::min(work_s, took_s);
        if (failed > 0) return;
        sort_s = std::min(sort_s, sorting_s(sorted));
        slower = std::max(sort_s / sorting_there_s, 1.0);
    }
    expect(
        is_quick(),
        fmt::format("{} took {:.3f} s: {} would take {:.0f} s, and may take {:.0f} s here, where a sort takes {:.1f} "
                    "times as long as on the machine for which {:.0f} s are stated",
                    what, work_s, of, times * work_s, slower * most_s, slower, most_s),
        hint_for_it);
}

Table Check::probe(const Probe& probe) {
    if (probe.inputs.empty()) throw Failure("a probe without inputs proves nothing: " + probe.signature);
    const size_t outputs = probe.truth(probe.inputs[0]).size();
    const Table results = run_probe(check_device(), probe, outputs);
    if (tables) tables->add(probe, results);
    // Undefined operations are errors if the function's result depends on them.
    std::map<size_t, const Undefined*> open;
    const std::optional<std::vector<Undefined>> searched = run_undefined(check_device(), probe, outputs);
    looked_for = searched.has_value();
    if (!looked_for)
        note = "operations that GLSL leaves undefined were not looked for in " + probe.include +
               ": the check cannot follow how it is written, a macro with half an expression perhaps";
    const std::vector<Undefined> undefined = searched.value_or(std::vector<Undefined>());  // `open` points into it
    for (const Undefined& one : undefined)
        if (counts_always(one.what) || !is_right(probe, probe.inputs[one.row], one.result)) open.emplace(one.row, &one);
    for (size_t row = 0; row < results.size(); ++row) {
        const Row truth = probe.truth(probe.inputs[row]);
        if (const auto found = open.find(row); found != open.end()) {
            const Undefined& one = *found->second;
            expect(
                false,
                call_text(probe, probe.inputs[row]) + " " + undefined_words(one.what, one.a, one.b) +
                    ". GLSL leaves open what that gives: it differs from device to device. Expected " +
                    result_text(probe, truth),
                "look for this case before the operation, and return there what is right; what max or clamp makes of "
                "an undefined number is undefined too");
        } else {
            const bool right = is_right(probe, probe.inputs[row], results[row]);
            expect(right, right ? "" : wrong_text(probe, row, results[row]),
                   right || !probe.hint ? "" : probe.hint(probe.inputs[row], results[row]));
        }
    }
    return results;
}

void Check::property(const Probe& probe, const Table& results, const std::string& otherwise,
                     const std::function<bool(std::span<const double>, std::span<const double>)>& holds) {
    ++properties;
    for (size_t i = 0; i < results.size(); ++i)
        if (!holds(probe.inputs[i], tables ? probe.truth(probe.inputs[i]) : results[i])) {
            if (tables) {
                tables->add_other();
                break;
            }
            expect(false,
                   call_text(probe, probe.inputs[i]) + " gave " + result_text(probe, results[i]) + ", " + otherwise);
            return;
        }
    expect(true, "");
}

Check run_check(const ExerciseCheck& exercise, bool solution, ProbeTables* tables) {
    Check check;
    check.tables = tables;
    Exercises::use("solution");
    Exercises::set(exercise.id, solution);
    try {
        if (!solution && !Exercises::compiles(exercise.id)) {
            check.expect(false, "it does not compile", "begin with the first error; the others may follow from it");
            return check;
        }
        exercise.run(check);
        if (check.passed + check.failed == 0) check.expect(false, "the check of " + exercise.id + " checked nothing");
    } catch (const ShaderError& e) { check.expect(false, e.what()); } catch (const std::exception& e) {
        check.expect(false, e.what());
        check.lost = true;
    }
    return check;
}

}  // namespace lightwalk
