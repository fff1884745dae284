// Fit of assets/tables/ggx.pfm, by hand: ninja -C build fit_ggx && build/fit_ggx assets/tables/ggx.pfm (a minute).
//
// For each view and roughness a linear map that turns the cosine lobe into GGX times n·l: E. Heitz, J. Dupuy, S. Hill and
// D. Neubelt, "Real-Time Polygonal-Light Shading with Linearly Transformed Cosines", SIGGRAPH 2016; and the split sum.
#include <array>
#include <cstdio>
#include <exception>

#include "04_surface_maps/ggx_table.h"
#include "04_surface_maps/truth.h"

using namespace lightwalk;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int samples = 32;  // along each side of a square

using Params = std::array<double, 3>;

/// GGX times n·l without Fresnel's term, seen from `v` in the plane y = 0.
struct Lobe {
    glm::dvec3 v;
    double alpha;

    double at(glm::dvec3 l) const {
        if (l.z <= 0) return 0;
        const glm::dvec3 h = glm::normalize(l + v);
        return truth::ggx_density(h.z, alpha) * truth::ggx_visibility(l.z, v.z, alpha) * l.z;
    }
    /// Density of sample(), per steradian.
    double density(glm::dvec3 l) const {
        const glm::dvec3 h = glm::normalize(l + v);
        return truth::ggx_density(h.z, alpha) * std::max(h.z, 0.0) / (4 * glm::dot(v, h));
    }
    glm::dvec3 sample(double a, double b) const {
        const double tangent = alpha * std::sqrt(a / (1 - a)), z = 1 / std::sqrt(1 + tangent * tangent);
        const glm::dvec3 h(tangent * z * std::cos(2 * pi * b), tangent * z * std::sin(2 * pi * b), z);
        return 2 * glm::dot(v, h) * h - v;
    }
};

template <class Visit>
void over_square(const Visit& visit) {
    for (int i = 0; i < samples; ++i)
        for (int j = 0; j < samples; ++j) visit((i + 0.5) / samples, (j + 0.5) / samples);
}

/// A and B of the split sum, and the mean direction.
struct Means {
    double a = 0, b = 0;
    glm::dvec3 direction{0};
};

/// A half vector among those visible: E. Heitz, "Sampling the GGX Distribution of Visible Normals", JCGT 7(4), 2018.
glm::dvec3 visible_half_vector(const Lobe& lobe, double a, double b) {
    const glm::dvec3 eye = glm::normalize(glm::dvec3(lobe.alpha * lobe.v.x, 0, lobe.v.z)), side(0, 1, 0);
    const double radius = std::sqrt(a), x = radius * std::cos(2 * pi * b), seen = 0.5 * (1 + eye.z);
    const double y = (1 - seen) * std::sqrt(1 - x * x) + seen * radius * std::sin(2 * pi * b);
    const glm::dvec3 n = x * side + y * glm::cross(eye, side) + std::sqrt(std::max(0.0, 1 - x * x - y * y)) * eye;
    return glm::normalize(glm::dvec3(lobe.alpha * n.x, lobe.alpha * n.y, std::max(n.z, 0.0)));
}

Means means_of(const Lobe& lobe) {
    constexpr int side = 16;  // so many squares of samples
    const double square = lobe.alpha * lobe.alpha, v = lobe.v.z;
    Means means;
    for (int part = 0; part < side * side; ++part)
        over_square([&](double a, double b) {
            const glm::dvec3 h = visible_half_vector(lobe, (part / side + a) / side, (part % side + b) / side);
            const glm::dvec3 l = 2 * glm::dot(lobe.v, h) * h - lobe.v;
            if (l.z <= 0) return;
            // Masking and shadowing over masking alone.
            const double weight = 2 * l.z * (v + std::sqrt(v * v * (1 - square) + square)) *
                                  truth::ggx_visibility(l.z, v, lobe.alpha) / (double(samples * samples) * side * side);
            const double power = std::pow(1 - glm::dot(lobe.v, h), 5);
            means.a += weight * (1 - power);
            means.b += weight * power;
            means.direction += weight * l;
        });
    means.direction = glm::normalize(glm::dvec3(means.direction.x, 0, means.direction.z));
    return means;
}

/// Cosine lobe under a linear map, about the mean direction of what it stands for.
struct Transformed {
    glm::dmat3 map, inverse;
    double determinant = 1;

    Transformed(glm::dvec3 direction, const Params& p) {
        const glm::dmat3 frame(glm::dvec3(direction.z, 0, -direction.x), glm::dvec3(0, 1, 0), direction);
        map = frame * glm::dmat3(p[0], 0, 0, 0, p[1], 0, p[2], 0, 1);
        inverse = glm::inverse(map);
        determinant = std::abs(glm::determinant(map));
    }
    double at(glm::dvec3 l) const {
        const glm::dvec3 from = inverse * l;
        const double longer = glm::length(from);
        return std::max(from.z, 0.0) / (pi * longer * longer * longer * longer * determinant);
    }
    glm::dvec3 sample(double a, double b) const {
        const double z = std::sqrt(1 - a), across = std::sqrt(a);
        return glm::normalize(map * glm::dvec3(across * std::cos(2 * pi * b), across * std::sin(2 * pi * b), z));
    }
};

/// Difference to the third power: large where peaks do not meet (section 4.1 of the paper).
double distance(const Lobe& lobe, const Means& means, const Params& p) {
    if (p[0] < 1e-4 || p[1] < 1e-4) return 1e9;
    const Transformed cosine(means.direction, p);
    double sum = 0;
    const auto add = [&](glm::dvec3 l) {
        const double ours = cosine.at(l), theirs = lobe.density(l), most = std::max(ours + theirs, 1e-300);
        const double off = std::abs(lobe.at(l) / (means.a + means.b) - ours);
        sum += off * off * off / most;
    };
    over_square([&](double a, double b) {
        add(cosine.sample(a, b));
        add(lobe.sample(a, b));
    });
    return sum / (samples * samples);
}

/// J. Nelder and R. Mead, "A Simplex Method for Function Minimization", The Computer Journal 7(4), 1965.
template <class Value>
Params least(Params start, const Value& value) {
    struct Corner {
        Params at;
        double value;
    };
    std::array<Corner, 4> simplex;
    for (size_t i = 0; i < 4; ++i) {
        simplex[i].at = start;
        if (i > 0) simplex[i].at[i - 1] += 0.05 * std::max(std::abs(start[i - 1]), 0.1);
        simplex[i].value = value(simplex[i].at);
    }
    const auto by_value = [](const Corner& a, const Corner& b) { return a.value < b.value; };
    for (int iteration = 0; iteration < 150; ++iteration) {
        std::sort(simplex.begin(), simplex.end(), by_value);
        if (simplex[3].value - simplex[0].value < 1e-6 * simplex[0].value) break;
        Params middle{};
        for (size_t i = 0; i < 3; ++i)
            for (size_t c = 0; c < 3; ++c) middle[c] += simplex[i].at[c] / 3;
        const auto along = [&](double factor) {
            Corner corner;
            for (size_t c = 0; c < 3; ++c) corner.at[c] = middle[c] + factor * (simplex[3].at[c] - middle[c]);
            corner.value = value(corner.at);
            return corner;
        };
        const Corner mirrored = along(-1);
        if (mirrored.value < simplex[0].value) {
            const Corner farther = along(-2);
            simplex[3] = farther.value < mirrored.value ? farther : mirrored;
        } else if (mirrored.value < simplex[2].value) {
            simplex[3] = mirrored;
        } else {
            const Corner nearer = along(mirrored.value < simplex[3].value ? -0.5 : 0.5);
            if (nearer.value < std::min(mirrored.value, simplex[3].value)) {
                simplex[3] = nearer;
                continue;
            }
            for (size_t i = 1; i < 4; ++i) {
                for (size_t c = 0; c < 3; ++c) simplex[i].at[c] = 0.5 * (simplex[i].at[c] + simplex[0].at[c]);
                simplex[i].value = value(simplex[i].at);
            }
        }
    }
    return std::min_element(simplex.begin(), simplex.end(), by_value)->at;
}

void fit(const char* path) {
    constexpr int size = GgxTable::size;
    ImageRgb table(size, 2 * size);
    Params first{1, 1, 0};  // of the row, seen from the front
    for (int row = size - 1; row >= 0; --row) {
        Params p = first;
        for (int column = size - 1; column >= 0; --column) {
            const double n_dot_v = std::max(1 - std::pow(1 - column / (size - 1.0), 2), 1e-3);
            const Lobe lobe{{std::sqrt(1 - n_dot_v * n_dot_v), 0, n_dot_v},
                            std::max(std::pow(row / (size - 1.0), 2), 1e-3)};
            Means means = means_of(lobe);
            const bool in_front = column == size - 1;
            if (in_front) {
                means.direction = {0, 0, 1};  // there it is round
                p = least(p, [&](const Params& q) { return distance(lobe, means, {q[0], q[0], 0}); });
                p = first = {p[0], p[0], 0};
            } else {
                p = least(p, [&](const Params& q) { return distance(lobe, means, q); });
            }
            const glm::dmat3 inverse = Transformed(means.direction, p).inverse / (1 / p[1]);
            table.at(column, row) = glm::vec3(inverse[0][0], inverse[2][0], inverse[0][2]);
            table.at(column, size + row) = glm::vec3(inverse[2][2], means.a, means.b);
        }
    }
    write_pfm(path, table);
}

}  // namespace

int main(int count, char** words) try {
    if (count != 2) {
        std::fputs("usage: fit_ggx FILE.pfm\n", stderr);
        return 2;
    }
    fit(words[1]);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}
