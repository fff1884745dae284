// White balance, and the input of middle grey for each tone curve.
#pragma once
#include <glm/glm.hpp>
#include <string>

namespace lightwalk {

/// From linear Rec. 709 to linear Rec. 709 so that daylight of that correlated colour temperature, 4000 to 25000 K,
/// becomes white: Bradford's adaptation from it to daylight of 6504 K, for which it is the identity.
glm::mat3 white_balance_matrix(double kelvin);

/// Scale factor of light before the tone curve, so that 0.18 has the reference's luminance.
double matching_gain(const std::string& tone);

}  // namespace lightwalk
