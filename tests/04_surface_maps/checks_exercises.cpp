// Checks of the shaders of chapter 04: values against double precision, then properties.
#include "04_surface_maps/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

template <class Vector>
Row row_of(const Vector& v) {
    Row row;
    append(row, v);
    return row;
}

// A unit vector of tangent space, with z at least `lowest`.
glm::vec3 upward(Random& random, float lowest) {
    glm::vec3 v = random.direction();
    v.z = std::max(std::fabs(v.z), lowest);
    return glm::normalize(v);
}

}  // namespace

CHECK_EXERCISE(
    "04.unpack_normal",
    "the codes 0 to 1 stand for -1 to 1; z completes the vector to length 1, or is 0 if x and y are too long") {
    Probe probe{.include = "04_surface_maps/unpack_normal.glsl",
                .signature = "vec3 unpack_normal(vec2 code, float strength)",
                .inputs = {{0.5, 0.5, 1},
                           {1, 0.5, 1},
                           {0.5, 0, 1},
                           {1, 1, 1},
                           {0, 0, 2},
                           {0.5, 0.5, 0},
                           {1, 0.5, 0},
                           {0.8, 0.5, 0},
                           {0.8, 0.4, 1},
                           {0.8, 0.4, 4},
                           {0.2, 0.9, 0.5}},
                .truth =
                    [](std::span<const double> in) {
                        return row_of(truth::unpack_normal({in[0], in[1]}, in[2]));
                    },
                // Near the equator z is the root of a small difference.
                .bound = {.absolute = 1e-3},
                .hint = [](auto in, auto got) -> std::string {
                    const glm::dvec2 xy(2 * in[0] - 1, 2 * in[1] - 1);
                    if (in[2] == 0 && glm::dot(xy, xy) >= 1) return "nothing is left of this one: (0, 0, 1)";
                    if (glm::dot(xy, xy) > 1)
                        return "x and y are too long for any z: z is 0, and the whole is made unit length";
                    if (std::fabs(glm::length(vector3(got, 0)) - 1) > 1e-3) return "make the result unit length";
                    if (in[2] != 1) return "strength scales x and y, before the whole is made unit length, and not z";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 2000; ++i)
        probe.inputs.push_back({random.uniform(0, 1), random.uniform(0, 1), random.uniform(0.1, 4)});
    const Table results = check.probe(probe);
    check.property(probe, results, "but it must have length 1 and z at least 0",
                   [](auto, auto out) { return std::fabs(glm::length(vector3(out, 0)) - 1) < 1e-5 && out[2] >= 0; });
}

CHECK_EXERCISE("04.blend_detail", "add (0, 0, 1) to the base, negate x and y of the detail, and follow the formula") {
    Probe probe{
        .include = "04_surface_maps/blend_detail.glsl",
        .signature = "vec3 blend_detail(vec3 base, vec3 detail)",
        .truth = [](std::span<const double> in) { return row_of(truth::blend_detail(vector3(in, 0), vector3(in, 3))); },
        .bound = {.absolute = 1e-5}};
    Random random;
    const glm::vec3 flat(0, 0, 1);
    const auto add = [&](glm::vec3 base, glm::vec3 detail) {
        Row row = row_of(base);
        append(row, detail);
        probe.inputs.push_back(row);
    };
    add(flat, flat);
    for (int i = 0; i < 200; ++i) {
        add(flat, upward(random, 0));
        add(upward(random, 0), flat);
    }
    for (int i = 0; i < 1000; ++i) add(upward(random, 0), upward(random, 0));
    const Table results = check.probe(probe);
    check.property(
        probe, results, "but the angle between base and result must be that of the detail",
        [](auto in, auto out) { return std::fabs(glm::dot(vector3(in, 0), vector3(out, 0)) - in[5]) < 1e-4; });
}

CHECK_EXERCISE("04.parallax_offset",
               "per unit of depth the ray moves sideways by x / z and y / z; the limited version drops the / z") {
    const auto probe_of = [](const std::string& name, auto reference) {
        Probe probe{.include = "04_surface_maps/parallax_offset.glsl",
                    .signature = "vec2 " + name + "(float depth, vec3 to_eye, vec2 deepest)",
                    .truth =
                        [reference](std::span<const double> in) {
                            return row_of(reference(in[0], vector3(in, 1), glm::dvec2(in[4], in[5])));
                        },
                    .bound = {.absolute = 1e-6, .relative = 1e-5}};
        Random random;
        probe.inputs = {
            {1, 0, 0, 1, 0.1, 0.1}, {0, 0.6, 0, 0.8, 0.1, 0.1}, {1, 0.6, 0, 0.8, 0.1, 0.1}, {1, 0, 0.6, 0.8, 0.1, 0.2}};
        for (int i = 0; i < 1000; ++i) {
            Row row{random.uniform(0, 1)};
            append(row, upward(random, 0.02f));
            row.insert(row.end(), {random.uniform(0, 0.2), random.uniform(0, 0.2)});
            probe.inputs.push_back(row);
        }
        return probe;
    };
    check.probe(probe_of("parallax_offset", truth::parallax_offset));
    const Probe limited = probe_of("parallax_offset_limited", truth::parallax_offset_limited);
    const Table results = check.probe(limited);
    check.property(limited, results, "further than depth times deepest", [](auto in, auto out) {
        return std::fabs(out[0]) <= in[0] * in[4] + 1e-6 && std::fabs(out[1]) <= in[0] * in[5] + 1e-6;
    });
}

CHECK_EXERCISE("04.parallax_occlusion",
               "compare the ray's depth with the surface's, layer by layer; then intersect two straight lines") {
    for (const int field : {4, 1, 2}) {
        const auto probe_of = [&](const std::string& name, double (*reference)(int, double, double, int)) {
            Probe probe{.include = "../tests/04_surface_maps/known_field.glsl",
                        .signature = "float " + name + "(vec2 uv, vec2 shift, int steps)",
                        .truth =
                            [=](std::span<const double> in) {
                                return Row{reference(field, in[0], in[2], static_cast<int>(in[4]))};
                            },
                        .bound = {.absolute = 2e-4},
                        .macros = {{"FIELD", std::to_string(field)}}};
            const std::string surface = field == 1   ? "a ramp, depth_at = fract(u): "
                                        : field == 2 ? "a wave, depth_at = 0.5 + 0.5 sin(2 pi u): "
                                                     : "a plane, depth_at = 0.5: ";
            probe.words = [surface](const std::string& parameter, std::span<const double> v) {
                return parameter == "uv" ? "(" + number_text(v[0]) + ", " + number_text(v[1]) + ") over " +
                                               surface.substr(0, surface.size() - 2)
                                         : std::string();
            };
            probe.hint = [reference, field](auto in, auto) -> std::string {
                const double right = reference(field, in[0], in[2], static_cast<int>(in[4]));
                if (right == 0)
                    return "the very first layer, depth 0, is below the surface already: no layer is before it";
                if (right == 1) return "no layer before the last is below: at depth 1 the ray always is";
                return "";
            };
            if (field == 4)
                probe.inputs = {{0.3, 0.3, 0, 0, 1}, {0.3, 0.3, 0, 0, 2}, {0.3, 0.3, 0, 0, 3}, {0.3, 0.3, 0.5, 0, 7}};
            if (field == 1)  // at the mesh already
                probe.inputs = {{0, 0.3, 0, 0, 1}, {0, 0.3, 0, 0, 4}};
            Random random;
            for (int i = 0; i < 600; ++i) {
                const double u = random.uniform(0, 1), shift = random.uniform(-0.6, 0.6);
                const int steps = 2 + i % 60;
                // Where the ray grazes a layer, single precision may take the other side.
                double nearest = 1;
                for (int k = 0; k <= steps; ++k) {
                    const double t = double(k) / steps, at = u - t * shift;
                    nearest = std::min(nearest, std::fabs(truth::field_depth(field, at) - t));
                    if (field == 1) nearest = std::min(nearest, std::fabs(at - std::round(at)));  // the ramp's edge
                }
                if (nearest > 1e-4) probe.inputs.push_back({u, 0.3, shift, 0.1, double(steps)});
            }
            return probe;
        };
        const Probe layer = probe_of("first_layer_below", truth::first_layer_below);
        const Table layers = check.probe(layer);
        check.property(layer, layers, "which is none of the layers",
                       [](auto in, auto out) { return std::fabs(out[0] * in[4] - std::round(out[0] * in[4])) < 1e-3; });
        const Probe occlusion = probe_of("parallax_occlusion", truth::parallax_occlusion);
        check.property(occlusion, check.probe(occlusion), "but a depth is from 0 to 1",
                       [](auto, auto out) { return out[0] >= 0 && out[0] <= 1; });
    }
}

CHECK_EXERCISE("04.mix_orm", "a metal has no diffuse colour; guard the division where roughness is 0") {
    Probe probe{
        .include = "04_surface_maps/mix_orm.glsl",
        .signature = "MixedMaterial mix_orm(vec3 base, float roughness, float metalness)",
        .inputs = {{1, 0.5, 0.2, 1, 0},
                   {1, 0.5, 0.2, 0, 0},
                   {1, 0.5, 0.2, 0.5, 1},
                   {1, 0.5, 0.2, 0.3, 0.5},
                   {0, 0, 0, 0.01, 1}},
        .truth =
            [](std::span<const double> in) {
                const truth::Mixed mixed = truth::mix_orm(vector3(in, 0), in[3], in[4]);
                Row row = row_of(mixed.diffuse);
                append(row, mixed.specular);
                row.push_back(mixed.shininess);
                return row;
            },
        .bound = {.absolute = 1e-5, .relative = 1e-4},
        .words = [](const std::string& name, std::span<const double> v) -> std::string {
            const auto color = [&](size_t at) {
                return "(" + number_text(v[at]) + ", " + number_text(v[at + 1]) + ", " + number_text(v[at + 2]) + ")";
            };
            return name.empty() && v.size() == 7
                       ? "diffuse " + color(0) + ", specular " + color(3) + ", shininess " + number_text(v[6])
                       : "";
        },
        .hint = [](auto in, auto got) -> std::string {
            const truth::Mixed right = truth::mix_orm(vector3(in, 0), in[3], in[4]);
            if (glm::length(vector3(got, 0) - right.diffuse) > 1e-4)
                return "diffuse is wrong: a metal has none, anything else base";
            if (glm::length(vector3(got, 3) - right.specular) > 1e-4)
                return "specular is wrong: 0.04 for what is no metal, base for a metal, in proportion in between";
            return in[3] == 0 ? "roughness 0 divides by 0: the exponent is most_shininess"
                              : "the exponent is wrong: alpha is roughness squared, and squared again below the 2";
        }};
    Random random;
    for (int i = 0; i < 1000; ++i)
        probe.inputs.push_back({random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1),
                                random.uniform(0, 1)});
    const Table results = check.probe(probe);
    check.property(probe, results, "which reflects more than arrives",
                   [](auto, auto out) { return out[0] + out[3] <= 1.04001; });
    Probe override{.include = probe.include,
                   .signature = "float overridden(float map, float override)",
                   .inputs = {{0.3, -1}, {0.3, 0}, {0.3, 0.7}, {0, 1}, {1, -0.5}},
                   .truth = [](std::span<const double> in) { return Row{in[1] >= 0 ? in[1] : in[0]}; },
                   .bound = {.absolute = 1e-6}};
    check.probe(override);
}

CHECK_EXERCISE("04.cutout", "the three alphas are multiplied; a point at the cutoff stays") {
    Probe alpha{.include = "04_surface_maps/cutout.glsl",
                .signature = "float surface_alpha(float color_alpha, float opacity_texel, float opacity)",
                .inputs = {{1, 1, 1}, {0.5, 1, 1}, {1, 0.5, 1}, {1, 1, 0.5}, {0.5, 0.5, 0.5}, {0, 1, 1}},
                .truth = [](std::span<const double> in) { return Row{in[0] * in[1] * in[2]}; },
                .bound = {.absolute = 1e-6}};
    check.probe(alpha);
    Probe cut{.include = alpha.include,
              .signature = "bool is_cut_out(float alpha, float cutoff)",
              .inputs = {{0.4, 0.5}, {0.5, 0.5}, {0.6, 0.5}, {0, 0}, {1, 1}, {0.999, 1}},
              .truth = [](std::span<const double> in) { return Row{in[0] < in[1] ? 1.0 : 0.0}; },
              .bound = {.absolute = 0}};
    check.probe(cut);
}

CHECK_EXERCISE("04.anisotropy",
               "As many reads as the footprint is longer than wide, each of the level of its own piece.") {
    Probe probe{.include = "04_surface_maps/anisotropy.glsl",
                .signature = "vec4 footprint_reads(vec2 across, vec2 down, float limit)",
                // Chapter 07's floor, 20 m away; both vectors as the longer one; magnified; no texture coordinates.
                .inputs = {{10.24, 0, 0, 128, 16},
                           {0, 128, 10.24, 0, 16},
                           {10.24, 0, 0, 128, 4},
                           {0.3, 0, 0, 0.2, 16},
                           {9.5, 0, 0, 0.25, 16},
                           {0, 0, 0, 0, 16},
                           {40, 0, 0, 0, 8},
                           {3, 4, -2, 1.5, 1}},
                .truth =
                    [](std::span<const double> in) {
                        // EXT_texture_filter_anisotropic: N = min(ceil(Pmax / Pmin), limit), level log2(Pmax / N).
                        const double across = std::hypot(in[0], in[1]), down = std::hypot(in[2], in[3]);
                        const double longer = std::max({across, down, 1e-6}), shorter = std::min(across, down);
                        const double n = std::clamp(std::ceil(longer / std::max(shorter, 1.0)), 1.0, in[4]);
                        const size_t first = across < down ? 2 : 0;
                        return Row{in[first], in[first + 1], n, std::log2(longer / n)};
                    },
                .bound = {.absolute = 1e-3, .relative = 1e-4}};
    probe.hint = [](auto in, auto got) -> std::string {
        const double across = std::hypot(in[0], in[1]), down = std::hypot(in[2], in[3]);
        if (std::min(across, down) < 1 && got[2] > std::max(std::ceil(std::max(across, down)), 1.0))
            return "A shorter side below one texel counts as one texel.";
        const bool whole = std::fabs(got[3] - std::log2(std::max({across, down, 1e-6}))) < 1e-3;
        return got[2] > 1 && whole
                   ? "Each read stands for an n-th of the longer side: its level is that of this length."
                   : "";
    };
    Random random;
    while (probe.inputs.size() < 500) {
        const glm::dvec2 direction = glm::normalize(glm::dvec2(random.uniform(-1, 1), random.uniform(0.1, 1)));
        const double longer = random.logarithmic(0.1, 2000), ratio = random.logarithmic(1.01, 40);
        const double rounded = longer / std::max(longer / ratio, 1.0);
        if (std::fabs(rounded - std::round(rounded)) < 1e-3) continue;  // rounding decides
        const glm::dvec2 a = longer * direction, b = longer / ratio * glm::dvec2(-direction.y, direction.x);
        const glm::dvec2 across = probe.inputs.size() % 2 ? a : b, down = probe.inputs.size() % 2 ? b : a;
        probe.inputs.push_back({across.x, across.y, down.x, down.y, std::exp2(std::floor(random.uniform(0, 5)))});
    }
    check.probe(probe);
}
