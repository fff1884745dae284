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

TEST_CASE_METHOD(OnWater, "each level of the ocean's images is the mean of the one before it, in half floats") {
    water.method.set("fft");
    begin(size, 3);
    water.ocean.record(frame);
    frame.end();
    const auto texels = [&](const ImageView& view) {
        std::vector<glm::vec4> all;
        for (const uint64_t word : read<uint64_t>(view)) all.push_back(glm::unpackHalf4x16(word));
        return all;
    };
    // A sum of n terms is off by gamma of n - 1 of their sizes at most, in any order (N. Higham, "Accuracy and Stability of
    // Numerical Algorithms", 2002, section 4.2): gamma of n is n u / (1 - n u). Two sums of four are compared.
    const float u = 0x1p-24f, apart = 2 * 3 * u / (1 - 3 * u);
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
                // A step of a half float is at most 2^-10 of its value.
                for (int c = 0; c < 4; ++c)
                    most = std::max(most, std::fabs(level[i][c] - mean[c]) -
                                              0x1p-10f * std::max(std::fabs(mean[c]), 0x1p-14f) - apart * sizes[c]);
            }
            INFO(image->desc.name << " level " << mip);
            CHECK(most <= 0);
        }
    }
}

TEST_CASE_METHOD(
    OnWater, "the spectrum: every texel of all eight fields is a transform in double precision, again after 1,000 s",
    "[15.spectrum][15.fields]") {
    water.method.set("fft");
    water.ocean.chop.value = 0.75f;
    const double passed = 1.0 / 64;  // of 1,000 s: phases are exact in floats
    std::vector<uint64_t> found[2];
    for (const float time_s : {15.625f, 1015.625f}) {
        begin(size, time_s);
        water.ocean.record(frame);
        frame.end();
        const std::vector<uint64_t> moved = read<uint64_t>(water.ocean.moved().mip(0));
        if (time_s > 1000) CHECK(moved == found[0]);
        found[0] = moved;
        found[1] = read<uint64_t>(water.ocean.sloped().mip(0));
    }
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
            double squares = 0, most = 0, off = 0;
            for (const Complex& value : right) squares += value.real() * value.real() / 65536;
            for (size_t texel = 0; texel < 65536; ++texel) {
                const auto value = glm::unpackHalf4x16(found[i / 4][size_t(part) * 65536 + texel])[int(i % 4)];
                // A half float has steps of 2^-10 at most.
                const double step = std::fabs(right[texel].real()) * 0x1p-10 + 5e-5 * std::sqrt(squares);
                off = std::max(off, std::fabs(double(value) - right[texel].real()));
                most = std::max(most, std::fabs(double(value) - right[texel].real()) / step);
            }
            if (i == 1)
                fmt::print("part {}: deviation {:.3f} m, off by {:.5f} m at most\n", part, std::sqrt(squares), off);
            INFO("part " << part << ", field " << i << ", root mean square " << std::sqrt(squares));
            CHECK(squares > 0);
            CHECK(most < 1);
        }
    }
}
