// The lesson's figures on windows, bands and smoothing, measured.
#include <cmath>

#include "../catch.h"
#include "14_environment/music_truth.h"
#include "music_fixture.h"

using namespace lightwalk;

namespace {

std::vector<float> tone_samples(double cycles, size_t count, double phase = 0) {
    std::vector<float> samples;
    for (size_t n = 0; n < count; ++n)
        samples.push_back(static_cast<float>(std::cos(2 * M_PI * cycles * double(n) / double(count) + phase)));
    return samples;
}

double decibels(double ratio) { return 20 * std::log10(ratio); }

// The largest level of the low band over the smallest, of 60 Hz at 48 kHz, over the phase.
double over_phases(size_t count) {
    double least = 1e9, most = 0;
    for (int i = 0; i < 16; ++i) {
        const double level =
            truth::spectrum_bands(tone_samples(60.0 * double(count) / 48000, count, M_PI * i / 16), 48000).x;
        least = std::min(least, level);
        most = std::max(most, level);
    }
    return most / least;
}

}  // namespace

TEST_CASE("bass needs a long window: 60 Hz in 512 samples depends on the phase by 22%, in 2,048 by 0.1%",
          "[14.long_window]") {
    CHECK(over_phases(512) == Approx(1.22).margin(0.01));
    CHECK(over_phases(1024) == Approx(1.03).margin(0.01));
    CHECK(over_phases(2048) < 1.0015);
}

TEST_CASE("a window trades a wider peak for less leakage: 10 bins off -25 dB without one, -67 dB with Hann's",
          "[14.hann]") {
    const std::vector<float> between = tone_samples(100.5, 2048);
    const auto rectangle = truth::amplitudes(between, [](size_t, size_t) { return 1.0; });
    const auto hann = truth::amplitudes(between);
    CHECK(decibels(rectangle[100]) == Approx(-3.9).margin(0.1));
    CHECK(decibels(hann[100]) == Approx(-1.4).margin(0.1));
    CHECK(decibels(rectangle[110] / rectangle[100]) == Approx(-25.2).margin(0.1));
    CHECK(decibels(hann[110] / hann[100]) == Approx(-67).margin(0.5));
    const auto on_a_bin = truth::amplitudes(tone_samples(100, 2048));
    CHECK(on_a_bin[100] == Approx(1));
    CHECK(on_a_bin[99] == Approx(0.5));  // the price: three bins wide
    CHECK(on_a_bin[98] < 1e-6);
}

TEST_CASE(
    "the bands have 10, 160 and 683 bins at 48 kHz: of the same noise their sums differ by 70, their means by none",
    "[14.band_means]") {
    Sound noise{.rate_hz = 48000};
    uint32_t state = 3;
    for (int i = 0; i < 96000; ++i) {
        state = state * 1664525u + 1013904223u;
        noise.samples.push_back(static_cast<float>(double(state >> 8) / (1 << 24) - 0.5));
    }
    glm::dvec3 square(0.0), bins(0.0);
    for (int k = 0; k <= 1024; ++k) {
        const double f = k * 48000.0 / 2048;
        if (f >= 20 && f < 20000) ++bins[f < 250 ? 0 : f < 4000 ? 1 : 2];
    }
    CHECK(bins == glm::dvec3(10, 160, 683));
    const LevelTable table = measure_levels(noise);
    double count = 0;
    for (const Levels& entry : table.entries) {
        square += glm::dvec3(entry) * glm::dvec3(entry);
        ++count;
    }
    const glm::dvec3 power = square / count;
    CHECK(power.x == Approx(power.z).epsilon(0.1));
    CHECK(power.y == Approx(power.z).epsilon(0.1));
    CHECK(power.z * bins.z / (power.x * bins.x) == Approx(68.3).epsilon(0.1));
}

TEST_CASE(
    "smoothing by 0.8 a frame lasts 149, 75 or 31 ms at 30, 60 or 144 frames a second; by a time constant, as long") {
    const auto constant_ms = [](double frames) { return -1000 / (frames * std::log(0.8)); };
    CHECK(constant_ms(30) == Approx(149.4).margin(0.1));
    CHECK(constant_ms(60) == Approx(74.7).margin(0.1));
    CHECK(constant_ms(144) == Approx(31.1).margin(0.1));

    // A level that falls from 1 to 0 at 1 s.
    LevelTable step;
    for (int i = 0; i < 256; ++i) step.entries.push_back(Levels(i < 128 ? 1.0f : 0.0f));
    const LevelTable smooth = smooth_levels(step, 0.01, 0.15);
    const double last = 127 * LevelTable::hop_s;
    CHECK(smooth.at(last).x == Approx(1).epsilon(1e-5));
    CHECK(smooth.at(last + 0.15).x == Approx(std::exp(-1.0)).epsilon(0.01));
    CHECK(smooth.at(last + 0.30).x == Approx(std::exp(-2.0)).epsilon(0.01));
}
