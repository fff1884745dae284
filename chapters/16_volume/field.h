// The densities of a volume, and bounds known ahead of the march.
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

#include "16_volume/volume_data.h"
#include "common/app/module.h"
#include "common/base/epoch.h"
#include "common/gpu/frame.h"
#include "common/scene/scene.h"

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

/// The first object of a scene with a .volume file as model, or a nebula or a cloud made on the device. record()
/// in each frame before a pass reads density().
struct Field : Module {
    Field(Module& owner, std::string name) : Module(owner, std::move(name), "nebula") {}

    Choice shape{*this, "shape", {"nebula", "cloud"}, "nebula", "Shape of the field made on the device"};
    Knob<int> voxels{*this, "voxels", 256, {8, 256}, "Resolution of the nebula or cloud: voxels along each edge"};
    Knob<int> variety{*this, "variety", 7, {0, 1000}, "Which nebula or cloud: the seed of its noise"};

    void prepare(Gpu& gpu, Scene& scene) override;

    /// Makes it where there is none yet, or a knob was turned.
    void record(Frame& frame);

    const Image& density() const { return density_; }
    bool is_file() const { return from_file_; }
    glm::vec3 half_m() const { return half_m_; }  ///< half the edges of its box; the longest is 1 m
    uint64_t number() const { return number_; }   ///< another one whenever the densities are others

  private:
    Image density_;
    bool from_file_ = false;
    glm::vec3 half_m_{1.0f};
    uint64_t number_ = 0;
    Fingerprint made_;
    Pipeline nebula_ = compute({.shader = "16_volume/nebula.comp"});
};

/// True for the name of a file that read_volume() reads.
bool is_volume_file(const std::filesystem::path& file);

/// Empty blocks of a field, for the method `skipping`. Each entry is the size of the largest empty block around it:
/// BLOCK_VOXELS along an edge, or two or four times as many.
struct BlockPyramid {
    /// Records its making where the field, the transfer function, the border or a toggle is another one. `border`: how many voxels
    /// beyond a block a sample in it may read, 1 or more. `transfer_number`: another one for each transfer function.
    void record(Frame& frame, const Field& field, const Image& transfer, uint64_t transfer_number, int border);
    const Image& blocks() const { return blocks_; }

  private:
    Image ranges_, occupied_, blocks_;
    Fingerprint made_;
    Pipeline find_ = compute({.shader = "16_volume/ranges.comp"});
    Pipeline occupy_ = compute({.shader = "16_volume/occupied.comp"});
    Pipeline coarser_ = compute({.shader = "16_volume/coarser.comp"});
};

}  // namespace lightwalk
