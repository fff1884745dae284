// Several answers to the C++ exercises of a chapter in one program. A check calls the one that was chosen.
//
// Included before a chapter's exercises.h, in a file of its own (common/course/check/variants.py writes it): there EXERCISE
// defines each function as one that calls the chosen answer. Each answer is in a namespace of its own.
#pragma once
#include <string>

#include "common/base/exercise.h"

namespace lightwalk {

/// Throws InputError if there is no answer of that name: "parse_face.half".
void choose_variant(const std::string& name);

struct RegisterVariant {
    RegisterVariant(const char* name, void (*choose)());
};

template <class Exercise, class Signature>
struct Chosen;

template <class Exercise, class Result, class... Arguments>
struct Chosen<Exercise, Result(Arguments...)> {
    static inline Result (*function)(Arguments...) = nullptr;
    static Result call(Arguments... arguments) { return function(static_cast<Arguments&&>(arguments)...); }
};

}  // namespace lightwalk

// The function's symbol is found when the program starts (ifunc): any signature, without naming its parameters.
#undef EXERCISE
#define EXERCISE(id, result, name, ...)                                         \
    using Chosen_##name = Chosen<struct ChosenOf_##name, result(__VA_ARGS__)>;  \
    extern "C" {                                                                \
    static auto lightwalk_chosen_##name() { return &Chosen_##name::call; }      \
    }                                                                           \
    namespace exercise {                                                        \
    __attribute__((ifunc("lightwalk_chosen_" #name))) result name(__VA_ARGS__); \
    }                                                                           \
    namespace solution {                                                        \
    result name(__VA_ARGS__);                                                   \
    }                                                                           \
    inline const Toggle<result(__VA_ARGS__)> name { id, &exercise::name, LIGHTWALK_SOLUTION(name) }
