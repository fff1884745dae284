// An open sea by each method, as statistics: two draws of one spectrum differ in every pixel and are the same sea.
#include <fmt/core.h>

#include <cmath>
#include <cstring>

#include "15_terrain_water/ocean.h"
#include "water_fixture.h"

using namespace lightwalk;

namespace {

/// Properties of a sea that are independent of its random waves.
struct Statistics {
    double height_m = 0;    ///< significant: four standard deviations
    double slope = 0;       ///< root of the mean square of the steepness, both axes
    double long_waves = 0;  ///< share of the height's variance in waves longer than 10 m
    double whitecaps = 0;   ///< share of the surface, as the foam has it
};

struct OnSea : OnWater {
    static constexpr double foam = 0.1;  // scenes/open_sea.json

    void add(Statistics& s, double height, const glm::dmat3& slopes, double weight) const {
        const glm::dvec3 n = truth::normal_of(slopes);
        const double jacobian = (1 + slopes[0].x) * (1 + slopes[2].z) - slopes[0].z * slopes[2].x;
        const double share = std::clamp((foam - jacobian) / 0.5, 0.0, 1.0);
        s.height_m += weight * height * height;
        s.slope += weight * (n.x * n.x + n.z * n.z) / (n.y * n.y);
        s.whitecaps += weight * share * share * (3 - 2 * share);
    }

    static Statistics rooted(Statistics s) {
        return {4 * std::sqrt(s.height_m), std::sqrt(s.slope), s.long_waves, s.whitecaps};
    }

    Statistics of_waves(const std::string& method, int count) {
        water.method.set(method);
        water.waves.value = count;
        const std::vector<WaveData> waves = water.waves_at(3);
        Statistics s;
        Random random(15);
        const int places = 20000;
        for (int i = 0; i < places; ++i) {
            const glm::dvec2 at(random.uniform(-3000, 3000), random.uniform(-3000, 3000));
            glm::dmat3 slopes(0.0);
            double height = 0;
            for (const WaveData& w : waves) {
                const double amplitude = double(w.amplitude), steepness = double(w.steepness), phase = double(w.phase);
                slopes += truth::gerstner_slopes(at, glm::dvec2(w.k), amplitude, steepness, phase);
                height += truth::gerstner(at, glm::dvec2(w.k), amplitude, steepness, phase).y;
            }
            add(s, height, slopes, 1.0 / places);
        }
        double all = 0;
        for (const WaveData& w : waves) {
            const double square = double(w.amplitude) * double(w.amplitude);
            all += square;
            s.long_waves += 2 * M_PI / double(glm::length(w.k)) > 10 ? square : 0;
        }
        s.long_waves /= std::max(all, 1e-30);
        return rooted(s);
    }

    /// The device's three tiles, read at places that have nothing to do with each other.
    Statistics of_spectrum(int shape, float time_s) {
        water.method.set("fft");
        water.ocean.wind_m_s.value = 9;
        water.ocean.shape.value = shape;
        begin(size, time_s);
        water.ocean.record(frame);
        frame.end();
        const auto texels = [&](const Image& image) {
            const std::vector<std::byte> bytes = gpu.read_back(image.mip(0));
            std::vector<glm::vec4> all(3 * 256 * 256);
            for (size_t i = 0; i < all.size(); ++i) {
                uint64_t word = 0;
                std::memcpy(&word, &bytes[8 * i], 8);
                all[i] = glm::unpackHalf4x16(word);
            }
            return all;
        };
        const auto moved = texels(water.ocean.moved()), sloped = texels(water.ocean.sloped());
        Statistics s;
        Random random(15);
        const int places = 60000;
        for (int i = 0; i < places; ++i) {
            glm::dvec4 m(0), d(0);
            for (size_t part = 0; part < 3; ++part) {
                const size_t texel = part * 65536 + size_t(random.uniform(0, 65535.9));
                m += glm::dvec4(moved[texel]);
                d += glm::dvec4(sloped[texel]);
            }
            glm::dmat3 slopes(0.0);
            slopes[0] = {d.z, d.x, m.w};
            slopes[2] = {m.w, d.y, d.w};
            add(s, m.y, slopes, 1.0 / places);
        }
        double all = 0;
        for (int part = 0; part < 3; ++part)
            for (const OceanWave& w : water.ocean.waves(part)) {
                const glm::dvec2 a(w.forward), b(w.backward);
                const double energy = glm::dot(a, a) + glm::dot(b, b), k = double(glm::length(w.k));
                all += energy;
                s.long_waves += k > 0 && 2 * M_PI / k > 10 ? energy : 0;
            }
        s.long_waves /= all;
        return rooted(s);
    }

    static void print(const std::string& name, const Statistics& s) {
        fmt::print("sea, {}: height {:.2f} m, slope {:.3f}, long waves {:.0f}%, whitecaps {:.1f}%\n", name, s.height_m,
                   s.slope, 100 * s.long_waves, 100 * s.whitecaps);
    }
};

}  // namespace

TEST_CASE_METHOD(OnSea, "an open sea as statistics: two draws and two times are the same sea, other methods are not",
                 "[15.sea]") {
    const Statistics sea = of_spectrum(1, 3), later = of_spectrum(1, 10.3f), other = of_spectrum(2, 3);
    print("spectrum", sea);
    print("7.3 s later", later);
    print("another draw", other);
    for (const Statistics& same : {later, other}) {
        CHECK(same.height_m == Approx(sea.height_m).epsilon(0.2));
        CHECK(same.slope == Approx(sea.slope).epsilon(0.05));
        CHECK(same.long_waves == Approx(sea.long_waves).margin(0.1));
        CHECK(same.whitecaps == Approx(sea.whitecaps).margin(0.01));
    }
    for (const char* method : {"sines", "gerstner"})
        for (const int waves : {4, 8, 16}) {
            const Statistics found = of_waves(method, waves);
            print(fmt::format("{} {}", method, waves), found);
            // JONSWAP's significant height and slopes differ from those of a few waves of one steepness.
            CHECK(std::fabs(found.height_m / sea.height_m - 1) > 0.2);
        }
    // The height is JONSWAP's, by an integral over its frequencies.
    double variance = 0;
    for (double omega = 0.01; omega < 40; omega += 0.001) variance += 0.001 * jonswap(omega, 9, 60e3);
    CHECK(sea.height_m == Approx(4 * std::sqrt(variance)).epsilon(0.15));
}
