#include <cmath>

#include "15_terrain_water/exercises.h"

namespace lightwalk::solution {

double wave_amplitude(double density, double k, double along, double step) {
    if (k <= 0 || along <= 0) return 0;
    const double gravity = 9.81, omega = std::sqrt(gravity * k), spread = 2 / M_PI * along * along;
    // dω/dk = g / 2ω; divided by k it is a density over the plane.
    const double over_plane = density * spread * 0.5 * gravity / omega / k;
    // |h0|² has a mean of 2 a², and k and -k both add it.
    return std::sqrt(0.5 * 0.5 * over_plane * step * step);
}

}  // namespace lightwalk::solution
