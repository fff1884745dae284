// Ocean module: a wave spectrum as three tiles of displacement and slopes, by Fourier transforms.
#pragma once
#include "15_terrain_water/water_data.h"
#include "common/app/module.h"
#include "common/app/target.h"
#include "common/base/epoch.h"
#include "common/gpu/frame.h"

namespace lightwalk {

inline constexpr double gravity = 9.81;  // m/s²

/// JONSWAP: the spectral density of the height over the angular frequency, in m² s. K. Hasselmann et al., "Measurements of
/// wind-wave growth and swell decay during the Joint North Sea Wave Project", 1973; as C. Horvath has it, "Empirical
/// directional wave spectra for computer graphics", DigiPro 2015. `omega` in rad/s, `fetch_m` in metres.
double jonswap(double omega, double wind_m_s, double fetch_m);

/// record() in each frame; then water_surface.glsl reads moved() and sloped(): three layers, each of a part of the
/// spectrum, on a tile of tile_m() metres that repeats. All repeats after `repeat_s`.
struct Ocean : Module {
    Ocean(Module& owner, std::string name);

    Knob<float> wind_m_s{*this, "wind_m_s", 8.0f, {0.5f, 40.0f}, "Wind speed 10 m above the water", "m/s"};
    Knob<float> fetch_km{*this, "fetch_km", 60.0f, {0.1f, 5000.0f}, "Distance over which the wind has blown", "km"};
    Knob<float> wind_deg{
        *this,    "wind_deg", 25.0f, {-360.0f, 360.0f}, "Direction in which the wind blows, from +x towards +z",
        "degrees"};
    Knob<float> chop{
        *this, "chop", 1.0f, {0.0f, 2.0f}, "Scale factor of the horizontal displacement: 0 leaves crests round"};
    Knob<int> shape{*this, "shape", 1, {0, 1 << 30}, "Seed of the waves' random amplitudes"};

    static constexpr double repeat_s = 1000;

    void record(Frame& frame);
    const Image& moved() const { return moved_[0]; }
    const Image& moved_before() const { return moved_[1]; }  ///< by the record() before
    const Image& sloped() const { return sloped_; }
    static glm::vec3 tile_m() { return {256.0f, 34.0f, 5.0f}; }
    glm::vec3 slope_variance() const { return slope_variance_; }  ///< of each part, both axes together
    double height_variance() const { return height_variance_; }   ///< of all parts, in m²
    OceanTravel travel(int part, double seconds) const;           ///< of the waves' slopes

    /// Waves of one part: cycles, amplitudes and wave vectors.
    std::vector<OceanWave> waves(int part) const;

  private:
    void make(Frame& frame);
    Image fields_, moved_[2], sloped_;  ///< moved_: by this record(), by the one before
    Buffer waves_, tiles_, finished_;   ///< the last two of columns_: its workgroups' results, and their number
    Fingerprint made_;
    glm::vec3 slope_variance_{0};
    double height_variance_ = 0;
    OceanTravel a_second_[3]{};
    Pipeline rows_ = compute({.shader = "15_terrain_water/ocean_rows.comp"});
    Pipeline columns_ = compute({.shader = "15_terrain_water/ocean_columns.comp"});
};

}  // namespace lightwalk
