// Checks of exercises.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "common/check/probe.h"

namespace lightwalk {

class ProbeTables;

class Check {
  public:
    int passed = 0, failed = 0;
    int properties = 0;  ///< included in `passed` and `failed`
    ProbeTables* tables = nullptr;
    std::string first_failure;
    std::string hint;  ///< hint for first_failure; empty: the exercise's
    std::string note;
    bool lost = false;       ///< the verdict rests on a process that ended or was late, or on an error of the system
    bool looked_for = true;  ///< false if operations that GLSL leaves undefined were not searched for

    void expect(bool right, const std::string& otherwise, const std::string& hint_for_it = "");
    /// Runs `wrong`: student C++ that returns an error message or "". `what` names it after a crash or time-out.
    void call(const std::string& what, const std::function<std::string()>& wrong, const std::string& hint_for_it = "");
    /// Expects run(n) to take O(n log n) time: 10 × `few` items at most 40 × as long, and at most 25 × std::sort.
    void expect_no_square(const std::string& what, size_t few, const std::function<void(size_t)>& run);
    /// Expects work() to take `most_s` of processor time on the machine that the course is measured on, by the ratio
    /// to std::sort in turns with it: other load slows both. `of` completes "{what} took ...".
    void expect_quick(const std::string& what, const std::string& of, double times, double most_s,
                      const std::function<void()>& work, const std::string& hint_for_it);
    /// Expects all results within the bound, whatever undefined operations return. Returns the results.
    Table probe(const Probe& probe);
    /// Expects `holds` for every call; `otherwise` completes "f(...) gave x, ...".
    void property(const Probe& probe, const Table& results, const std::string& otherwise,
                  const std::function<bool(std::span<const double> input, std::span<const double> result)>& holds);
};

struct ExerciseCheck {
    std::string id;
    std::string hint;
    void (*run)(Check& check);
};

const std::vector<ExerciseCheck>& all_checks();

/// Checks the student's version or the solution; other exercises use solutions. `tables` records the probes.
Check run_check(const ExerciseCheck& exercise, bool solution, ProbeTables* tables = nullptr);

/// Device for probes: $LIGHTWALK_DEVICE, else the best one.
Gpu& check_device();
/// Destroys the device. Throws Failure if there were validation messages.
void release_check_device();

struct RegisterCheck {
    RegisterCheck(const char* id, const char* hint, void (*run)(Check&));
};

}  // namespace lightwalk

#define LIGHTWALK_JOIN_(a, b) a##b
#define LIGHTWALK_JOIN(a, b) LIGHTWALK_JOIN_(a, b)

/// Example: CHECK_EXERCISE("02.phong", "a hint") { check.probe({...}); }
#define CHECK_EXERCISE(id, hint) LIGHTWALK_CHECK_EXERCISE(id, hint, __COUNTER__)
#define LIGHTWALK_CHECK_EXERCISE(id, hint, number)                                                                     \
    static void LIGHTWALK_JOIN(run_check_, number)(lightwalk::Check & check);                                          \
    static const lightwalk::RegisterCheck LIGHTWALK_JOIN(register_check_, number)(id, hint,                            \
                                                                                  LIGHTWALK_JOIN(run_check_, number)); \
    static void LIGHTWALK_JOIN(run_check_, number)([[maybe_unused]] lightwalk::Check & check)
