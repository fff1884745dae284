// Teeth: every solution passes its check, every starter fails it.
#include "catch.h"
#include "checks.h"

using namespace lightwalk;

#ifndef LIGHTWALK_NO_SOLUTION
#define TEETH(name)                                                         \
    TEST_CASE("01." #name ": the solution passes") {                        \
        const Failures failures = check_##name(solution::name);             \
        for (const std::string& failure : failures) UNSCOPED_INFO(failure); \
        CHECK(failures.empty());                                            \
    }                                                                       \
    TEST_CASE("01." #name ": the starter fails") { CHECK_FALSE(check_##name(exercise::name).empty()); }

TEETH(parse_vertex_line)
TEETH(parse_face)
TEETH(triangulate)
TEETH(view_projection)
#endif
