// Sums of Gaussians that represent the profile of skin, and the kernel of a blur along a line.
#pragma once
#include <vector>

#include "12_skin/profile.h"

namespace lightwalk {

/// A Gaussian of a sum. `variance` in mm² along each axis, the same for all channels but in a sum of one.
struct Gaussian {
    glm::vec3 weight, variance;
};

/// The best sums of 1, 2, 3, 4 or 6 of the profile's Gaussians. One matches each channel's variance; larger sums keep
/// the Gaussians with the smallest error at a step edge (test_profile.cpp tries all), and each omitted one adds its
/// weight to the one nearest in the logarithm of the variance. Throws Failure for another number.
std::vector<Gaussian> gaussians_of(int count);

/// The same six, some of them, with the weights of the rest given to the nearest.
std::vector<Gaussian> merged(const std::vector<size_t>& kept);

/// Light at `x` mm beyond an edge, where there is 1 before it and 0 behind it would be 0 and 1 without skin: the exact
/// step response of a sum, for each channel.
glm::dvec3 step_edge(const std::vector<Gaussian>& sum, double x_mm);

/// Weights (rgb) and offsets in mm (w) of a blur along a line: the line-spread function, cut into `side` pieces on
/// each side out to 8.2 mm, narrow ones first. They sum to 1 in each channel.
std::vector<glm::vec4> line_kernel(int side);

}  // namespace lightwalk
