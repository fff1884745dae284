// Teams of threads: each job once in each step, whoever comes late, and exceptions passed on.
#include <chrono>
#include <numeric>
#include <stdexcept>

#include "01_obj/threads.h"
#include "catch.h"

using namespace lightwalk;

TEST_CASE("a team runs every job of every step once, and is done with a step before the next") {
    for (const size_t threads : {1, 2, 7}) {
        Team team(threads);
        CHECK(team.threads() == threads);
        std::vector<size_t> runs(100);
        for (size_t step = 1; step <= 300; ++step) {
            const size_t count = step % runs.size();
            std::fill(runs.begin(), runs.end(), 0);
            team.run(count, [&](unsigned thread, size_t i) { runs.at(i) += thread < threads ? 1 : 1000; });
            REQUIRE(std::accumulate(runs.begin(), runs.end(), size_t{0}) == count);
            REQUIRE(std::count(runs.begin(), runs.end(), 1) == std::ptrdiff_t(count));
        }
    }
}

TEST_CASE("a team's step ends with its last job, though the caller's own ended before") {
    Team team(2);
    if (team.threads() < 2) return;  // the system has no more
    for (int step = 0; step < 3; ++step) {
        std::atomic<int> begun = 0, ended = 0;
        team.run(2, [&](unsigned thread, size_t) {
            ++begun;
            while (begun < 2) std::this_thread::yield();
            if (thread != 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
            ++ended;
        });
        REQUIRE(ended == 2);
    }
}

TEST_CASE("an exception of a team's job comes out of its step, and the team goes on") {
    Team team(3);
    const auto fails = [](unsigned, size_t i) {
        if (i == 20) throw std::runtime_error("20");
    };
    for (int step = 0; step < 20; ++step) {
        CHECK_THROWS_AS(team.run(50, fails), std::runtime_error);
        std::atomic<size_t> runs = 0;
        team.run(50, [&](unsigned, size_t) { ++runs; });
        CHECK(runs == 50);
    }
}
