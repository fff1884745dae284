// Checks of 14.spectrum_bands.
#include <fmt/core.h>

#include "14_environment/exercises.h"
#include "14_environment/music_truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

struct Input {
    std::string name;
    double rate_hz;
    std::vector<float> samples;
};

std::vector<float> tone(double frequency_hz, double rate_hz, double amplitude = 0.5, double phase = 0.3) {
    std::vector<float> samples;
    for (int n = 0; n < 2048; ++n)
        samples.push_back(static_cast<float>(amplitude * std::cos(2 * M_PI * frequency_hz * n / rate_hz + phase)));
    return samples;
}

std::vector<Input> inputs() {
    std::vector<Input> all{{"silence", 48000, std::vector<float>(2048)}};
    const auto add = [&](double frequency_hz, double rate_hz) {
        all.push_back(
            {fmt::format("a tone of {:g} Hz and amplitude 0.5", frequency_hz), rate_hz, tone(frequency_hz, rate_hz)});
    };
    add(93.75, 48000);  // at one of the 1,025 frequencies
    add(1500, 48000);
    add(9000, 48000);
    // At these rates the bands' edges are among the frequencies.
    for (const double rate : {8000.0, 32000.0, 40960.0})
        for (const double edge : {20.0, 250.0, 4000.0, 20000.0})
            if (2 * edge <= rate) add(edge, rate);
    add(60, 44100);
    add(1234.5, 44100);
    add(23000, 48000);
    add(60000, 192000);
    add(5, 44100);
    std::vector<float> click(2048);
    click[700] = 0.8f;
    all.push_back({"a click at sample 700", 48000, click});
    all.push_back({"a constant 0.25", 44100, std::vector<float>(2048, 0.25f)});
    Random random;
    for (const double rate : {8000.0, 11025.0, 22050.0, 44100.0, 48000.0, 96000.0, 192000.0}) {
        Input noise{"noise", rate, {}};
        for (int n = 0; n < 2048; ++n) noise.samples.push_back(static_cast<float>(random.uniform(-1, 1)));
        all.push_back(noise);
    }
    return all;
}

}  // namespace

CHECK_EXERCISE("14.spectrum_bands",
               "window, then transform; squares are averaged over the bins of a band, and the root "
               "is taken last") {
    for (const Input& input : inputs()) {
        const std::string what = fmt::format("spectrum_bands({}, {:g} samples per second)", input.name, input.rate_hz);
        check.call(what, [&]() -> std::string {
            const glm::vec3 got = spectrum_bands(input.samples, static_cast<float>(input.rate_hz));
            const glm::dvec3 right = truth::spectrum_bands(input.samples, input.rate_hz);
            for (int band = 0; band < 3; ++band) {
                if (std::abs(double(got[band]) - right[band]) <= 1e-5 + 1e-4 * right[band]) continue;
                const char* names[] = {"low", "middle", "high"};
                return fmt::format("{} gave {:.6f} in the {} band, expected {:.6f}", what, got[band], names[band],
                                   right[band]);
            }
            return "";
        });
        if (check.failed) return;
    }
}
