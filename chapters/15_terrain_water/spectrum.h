// Spectrum of a sea under wind.
#pragma once

namespace lightwalk {

inline constexpr double gravity = 9.81;  // m/s²

/// JONSWAP: the spectral density of the height over the angular frequency, in m² s. K. Hasselmann et al., "Measurements of
/// wind-wave growth and swell decay during the Joint North Sea Wave Project", 1973; as C. Horvath has it, "Empirical
/// directional wave spectra for computer graphics", DigiPro 2015. `omega` in rad/s, `fetch_m` in metres.
double jonswap(double omega, double wind_m_s, double fetch_m);

}  // namespace lightwalk
