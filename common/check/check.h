// Checks: the requirements of an exercise, in words a student understands.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "common/check/probe.h"

namespace lightwalk {

class ProbeTables;

/// Collects passes and failures of one exercise.
class Check {
  public:
    int passed = 0, failed = 0;
    int properties = 0;             ///< of the two above
    ProbeTables* tables = nullptr;  ///< that keep each probe
    std::string first_failure;      ///< empty if all is right
    std::string hint;               ///< for that failure; empty: the exercise's
    std::string note;               ///< parts that were skipped; empty: none

    void expect(bool right, const std::string& otherwise, const std::string& hint_for_it = "");
    /// Runs `wrong`, which calls the student's C++ and returns the fault ("" for none). `what` names the call in
    /// messages about a crash, a time-out or an exception.
    void call(const std::string& what, const std::function<std::string()>& wrong, const std::string& hint_for_it = "");
    /// Expects that the time of `run(n)`, which calls the student's C++ with n things, grows as n or n log n, and not as
    /// n squared: for 10 `few` it may be 40 times that for `few` and 25 times that of std::sort for as many numbers, the
    /// fastest of three to six runs each.
    void expect_no_square(const std::string& what, size_t few, const std::function<void(size_t)>& run);
    /// Runs the probe and expects every result within its bound, regardless of the values that undefined operations
    /// return. Returns the results, for properties.
    Table probe(const Probe& probe);
    /// Expects `holds` of every call's input and result; `otherwise` completes "f(...) gave x, ...".
    void property(const Probe& probe, const Table& results, const std::string& otherwise,
                  const std::function<bool(std::span<const double> input, std::span<const double> result)>& holds);
};

struct ExerciseCheck {
    std::string id;    ///< "02.phong"
    std::string hint;  ///< one sentence
    void (*run)(Check& check);
};

/// Every check linked into the program, in the order of their ids.
const std::vector<ExerciseCheck>& all_checks();

/// Runs it on the student's version or the reference, with references for the other exercises. A file that does not
/// compile is a failure with the compiler's text. `tables` keep the probes.
Check run_check(const ExerciseCheck& exercise, bool solution, ProbeTables* tables = nullptr);

/// The device that probes run on: $LIGHTWALK_DEVICE, else the best there is.
Gpu& check_device();
/// Ends with the device's destruction; throws Failure if validation has said something.
void release_check_device();

struct RegisterCheck {
    RegisterCheck(const char* id, const char* hint, void (*run)(Check&));
};

}  // namespace lightwalk

#define LIGHTWALK_JOIN_(a, b) a##b
#define LIGHTWALK_JOIN(a, b) LIGHTWALK_JOIN_(a, b)

/// CHECK_EXERCISE("02.phong", "a hint") { check.probe({...}); }
#define CHECK_EXERCISE(id, hint) LIGHTWALK_CHECK_EXERCISE(id, hint, __COUNTER__)
#define LIGHTWALK_CHECK_EXERCISE(id, hint, number)                                                                     \
    static void LIGHTWALK_JOIN(run_check_, number)(lightwalk::Check & check);                                          \
    static const lightwalk::RegisterCheck LIGHTWALK_JOIN(register_check_, number)(id, hint,                            \
                                                                                  LIGHTWALK_JOIN(run_check_, number)); \
    static void LIGHTWALK_JOIN(run_check_, number)([[maybe_unused]] lightwalk::Check & check)
