#include "15_terrain_water/spectrum.h"

#include <cmath>

namespace lightwalk {

// [jonswap]
double jonswap(double omega, double wind_m_s, double fetch_m) {
    if (omega <= 0) return 0;
    const double alpha = 0.076 * std::pow(wind_m_s * wind_m_s / (fetch_m * gravity), 0.22);
    const double peak = 22 * std::cbrt(gravity * gravity / (wind_m_s * fetch_m));
    const double width = omega <= peak ? 0.07 : 0.09, off = (omega - peak) / (width * peak);
    return alpha * gravity * gravity / std::pow(omega, 5) * std::exp(-1.25 * std::pow(peak / omega, 4)) *
           std::pow(3.3, std::exp(-0.5 * off * off));
}
// [/jonswap]

}  // namespace lightwalk
