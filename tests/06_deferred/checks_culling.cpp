// Checks of the exercises about objects that are not drawn.
#include "06_deferred/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

std::string truth_word(const std::string& name, std::span<const double> v) {
    return name.empty() ? (v[0] != 0 ? "true" : "false") : "";
}

// A camera's matrix as the course has them: near depth 1, far depth 0, y down.
glm::dmat4 camera_matrix(Random& random) {
    const double focal = random.uniform(0.8, 3), aspect = random.uniform(0.5, 2), n = random.uniform(0.05, 0.5),
                 f = 500;
    glm::dmat4 projection(0.0), move(1.0);
    projection[0][0] = focal / aspect;
    projection[1][1] = -focal;
    projection[2][2] = n / (f - n);
    projection[2][3] = -1;
    projection[3][2] = n * f / (f - n);
    const double turn = random.uniform(0, 6.28);
    move[0][0] = move[2][2] = std::cos(turn);
    move[0][2] = std::sin(turn);
    move[2][0] = -std::sin(turn);
    return projection * move;
}

}  // namespace

CHECK_EXERCISE("06.box_is_out",
               "which corner of the box is the farthest in front of the plane? abs() finds it for all eight") {
    Probe probe{
        .include = "06_deferred/box_is_out.glsl",
        .signature = "bool box_is_out(vec3 center, vec3 half_size, vec4 plane)",
        .truth =
            [](std::span<const double> in) {
                const double most = truth::most_in_front(vector3(in, 0), vector3(in, 3), {vector3(in, 6), in[9]});
                return Row{most < 0 ? 1.0 : 0.0};
            },
        .bound = {.absolute = 0},
        .words = truth_word,
        .hint = [](auto in, auto got) -> std::string {
            const double most = truth::most_in_front(vector3(in, 0), vector3(in, 3), {vector3(in, 6), in[9]});
            if (most == 0) return "the plane touches the box, which is not out then";
            const double middle = glm::dot(vector3(in, 6), vector3(in, 0)) + in[9];
            if (got[0] != 0)
                return middle < 0
                           ? "its center is behind the plane, and a corner in front of it: part of it may be seen"
                           : "its center is in front of the plane";
            return "all eight corners are behind the plane";
        }};
    const auto add = [&](glm::dvec3 center, glm::dvec3 half, glm::dvec3 normal, double w) {
        Row row;
        append(row, center);
        append(row, half);
        append(row, normal);
        row.push_back(w);
        for (double& x : row) x = double(float(x));
        probe.inputs.push_back(row);
    };
    for (const double side : {1.0, -1.0}) {
        add({-3 * side, 0, 0}, {1, 1, 1}, {side, 0, 0}, 1);    // out
        add({-2 * side, 5, 9}, {1, 1, 1}, {side, 0, 0}, 1);    // touched by the plane
        add({0, -1.5 * side, 0}, {2, 1, 2}, {0, side, 0}, 1);  // cut
        add({4, 4, -1 * side}, {0, 0, 0}, {0, 0, side}, 1);    // a point in the plane
        add({4, 4, -2 * side}, {8, 8, 0}, {0, 0, side}, 1);    // flat, and out
    }
    Random random(46);
    while (probe.inputs.size() < 3000) {
        const double scale = random.logarithmic(0.1, 30);
        const auto number = [&](double least, double most) { return double(float(random.uniform(least, most))); };
        const glm::dvec3 center(number(-20, 20), number(-20, 20), number(-20, 20)), normal(random.direction());
        const glm::dvec3 half(number(0, scale), number(0, scale), number(0, scale));
        const double w = number(-30, 30);
        if (std::fabs(truth::most_in_front(center, half, {normal, w})) > 1e-3) add(center, half, normal, w);
    }
    check.probe(probe);
}

CHECK_EXERCISE("06.pyramid_level", "how many texels from low >> k to high >> k, along x and along y?") {
    Probe probe{
        .include = "06_deferred/pyramid_level.glsl",
        .signature = "int pyramid_level(ivec2 low, ivec2 high)",
        .truth =
            [](std::span<const double> in) {
                return Row{double(truth::pyramid_level({int(in[0]), int(in[1])}, {int(in[2]), int(in[3])}))};
            },
        .bound = {.absolute = 0},
        .hint = [](auto in, auto got) -> std::string {
            const int right = truth::pyramid_level({int(in[0]), int(in[1])}, {int(in[2]), int(in[3])});
            if (got[0] > right)
                return "a smaller level would do: it is not the size alone that counts, but where the rectangle lies";
            return "in that level it lies in three texels or more along one axis, and one of them is not read";
        }};
    const auto add = [&](int x, int y, int right, int bottom) {
        probe.inputs.push_back({double(x), double(y), double(right), double(bottom)});
    };
    add(0, 0, 0, 0);
    add(5, 5, 6, 5);
    add(7, 0, 9, 0);
    add(6, 0, 9, 0);
    add(0, 6, 0, 9);
    add(3, 0, 4, 0);
    add(0, 0, 3, 0);
    add(1, 0, 4, 0);
    add(0, 0, 65535, 65535);
    add(32767, 0, 32768, 0);
    add(0, 100, 1919, 100);
    Random random(47);
    for (int i = 0; i < 3000; ++i) {
        const int x = int(random.uniform(0, 4000)), y = int(random.uniform(0, 2200));
        add(x, y, x + int(random.logarithmic(1, 3000)) - 1, y + int(random.logarithmic(1, 2000)) - 1);
    }
    check.probe(probe);
}

CHECK_EXERCISE("06.screen_box",
               "what does the function do with a corner behind the camera, and what may the box cover then?") {
    const auto truth_of = [](std::span<const double> in) {
        glm::dmat4 m;
        for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = in[size_t(6 + i)];
        const auto box = truth::screen_box(vector3(in, 0), vector3(in, 3), m, {in[22], in[23]});
        return Row(box.begin(), box.end());
    };
    const auto crosses = [truth_of](std::span<const double> in) { return truth_of(in)[4] == 1; };
    Probe probe{.include = "../tests/06_deferred/screen_box.glsl",
                .signature = "ScreenBox screen_box(vec3 center, vec3 half_size, mat4 to_clip, vec2 size)",
                .truth = truth_of,
                .bound = {.absolute = 0.02, .relative = 1e-3},
                .words = [](const std::string& name, std::span<const double>) -> std::string {
                    return name == "to_clip" ? "a camera's matrix" : "";
                },
                .hint = [crosses](auto in, auto) -> std::string {
                    return crosses(in)
                               ? "a corner of this box is nearer than the near plane, or behind the camera: the "
                                 "corners left say little about what the box covers"
                               : "all corners of this box are in front of the camera";
                }};
    Random random(48);
    while (probe.inputs.size() < 1500) {
        const glm::dmat4 to_clip = camera_matrix(random);
        const double scale = random.logarithmic(0.1, 10);
        const auto number = [&](double least, double most) { return double(float(random.uniform(least, most))); };
        Row row{number(-30, 30),     number(-5, 5),       number(-30, 30),
                number(0.01, scale), number(0.01, scale), number(0.01, scale)};
        for (int k = 0; k < 16; ++k) row.push_back(double(float(to_clip[k / 4][k % 4])));
        row.insert(row.end(), {double(64 + probe.inputs.size() % 300), double(48 + probe.inputs.size() % 200)});
        // A corner in the near plane itself may round to either side.
        bool is_clear = true;
        for (const glm::dvec3& corner : truth::corners(vector3(row, 0), vector3(row, 3))) {
            const glm::dvec4 clip = to_clip * glm::dvec4(corner, 1.0);
            is_clear &= std::fabs(clip.z - clip.w) > 0.02;
        }
        if (is_clear) probe.inputs.push_back(row);
    }
    const Table results = check.probe(probe);
    if (check.failed) return;
    for (size_t i = 0; i < results.size(); ++i) {
        const double nearest = truth_of(probe.inputs[i])[4];
        check.expect(std::fabs(results[i][4] - nearest) <= 1e-5 + 1e-4 * nearest,
                     call_text(probe, probe.inputs[i]) + " has nearest " + number_text(results[i][4]) + ", expected " +
                         number_text(nearest),
                     "depth grows towards the camera: 1 is at the near plane");
        if (check.failed) return;
    }
}
