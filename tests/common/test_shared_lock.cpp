// Turns of threads: one at a time, and a thread that asks gets its turn.
#include <thread>

#include "catch.h"
#include "common/base/shared_lock.h"

using namespace lightwalk;

TEST_CASE("one thread at a time has the turn, and one that asks for it gets it while the other gives it briefly") {
    int inside = 0, most_inside = 0, turns = 0;
    const auto enter = [&] {
        most_inside = std::max(most_inside, ++inside);
        std::this_thread::yield();
        --inside;
    };
    CHECK_FALSE(SharedLock::is_held());
    {
        const SharedLock::InUse shared;
        CHECK(SharedLock::is_held());
        std::thread other([&] {
            for (int i = 0; i < 100; ++i) {
                SharedLock::lock();
                enter();
                ++turns;
                SharedLock::unlock();
            }
        });
        for (int i = 0; i < 1000000 && turns < 100; ++i) {
            enter();
            unlocked([] {});
        }
        CHECK(turns == 100);
        unlocked([&] { other.join(); });
        CHECK(unlocked([] { return SharedLock::is_held(); }) == false);
    }
    CHECK_FALSE(SharedLock::is_held());
    CHECK(most_inside == 1);
}

TEST_CASE("a thread that shall end does so where it would give its turn") {
    std::atomic<bool> stop = false;
    SharedLock::stop_when(&stop);
    CHECK(unlocked([] { return 1; }) == 1);
    stop = true;
    CHECK_THROWS_AS(unlocked([] { return 1; }), SharedLock::Stopped);
    SharedLock::stop_when(nullptr);
}
