// Volumes in files: a text that describes the numbers, and the numbers.
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

namespace lightwalk {

/// Voxels with x fastest, then y, then z.
struct VolumeData {
    glm::uvec3 size{0};
    glm::vec3 spacing_m{0.001f};  ///< from voxel to voxel along each axis
    bool is_half = false;         ///< 16-bit floats, else 8 bits for 0 to 1
    std::vector<std::byte> bytes;
};

/// Reads `file`, JSON with
///     "file"        the numbers, a file name beside it
///     "dims"        voxels along x, y, z: 1 to 512 each
///     "spacing_mm"  from voxel to voxel, 1e-3 to 1e3; default [1, 1, 1]
///     "dtype"       "uint8" (0 to 255 stand for 0 to 1), or "float32" (0 to 1, little-endian)
/// and any further keys, and exactly that many bytes of numbers. Throws InputError with one line.
VolumeData read_volume(const std::filesystem::path& file);

}  // namespace lightwalk
