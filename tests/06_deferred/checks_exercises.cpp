// Checks of the shaders of chapter 06 that can be called one by one.
#include "06_deferred/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

template <class Vector>
Row row_of(const Vector& v) {
    Row row;
    append(row, v);
    return row;
}

// The axes, the edges where the fold is, and directions all over the sphere.
std::vector<glm::vec3> directions() {
    std::vector<glm::vec3> all;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x || y || z) all.push_back(glm::normalize(glm::vec3(x, y, z)));
    Random random;
    for (int i = 0; i < 3000; ++i) all.push_back(random.direction());
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 d = random.direction();
        all.push_back(glm::normalize(glm::vec3(d.x, d.y, -1e-4f * std::fabs(d.z))));
        all.push_back(glm::normalize(glm::vec3(1e-4f * d.x, 1e-4f * d.y, -1)));
    }
    return all;
}

}  // namespace

CHECK_EXERCISE("06.encode_normal", "divide by |x| + |y| + |z|; fold x and y only where z is negative") {
    Probe probe{.include = "06_deferred/encode_normal.glsl",
                .signature = "vec2 encode_normal(vec3 normal)",
                .truth = [](std::span<const double> in) { return row_of(truth::encode_normal(vector3(in, 0))); },
                .bound = {.absolute = 2e-6},
                .hint = [](auto in, auto got) -> std::string {
                    if (in[2] >= 0) return "the upper half: x and y, divided by |x| + |y| + |z|";
                    if (in[0] == 0 || in[1] == 0) return "the sign of 0 is 1 here, and sign(0.0) is 0";
                    const glm::dvec2 e =
                        glm::dvec2(in[0], in[1]) / (std::fabs(in[0]) + std::fabs(in[1]) + std::fabs(in[2]));
                    if (std::fabs(got[0] - e.x) < 1e-6)
                        return "the lower half has to be folded outwards, into the corners";
                    return "the lower half: 1 - |y| with the sign of x, and 1 - |x| with the sign of y";
                }};
    for (const glm::vec3& d : directions()) probe.inputs.push_back(row_of(d));
    const Table results = check.probe(probe);
    check.property(probe, results, "but a code is in [-1, 1]",
                   [](auto, auto out) { return std::fabs(out[0]) <= 1.00001 && std::fabs(out[1]) <= 1.00001; });
}

CHECK_EXERCISE("06.decode_normal", "z is 1 - |x| - |y|; where it is negative, fold x and y back; then normalise") {
    Probe probe{.include = "06_deferred/decode_normal.glsl",
                .signature = "vec3 decode_normal(vec2 code)",
                .truth =
                    [](std::span<const double> in) {
                        return row_of(truth::decode_normal({in[0], in[1]}));
                    },
                .bound = {.absolute = 2e-6},
                .hint = [](auto in, auto got) -> std::string {
                    if (std::fabs(glm::length(vector3(got, 0)) - 1) > 1e-4) return "make it unit length";
                    if (std::fabs(in[0]) + std::fabs(in[1]) <= 1) return "inside the diamond x and y stay as they are";
                    return "in a corner z is below 0, and x and y are folded as encode_normal() folds them";
                }};
    Random random;
    for (const glm::vec3& d : directions()) {
        const glm::dvec2 e = truth::encode_normal(glm::dvec3(d));
        probe.inputs.push_back({double(float(e.x)), double(float(e.y))});
        const glm::dvec2 coarse = truth::quantised(e, 8);
        probe.inputs.push_back({double(float(coarse.x)), double(float(coarse.y))});
    }
    check.probe(probe);
}

CHECK_EXERCISE(
    "06.quantise",
    "how many steps are there from -1 to 1, and how many numbers fit into `bits` bits? Follow 1 and -1 through") {
    Random random(6);
    for (const int bits : {8, 12, 16, 2, 4, 5}) {
        const double most = (1 << (bits - 1)) - 1;
        Probe probe{.include = "../tests/06_deferred/round_trip.glsl",
                    .signature = "CheckRoundTrip check_round_trip(vec2 code, int bits, int other)",
                    .truth =
                        [](auto in) {
                            return Row{std::clamp(in[0], -1.0, 1.0), std::clamp(in[1], -1.0, 1.0), 0};
                        },
                    .bound = {.absolute = 0.5 / most + 1e-6},
                    .hint = [](auto in, auto got) -> std::string {
                        if (got[0] != got[0] || got[1] != got[1]) return "";
                        for (const size_t k : {0, 1})
                            if (in[k] > 0.9 && got[k] < 0)
                                return "1 came back as -1: the number of its step needs a bit more than there is";
                        if (got[2] != 0)
                            return "a number has become too large for its bits, and spills into those above";
                        return "";
                    }};
        for (const double x : {0.0, 1.0, -1.0})
            for (const double y : {0.0, 1.0, -1.0})
                for (const double other : {0.0, -1.0}) probe.inputs.push_back({x, y, double(bits), other});
        const size_t exact = probe.inputs.size();
        probe.inputs.push_back({1.0000001, -1.0000001, double(bits), 0});
        for (int i = 0; i < 200; ++i)
            probe.inputs.push_back(
                {random.uniform(-1, 1), random.uniform(-1, 1), double(bits), std::floor(random.uniform(-2e9, 2e9))});
        // The middle between two steps, give or take: the farthest that a code is moved.
        for (int i = 0; i < 20; ++i) {
            const double middle = (std::floor(random.uniform(-most, most)) + 0.5) / most;
            probe.inputs.push_back({middle * 0.99999, middle * 0.99999, double(bits), -1});
        }
        for (Row& row : probe.inputs) {
            row[0] = double(float(row[0]));
            row[1] = double(float(row[1]));
        }
        const Table results = check.probe(probe);
        if (check.failed) return;
        for (size_t i = 0; i < results.size(); ++i) {
            const Row &in = probe.inputs[i], &got = results[i];
            check.expect(i >= exact || (std::fabs(got[0] - in[0]) <= 1e-6 && std::fabs(got[1] - in[1]) <= 1e-6),
                         call_text(probe, in) + " " + gave_text(std::span(got).first(2), std::span(in).first(2)) +
                             ": -1, 0 and 1 come back exactly");
            check.expect(got[2] == 0,
                         call_text(probe, in) + fmt::format(" wrote {:g} bits above those of the code", got[2]),
                         "a number has become too large for its bits");
            if (check.failed) return;
        }
    }
}

CHECK_EXERCISE("06.position_from_depth", "map the pixel's centre to -1 ... 1, multiply by the matrix, divide by w") {
    Probe probe{.include = "06_deferred/position_from_depth.glsl",
                .signature = "vec3 position_from_depth(uvec2 pixel, float depth, vec2 size, mat4 clip_to_world)",
                .truth =
                    [](std::span<const double> in) {
                        glm::dmat4 m;
                        for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = in[5 + i];
                        return row_of(truth::position_from_depth({in[0], in[1]}, in[2], {in[3], in[4]}, m));
                    },
                .bound = {.absolute = 1e-3, .relative = 1e-4},
                .words = [](const std::string& name, std::span<const double>) -> std::string {
                    return name == "clip_to_world" ? "the inverse of a camera's matrix" : "";
                }};
    const auto wrong_by = [&probe](auto change) {
        return [change, reference = probe.truth](std::span<const double> in, std::span<const double> got) {
            Row other(in.begin(), in.end());
            change(other);
            const Row as = reference(other);
            return glm::distance(vector3(as, 0), vector3(got, 0)) < 1e-3 * (1 + glm::length(vector3(as, 0)));
        };
    };
    const auto corner = wrong_by([](Row& r) {
        r[0] -= 0.5;
        r[1] -= 0.5;
    });
    const auto flipped = wrong_by([](Row& r) { r[1] = r[4] - 1 - r[1]; });
    const auto doubled = wrong_by([](Row& r) { r[2] = 2 * r[2] - 1; });
    probe.hint = [=](auto in, auto got) -> std::string {
        if (corner(in, got)) return "that is the pixel's corner: its middle is at pixel + 0.5";
        if (flipped(in, got)) return "y goes down here, as the rows of a picture do: nothing is to be turned around";
        if (doubled(in, got)) return "depth is clip space's z as it stands; only x and y go from -1 to 1";
        return "what the matrix gives is homogeneous: divide by w";
    };
    Random random;
    for (int i = 0; i < 400; ++i) {
        // Looking along -z from anywhere, near 0.1 m and far 1000 m.
        const double focal = random.uniform(0.8, 3), aspect = random.uniform(0.5, 2), n = 0.1, f = 1000;
        glm::dmat4 projection(0.0), move(1.0);
        projection[0][0] = focal / aspect;
        projection[1][1] = -focal;
        projection[2][2] = n / (f - n);
        projection[2][3] = -1;
        projection[3][2] = n * f / (f - n);
        move[3] = glm::dvec4(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5), 1);
        const glm::dmat4 inverse = glm::inverse(projection * move);
        const double distance = random.logarithmic(0.2, 60), width = 64 + i % 300, height = 48 + i % 200;
        Row row{std::floor(random.uniform(0, width)), std::floor(random.uniform(0, height)),
                double(float(n * (f - distance) / (distance * (f - n)))), width, height};
        for (int k = 0; k < 16; ++k) row.push_back(double(float(inverse[k / 4][k % 4])));
        probe.inputs.push_back(row);
    }
    check.probe(probe);
}

CHECK_EXERCISE("06.cull_back_face", "the sign of dot(cross(b - a, c - a), a), reversed for mirrored instances") {
    Probe probe{
        .include = "06_deferred/cull_back_face.glsl",
        .signature = "bool is_back_face(vec3 a, vec3 b, vec3 c, bool mirrored)",
        .truth =
            [](std::span<const double> in) {
                return Row{truth::faces_away(vector3(in, 0), vector3(in, 3), vector3(in, 6), in[9] != 0) >= 0 ? 1.0
                                                                                                              : 0.0};
            },
        .bound = {.absolute = 0},
        .words = [](const std::string& name, std::span<const double> v) -> std::string {
            return name.empty() ? (v[0] != 0 ? "true" : "false") : "";
        },
        .hint = [](auto in, auto) -> std::string {
            const glm::dvec3 a = vector3(in, 0), b = vector3(in, 3), c = vector3(in, 6);
            if (glm::length(glm::cross(b - a, c - a)) == 0) return "it has no area: nobody sees it";
            if (truth::faces_away(a, b, c, false) == 0) return "the eye is in its plane: it is seen from the edge";
            if (std::max({a.z, b.z, c.z}) > 0)
                return "a corner is behind the eye: divided by its w, its place on the screen is on the wrong side";
            if (in[9] != 0) return "a mirror turns counter-clockwise into clockwise";
            return "the triangle's normal against the way from the eye to it";
        }};
    const auto add = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        for (const double mirrored : {0.0, 1.0}) {
            Row row = row_of(a);
            append(row, b);
            append(row, c);
            row.push_back(mirrored);
            probe.inputs.push_back(row);
        }
    };
    add({-1, -1, -5}, {1, -1, -5}, {0, 1, -5});
    add({0, 1, -5}, {1, -1, -5}, {-1, -1, -5});
    add({1, 1, -3}, {1, 1, -3}, {2, 0, -4});     // no area
    add({0, 0, -1}, {0, 0, -2}, {0, 0, -4});     // a line
    add({0, 0, -1}, {1, 0, -2}, {-1, 0, -4});    // from the edge
    add({-3, -1, 4}, {3, -1, 4}, {0, -1, -40});  // a floor that begins behind the eye
    add({0, -1, -40}, {3, -1, 4}, {-3, -1, 4});  // and from below
    Random random;
    for (int i = 0; i < 4000; ++i) {
        const auto point = [&] {
            return glm::vec3(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-6, i % 2 ? -0.5 : 6));
        };
        const glm::vec3 a = point(), b = point(), c = point();
        if (std::fabs(truth::faces_away(glm::dvec3(a), glm::dvec3(b), glm::dvec3(c), false)) > 1e-3) add(a, b, c);
    }
    check.probe(probe);
}

CHECK_EXERCISE("06.pack_material",
               "clamp, take the root or the logarithm, and round; packUnorm4x8 does the last step for four") {
    Probe probe{.include = "06_deferred/pack_material.glsl",
                .signature = "uvec2 pack_material(PixelMaterial m)",
                .inputs = {{0, 0, 0, 0, 0, 0, 0, 0, 0},
                           {1, 1, 1, 1, 1, 1, 8192, 1, 1},
                           {1, 0, 0, 0, 0, 0, 0, 0, 0},
                           {0, 0, 0, 1.5, 3, 40, 30, 1, 0},  // specular above 1
                           {0.5, 0.5, 0.5, 0.04, 0.04, 0.04, 100000, 1, 1},
                           {0.002, 0.002, 0.002, 0.04, 0.04, 0.04, 1, 0.5, 0}}};
    Random random;
    for (int i = 0; i < 1000; ++i) {
        Row row;
        for (int k = 0; k < 6; ++k) row.push_back(random.uniform(0, 1));
        row.push_back(random.logarithmic(0.01, 9000));
        row.insert(row.end(), {random.uniform(0, 1), double(i % 2)});
        probe.inputs.push_back(row);
    }
    constexpr const char* names[] = {"diffuse red",  "diffuse green",  "diffuse blue",  "gloss",
                                     "specular red", "specular green", "specular blue", "occlusion"};
    probe.truth = [](auto) { return Row{0, 0}; };
    probe.bound = {.absolute = 1e30};  // compared below, byte by byte
    const Table results = check.probe(probe);
    for (size_t i = 0; i < results.size(); ++i) {
        const Row& in = probe.inputs[i];
        const auto codes = truth::material_codes(vector3(in, 0), vector3(in, 3), in[6], in[7]);
        const uint32_t words[] = {static_cast<uint32_t>(static_cast<int64_t>(results[i][0])),
                                  static_cast<uint32_t>(static_cast<int64_t>(results[i][1]))};
        for (size_t k = 0; k < 8; ++k) {
            const uint32_t code = words[k / 4] >> 8 * (k % 4) & (k == 7 ? 127u : 255u);
            const bool clamps = (k == 3 && in[6] > 8192) || (k >= 4 && k < 7 && in[3 + k - 4] > 1);
            check.expect(std::fabs(code - codes[k]) <= 0.51,
                         call_text(probe, in) + " packed " + names[k] + " as " + std::to_string(code) + ", expected " +
                             number_text(std::round(codes[k])),
                         clamps ? "too much for its bits: clamp it first, or it runs over into its neighbour"
                         : std::fabs(code - codes[k]) < 1 ? "round to the nearest code, do not cut off"
                                                          : "");
        }
        check.expect((words[1] >> 31) == (in[8] != 0 ? 1u : 0u),
                     call_text(probe, in) + " has the last bit " + std::to_string(words[1] >> 31) + ", expected " +
                         number_text(in[8]),
                     "the last bit of the second word says whether ambient_specular is 1");
    }
}
