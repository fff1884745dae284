// Plan of a blur: its steps, the images between them, and the Gaussians it represents. Needs no device.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace lightwalk {

/// Request for a blur.
struct BlurWish {
    std::string method;     ///< of Bloom::method, but for "none"
    double sigma_px = 16;   ///< 0 to 200
    double truncation = 3;  ///< at how many sigma the weights of line methods end
    bool sum = false;       ///< several Gaussians, each with the same energy, instead of one
    glm::uvec2 size{1};     ///< pixels
    bool karis = false;     ///< the pyramid's first level weighs each read by 1 / (1 + luminance)
    bool operator==(const BlurWish&) const = default;
};

/// One dispatch. Image numbers: 0 is the bright pass, 1 the result.
struct Step {
    enum class Kind { line, level_line, shared, window, down, up, kawase_down, kawase_up, copy };
    Kind kind = Kind::line;
    int from = 0, into = 1;
    glm::ivec2 direction{1, 0};        ///< of lines
    uint32_t first_tap = 0, taps = 0;  ///< of Plan::taps
    bool linear = true;                ///< reads between texels
    float spread = 1;                  ///< Kawase's offset; of copy how many texels are read for one that is written
    float weight = 1, keep = 0;        ///< image = weight * result + keep * image
    bool karis = false;
};

struct Plan {
    std::vector<Step> steps;
    std::vector<glm::vec2> taps;    ///< (offset in texels, weight), one side, the middle first
    std::vector<glm::uvec2> sizes;  ///< of the images
    /// Size of the picture in texels of each image, a fraction for levels, and the margin on each side.
    std::vector<glm::vec2> extents;
    std::vector<int> aprons;
    std::vector<double> sigmas_px;  ///< the Gaussians that it stands for, all of the same weight
    bool full_floats = false;       ///< 32 bits in every image: the truth
};

/// Throws InputError for a method that is not known, and for a window of more than 129 × 129 texels.
Plan plan_blur(const BlurWish& wish);

/// The workgroups of a step.
glm::uvec3 groups_of(const Step& step, const Plan& plan);

/// Variance in square texels, per axis, of a filter's taps read linearly around a point that lies `phase` of a texel
/// beyond a texel's middle. Variances add up along a chain of filters.
double tap_variance(const std::vector<glm::dvec2>& offsets_and_weights, double phase);

/// The variance in square pixels of the 13-tap and tent pyramid of so many levels: 1.5 (4^levels - 1).
double pyramid_variance(int levels);

/// Dual Kawase filter; `offset` of the taps on the way up, about 0.5 to 2.15.
double kawase_variance(int levels, double offset);

/// The offset of its taps on the way down: 1, or less where one level already blurs too much.
float kawase_down_offset(int levels, float offset);

}  // namespace lightwalk
