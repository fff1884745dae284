// The water's spectrum against sums of its waves in double precision.
#include <fmt/core.h>

#include <cmath>
#include <complex>
#include <cstring>

#include "15_terrain_water/ocean.h"
#include "water_fixture.h"

using namespace lightwalk;

namespace {

using Complex = std::complex<double>;

/// Sum over k of each value times exp(2 pi i k n / N), by halves. J. Cooley and J. Tukey, 1965.
std::vector<Complex> transformed(const std::vector<Complex>& line) {
    const size_t n = line.size();
    if (n == 1) return line;
    std::vector<Complex> even, odd, all(n);
    for (size_t i = 0; i < n; i += 2) {
        even.push_back(line[i]);
        odd.push_back(line[i + 1]);
    }
    even = transformed(even);
    odd = transformed(odd);
    for (size_t i = 0; i < n / 2; ++i) {
        const Complex turned = std::polar(1.0, 2 * M_PI * double(i) / double(n)) * odd[i];
        all[i] = even[i] + turned;
        all[i + n / 2] = even[i] - turned;
    }
    return all;
}

/// Rows, then columns, of 256 each.
std::vector<Complex> transformed_twice(std::vector<Complex> square) {
    for (const bool vertical : {false, true})
        for (size_t i = 0; i < 256; ++i) {
            const auto at = [&](size_t j) -> Complex& { return square[vertical ? 256 * j + i : 256 * i + j]; };
            std::vector<Complex> line;
            for (size_t j = 0; j < 256; ++j) line.push_back(at(j));
            line = transformed(line);
            for (size_t j = 0; j < 256; ++j) at(j) = line[j];
        }
    return square;
}

}  // namespace

TEST_CASE_METHOD(OnWater, "the spectrum: the device's height is the sum of its waves, and repeats after 1,000 s",
                 "[15.spectrum]") {
    water.method.set("fft");
    const auto heights = [&](float time_s, int part) {
        begin(size, time_s);
        water.ocean.record(frame);
        frame.end();
        const std::vector<std::byte> bytes = gpu.read_back(water.ocean.moved().mip(0));
        std::vector<glm::vec4> texels;
        for (uint32_t i = 0; i < 256 * 256; ++i) {
            uint64_t word = 0;
            std::memcpy(&word, &bytes[(size_t(part) * 256 * 256 + i) * 8], 8);
            texels.push_back(glm::unpackHalf4x16(word));
        }
        return texels;
    };
    for (const int part : {0, 2}) {
        const float time_s = 12.25f;
        const std::vector<glm::vec4> found = heights(time_s, part);
        const std::vector<OceanWave> waves = water.ocean.waves(part);
        double variance = 0, most = 0;
        for (const glm::vec4& texel : found) variance += double(texel.y) * double(texel.y) / double(found.size());
        for (const glm::ivec2 at : {glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(17, 200), glm::ivec2(255, 31)}) {
            const glm::dvec2 place = glm::dvec2(at) * double(Ocean::tile_m()[part]) / 256.0;
            glm::dvec3 sum(0);
            for (const OceanWave& w : waves) {
                const double phase = 2 * M_PI * std::fmod(double(w.cycles) * double(time_s) / 1000, 1);
                const std::complex<double> turn(std::cos(phase), -std::sin(phase));
                const std::complex<double> h =
                    std::complex<double>(double(w.forward.x), double(w.forward.y)) * turn +
                    std::complex<double>(double(w.backward.x), double(w.backward.y)) * std::conj(turn);
                const double along = glm::dot(glm::dvec2(w.k), place), k = glm::length(glm::dvec2(w.k));
                const std::complex<double> wave = h * std::complex<double>(std::cos(along), std::sin(along));
                sum.y += wave.real();
                if (k > 0) {
                    sum.x -= double(w.k.x) / k * wave.imag();
                    sum.z -= double(w.k.y) / k * wave.imag();
                }
            }
            const glm::vec4 texel = found[size_t(at.y * 256 + at.x)];
            for (int c = 0; c < 3; ++c) most = std::max(most, std::fabs(double(texel[c]) - sum[c]));
        }
        fmt::print("part {}: deviation {:.3f} m, off by {:.5f} m at most\n", part, std::sqrt(variance), most);
        CHECK(most < 0.004 * std::sqrt(variance) + 1e-5);
        CHECK(variance > 0);
        const std::vector<glm::vec4> later = heights(time_s + 1000.0f, part);
        CHECK(glm::length(later[777] - found[777]) < 0.01 * std::sqrt(variance));
    }
}

TEST_CASE_METHOD(OnWater, "the parts of the spectrum hold JONSWAP's variance") {
    begin(size);
    water.method.set("fft");
    water.ocean.record(frame);
    frame.end();
    double right = 0;
    for (double omega = 0.01; omega < 40; omega += 0.001) right += 0.001 * jonswap(omega, 8, 60e3);
    fmt::print("significant height {:.2f} m; of JONSWAP {:.2f} m\n", 4 * std::sqrt(water.ocean.height_variance()),
               4 * std::sqrt(right));
    CHECK(water.ocean.height_variance() == Approx(right).epsilon(0.25));  // one draw of random amplitudes
}

TEST_CASE_METHOD(OnWater, "each level of the ocean's images is the mean of the one before it, in half floats") {
    water.method.set("fft");
    begin(size, 3);
    water.ocean.record(frame);
    frame.end();
    const auto texels = [&](const ImageView& view) {
        const std::vector<std::byte> bytes = gpu.read_back(view);
        std::vector<glm::vec4> all;
        for (size_t i = 0; i < bytes.size(); i += 8) {
            uint64_t word = 0;
            std::memcpy(&word, &bytes[i], 8);
            all.push_back(glm::unpackHalf4x16(word));
        }
        return all;
    };
    for (const Image* image : {&water.ocean.moved(), &water.ocean.sloped()}) {
        REQUIRE(image->desc.mips == 8);
        for (uint32_t mip = 1; mip < 8; ++mip) {
            const std::vector<glm::vec4> finer = texels(image->mip(mip - 1)), level = texels(image->mip(mip));
            const uint32_t side = 256u >> mip;
            REQUIRE(level.size() == size_t(3) * side * side);
            float most = -1;
            for (uint32_t i = 0; i < level.size(); ++i) {
                const uint32_t x = i % side, y = i / side % side, layer = i / (side * side);
                glm::vec4 mean(0), sizes(0);
                for (uint32_t k = 0; k < 4; ++k) {
                    const glm::vec4 one = finer[((layer * 2 * side + 2 * y + k / 2) * 2 * side) + 2 * x + k % 2];
                    mean += 0.25f * one;
                    sizes += 0.25f * glm::abs(one);
                }
                // A step of a half float is at most 2^-10 of its value. Two sums of four, in different orders, differ by at
                // most 2^-21 of the sizes.
                for (int c = 0; c < 4; ++c)
                    most = std::max(most, std::fabs(level[i][c] - mean[c]) -
                                              0x1p-10f * std::max(std::fabs(mean[c]), 0x1p-14f) - 0x1p-21f * sizes[c]);
            }
            INFO(image->desc.name << " level " << mip);
            CHECK(most <= 0);
        }
    }
}

TEST_CASE_METHOD(OnWater, "the spectrum: every texel of all eight fields is a transform in double precision",
                 "[15.fields]") {
    water.method.set("fft");
    water.ocean.chop.value = 0.75f;
    const double passed = 1.0 / 64;  // of 1,000 s: phases are exact in floats
    begin(size, 15.625f);
    water.ocean.record(frame);
    frame.end();
    const auto texels_of = [&](const Image& image) {
        const std::vector<std::byte> bytes = gpu.read_back(image.mip(0));
        std::vector<uint64_t> words(bytes.size() / 8);
        std::memcpy(words.data(), bytes.data(), bytes.size());
        return words;
    };
    const std::vector<uint64_t> found[2] = {texels_of(water.ocean.moved()), texels_of(water.ocean.sloped())};
    for (int part = 0; part < 3; ++part) {
        std::vector<Complex> fields[8];
        for (const OceanWave& w : water.ocean.waves(part)) {
            const Complex turn = std::polar(1.0, -2 * M_PI * std::fmod(double(w.cycles) * passed, 1));
            const Complex h = Complex(double(w.forward.x), double(w.forward.y)) * turn +
                              Complex(double(w.backward.x), double(w.backward.y)) * std::conj(turn);
            const double k = std::max(double(glm::length(w.k)), 1e-30);
            // A derivative multiplies by i k; waves move the surface along k by a quarter of a wave.
            const Complex by_x(0, double(w.k.x)), by_z(0, double(w.k.y));
            const Complex x = 0.75 / k * by_x * h, z = 0.75 / k * by_z * h;
            const Complex all[8] = {x, h, z, x * by_z, h * by_x, h * by_z, x * by_x, z * by_z};
            for (size_t i = 0; i < 8; ++i) fields[i].push_back(all[i]);
        }
        for (size_t i = 0; i < 8; ++i) {
            const std::vector<Complex> right = transformed_twice(fields[i]);
            double squares = 0, most = 0;
            for (const Complex& value : right) squares += value.real() * value.real() / 65536;
            for (size_t texel = 0; texel < 65536; ++texel) {
                const auto value = glm::unpackHalf4x16(found[i / 4][size_t(part) * 65536 + texel])[int(i % 4)];
                // A half float has steps of 2^-10 at most.
                const double step = std::fabs(right[texel].real()) * 0x1p-10 + 5e-5 * std::sqrt(squares);
                most = std::max(most, std::fabs(double(value) - right[texel].real()) / step);
            }
            INFO("part " << part << ", field " << i << ", root mean square " << std::sqrt(squares));
            CHECK(squares > 0);
            CHECK(most < 1);
        }
    }
}
