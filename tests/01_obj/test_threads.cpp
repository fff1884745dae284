// Jobs on threads: each once, whoever takes it, all done at the end, and exceptions passed on.
#include <chrono>
#include <numeric>
#include <stdexcept>

#include "01_obj/scan.h"
#include "catch.h"

using namespace lightwalk;

TEST_CASE("every job runs once") {
    for (const unsigned threads : {1u, 2u, 7u})
        for (size_t count = 0; count < 100; ++count) {
            std::vector<size_t> runs(100);
            on_threads(threads, count, [&](unsigned thread, size_t i) { runs.at(i) += thread < threads ? 1 : 1000; });
            REQUIRE(std::accumulate(runs.begin(), runs.end(), size_t{0}) == count);
            REQUIRE(std::count(runs.begin(), runs.end(), 1) == std::ptrdiff_t(count));
        }
}

TEST_CASE("the last job has ended at the end, though the caller's own ended before") {
    std::atomic<int> ended = 0;
    on_threads(2, 20, [&](unsigned thread, size_t) {
        if (thread != 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
        ++ended;
    });
    CHECK(ended == 20);
}

TEST_CASE("an exception of a job comes out") {
    const auto fails = [](unsigned, size_t i) {
        if (i == 20) throw std::runtime_error("20");
    };
    for (int step = 0; step < 20; ++step) CHECK_THROWS_AS(on_threads(3, 50, fails), std::runtime_error);
}
