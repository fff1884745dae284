// Where frames go, when the program that takes them ends.
#include "../catch.h"
#include "19_ambiance/film_out.h"
#include "common/base/error.h"

using namespace lightwalk;

namespace {

std::string ended(const std::string& script) {
    try {
        FramePipe pipe(std::vector<std::string>{"sh", "-c", script});
        pipe.finish();
        return "";
    } catch (const Failure& failure) { return failure.what(); }
}

}  // namespace

// POSIX.1-2017, Shell Command Language, 2.8.2: a program that a signal ended has a code above 128; shells add its number.
TEST_CASE("a program that fails or is killed is said with its code and its last words") {
    CHECK(ended("cat >/dev/null") == "");
    CHECK(ended("cat >/dev/null; echo first >&2; echo no room >&2; exit 3") == "sh failed, with code 3: no room");
    CHECK(ended("cat >/dev/null; kill -9 $$") == "sh failed, with code 137");
}
