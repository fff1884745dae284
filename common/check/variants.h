// Several student answers to C++ exercises in one program; the check calls the chosen one.
//
// Included before a chapter's exercises.h in a generated file (common/course/check/variants.py): EXERCISE then defines
// functions that call the chosen answer. Each answer has its own namespace.
#pragma once
#include <string>

#include "common/base/exercise.h"

namespace lightwalk {

/// Selects an answer, such as "parse_face.half". Throws InputError if it does not exist.
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

// ifunc resolves the symbol at program start, for any signature without naming parameters.
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
