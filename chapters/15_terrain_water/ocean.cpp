#include "15_terrain_water/ocean.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "15_terrain_water/exercises.h"

namespace lightwalk {

namespace {

constexpr int texels = static_cast<int>(OCEAN_TEXELS);
constexpr uint32_t levels = OCEAN_LEVELS, layers = 6;  // of both images together

// Wave numbers, in 1/m, between which the parts share the spectrum: six waves of the next tile are its longest.
double least_k(int part) { return part == 0 ? 0.0 : 6 * 2 * M_PI / double(Ocean::tile_m()[part]); }
double most_k(int part) { return part == 2 ? 0.5 * M_PI * texels / double(Ocean::tile_m()[2]) : least_k(part + 1); }

// From 0 to 1, never either: D. Stafford's variant 13 of MurmurHash3's finalizer, 2011.
double random_at(uint64_t n) {
    n = (n ^ n >> 30) * 0xbf58476d1ce4e5b9u;
    n = (n ^ n >> 27) * 0x94d049bb133111ebu;
    n ^= n >> 31;
    return (double(n >> 11) + 0.5) * 0x1p-53;
}

glm::dvec2 normal_pair(uint64_t n) {  // G. Box and M. Muller, 1958
    const double r = std::sqrt(-2 * std::log(random_at(2 * n))), angle = 2 * M_PI * random_at(2 * n + 1);
    return {r * std::cos(angle), r * std::sin(angle)};
}

std::vector<ImageView> levels_of(const Image& image) {
    std::vector<ImageView> all;
    for (uint32_t mip = 0; mip < image.desc.mips; ++mip) all.push_back(image.mip(mip));
    return all;
}

}  // namespace

Ocean::Ocean(Module& owner, std::string name) : Module(owner, std::move(name), "ocean") {}

std::vector<OceanWave> Ocean::waves(int part) const {
    const double tile = double(tile_m()[part]), step = 2 * M_PI / tile;
    const double wind_rad = double(wind_deg) * M_PI / 180;
    // The complex amplitude of the wave with these integer numbers of waves along the tile's edges.
    const auto amplitude = [&](int x, int z) {
        const double kx = step * x, kz = step * z, k = std::hypot(kx, kz);
        if (k <= least_k(part) || k > most_k(part) || k == 0) return glm::dvec2(0);
        const double along = (kx * std::cos(wind_rad) + kz * std::sin(wind_rad)) / k;
        if (along <= 0) return glm::dvec2(0);
        const double density = jonswap(std::sqrt(gravity * k), double(wind_m_s), 1000 * double(fetch_km));
        const auto place = static_cast<uint64_t>((z + texels) * 4 * texels + x + texels) +
                           (static_cast<uint64_t>(shape.value) << 32) + (static_cast<uint64_t>(part) << 24);
        return normal_pair(place) * wave_amplitude(density, k, along, step);
    };
    std::vector<OceanWave> all;
    for (int row = 0; row < texels; ++row)
        for (int column = 0; column < texels; ++column) {
            const int x = column < texels / 2 ? column : column - texels;
            const int z = row < texels / 2 ? row : row - texels;
            const glm::dvec2 forward = amplitude(x, z), backward = amplitude(-x, -z);
            const double omega = std::sqrt(gravity * step * std::hypot(x, z));
            all.push_back({.forward = forward,
                           .backward = {backward.x, -backward.y},
                           .k = glm::dvec2(step * x, step * z),
                           .cycles = static_cast<float>(std::round(omega * repeat_s / (2 * M_PI)))});
        }
    return all;
}

// One-time setup, repeated when a knob changes.
void Ocean::make(Frame& frame) {
    const auto fit = [&](Image& image, const char* name, VkFormat format, uint32_t layers, uint32_t mips,
                         bool kept = false) {
        image.ensure(frame.gpu.device, {.name = path() + name,
                                        .format = format,
                                        .size = glm::uvec2(OCEAN_TEXELS),
                                        .mips = mips,
                                        .layers = layers,
                                        .kept = kept});
    };
    fit(fields_, " fields", VK_FORMAT_R32G32B32A32_SFLOAT, layers, 1);
    for (Image& moved : moved_) fit(moved, " moved", VK_FORMAT_R16G16B16A16_SFLOAT, 3, levels, true);
    fit(sloped_, " sloped", VK_FORMAT_R16G16B16A16_SFLOAT, 3, levels);
    if (!finished_) {
        const VkDeviceSize tiles = layers * (OCEAN_TEXELS / 4) * (OCEAN_TEXELS / 4);
        tiles_ = Buffer(frame.gpu.device, {.name = path() + " tiles", .bytes = sizeof(glm::vec4) * tiles});
        finished_ = Buffer(frame.gpu.device, {.name = path() + " finished", .bytes = sizeof(uint32_t) * layers});
    }
    if (made_.is_current(epoch())) return;
    std::vector<OceanWave> all;
    height_variance_ = 0;
    for (int part = 0; part < 3; ++part) {
        double slopes = 0;
        OceanTravel& travel = a_second_[part] = {};
        for (const OceanWave& wave : waves(part)) {
            // The variance of a sum over k and -k of amplitudes with these squares.
            const double square = double(glm::dot(wave.forward, wave.forward) + glm::dot(wave.backward, wave.backward));
            height_variance_ += square;
            const double slope = square * double(glm::dot(wave.k, wave.k));
            slopes += slope;
            const double onwards =
                double(glm::dot(wave.forward, wave.forward) - glm::dot(wave.backward, wave.backward));
            const double omega = 2 * M_PI / repeat_s * double(wave.cycles);
            travel.squares +=
                static_cast<float>(slope) * glm::vec3(wave.k.x * wave.k.x, wave.k.x * wave.k.y, wave.k.y * wave.k.y);
            travel.turned += static_cast<float>(omega * onwards * double(glm::dot(wave.k, wave.k))) * wave.k;
            travel.changed += static_cast<float>(slope * omega * omega);
            all.push_back(wave);
        }
        slope_variance_[part] = static_cast<float>(slopes);
    }
    frame.upload("ocean waves", waves_, all);
}

OceanTravel Ocean::travel(int part, double seconds) const {
    const auto s = static_cast<float>(seconds);
    const OceanTravel& one = a_second_[part];
    return {one.squares, s * one.turned, s * s * one.changed};
}

void Ocean::record(Frame& frame) {
    std::swap(moved_[0], moved_[1]);
    make(frame);
    // All frequencies are whole multiples of 1 / repeat_s: after 1e5 s nothing is lost but whole turns.
    const OceanNow now{.passed = static_cast<float>(std::fmod(double(frame.time_s), repeat_s) / repeat_s),
                       .chop = chop};
    frame.compute(
        "ocean",
        {.reads = {fields_, waves_, tiles_, finished_}, .writes = {fields_, tiles_, finished_, moved_[0], sloped_}},
        [&](Compute& pass) {
            pass.use(rows_).set("ocean_waves", waves_).set("ocean_now", now).set("fields", fields_);
            pass.set("finished", finished_).dispatch({OCEAN_TEXELS / 2, 3, 1}).wait();
            pass.use(columns_).set("fields", fields_).set("ocean_tiles", tiles_);
            pass.set_if_present("finished", finished_);  // an exercise of chapter 07's: it may not be there yet
            pass.set("moved", std::span<const ImageView>(levels_of(moved_[0])));
            pass.set("sloped", std::span<const ImageView>(levels_of(sloped_)));
            pass.dispatch({OCEAN_TEXELS / 4, layers, 1});
        });
}

double jonswap(double omega, double wind_m_s, double fetch_m) {
    if (omega <= 0) return 0;
    const double alpha = 0.076 * std::pow(wind_m_s * wind_m_s / (fetch_m * gravity), 0.22);
    const double peak = 22 * std::cbrt(gravity * gravity / (wind_m_s * fetch_m));
    const double width = omega <= peak ? 0.07 : 0.09, off = (omega - peak) / (width * peak);
    return alpha * gravity * gravity / std::pow(omega, 5) * std::exp(-1.25 * std::pow(peak / omega, 4)) *
           std::pow(3.3, std::exp(-0.5 * off * off));
}

}  // namespace lightwalk
