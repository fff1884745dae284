// The grader's side of a student's C++: the check program calls an exercise as ever, and the call goes to another
// process, which has the student's code, and no reference and no truth to measure by.
//
// Included before a chapter's exercises.h, in a file of its own (common/build.cmake makes it): there EXERCISE and TRIAL
// define each function as one that asks.
#pragma once
#include "common/base/exercise.h"
#include "common/check/guard.h"
#include "common/check/trial.h"
#include "common/judge/wire.h"

namespace lightwalk {

/// Result of a call, with the final values of its non-const arguments. Rethrows the student's exceptions (InputError
/// as such, others as std::runtime_error), and throws Lost.
std::string ask(const std::string& id, const std::string& arguments);

/// One that cannot be asked for: an argument is a device, a function, a pointer.
[[noreturn]] void refuse_to_ask(const std::string& id);

template <class Id, class Signature>
struct Remote;

template <class Id, class Result, class... Arguments>
struct Remote<Id, Result(Arguments...)> {
    static constexpr bool possible = (std::is_void_v<Result> || wire::can_travel<std::remove_cvref_t<Result>>()) &&
                                     !std::is_reference_v<Result> &&
                                     (wire::can_travel<std::remove_cvref_t<Arguments>>() && ...);

    static Result call(Arguments... arguments) {
        if constexpr (!possible) {
            refuse_to_ask(Id::id());
        } else {
            std::string bytes;
            (wire::put(bytes, arguments), ...);
            const std::string answer = ask(Id::id(), bytes);
            std::string_view rest = answer;
            if constexpr (std::is_void_v<Result>) {
                (take_back<Arguments>(rest, arguments), ...);
            } else {
                Result result{};
                wire::take(rest, result);
                (take_back<Arguments>(rest, arguments), ...);
                return result;
            }
        }
    }

  private:
    template <class Argument, class Value>
    static void take_back(std::string_view& bytes, Value& value) {
        if constexpr (std::is_lvalue_reference_v<Argument> && !std::is_const_v<std::remove_reference_t<Argument>>)
            wire::take(bytes, const_cast<std::remove_const_t<Value>&>(value));
    }
};

}  // namespace lightwalk

// The function's symbol is found when the program starts (ifunc): any signature, without naming its parameters.
#define LIGHTWALK_ASK(word, result, name, ...)                                                       \
    namespace {                                                                                      \
    struct AskFor_##name {                                                                           \
        static const char* id() { return word; }                                                     \
    };                                                                                               \
    }                                                                                                \
    extern "C" {                                                                                     \
    static auto lightwalk_ask_##name() { return &Remote<AskFor_##name, result(__VA_ARGS__)>::call; } \
    }

#undef EXERCISE
#define EXERCISE(word, result, name, ...)                                    \
    LIGHTWALK_ASK(word, result, name, __VA_ARGS__)                           \
    namespace exercise {                                                     \
    __attribute__((ifunc("lightwalk_ask_" #name))) result name(__VA_ARGS__); \
    }                                                                        \
    static_assert(true)

#undef TRIAL
#define TRIAL(word, result, name, ...)                       \
    LIGHTWALK_ASK(word " " #name, result, name, __VA_ARGS__) \
    __attribute__((ifunc("lightwalk_ask_" #name))) result name(__VA_ARGS__)
