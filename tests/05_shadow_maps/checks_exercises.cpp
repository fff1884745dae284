// Checks of chapter 05: values against double precision, then properties.
#include "05_shadow_maps/exercises.h"
#include "05_shadow_maps/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

// Depth 1 at `near`, 0 at `far`, y down, looking along `forward`.
glm::mat4 lamp(glm::vec3 eye, glm::vec3 forward, float slope, float near, float far) {
    const glm::vec3 up = std::fabs(forward.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right = glm::normalize(glm::cross(forward, up)), down = glm::cross(forward, right);
    const glm::vec4 rows[] = {glm::vec4(right, -glm::dot(right, eye)) / slope,
                              glm::vec4(down, -glm::dot(down, eye)) / slope,
                              glm::vec4(-forward, glm::dot(forward, eye)) * (near / (far - near)),
                              glm::vec4(forward, -glm::dot(forward, eye))};
    glm::mat4 m = glm::transpose(glm::mat4(rows[0], rows[1], rows[2], rows[3]));
    m[3][2] += far * near / (far - near);
    return m;
}

glm::mat4 sun(glm::vec3 forward, float half_width, float far) {
    glm::mat4 m = lamp(glm::vec3(0.0f), forward, half_width, 1, 2);
    for (int column = 0; column < 4; ++column) {
        m[column][2] = -m[column][3] / far + (column == 3 ? 1.0f : 0.0f);
        m[column][3] = column == 3 ? 1.0f : 0.0f;
    }
    return m;
}

glm::dmat4 matrix(std::span<const double> in) {
    glm::dmat4 m;
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = in[size_t(i)];
    return m;
}

}  // namespace

CHECK_EXERCISE("05.light_clip_position", "multiply, test w, divide by w, and map -1 to 1 onto 0 to 1") {
    Probe probe{.include = "05_shadow_maps/light_clip_position.glsl",
                .signature = "vec3 light_clip_position(mat4 to_clip, vec3 position)",
                .truth =
                    [](std::span<const double> in) {
                        Row row;
                        append(row, truth::light_clip_position(matrix(in), {in[16], in[17], in[18]}));
                        return row;
                    },
                .bound = {.absolute = 2e-3, .relative = 1e-4},
                .words = [](const std::string& name, std::span<const double>) -> std::string {
                    return name == "to_clip" ? "a light's matrix" : "";
                },
                .hint = [](auto in, auto got) -> std::string {
                    const glm::dvec4 clip = matrix(in) * glm::dvec4(in[16], in[17], in[18], 1);
                    const glm::dvec3 right = truth::light_clip_position(matrix(in), {in[16], in[17], in[18]});
                    if (clip.w <= 0)
                        return "the point is behind the light, w is " + number_text(clip.w) +
                               ": the result is vec3(-1)";
                    if (std::fabs(right.y - 0.5) > 0.01 && std::fabs(got[1] - (1 - right.y)) < 1e-3 &&
                        std::fabs(got[0] - right.x) < 1e-3)
                        return "v is upside down: in clip space y points down already, as v does";
                    if (std::fabs(got[2] - (0.5 + 0.5 * right.z)) < 1e-3 && std::fabs(got[0] - right.x) < 1e-3)
                        return "depth goes from 0 to 1 already: only x and y come from -1 to 1";
                    if (std::fabs(got[2] - right.z) > 1e-3 && std::fabs(got[2] - clip.z) < 1e-3)
                        return "depth, too, is divided by w";
                    return "";
                }};
    Random random;
    const auto add = [&](const glm::mat4& m, glm::vec3 position) {
        const float w = (m * glm::vec4(position, 1.0f)).w;
        if (w != 0.0f && std::fabs(w) < 0.05f) return;  // near the edge, where rounding decides
        Row row;
        for (int column = 0; column < 4; ++column) append(row, m[column]);
        append(row, position);
        probe.inputs.push_back(row);
    };
    const glm::mat4 ahead = lamp(glm::vec3(0.0f), {0, 0, -1}, 1, 0.125f, 16);
    for (const glm::vec3 p : {glm::vec3(0, 0, -1), glm::vec3(0.5f, 0, -1), glm::vec3(0, 0.5f, -1), glm::vec3(0, 0, 1),
                              glm::vec3(0.25f, 0.25f, 2), glm::vec3(1, 1, 0), glm::vec3(0.0f)})
        add(ahead, p);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 eye(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4));
        add(lamp(eye, random.direction(), static_cast<float>(random.uniform(0.2, 2)), 0.1f, 20),
            {random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)});
        add(sun(random.direction(), 8, 20), {random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)});
    }
    check.probe(probe);
}

CHECK_EXERCISE("05.compare_depth", "greater depth is nearer to the light; a point outside the map is lit") {
    Probe probe{.include = "05_shadow_maps/compare_depth.glsl",
                .signature = "float compare_depth(vec3 place, float stored)",
                .inputs = {{0.5, 0.5, 0.4, 0.6},
                           {0.5, 0.5, 0.6, 0.4},
                           {0.5, 0.5, 0.5, 0.5},
                           {0.5, 0.5, 0.3, 0},
                           {0.5, 0.5, 0, 0},
                           {-1, -1, -1, 0.5},
                           {1.2, 0.5, 0.1, 0.9},
                           {0.5, -0.1, 0.1, 0.9},
                           {0.5, 1.1, 0.1, 0.9},
                           {-0.1, 0.5, 0.1, 0.9},
                           {0.5, 0.5, -0.25, 0.5},  // before the near plane and behind the far one
                           {0.5, 0.5, -0.25, 0},
                           {0.5, 0.5, 1.25, 0.5},
                           {0.5, 0.5, 1.25, 1},
                           {0.5, 0.5, 0.5, 1},  // the nearest surface lies on the near plane
                           {0.5, 0.5, 1, 1},
                           {0, 0, 0.25, 0.5},
                           {1, 1, 0.25, 0.5}},
                .truth =
                    [](std::span<const double> in) {
                        return Row{truth::compare_depth({in[0], in[1], in[2]}, in[3])};
                    },
                .bound = {.absolute = 1e-6},
                .hint = [](auto in, auto) -> std::string {
                    if (in[0] < 0 || in[0] > 1 || in[1] < 0 || in[1] > 1)
                        return "the point is outside the map, which knows nothing of it: it is lit";
                    if (in[2] < 0 || in[2] > 1)
                        return "what the map knows is a matter of xy; a z outside 0 to 1 is compared like any other";
                    if (in[2] == in[3]) return "a depth equal to the stored one is the surface itself: it is lit";
                    return "depth is reversed: the nearer to the light, the greater";
                }};
    Random random;
    for (int i = 0; i < 500; ++i)
        probe.inputs.push_back(
            {random.uniform(-0.5, 1.5), random.uniform(-0.5, 1.5), random.uniform(-0.5, 1.5), random.uniform(0, 1)});
    check.probe(probe);
}

CHECK_EXERCISE("05.slope_bias",
               "along the diagonal a texel's centre is sqrt(2) * reach texels away; multiply by the tangent") {
    Probe probe{.include = "05_shadow_maps/slope_bias.glsl",
                .signature = "float slope_bias(float cosine, float texel, float reach)",
                .inputs = {{1, 0.01, 0.5},
                           {0.7071068, 0.01, 0.5},
                           {0.5, 0.01, 0.5},
                           {0.5, 0.01, 3},
                           {0, 0.01, 0.5},
                           {0.01, 0.02, 0.5},
                           {0.025, 0.02, 1}},
                .truth = [](std::span<const double> in) { return Row{truth::slope_bias(in[0], in[1], in[2])}; },
                .bound = {.absolute = 1e-6, .relative = 3e-3},
                .hint = [](auto in, auto got) -> std::string {
                    const double right = truth::slope_bias(in[0], in[1], in[2]);
                    if (in[0] < 0.025) return "below a cosine of 0.025 the bias grows no more";
                    if (std::fabs(got[0] * std::sqrt(2.0) - right) < 1e-2 * right)
                        return "that is along u or along v alone: along the diagonal it is sqrt(2) times as far";
                    const double tangent = std::tan(std::acos(in[0])), sine = std::sqrt(1 - in[0] * in[0]);
                    if (tangent > 0 && std::fabs(got[0] - right / tangent * sine) < 1e-2 * right)
                        return "the sine says how far along the normal; towards the light it is the tangent";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 1000; ++i)
        probe.inputs.push_back({random.uniform(0, 0.999), random.logarithmic(1e-3, 0.5), random.uniform(0.5, 8)});
    check.probe(probe);
}

CHECK_EXERCISE("05.chebyshev",
               "a point that is not behind the mean is lit; a variance below `least` counts as `least`") {
    Probe probe{.include = "05_shadow_maps/chebyshev.glsl",
                .signature = "float chebyshev(vec2 moments, float depth, float least)",
                .inputs = {{0.5, 0.25, 0.5, 1e-4},
                           {0.5, 0.25, 0.4, 1e-4},
                           {0.5, 0.25, 0.6, 1e-4},
                           {0.5, 0.2499, 0.6, 1e-4},
                           {0.5, 0.5, 1, 1e-4},
                           {0.45, 0.405, 1, 1e-4},
                           {0, 0, 1, 1e-3}},
                .truth =
                    [](std::span<const double> in) {
                        return Row{truth::chebyshev({in[0], in[1]}, in[2], in[3])};
                    },
                .bound = {.absolute = 1e-5, .relative = 3e-3},
                .hint = [](auto in, auto) -> std::string {
                    if (in[2] <= in[0]) return "it is not behind the mean: all of it is lit";
                    if (in[1] - in[0] * in[0] < in[3]) return "the variance is below `least`, or negative by rounding";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const double mean = random.uniform(0, 1);
        probe.inputs.push_back({mean, static_cast<float>(mean * mean + random.uniform(-0.01, 0.25)),
                                random.uniform(0, 1), random.logarithmic(1e-4, 1e-2)});
    }
    const Table results = check.probe(probe);
    check.property(probe, results, "but it must be above 0 and at most 1",
                   [](auto, auto out) { return out[0] > 0 && out[0] <= 1; });
}

CHECK_EXERCISE("05.penumbra_width", "the light's width, scaled by similar triangles: gap over blocker distance") {
    Probe probe{
        .include = "05_shadow_maps/penumbra_width.glsl",
        .signature = "float penumbra_width(float receiver, float blocker, float size, bool parallel)",
        .inputs = {{2, 1, 0.1, 0},
                   {3, 1, 0.1, 0},
                   {3, 2, 0.1, 0},
                   {2, 1, 0, 0},
                   {1, 2, 0.1, 0},
                   {1, 1, 0.1, 0},
                   {2, 0, 0.1, 0},
                   {2, -1, 0.1, 0},
                   {2, 5e-4, 0.1, 0},
                   {2, 2e-3, 0.1, 0},
                   {5e-4, -1, 0.1, 0},
                   {5e-4, 0, 0.1, 0},
                   {2, 5e-4, 0.1, 1},
                   {2, -1, 0.1, 1},
                   {2, 1, 0.1, 1},
                   {2, 0, 0.1, 1},
                   {1, 2, 0.1, 1},
                   {5, 4, 0.01, 1},
                   {0, 0, 0.1, 0}},
        .truth = [](std::span<const double> in) { return Row{truth::penumbra_width(in[0], in[1], in[2], in[3] != 0)}; },
        .bound = {.absolute = 1e-6, .relative = 1e-4},
        .hint = [](auto in, auto got) -> std::string {
            if (in[0] <= in[1]) return "the blocker is not nearer than the receiver: no half shadow, 0";
            if (in[3] != 0) return "the rays of a sun's edges keep their angle: size times the gap";
            if (in[1] < 1e-3) return "a blocker nearer than 1 mm counts as 1 mm away, in the gap too; no division by 0";
            if (std::fabs(got[0] - in[2] * (in[0] - in[1]) / in[0]) < 1e-4 * got[0])
                return "divided by the blocker's distance, not by the receiver's";
            return "";
        }};
    Random random;
    for (int i = 0; i < 500; ++i) {
        const double blocker = random.logarithmic(0.01, 10);
        probe.inputs.push_back({random.logarithmic(0.01, 20), blocker, random.uniform(0, 1), double(i % 2)});
    }
    check.probe(probe);
}

namespace {

// Radius of the smallest ball with its centre `middle` in front of the camera that holds all corners of the slice.
double radius_from(double middle, double corner_slope, double near_m, double far_m) {
    return std::max(std::hypot(middle - near_m, corner_slope * near_m),
                    std::hypot(far_m - middle, corner_slope * far_m));
}

// The least of them: by search, since it falls and rises once.
double least_radius(double corner_slope, double near_m, double far_m) {
    double from = 0, to = 2 * far_m;
    for (int i = 0; i < 200; ++i) {
        const double a = (2 * from + to) / 3, b = (from + 2 * to) / 3;
        if (radius_from(a, corner_slope, near_m, far_m) > radius_from(b, corner_slope, near_m, far_m))
            from = a;
        else
            to = b;
    }
    return radius_from(from, corner_slope, near_m, far_m);
}

}  // namespace

CHECK_EXERCISE(
    "05.fit_cascade",
    "two corners decide, a near and a far one: where on the axis are both equally far away? Then whole texels") {
    const auto fit = [&](float tan_half, float aspect, float near_m, float far_m) {
        const std::string text = "fit_slice(" + number_text(double(tan_half)) + ", " + number_text(double(aspect)) +
                                 ", " + number_text(double(near_m)) + ", " + number_text(double(far_m)) + ")";
        const double slope = double(tan_half) * std::hypot(1.0, double(aspect)), n = near_m, f = far_m;
        const double least = least_radius(slope, n, f);
        glm::vec2 got(0.0f);
        check.call(
            text,
            [&]() -> std::string {
                got = fit_slice(tan_half, aspect, near_m, far_m);
                const std::string gave =
                    text + " gave " + number_text(double(got.x)) + " and " + number_text(double(got.y));
                const double needed = radius_from(double(got.x), slope, n, f);
                if (!(needed <= 1.0001 * double(got.y)))
                    return gave + ": a corner of the slice is " + number_text(needed) + " from this centre";
                if (!(double(got.y) <= 1.0001 * least))
                    return gave + ", but a radius of " + number_text(least) + " is enough";
                return "";
            },
            0.5 * (n + f) * (1 + slope * slope) >= f ? "here the far end alone decides, and its middle is the centre"
                                                     : "");
    };
    const auto snap = [&](glm::vec2 middle, float texel) {
        const std::string text = "snap_middle((" + number_text(double(middle.x)) + ", " +
                                 number_text(double(middle.y)) + "), " + number_text(double(texel)) + ")";
        check.call(
            text,
            [&]() -> std::string {
                const glm::vec2 got = snap_middle(middle, texel), origin = snap_middle(glm::vec2(0.0f), texel);
                for (int axis = 0; axis < 2; ++axis) {
                    const double g = double(got[axis]), m = double(middle[axis]), t = double(texel);
                    const double moved = g - double(origin[axis]);
                    const double rounding = 2e-7 * std::fabs(m);
                    const std::string gave = text + " gave " + number_text(g) + " along axis " + std::to_string(axis);
                    if (!(std::fabs(g - m) < t + rounding)) return gave + ", a texel or more from where it was";
                    if (!(std::fabs(moved - std::round(moved / t) * t) <= 1e-4 * t + rounding))
                        return gave + ", which is " + number_text(moved / t) + " texels from the result for (0, 0)";
                }
                return "";
            },
            "two results differ by a whole number of texels: then each border of a texel stays where it is");
    };
    // Corners at 45 degrees from the axis are where the far end alone begins to decide.
    for (const float tan_half : {0.1f, 0.41f, 0.5f, 1.0f, 3.0f})
        for (const float aspect : {2.0f, 1.0f, 0.5f}) {
            fit(tan_half, aspect, 0.1f, 0.67f);
            fit(tan_half, aspect, 4.5f, 30.0f);
            fit(tan_half, aspect, 29.9f, 30.0f);
            fit(tan_half, aspect, 1e-3f, 1e4f);
        }
    for (const float texel : {0.01f, 0.25f, 3.0f})
        for (const glm::vec2 middle :
             {glm::vec2(0.0f), {0.1f, 7.3f}, {-0.1f, -7.3f}, {0.75f, -0.75f}, {-900.1f, 250.2f}})
            snap(middle, texel);
    Random random;
    for (int i = 0; i < 200; ++i) {
        const float near_m = static_cast<float>(random.logarithmic(0.01, 100));
        fit(static_cast<float>(random.logarithmic(0.05, 2)), static_cast<float>(random.uniform(0.3, 3)), near_m,
            near_m * static_cast<float>(random.logarithmic(1.01, 1000)));
        snap({random.uniform(-1000, 1000), random.uniform(-10, 10)}, static_cast<float>(random.logarithmic(0.01, 5)));
    }
}

namespace {

// The equations of the weights, a column for each corner: (x, y) less place times w add up to (0, 0), the weights to 1.
glm::dmat3 equations(std::span<const double> in) {
    glm::dmat3 m;
    for (size_t i = 0; i < 3; ++i)
        m[int(i)] = {in[4 * i] - in[12] * in[4 * i + 3], in[4 * i + 1] - in[13] * in[4 * i + 3], 1};
    return m;
}

}  // namespace

CHECK_EXERCISE("05.corner_weights", "move the place to the origin: which area do two corners span with it?") {
    Probe probe{
        .include = "05_shadow_maps/corner_weights.glsl",
        .signature = "vec3 corner_weights(vec4 a, vec4 b, vec4 c, vec2 place)",
        .truth =
            [](auto in) {
                const glm::dmat3 m = equations(in);
                Row row;
                append(row, glm::determinant(m) == 0 ? glm::dvec3(1, 0, 0) : glm::inverse(m) * glm::dvec3(0, 0, 1));
                return row;
            },
        .bound = {.absolute = 2e-4, .relative = 2e-4},
        .hint = [](auto in, auto out) -> std::string {
            if (glm::determinant(equations(in)) == 0) return "no weights do that for this one, or many do";
            const double sum = out[0] + out[1] + out[2];
            if (std::fabs(sum - 1) > 1e-3) return fmt::format("the weights add up to {:.4g}", sum);
            glm::dvec2 flat(0);
            for (size_t i = 0; i < 3; ++i) flat += out[i] / in[4 * i + 3] * glm::dvec2(in[4 * i], in[4 * i + 1]);
            if (glm::length(flat - glm::dvec2(in[12], in[13])) < 1e-3)
                return "these are the weights on the screen, without perspective: a near corner has a larger one";
            const glm::dvec3 right = glm::inverse(equations(in)) * glm::dvec3(0, 0, 1);
            if (glm::length(glm::abs(right) / (std::fabs(right.x) + std::fabs(right.y) + std::fabs(right.z)) -
                            vector3(out)) < 1e-3)
                return "this place is outside of the triangle, or a corner is behind the camera: areas have signs";
            return "";
        }};
    const auto add = [&](glm::dvec4 a, glm::dvec4 b, glm::dvec4 c, glm::dvec2 place) {
        Row row;
        for (const glm::dvec4& corner : {a, b, c}) append(row, corner);
        append(row, place);
        for (double& number : row) number = double(float(number));
        probe.inputs.push_back(row);
    };
    add({-1, -1, 0, 1}, {1, -1, 0, 1}, {0, 1, 0, 1}, {0, 0});              // all as far
    add({-1, -1, 0.5, 1}, {3, -3, 0.25, 3}, {0, 2, 0.5, 2}, {0, 0});       // the lesson's question
    add({-1, -1, 0.5, 1}, {3, -3, 0.25, 3}, {0, 2, 0.5, 2}, {-0.5, 0.5});  // outside
    add({-1, -1, 0.5, 1}, {3, -3, 0.25, 3}, {0, 2, 0.5, -2}, {0, -0.75});  // a corner behind the camera
    add({-1, 0, 0.5, 1}, {2, 0, 0.5, 2}, {0, 0, 0.5, 4}, {0.5, 0});        // seen from its edge
    add({1.5, 0, 0.5, 1}, {1, 1, 0.5, 2}, {4, -1, 0.5, 4}, {0.5, 0});      // on the horizon of its plane
    Random random(5);
    while (probe.inputs.size() < 1500) {
        // A place that a known mean of the corners has, not far outside of the triangle.
        glm::dvec4 corners[3], mean(0);
        glm::dvec3 weights;
        for (int i = 0; i < 3; ++i) weights[i] = random.uniform(probe.inputs.size() % 3 ? 0.05 : -0.5, 1);
        weights /= weights.x + weights.y + weights.z;
        for (int i = 0; i < 3; ++i) {
            const double w = random.logarithmic(0.1, 30) * (probe.inputs.size() % 4 == 0 && i == 0 ? -1 : 1);
            corners[i] = {w * random.uniform(-1.5, 1.5), w * random.uniform(-1.5, 1.5), random.uniform(0, 1), w};
            mean += weights[i] * corners[i];
        }
        const glm::dmat3 lines(corners[0].x, corners[0].y, corners[0].w, corners[1].x, corners[1].y, corners[1].w,
                               corners[2].x, corners[2].y, corners[2].w);
        const double size = std::fabs(corners[0].w * corners[1].w * corners[2].w);
        if (std::fabs(glm::determinant(lines)) < 0.3 * size || std::fabs(mean.w) < 0.3) continue;
        const glm::dvec2 place = glm::dvec2(mean) / mean.w;
        if (std::max({std::fabs(weights.x), std::fabs(weights.y), std::fabs(weights.z)}) < 3 &&
            std::max(std::fabs(place.x), std::fabs(place.y)) <= 1)
            add(corners[0], corners[1], corners[2], place);
    }
    check.probe(probe);
}
