// Shared by the tests of loaders: a text that all of ours read alike, or refuse alike.
#pragma once
#include "agreement.h"
#include "catch.h"

namespace lightwalk {

inline const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

// Read by the textbook loader, after the others were found to agree.
inline ObjData read_text(std::string_view text) {
    CHECK(disagreement(text) == "");
    Outcome outcome = outcome_of(text, Loader::textbook);
    CHECK(outcome.error == "");
    return std::move(outcome.data);
}

inline void refuse(std::string_view text, size_t line) {
    CAPTURE(text);
    CHECK(disagreement(text) == "");
    for (const Loader loader : {Loader::textbook, Loader::scan, Loader::parallel}) {
        const Outcome outcome = outcome_of(text, loader);
        CHECK(outcome.place == "test.obj:" + std::to_string(line));
        CHECK(outcome.error.size() > outcome.place.size() + 10);  // there is a reason behind it
        CHECK(outcome.error.find('\n') == std::string::npos);
    }
}

}  // namespace lightwalk
