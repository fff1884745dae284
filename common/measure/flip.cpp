#include "common/measure/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <system_error>
#include <thread>
#include <vector>

#include "common/base/error.h"

namespace lightwalk {

namespace {

struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;

    Plane() = default;
    Plane(int wide, int high) : width(wide), height(high), values(size_t(wide) * size_t(high)) {}
    float* row(int y) { return values.data() + size_t(y) * size_t(width); }
    const float* row(int y) const { return values.data() + size_t(y) * size_t(width); }
};

/// 2r + 1 weights and their sum: 1 for a blur, 0 for a derivative.
struct Kernel {
    std::vector<float> weights;
    float sum = 1.0f;
};

// Calls work(y_begin, y_end) over [0, height) on up to 8 threads, at most one per core, and as many as the system starts.
void for_row_bands(int height, const std::function<void(int, int)>& work) {
    const int cores = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 8u));
    const int bands = std::min(cores, std::max(1, height / 16));
    std::vector<std::jthread> others;
    const auto work_on = [&](int band) { work(height * band / bands, height * (band + 1) / bands); };
    int band = 1;
    try {
        for (; band < bands; ++band) others.emplace_back(work_on, band);
    } catch (const std::system_error&) {}
    work_on(0);
    for (; band < bands; ++band) work_on(band);
}

// Accumulators per block: a constant number stays in vector registers.
constexpr int block = 16;

// out(x, y) = Σ weights[r + i] · in(x + i, y), i in [-r, r], borders replicated. Computed as sum · in(x, y) plus
// weighted differences from in(x, y), so that constants stay exact and their derivative is exactly 0 (FLIP takes its
// square root). Additions have a fixed order, independent of the number of threads.
Plane filter_rows(const Plane& in, const Kernel& kernel) {
    const int taps = static_cast<int>(kernel.weights.size()), radius = taps / 2;
    Plane out(in.width, in.height);
    for_row_bands(in.height, [&](int begin, int end) {
        std::vector<float> padded(size_t(in.width + 2 * radius + block));
        for (int y = begin; y < end; ++y) {
            const float* row = in.row(y);
            std::fill_n(padded.begin(), radius, row[0]);
            std::copy_n(row, in.width, padded.begin() + radius);
            std::fill(padded.begin() + radius + in.width, padded.end(), row[in.width - 1]);
            for (int x = 0; x < in.width; x += block) {
                const float* centre = padded.data() + x + radius;
                float total[block];
                for (int i = 0; i < block; ++i) total[i] = kernel.sum * centre[i];
                for (int tap = 0; tap < taps; ++tap) {
                    const float weight = kernel.weights[size_t(tap)];
                    const float* from = centre + tap - radius;
                    for (int i = 0; i < block; ++i) total[i] += weight * (from[i] - centre[i]);
                }
                std::copy_n(total, std::min(block, in.width - x), out.row(y) + x);
            }
        }
    });
    return out;
}

Plane filter_columns(const Plane& in, const Kernel& kernel) {
    const int taps = static_cast<int>(kernel.weights.size()), radius = taps / 2;
    Plane out(in.width, in.height);
    for_row_bands(in.height, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            const float* centre = in.row(y);
            float* to = out.row(y);
            for (int x = 0; x < in.width; ++x) to[x] = kernel.sum * centre[x];
            for (int tap = 0; tap < taps; ++tap) {
                const float weight = kernel.weights[size_t(tap)];
                const float* from = in.row(std::clamp(y + tap - radius, 0, in.height - 1));
                for (int x = 0; x < in.width; ++x) to[x] += weight * (from[x] - centre[x]);
            }
        }
    });
    return out;
}

constexpr double pi = std::numbers::pi;

// Constants of the 2020 paper, with symbol and section.
namespace constant {
constexpr float colour_exponent = 0.7f;      // q_c, 4.1.3
constexpr float colour_split = 0.4f;         // p_c: fraction of the largest colour error …
constexpr float colour_split_to = 0.95f;     // p_t: … that maps to this
constexpr double feature_width_deg = 0.082;  // w, 4.2: edge detector, peak to trough
constexpr float feature_exponent = 0.5f;     // q_f
}  // namespace constant

// Contrast sensitivity of an opponent channel: sum of two Gaussians, Table 1.
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr Sensitivity achromatic{1.0, 0.0047, 0.0, 1e-5}, red_green{1.0, 0.0053, 0.0, 1e-5},
    blue_yellow{34.1, 0.04, 13.5, 0.025};

Kernel to_kernel(const std::vector<double>& weights, float sum) {
    return {std::vector<float>(weights.begin(), weights.end()), sum};
}

std::vector<double> bell(int radius, double scale) {
    std::vector<double> weights;
    for (int i = -radius; i <= radius; ++i) weights.push_back(std::exp(-(scale * i) * (scale * i)));
    return weights;
}

double sum(const std::vector<double>& weights) {
    double total = 0.0;
    for (const double w : weights) total += w;
    return total;
}

struct Term {
    double weight;
    Kernel kernel;
};

// Inverse Fourier transform, Σ a √(π/b) exp(-π² d² / b), d in degrees (eq. 4); radius: three standard deviations.
std::vector<Term> spatial_filter(const Sensitivity& s, double pixels_per_degree) {
    const double widest = std::sqrt(blue_yellow.b1 / (2.0 * pi * pi));
    const int radius = static_cast<int>(std::ceil(3.0 * widest * pixels_per_degree));
    std::vector<Term> terms;
    double total = 0.0;
    for (const auto& [a, b] : {std::pair(s.a1, s.b1), std::pair(s.a2, s.b2)}) {
        if (a == 0.0) continue;
        std::vector<double> weights = bell(radius, pi / std::sqrt(b) / pixels_per_degree);
        const double once = sum(weights);
        for (double& w : weights) w /= once;
        terms.push_back({a * std::sqrt(pi / b) * once * once, to_kernel(weights, 1.0f)});
        total += terms.back().weight;
    }
    for (Term& term : terms) term.weight /= total;
    return terms;
}

// Feature detectors (4.2): Gaussian and derivatives (edge, point); positive weights sum to 1, negative to -1.
struct FeatureKernels {
    Kernel smooth, edge, point;
};

FeatureKernels feature_kernels(double pixels_per_degree) {
    const double deviation = 0.5 * constant::feature_width_deg * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3.0 * deviation));
    const auto gaussian = bell(radius, 1.0 / (std::numbers::sqrt2 * deviation));
    auto smooth = gaussian, edge = gaussian, point = gaussian;
    const double total = sum(gaussian);
    for (int i = -radius; i <= radius; ++i) {
        const double x = i / deviation;
        smooth[size_t(i + radius)] /= total;
        edge[size_t(i + radius)] *= -x;
        point[size_t(i + radius)] *= x * x - 1.0;
    }
    for (std::vector<double>* weights : {&edge, &point}) {
        double positive = 0.0, negative = 0.0;
        for (const double w : *weights) (w > 0.0 ? positive : negative) += w;
        for (double& w : *weights) w /= w > 0.0 ? positive : -negative;
    }
    return {to_kernel(smooth, 1.0f), to_kernel(edge, 0.0f), to_kernel(point, 0.0f)};
}

struct ColourSpace {
    glm::mat3 to_xyz = glm::mat3(detail::rgb_to_xyz());
    glm::mat3 from_xyz = glm::mat3(glm::inverse(detail::rgb_to_xyz()));
    glm::vec3 white = glm::vec3(detail::rgb_to_xyz() * glm::dvec3(1.0));
};

const ColourSpace& colour_space() {
    static const ColourSpace space;
    return space;
}

// Linearised CIELAB, the filtering space (4.1.1): Y in [-16, 100].
glm::vec3 to_opponent(glm::vec3 rgb) {
    const glm::vec3 v = colour_space().to_xyz * rgb / colour_space().white;
    return {116.0f * v.y - 16.0f, 500.0f * (v.x - v.y), 200.0f * (v.y - v.z)};
}

glm::vec3 from_opponent(glm::vec3 o) {
    const float y = (o.x + 16.0f) / 116.0f;
    return colour_space().from_xyz * (glm::vec3(y + o.y / 500.0f, y, y - o.z / 200.0f) * colour_space().white);
}

// CIELAB with the Hunt effect: a and b are scaled by lightness (4.1.2).
glm::vec3 to_hunt_lab(glm::vec3 rgb) {
    const glm::vec3 v = colour_space().to_xyz * rgb / colour_space().white;
    const auto f = [](float t) {
        constexpr float delta = 6.0f / 29.0f;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3.0f * delta * delta) + 4.0f / 29.0f;
    };
    const float fx = f(v.x), fy = f(v.y), fz = f(v.z);
    const float lightness = 116.0f * fy - 16.0f;
    return {lightness, 0.01f * lightness * 500.0f * (fx - fy), 0.01f * lightness * 200.0f * (fy - fz)};
}

// HyAB distance (Abasi et al. 2020): city-block in lightness, Euclidean in a and b.
float hyab(glm::vec3 p, glm::vec3 q) {
    const glm::vec3 d = p - q;
    return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

// Maps a HyAB distance to [0, 1] (4.1.3). Green to blue is the largest distance within sRGB.
float colour_error(float distance) {
    static const float largest =
        std::pow(hyab(to_hunt_lab({0.0f, 1.0f, 0.0f}), to_hunt_lab({0.0f, 0.0f, 1.0f})), constant::colour_exponent);
    const float error = std::pow(distance, constant::colour_exponent);
    const float split = constant::colour_split * largest;
    if (error < split) return constant::colour_split_to / split * error;
    return constant::colour_split_to + (error - split) / (largest - split) * (1.0f - constant::colour_split_to);
}

struct Filtered {
    std::array<Plane, 3> colour;
    Plane edge_x, edge_y, point_x, point_y;
};

Plane filter_both(const Plane& in, const Kernel& along_x, const Kernel& along_y) {
    return filter_columns(filter_rows(in, along_x), along_y);
}

Plane filter_with(const Plane& in, const std::vector<Term>& terms) {
    Plane out(in.width, in.height);
    for (const Term& term : terms) {
        const Plane part = filter_both(in, term.kernel, term.kernel);
        const float weight = static_cast<float>(term.weight);
        for (size_t i = 0; i < out.values.size(); ++i) out.values[i] += weight * part.values[i];
    }
    return out;
}

Filtered filtered(const ImageRgb& image, float pixels_per_degree) {
    std::array<Plane, 3> opponent;
    for (Plane& plane : opponent) plane = Plane(image.width, image.height);
    Plane luminance(image.width, image.height);
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        const glm::vec3 o = to_opponent(image.pixels[i]);
        for (int c = 0; c < 3; ++c) opponent[size_t(c)].values[i] = o[c];
        luminance.values[i] = (o.x + 16.0f) / 116.0f;
    }
    Filtered result;
    constexpr std::array channels{achromatic, red_green, blue_yellow};
    for (size_t c = 0; c < 3; ++c)
        result.colour[c] = filter_with(opponent[c], spatial_filter(channels[c], pixels_per_degree));

    const FeatureKernels kernels = feature_kernels(pixels_per_degree);
    const Plane smooth = filter_rows(luminance, kernels.smooth);
    result.edge_x = filter_columns(filter_rows(luminance, kernels.edge), kernels.smooth);
    result.point_x = filter_columns(filter_rows(luminance, kernels.point), kernels.smooth);
    result.edge_y = filter_columns(smooth, kernels.edge);
    result.point_y = filter_columns(smooth, kernels.point);
    return result;
}

float pixel_error(const Filtered& r, const Filtered& t, size_t i) {
    const auto lab = [i](const Filtered& f) {
        const glm::vec3 o(f.colour[0].values[i], f.colour[1].values[i], f.colour[2].values[i]);
        return to_hunt_lab(glm::clamp(from_opponent(o), 0.0f, 1.0f));
    };
    const auto magnitude = [i](const Plane& x, const Plane& y) {
        return std::sqrt(x.values[i] * x.values[i] + y.values[i] * y.values[i]);
    };
    const float colour = colour_error(hyab(lab(r), lab(t)));
    const float edge = std::abs(magnitude(r.edge_x, r.edge_y) - magnitude(t.edge_x, t.edge_y));
    const float point = std::abs(magnitude(r.point_x, r.point_y) - magnitude(t.point_x, t.point_y));
    const float feature =
        std::pow(std::max(edge, point) / std::numbers::sqrt2_v<float>, constant::feature_exponent);  // eq. 13
    // Feature errors amplify colour errors (eq. 14).
    return std::clamp(std::pow(colour, 1.0f - feature), 0.0f, 1.0f);
}

void check_pair(const ImageRgb& reference, const ImageRgb& test, float per_degree) {
    if (reference.width != test.width || reference.height != test.height)
        throw InputError("FLIP needs images of one size, not {}x{} and {}x{}", reference.width, reference.height,
                         test.width, test.height);
    if (reference.pixels.empty()) throw InputError("FLIP needs images with at least one pixel");
    if (!(per_degree > 0.0f && per_degree <= 1000.0f))
        throw InputError("FLIP needs pixels per degree above 0 and at most 1000");
}

}  // namespace

glm::dmat3 detail::rgb_to_xyz() {
    // Columns: XYZ of the primaries (.64, .33), (.30, .60), (.15, .06), scaled to sum to white.
    const auto xyz = [](double x, double y) { return glm::dvec3(x / y, 1.0, (1.0 - x - y) / y); };
    const glm::dmat3 primaries(xyz(0.64, 0.33), xyz(0.30, 0.60), xyz(0.15, 0.06));
    const glm::dvec3 scale = glm::inverse(primaries) * xyz(0.31271, 0.32902);
    return glm::dmat3(primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z);
}

float pixels_per_degree(float distance_m, float width_m, float width_pixels) {
    return distance_m * width_pixels / width_m * static_cast<float>(pi / 180.0);
}

ErrorMap flip_ldr(const ImageRgb& reference, const ImageRgb& test, float pixels_per_degree) {
    check_pair(reference, test, pixels_per_degree);
    // Equal substitutes for non-finite pixels, so that neighbours are unaffected.
    ImageRgb r = reference, t = test;
    std::vector<size_t> broken;
    for (size_t i = 0; i < r.pixels.size(); ++i) {
        const bool good_r = all_finite(r.pixels[i]), good_t = all_finite(t.pixels[i]);
        if (!good_r || !good_t) {
            broken.push_back(i);
            r.pixels[i] = t.pixels[i] = good_r ? r.pixels[i] : good_t ? t.pixels[i] : glm::vec3(0.0f);
        }
        r.pixels[i] = glm::clamp(r.pixels[i], 0.0f, 1.0f);
        t.pixels[i] = glm::clamp(t.pixels[i], 0.0f, 1.0f);
    }
    ErrorMap map{r.width, r.height, std::vector<float>(r.pixels.size())};
    if (r.pixels != t.pixels) {  // equal inputs: error exactly 0
        const Filtered of_reference = filtered(r, pixels_per_degree), of_test = filtered(t, pixels_per_degree);
        for_row_bands(r.height, [&](int begin, int end) {
            for (size_t i = size_t(begin) * size_t(r.width); i < size_t(end) * size_t(r.width); ++i)
                map.values[i] = pixel_error(of_reference, of_test, i);
        });
    }
    for (const size_t i : broken) map.values[i] = 1.0f;
    return map;
}

}  // namespace lightwalk
