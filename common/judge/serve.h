// The student's side of the grader: a process that has the student's C++ and answers calls of it.
//
// Included before a chapter's exercises.h, in a file of its own (common/build.cmake makes it), which the grader links
// with the student's object.
#pragma once
#include "common/base/exercise.h"
#include "common/check/trial.h"
#include "common/judge/wire.h"

namespace lightwalk {

/// Arguments as bytes to the result as bytes.
using Answer = std::string (*)(std::string_view arguments);

struct RegisterAnswer {
    RegisterAnswer(const char* id, Answer answer);
};

template <auto function, class Signature>
struct Serve;

template <auto function, class Result, class... Arguments>
struct Serve<function, Result(Arguments...)> {
    static constexpr bool possible = (std::is_void_v<Result> || wire::can_travel<std::remove_cvref_t<Result>>()) &&
                                     !std::is_reference_v<Result> &&
                                     (wire::can_travel<std::remove_cvref_t<Arguments>>() && ...);

    static std::string answer(std::string_view bytes) {
        if constexpr (!possible) {
            throw Failure("what it takes cannot be handed to another process");
        } else {
            std::tuple<typename wire::kept<std::remove_cvref_t<Arguments>>::type...> arguments;
            std::apply([&](auto&... each) { (wire::take(bytes, each), ...); }, arguments);
            std::string out;
            std::apply(
                [&](auto&... each) {
                    if constexpr (std::is_void_v<Result>)
                        function(each...);
                    else
                        wire::put(out, function(each...));
                    (put_back<Arguments>(out, each), ...);
                },
                arguments);
            return out;
        }
    }

  private:
    template <class Argument, class Value>
    static void put_back(std::string& bytes, const Value& value) {
        if constexpr (std::is_lvalue_reference_v<Argument> && !std::is_const_v<std::remove_reference_t<Argument>>)
            wire::put(bytes, value);
    }
};

}  // namespace lightwalk

#undef EXERCISE
#define EXERCISE(id, result, name, ...)     \
    namespace exercise {                    \
    [[gnu::weak]] result name(__VA_ARGS__); \
    }                                       \
    static const RegisterAnswer serve_##name(id, Serve<&exercise::name, result(__VA_ARGS__)>::answer)

#undef TRIAL
#define TRIAL(id, result, name, ...) \
    result name(__VA_ARGS__);        \
    static const RegisterAnswer serve_##name(id " " #name, Serve<&name, result(__VA_ARGS__)>::answer)
