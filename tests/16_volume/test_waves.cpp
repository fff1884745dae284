// Waves, as a Fourier sum over the box finds them: which crests displace an axis, and which way they travel.
#include "volume_fixture.h"

using namespace lightwalk;

namespace {

constexpr int side = 20;  // of the grid

struct FoundWave {
    double height, phase_rad;  ///< height sin(2 pi crests s + phase)
};

// The wave of so many crests along an axis that displaces another.
FoundWave wave_of(const std::vector<glm::vec3>& displaced, int axis, int along, int crests) {
    double sine = 0, cosine = 0;
    for (int i = 0; i < side * side * side; ++i) {
        const int at[] = {i % side, i / side % side, i / (side * side)};
        const double turn = 2 * glm::pi<double>() * crests * at[along] / side;
        sine += double(displaced[size_t(i)][axis]) * std::sin(turn);
        cosine += double(displaced[size_t(i)][axis]) * std::cos(turn);
    }
    return {2 * std::hypot(sine, cosine) / (side * side * side), std::atan2(cosine, sine)};
}

}  // namespace

TEST_CASE_METHOD(OnVolume, "an axis is displaced by two crests that go back and by five half as high that go on",
                 "[16.waves]") {
    const Pipeline waved = compute({.shader = "../tests/16_volume/waved.comp"});
    const Buffer result(gpu.device, {.name = "result", .bytes = side * side * side * sizeof(glm::vec3)});
    volume.wave.value = 0.02f;
    volume.wave_speed.value = 0.5f;
    // Their speeds and phases at the beginning, so that no two axes are in step.
    const double faster[] = {1, 1.31, 0.73}, begins_rad[] = {0, 1, 2};
    for (const float time_s : {0.0f, 0.6f}) {
        owner.begin_frame(gpu, size);
        frame.begin(size, time_s);
        volume.update(frame);
        frame.compute("waved", {.writes = {result}, .with = {volume}},
                      [&](Compute& pass) { pass.use(waved).set("result", result).dispatch_threads(glm::uvec3(side)); });
        frame.end();
        std::vector<glm::vec3> displaced(side * side * side);
        const std::vector<std::byte> bytes = gpu.read_back(result);
        std::memcpy(displaced.data(), bytes.data(), bytes.size());
        for (int axis = 0; axis < 3; ++axis) {
            INFO("at " << time_s << " s, axis " << axis);
            const int next = (axis + 1) % 3, last = (axis + 2) % 3;
            const FoundWave back = wave_of(displaced, axis, next, 2), on = wave_of(displaced, axis, last, 5);
            const auto phase = [&](int i) { return begins_rad[i] + faster[i] * 0.5 * double(time_s); };
            CHECK(back.height == Approx(0.02).epsilon(1e-3));
            CHECK(on.height == Approx(0.01).epsilon(1e-3));
            CHECK(std::remainder(back.phase_rad - phase(axis), 2 * glm::pi<double>()) == Approx(0).margin(1e-3));
            CHECK(std::remainder(on.phase_rad + phase(next), 2 * glm::pi<double>()) == Approx(0).margin(1e-3));
        }
    }
}
