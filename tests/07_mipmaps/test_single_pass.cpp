// The single pass in its parts: by shuffles and through shared memory, in one dispatch and in two, with its counters.
#include "chain_fixture.h"

using namespace lightwalk;

TEST_CASE_METHOD(OnChain, "a single pass by shuffles makes what one through shared memory does, at any size",
                 "[07.shuffles]") {
    for (const glm::uvec2 size : odd_sizes) {
        const Image noisy = image(size, one_float, noise, 2);
        for (uint32_t layer = 0; layer < 2; ++layer) {
            const ImageView view = ImageView(noisy).layer(layer);
            std::vector<truth::Texels> expected;
            chain.reduction.set("shared");
            fill(noisy, "single_pass");
            for (uint32_t m = 1; m < noisy.desc.mips; ++m) expected.push_back(level(view, m));
            chain.reduction.set("shuffle");
            fill(noisy, "single_pass");
            for (uint32_t m = 1; m < noisy.desc.mips; ++m) {
                const truth::Texels found = level(view, m);
                double worst = 0;
                for (size_t i = 0; i < found.values.size(); ++i)
                    worst = std::max(worst, std::fabs(found.values[i].r - expected[m - 1].values[i].r));
                INFO(size.x << "x" << size.y << " level " << m << " layer " << layer);
                CHECK(worst < 1e-6);
            }
        }
    }
}

TEST_CASE_METHOD(OnChain, "many tiles are finished by a second dispatch, which rounds nothing twice") {
    // 33×33 tiles. Halves that were rounded at the sixth level would be off by some 1e-4 afterwards.
    const Image noisy = image({2112, 2112}, one_float, noise);
    for (const std::string reduction : {"shared", "shuffle"}) {
        chain.reduction.set(reduction);
        fill(noisy, "single_pass");
        const truth::Texels sixth = level(noisy, 6), seventh = level(noisy, 7);
        REQUIRE(seventh.size == glm::uvec2(16));
        double worst = 0;
        for (uint32_t y = 0; y < 16; ++y)
            for (uint32_t x = 0; x < 16; ++x) {
                double mean = 0;
                for (uint32_t i = 0; i < 4; ++i) mean += 0.25 * sixth.at(2 * x + i % 2, 2 * y + i / 2).r;
                worst = std::max(worst, std::fabs(seventh.at(x, y).r - mean));
            }
        CHECK(worst < 1e-6);
        CHECK(last(noisy).r == Approx(0.5).margin(0.01));
    }
}

TEST_CASE_METHOD(OnChain, "counters of finished workgroups are cleared before they come again", "[07.counters]") {
    // 300 layers use 600 of 4096 counters each time.
    const Image noisy = image({128, 70}, one_float, noise, 300);
    fill(noisy, "box");
    const double right = last(ImageView(noisy).layer(299)).r;
    const Image again = image({128, 70}, one_float, noise, 300);
    for (int i = 0; i < 16; ++i) {
        fill(again, "single_pass");
        CHECK(last(ImageView(again).layer(299)).r == Approx(right).epsilon(1e-5));
        // So that a level that is left out shows.
        Frame own(gpu);
        own.begin({4, 4}, 0);
        own.upload("nothing", ImageView(again).mip(again.desc.mips - 1), std::vector<std::byte>(300 * 4));
        own.end();
    }
}
