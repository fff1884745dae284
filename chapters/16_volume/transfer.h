// Transfer functions: colour and opacity of a density.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace lightwalk {

/// TRANSFER_TEXELS entries over densities from 0 to 1: linear colour, and the opacity of REFERENCE_M metres. `name` is one
/// of transfer_names(); throws std::out_of_range otherwise. `density` (0 or more) multiplies the optical depth.
std::vector<glm::vec4> transfer_function(const std::string& name, float density);

const std::vector<std::string>& transfer_names();

/// The table of chapter 16's pre-integration: `texels` squared entries, row by row the density behind, in a row the one in
/// front, for steps of `ratio` reference lengths: light that is weighted by opacity already, and opacity.
std::vector<glm::vec4> preintegrated_table(const std::vector<glm::vec4>& transfer, int texels, float ratio);

/// The thinnest layer that the transfer function shows, as a share of the range of densities: the shortest run of entries
/// above half of a peak of opacity. 1 where there is none.
float thinnest_layer(const std::vector<glm::vec4>& transfer);

}  // namespace lightwalk
