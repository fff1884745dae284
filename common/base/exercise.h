// Exercises and their toggles between the student's version and the solution.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lightwalk {

class Exercises {
  public:
    /// True if the solution of `id` is in use; always false in trees without solutions.
    static bool uses_solution(std::string_view id);

    /// Parses --use: "solution", "exercise", or a list in which later items take precedence, such as
    /// "exercise,03.point_attenuation=solution". Throws InputError, listing the ids, if one is unknown.
    static void use(std::string_view which);
    static void set(std::string_view id, bool solution);

    /// Ids in lesson order, from the `exercise` folders of chapters and shaders.
    static std::vector<std::string> ids();

    /// False in handouts.
    static bool has_solution(std::string_view id);

    /// Registers a C++ exercise. `compiles`: whether the student's file compiled.
    static void declare(std::string_view id, bool has_solution, bool compiles);

    /// False if the student's C++ file did not compile; the solution then runs instead.
    static bool compiles(std::string_view id);

    /// Warns once that the solution replaces a file that did not compile. Throws InputError without a solution.
    static void stand_in(std::string_view id);

    /// All toggle states as text, for cache keys.
    static const std::string& state();

    /// Number for the exercises in use and the edits of shaders: the same again when a toggle is set back, so that a split
    /// view, which sets toggles in every frame, remakes nothing.
    static uint64_t epoch();

    /// Changes epoch() after a GLSL edit, so that tables and maps computed by shaders are updated.
    static void shaders_were_edited();
};

template <class Signature>
class Toggle;

template <class Result, class... Arguments>
class Toggle<Result(Arguments...)> {
  public:
    using Function = Result (*)(Arguments...);
    Toggle(const char* id, Function exercise, Function solution) : id_(id), exercise_(exercise), solution_(solution) {
        Exercises::declare(id, solution != nullptr, exercise != nullptr);
    }
    /// Version in use. Hoist out of loops with millions of calls.
    Function function() const {
        if (solution_ && Exercises::uses_solution(id_)) return solution_;
        if (exercise_) return exercise_;
        Exercises::stand_in(id_);
        return solution_;
    }
    Result operator()(Arguments... arguments) const { return function()(static_cast<Arguments&&>(arguments)...); }

  private:
    const char* id_;
    Function exercise_, solution_;
};

}  // namespace lightwalk

#ifdef LIGHTWALK_NO_SOLUTION
#define LIGHTWALK_SOLUTION(name) nullptr
#else
#define LIGHTWALK_SOLUTION(name) &solution::name
#endif

/// Declares exercise::name, solution::name and the toggle `name`, within namespace lightwalk. The exercise is a weak
/// symbol, null if the student's file did not compile.
///
///     EXERCISE("01.triangulate", void, triangulate, int a, int b);
#define EXERCISE(id, result, name, ...)     \
    namespace exercise {                    \
    [[gnu::weak]] result name(__VA_ARGS__); \
    }                                       \
    namespace solution {                    \
    result name(__VA_ARGS__);               \
    }                                       \
    inline const Toggle<result(__VA_ARGS__)> name { id, &exercise::name, LIGHTWALK_SOLUTION(name) }
