// Turns of threads: one at a time, and a thread that asks gets its turn.
#include <thread>

#include "catch.h"
#include "common/base/turn.h"

using namespace lightwalk;

TEST_CASE("one thread at a time has the turn, and one that asks for it gets it while the other gives it briefly") {
    int inside = 0, most_inside = 0, turns = 0;
    const auto enter = [&] {
        most_inside = std::max(most_inside, ++inside);
        std::this_thread::yield();
        --inside;
    };
    CHECK_FALSE(Turn::is_mine());
    {
        const Turn::Shared shared;
        CHECK(Turn::is_mine());
        std::thread other([&] {
            for (int i = 0; i < 100; ++i) {
                Turn::take();
                enter();
                ++turns;
                Turn::give();
            }
        });
        for (int i = 0; i < 1000000 && turns < 100; ++i) {
            enter();
            aside([] {});
        }
        CHECK(turns == 100);
        aside([&] { other.join(); });
        CHECK(aside([] { return Turn::is_mine(); }) == false);
    }
    CHECK_FALSE(Turn::is_mine());
    CHECK(most_inside == 1);
}

TEST_CASE("a thread that shall end does so where it would give its turn") {
    std::atomic<bool> stop = false;
    Turn::stop_when(&stop);
    CHECK(aside([] { return 1; }) == 1);
    stop = true;
    CHECK_THROWS_AS(aside([] { return 1; }), Turn::Stopped);
    Turn::stop_when(nullptr);
}
