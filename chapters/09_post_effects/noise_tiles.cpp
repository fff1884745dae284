#include <cmath>
#include <cstdint>

#include "09_post_effects/post.h"

namespace lightwalk {
namespace {

// Points on a torus, and at each place how close the others are: integers, so that every machine finds the same.
class Points {
  public:
    explicit Points(int side) : on(size_t(side * side), 0), side_(side), close_(size_t(side * side), 0) {
        for (int d = 0; d <= reach * reach * 2; ++d)
            weights_.push_back(static_cast<int64_t>(std::lround(1e6 * std::exp(-d / (2 * 1.5 * 1.5)))));
    }
    void flip(size_t at) {
        const int64_t sign = on[at] ? -1 : 1;
        on[at] = !on[at];
        const int x = int(at) % side_, y = int(at) / side_;
        for (int j = -reach; j <= reach; ++j)
            for (int i = -reach; i <= reach; ++i) {
                const int u = (x + i + 2 * side_) % side_, v = (y + j + 2 * side_) % side_;
                close_[size_t(v * side_ + u)] += sign * weights_[size_t(i * i + j * j)];
            }
    }
    /// The point with the most others around it, or the place without a point with the fewest.
    size_t tightest(bool among_points) const {
        size_t best = on.size();
        for (size_t i = 0; i < on.size(); ++i) {
            if (bool(on[i]) != among_points) continue;
            if (best == on.size() || (among_points ? close_[i] > close_[best] : close_[i] < close_[best])) best = i;
        }
        return best;
    }
    std::vector<char> on;

  private:
    static constexpr int reach = 6;  // four standard deviations
    int side_;
    std::vector<int64_t> close_, weights_;
};

struct Numbers {
    uint32_t state;
    double next() {  // M. E. O'Neill's PCG, 2014
        state = state * 747796405u + 2891336453u;
        const uint32_t word = (state >> ((state >> 28) + 4) ^ state) * 277803737u;
        return double((word >> 22 ^ word) >> 8) / 16777216.0;
    }
};

}  // namespace

std::vector<float> blue_noise(int side) {
    // A tenth of the places at random; then the tightest point moves to the largest void until that is where it came
    // from.
    Points points(side);
    Numbers random{1};
    const size_t all = points.on.size(), first = all / 10;
    for (size_t placed = 0; placed < first;)
        if (const auto at = static_cast<size_t>(random.next() * double(all)); !points.on[at]) {
            points.flip(at);
            ++placed;
        }
    for (size_t turn = 0; turn < all; ++turn) {
        const size_t from = points.tightest(true);
        points.flip(from);
        const size_t to = points.tightest(false);
        points.flip(to);
        if (from == to) break;
    }
    // Ranks: downwards by taking the tightest away, upwards by filling the largest void.
    std::vector<float> ranks(all);
    const auto threshold = [&](size_t rank) { return (float(rank) + 0.5f) / float(all); };
    Points fewer = points;
    for (size_t rank = first; rank-- > 0;) {
        const size_t at = fewer.tightest(true);
        fewer.flip(at);
        ranks[at] = threshold(rank);
    }
    for (size_t rank = first; rank < all; ++rank) {
        const size_t at = points.tightest(false);
        points.flip(at);
        ranks[at] = threshold(rank);
    }
    return ranks;
}

std::vector<float> film_clumps(int side) {
    Numbers random{2};
    std::vector<double> white(size_t(side * side));
    for (double& one : white) one = 2 * random.next() - 1;
    double weights[7][7];
    for (int j = 0; j < 7; ++j)
        for (int i = 0; i < 7; ++i) weights[j][i] = std::exp(-0.5 * ((i - 3) * (i - 3) + (j - 3) * (j - 3)));
    std::vector<float> clumps;
    double mean = 0, square = 0;
    for (int at = 0; at < side * side; ++at) {
        double sum = 0;
        for (int j = 0; j < 7; ++j)
            for (int i = 0; i < 7; ++i)
                sum += weights[j][i] *
                       white[size_t((at / side + j + side - 3) % side * side + (at % side + i + side - 3) % side)];
        clumps.push_back(float(sum));
        mean += sum;
        square += sum * sum;
    }
    mean /= double(clumps.size());
    square /= double(clumps.size());
    const double scale = std::sqrt(1.0 / 3.0 / (square - mean * mean));
    for (float& one : clumps) one = float((double(one) - mean) * scale);
    return clumps;
}

Image upload_tile(Gpu& gpu, const std::string& name, const std::vector<float>& tile) {
    const auto side = static_cast<uint32_t>(std::lround(std::sqrt(double(tile.size()))));
    Image image(gpu.device, {.name = name, .format = VK_FORMAT_R32_SFLOAT, .size = {side, side}});
    gpu.upload(image, std::as_bytes(std::span(tile)));
    return image;
}

}  // namespace lightwalk
