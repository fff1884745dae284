// Exercises and their toggles: which version of each, the student's or the reference, is in use.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lightwalk {

/// The state of every toggle. An exercise is known by its id, "NN.name".
class Exercises {
  public:
    /// True if the reference of `id` is in use. In a tree without solutions it is always false.
    static bool uses_solution(std::string_view id);

    /// Parses --use: "solution", "exercise", or a list in which later items overrule earlier ones, such as
    /// "exercise,03.point_attenuation=solution". Throws InputError and lists the ids if one is unknown.
    static void use(std::string_view which);
    static void set(std::string_view id, bool solution);

    /// Every id, in the lessons' order: the files in the folders `exercise` of all chapters and of their shaders.
    static std::vector<std::string> ids();

    /// False in a handout: there is no solution to switch to.
    static bool has_solution(std::string_view id);

    /// Makes a C++ exercise known; Toggle calls it. `compiles`: whether the student's file did.
    static void declare(std::string_view id, bool has_solution, bool compiles);

    /// False if the file of a C++ exercise did not compile; the reference replaces it.
    static bool compiles(std::string_view id);

    /// For a C++ exercise that is called though its file did not compile: says so, once for each. Without a reference
    /// it throws InputError.
    static void stand_in(std::string_view id);

    /// The state of all toggles as one word, a key for results that depend on them.
    static const std::string& state();

    /// Epoch of the last change of a toggle, or edit of a shader.
    static uint64_t epoch();

    /// Notes that a GLSL file changed while the program runs: epoch() rises, so that results made once by a shader (a table,
    /// a filtered cube, a shadow map) are recomputed.
    static void shaders_were_edited();
};

template <class Signature>
class Toggle;

/// A C++ exercise: two functions of one signature. Calling it calls the one in use.
template <class Result, class... Arguments>
class Toggle<Result(Arguments...)> {
  public:
    using Function = Result (*)(Arguments...);
    Toggle(const char* id, Function exercise, Function solution) : id_(id), exercise_(exercise), solution_(solution) {
        Exercises::declare(id, solution != nullptr, exercise != nullptr);
    }
    /// The version in use. Look it up once before a loop over millions of calls.
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

/// Declares exercise::name and solution::name and the toggle `name` that calls one of them, within namespace
/// lightwalk. The exercise is a weak symbol, null if the student's file did not compile.
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
