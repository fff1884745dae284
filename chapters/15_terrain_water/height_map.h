// Height maps: elevations on a grid, from files.
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace lightwalk {

/// Elevations on a regular grid, rows from north to south.
struct HeightMap {
    int width = 0, height = 0;       ///< samples, 2 or more each
    glm::vec2 sample_m{30.0f};       ///< from one sample to the next, eastwards and southwards
    std::vector<float> elevation_m;  ///< row by row
};

/// True for the file formats that chapter 15 takes for height maps.
bool is_height_map_file(const std::filesystem::path& file);

/// Reads a grey PNG of 8 or 16 bits, or an .hgt of the Shuttle Radar Topography Mission, whose name says its latitude. A .json of the same name beside it gives min_elevation_m, max_elevation_m,
/// metres_per_sample_x and metres_per_sample_y; without it a PNG's black is 0 m, white 1,000 m, and samples are 30 m apart.
/// Throws InputError: missing, damaged, not grey, fewer than 2x2 samples, a size that no image may have, or a number of
/// the .json out of range.
HeightMap read_height_map(const std::filesystem::path& file);

}  // namespace lightwalk
