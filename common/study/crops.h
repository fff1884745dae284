// Crops: small parts of a picture at full resolution, and the mean error estimated from them.
#pragma once
#include <span>
#include <vector>

#include "common/gpu/frame.h"
#include "common/measure/flip.h"

namespace lightwalk {

/// Pixels of a crop's side, and how far FLIP's filters look at its default pixels per degree: errors nearer to a border
/// that the picture does not have are not counted.
constexpr unsigned crop_px = 64, crop_margin_px = 10;

/// The part of a picture that a crop represents, and the crop itself. A picture's parts are adjacent and cover it.
struct CropPlace {
    glm::uvec2 lower{0}, upper{0};  ///< pixels of the whole picture, upper excluded: errors here count
    glm::uvec2 origin{0};           ///< of the crop_px by crop_px pixels that are drawn
    double share = 0;               ///< of the picture's pixels
};

/// All parts of a picture of at least crop_px pixels a side, row by row.
std::vector<CropPlace> cut(glm::uvec2 whole);

/// The mean of a map, of a picture of any size, over the pixels that show a part of the picture of `whole` pixels.
double mean_over(const ErrorMap& map, glm::uvec2 whole, const CropPlace& place);

/// The mean of the map of a drawn crop over the pixels that count.
double mean_of_crop(const ErrorMap& map, const CropPlace& place);

/// Multiples of it are spread evenly between integers, however many there are.
constexpr double golden_ratio = 0.6180339887498949;

/// `count` places, drawn with these chances (which sum to 1), some of them more than once: one in every count-th part
/// of the sum of chances, at a place in it that differs from part to part, so that no pattern of the picture keeps
/// step. The same for the same `start`, in [0, 1).
std::vector<size_t> draw_places(std::span<const double> chances, size_t count, double start);

/// A picture's mean, estimated from parts of it. Parts drawn with greater probability count less: the mean of share ·
/// error / probability over the draws has the picture's mean as its expected value (M. H. Hansen and W. N. Hurwitz,
/// Annals of Mathematical Statistics 14, 1943).
class Estimate {
  public:
    void add(double error, double share, double chance) { draws_.push_back(share * error / chance); }
    size_t count() const { return draws_.size(); }
    double mean() const;
    double standard_error() const;  ///< of the mean; infinite below two draws

  private:
    std::vector<double> draws_;
};

}  // namespace lightwalk
