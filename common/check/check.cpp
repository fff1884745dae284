#include "common/check/check.h"

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "common/base/error.h"
#include "common/base/exercise.h"

namespace lightwalk {
namespace {

std::vector<ExerciseCheck>& registry() {
    static std::vector<ExerciseCheck> list;
    return list;
}

std::unique_ptr<Gpu>& device() {
    static std::unique_ptr<Gpu> gpu;
    return gpu;
}

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

}  // namespace

RegisterCheck::RegisterCheck(const char* id, const char* hint, void (*run)(Check&)) {
    auto& list = registry();
    list.push_back({id, hint, run});
    std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
}

const std::vector<ExerciseCheck>& all_checks() { return registry(); }

Gpu& check_device() {
    if (!device())
        device() = std::make_unique<Gpu>(DeviceOptions{.name = environment("LIGHTWALK_DEVICE"),
                                                       .validate = environment("LIGHTWALK_VALIDATE") == "on",
                                                       .surface_extensions = {}});
    return *device();
}

void release_check_device() {
    if (!device()) return;
    device()->device.check_validation();
    device().reset();
}

void Check::expect(bool right, const std::string& otherwise) {
    ++(right ? passed : failed);
    if (!right && first_failure.empty()) first_failure = otherwise;
}

void Check::add(const std::vector<std::string>& failures) {
    if (failures.empty()) ++passed;
    for (const std::string& failure : failures) expect(false, failure);
}

Table Check::probe(const Probe& probe) {
    if (probe.inputs.empty()) throw Failure("a probe without inputs proves nothing: " + probe.signature);
    const Table results = run_probe(check_device(), probe, probe.truth(probe.inputs[0]).size());
    const std::string worst = worst_of(probe, results);
    expect(worst.empty(), worst);
    return results;
}

void Check::property(const Probe& probe, const Table& results, const std::string& otherwise,
                     const std::function<bool(std::span<const double>, std::span<const double>)>& holds) {
    for (size_t i = 0; i < results.size(); ++i)
        if (!holds(probe.inputs[i], results[i])) {
            expect(false, call_text(probe, probe.inputs[i]) + " gave " + number_text(results[i][0]) + ", " + otherwise);
            return;
        }
    expect(true, "");
}

Check run_check(const ExerciseCheck& exercise, bool solution) {
    Check check;
    Exercises::use("solution");
    Exercises::set(exercise.id, solution);
    try {
        exercise.run(check);
        if (check.passed + check.failed == 0) check.expect(false, "the check of " + exercise.id + " checked nothing");
    } catch (const std::exception& e) { check.expect(false, e.what()); }
    return check;
}

}  // namespace lightwalk
