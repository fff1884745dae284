// Noise over time and space: its moments, its hash, its variance and its gradients.
#include <fmt/core.h>

#include "volume_fixture.h"

using namespace lightwalk;

TEST_CASE("time in floats: after a week a frame is less than a step; the noise's moment keeps its parts") {
    const auto step = [](float seconds) { return std::nextafter(seconds, 1e9f) - seconds; };
    CHECK(step(3600) == Approx(2.4e-4).epsilon(0.05));
    CHECK(step(86400) == Approx(0.0078).epsilon(0.05));
    CHECK(step(604800) == Approx(0.0625).epsilon(0.01));
    CHECK(step(604800) > 1.0f / 60);
    for (const double week : {0.0, 604800.0, 31536000.0}) {
        const NoiseMoment now = noise_moment(week + 0.25, 0), next = noise_moment(week + 0.25 + 1.0 / 60, 0);
        CHECK(now.cell == int(week));
        CHECK(double(next.time - now.time) == Approx(1.0 / 60).epsilon(1e-5));
        const double skew = (std::sqrt(5.0) - 1) / 4;
        const double moved = double(next.skew_cell - now.skew_cell) + double(next.skew_time) - double(now.skew_time);
        CHECK(moved == Approx(skew / 60).epsilon(1e-3));
    }
}

TEST_CASE_METHOD(OnVolume, "a week later the shell still moves, and evenly, for each noise") {
    volume.shell.value = true;
    volume.shell_bumps.value = 0.3f;
    for (const char* noise : {"lattice", "simplex", "texture"}) {
        volume.noise.set(noise);
        const auto change = [&](float from, float to) { return mean_difference(picture(from), picture(to)); };
        const double early = change(10, 10.5f), late = change(604800, 604800.5f);
        fmt::print("{}: in half a second the picture changes by {:.5f}, a week later by {:.5f}\n", noise, early, late);
        CHECK(early > 1e-5);
        CHECK(late > 0.2 * early);
        CHECK(late < 5 * early);
    }
}

TEST_CASE_METHOD(OnVolume, "a hash by sine differs between float and double, even near 0; integers are the same",
                 "[16.hash]") {
    double apart = 0;
    int count = 0;
    for (int x = -10; x <= 10; ++x)
        for (int y = -10; y <= 10; ++y, ++count) {
            const double exact = std::sin(x * 12.9898 + y * 78.233) * 43758.5453;
            const float rounded = std::sin(float(x) * 12.9898f + float(y) * 78.233f) * 43758.5453f;
            const double one = exact - std::floor(exact), other = double(rounded) - std::floor(double(rounded));
            const double way = std::fabs(one - other);
            apart += std::min(way, 1 - way);
        }
    // Chance: 0.25. Within 10 of 0 float sines are off by at most 1e-7 of the product with 43,758.
    fmt::print("hash by sine: float and double are {:.3f} apart in the mean; chance is 0.25\n", apart / count);
    CHECK(apart / count > 1e-4);
    Probe probe{.include = "16_volume/lattice_4d.glsl", .signature = "float lattice_4d(ivec4 cell)", .inputs = {}};
    Random random(9);
    for (int i = 0; i < 500; ++i) {
        Row row;
        for (int k = 0; k < 4; ++k) row.push_back(std::floor(random.uniform(-2e9, 2e9)));
        probe.inputs.push_back(row);
    }
    const Table found = run_probe(gpu, probe, 1);
    double sum = 0, squares = 0;
    for (size_t i = 0; i < found.size(); ++i) {
        const Row& in = probe.inputs[i];
        CHECK(found[i][0] == Approx(truth::lattice_4d({int(in[0]), int(in[1]), int(in[2]), int(in[3])})).margin(1e-6));
        sum += found[i][0];
        squares += found[i][0] * found[i][0];
    }
    CHECK(std::fabs(sum / 500) < 0.1);
    CHECK(squares / 500 == Approx(1.0 / 3).margin(0.06));
}

// Kernels (0.6 - r²)⁴ times gradients of length sqrt(3), sqrt(5) in a unit of volume: 3/4 π² 0.6¹¹ B(3, 9).
TEST_CASE_METHOD(DeviceTest, "simplex noise varies as the kernels of its lattice sum to", "[16.simplex]") {
    Probe probe{.include = "16_volume/simplex_4d.glsl", .signature = "float simplex_4d(vec3 at, NoiseMoment moment)"};
    Random random(32);
    for (int i = 0; i < 20000; ++i) {
        const NoiseMoment moment = noise_moment(random.uniform(0, 1000), 5);
        probe.inputs.push_back({random.uniform(-99, 99), random.uniform(-99, 99), random.uniform(-99, 99),
                                double(moment.cell), double(moment.time), double(moment.skew_cell),
                                double(moment.skew_time), double(moment.seed)});
    }
    double squares = 0;
    for (const Row& row : run_probe(gpu, probe, 1)) squares += row[0] * row[0] / 20000;
    const double pi = 3.14159265358979;
    CHECK(squares == Approx(27 * 27 * std::sqrt(5.0) * 0.75 * pi * pi * std::pow(0.6, 11) / 495).epsilon(0.06));
}

TEST_CASE(
    "sampling rules against 2^16 steps: midpoint and trapezium for what is smooth, preintegration for a thin layer",
    "[figures][16.rules]") {
    // A density that goes up and down along the ray; a transfer function that is smooth, and one 0.02 of the range thick.
    const auto density = [](double s) { return 0.5 + 0.45 * std::sin(3 * s + 1) * std::cos(2 * s); };
    for (const bool thin : {false, true}) {
        std::vector<glm::vec4> transfer;
        for (int i = 0; i < 256; ++i) {
            const double x = i / 255.0;
            const double opacity = thin ? (std::fabs(x - 0.6) < 0.01 ? 0.3 : 0) : 0.02 * x;
            transfer.emplace_back(1, 1, 1, float(opacity));
        }
        const auto opacity_at = [&](double d) {
            const double at = std::clamp(d, 0.0, 1.0) * 255;
            const size_t below = std::min(size_t(at), size_t(254));
            return glm::mix(double(transfer[below].a), double(transfer[below + 1].a), at - double(below));
        };
        const auto extinction = [&](double s) { return -std::log1p(-opacity_at(density(s))) / double(REFERENCE_M); };
        const double right = truth::march(2, extinction, [](double) { return 1.0; }).light;
        for (const int steps : {16, 64, 256}) {
            const double length = 2.0 / steps;
            double sum[5] = {0, 0, 0, 0, 0}, through[5] = {1, 1, 1, 1, 1};
            for (int i = 0; i < steps; ++i) {
                const double a = i * length, b = a + length;
                const double ratio = length / double(REFERENCE_M);
                const double opacities[5] = {-std::expm1(-extinction(a) * length),
                                             -std::expm1(-0.5 * (extinction(a) + extinction(b)) * length),
                                             -std::expm1(-extinction(0.5 * (a + b)) * length),
                                             truth::preintegrate(transfer, density(a), density(b), ratio).w,
                                             std::min(extinction(a) * length, 1.0)};
                for (int m = 0; m < 5; ++m) {
                    sum[m] += through[m] * opacities[m];
                    through[m] *= 1 - opacities[m];
                }
            }
            fmt::print(
                "{}, {:3} steps: off by left {:.5f}, trapezium {:.5f}, midpoint {:.5f}, preintegrated {:.5f}, "
                "opacity by length {:.5f}\n",
                thin ? "thin  " : "smooth", steps, std::fabs(sum[0] - right), std::fabs(sum[1] - right),
                std::fabs(sum[2] - right), std::fabs(sum[3] - right), std::fabs(sum[4] - right));
            if (thin && steps == 64) CHECK(std::fabs(sum[3] - right) < 0.3 * std::fabs(sum[2] - right));
            if (!thin && steps == 64) CHECK(std::fabs(sum[2] - right) < 0.5 * std::fabs(sum[4] - right));
            if (!thin && steps == 256) CHECK(std::fabs(sum[2] - right) < 2e-4);
        }
    }
}

TEST_CASE(
    "gradients by central differences of Marschner and Lobb's signal: finer is better, but not in 8 bits, where "
    "Sobel's "
    "27 voxels help",
    "[figures][16.gradients]") {
    constexpr double pi = 3.14159265358979;
    const auto signal = [](glm::dvec3 p) {
        const double r = std::sqrt(p.x * p.x + p.y * p.y);
        return (1 - std::sin(pi * p.z / 2) + 0.25 * (1 + std::cos(2 * pi * 6 * std::cos(pi * r / 2)))) / 2.5;
    };
    double degrees[4][2], sobels[4][2];
    const int sizes[] = {41, 64, 128, 256};
    for (int k = 0; k < 4; ++k)
        for (const bool bytes : {false, true}) {
            const int n = sizes[k];
            const auto voxel = [&](glm::ivec3 at) {
                const double value = signal(glm::dvec3(at) / double(n - 1) * 2.0 - 1.0);
                return bytes ? std::round(255 * value) / 255 : value;
            };
            Random random(3);
            // Sobel's: the same differences in the nine rows around, weighed by 1 2 1 across.
            const auto sobel = [&](glm::ivec3 at, int axis, glm::ivec3 step) {
                double difference = 0;
                for (int u = -1; u <= 1; ++u)
                    for (int v = -1; v <= 1; ++v) {
                        glm::ivec3 beside = at;
                        beside[(axis + 1) % 3] += u;
                        beside[(axis + 2) % 3] += v;
                        difference +=
                            (2 - std::abs(u)) * (2 - std::abs(v)) * (voxel(beside + step) - voxel(beside - step));
                    }
                return difference;
            };
            const auto angle = [](glm::dvec3 a, glm::dvec3 b) {
                return std::acos(std::clamp(glm::dot(glm::normalize(a), glm::normalize(b)), -1.0, 1.0));
            };
            double sum = 0, sobel_sum = 0;
            const int count = 1500;
            for (int i = 0; i < count; ++i) {
                const glm::ivec3 at(random.uniform(2, n - 3), random.uniform(2, n - 3), random.uniform(2, n - 3));
                glm::dvec3 found, around, right;
                const glm::dvec3 place = glm::dvec3(at) / double(n - 1) * 2.0 - 1.0;
                for (int axis = 0; axis < 3; ++axis) {
                    glm::ivec3 step(0);
                    step[axis] = 1;
                    found[axis] = voxel(at + step) - voxel(at - step);
                    around[axis] = sobel(at, axis, step);
                    glm::dvec3 little(0);
                    little[axis] = 1e-5;
                    right[axis] = signal(place + little) - signal(place - little);
                }
                if (glm::length(found) > 0) sum += angle(found, right);
                if (glm::length(around) > 0) sobel_sum += angle(around, right);
            }
            degrees[k][bytes] = sum / count * 180 / pi;
            sobels[k][bytes] = sobel_sum / count * 180 / pi;
        }
    for (int k = 0; k < 4; ++k)
        fmt::print("{}³ voxels: off by {:.2f}° as floats, {:.2f}° in 8 bits; by Sobel's {:.2f}°, {:.2f}°\n", sizes[k],
                   degrees[k][0], degrees[k][1], sobels[k][0], sobels[k][1]);
    CHECK(degrees[0][0] > 10);
    CHECK(degrees[3][0] < 1);
    CHECK(degrees[3][1] > degrees[2][1]);
    CHECK(sobels[0][0] > 1.1 * degrees[0][0]);  // too coarse a grid: wider is worse
    CHECK(sobels[3][1] < 0.5 * degrees[3][1]);  // noise of 8 bits: wider is better
}

TEST_CASE_METHOD(OnVolume, "each moment reads the texture of noise at a place of its own, in all three directions") {
    // Instead of the texel the place comes back that was read, as one number.
    Probe probe{.include = "common/srgb.glsl",
                .before =
                    "#define VOLUME_NOISE 2\n#define VOLUME_NOISE_LATTICE 0\n#define VOLUME_NOISE_SIMPLEX 1\n"
                    "#define textureSize(map, level) ivec3(1)\n"
                    "#define textureLod(map, at, level) vec4(dot(floor(at), vec3(10000.0, 100.0, 1.0)))\n"
                    "#include \"16_volume/noise_methods.glsl\"\n"
                    "float place_of(float moment) { return at_moment(vec3(50.0), int(moment), 3); }\n",
                .signature = "float place_of(float moment)"};
    for (int moment = 0; moment < 400; ++moment) probe.inputs.push_back({double(moment)});
    const Table found = run_probe(gpu, probe, 1);
    std::vector<glm::dvec3> shifts;
    for (const auto& row : found) {
        const int place = int(row[0]);
        shifts.emplace_back(place / 10000 - 50, place / 100 % 100 - 50, place % 100 - 50);
    }
    // Even from -31 to 31: a variance of 31 squared over 3; and two directions have nothing in common.
    const auto mean_of = [&](int a, int b) {
        double sum = 0;
        for (const glm::dvec3& shift : shifts) sum += shift[a] * shift[b];
        return sum / double(shifts.size());
    };
    for (int axis = 0; axis < 3; ++axis) {
        CHECK(mean_of(axis, axis) == Approx(31 * 31 / 3.0).epsilon(0.15));
        CHECK(std::fabs(mean_of(axis, (axis + 1) % 3)) < 0.2 * 31 * 31 / 3.0);
    }
}
