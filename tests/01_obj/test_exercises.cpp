// Teeth: every solution passes its check, every starter fails it.
#include "catch.h"
#include "checks.h"
#include "common/check/comma_locale.h"

using namespace lightwalk;

TEST_CASE("the locale of the checks writes a comma, for C too") {
    {
        const CommaLocale comma;
        CHECK(std::strtof("1,5", nullptr) == 1.5f);
    }
    CHECK(std::strtof("1,5", nullptr) == 1.0f);
}

#ifndef LIGHTWALK_NO_SOLUTION
#define TEETH(name)                                  \
    TEST_CASE("01." #name ": the solution passes") { \
        Check check;                                 \
        check_##name(check, solution::name);         \
        CHECK(check.first_failure == "");            \
        CHECK(check.passed > 0);                     \
    }                                                \
    TEST_CASE("01." #name ": the starter fails") {   \
        Check check;                                 \
        check_##name(check, exercise::name);         \
        CHECK(check.failed > 0);                     \
    }

TEETH(parse_vertex_line)
TEETH(parse_face)
TEETH(triangulate)
TEETH(view_projection)
#endif
