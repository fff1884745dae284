// What ./course check runs for chapter 01.
#include "01_obj/truth.h"
#include "checks.h"
#include "common/check/check.h"

using namespace lightwalk;

CHECK_EXERCISE("01.parse_vertex_line",
               "std::from_chars rounds correctly and knows no locale; count the numbers before you believe them") {
    check.add(check_parse_vertex_line(parse_vertex_line.function()));
}

CHECK_EXERCISE("01.parse_face", "a negative index counts back from the last one read so far: -1 is that one") {
    check.add(check_parse_face(parse_face.function()));
}

CHECK_EXERCISE("01.triangulate", "cut off an ear at a time: a corner that turns left and has no other corner inside") {
    check.add(check_triangulate(triangulate.function()));
}

CHECK_EXERCISE("01.view_projection",
               "write down where the near and the far plane must land, and solve for two numbers") {
    check.add(check_view_projection(view_projection.function()));
}

namespace {

glm::dmat4 matrix4(std::span<const double> values) {
    glm::dmat4 m(0.0);
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = values[static_cast<size_t>(i)];
    return m;
}

Row random_matrix(Random& random, int count) {
    Row row;
    for (int i = 0; i < count; ++i) row.push_back(random.uniform(-2, 2));
    return row;
}

Row row_of(const glm::dvec4& v, int count) {
    Row row;
    for (int i = 0; i < count; ++i) row.push_back(v[i]);
    return row;
}

}  // namespace

CHECK_EXERCISE("01.transform",
               "a position has w = 1, so the matrix's translation counts; a normal needs its own matrix") {
    Random random;
    Probe place{
        .include = "01_obj/transform.glsl",
        .signature = "vec3 position_to_world(mat4 model, vec3 position)",
        .truth =
            [](std::span<const double> in) { return row_of(matrix4(in) * glm::dvec4(in[16], in[17], in[18], 1.0), 3); },
        .bound = {.absolute = 1e-5, .relative = 1e-5}};
    Probe turn{.include = place.include,
               .signature = "vec3 normal_to_world(mat3 normal_matrix, vec3 normal)",
               .truth =
                   [](std::span<const double> in) {
                       glm::dvec3 n(0.0);
                       for (int i = 0; i < 9; ++i)
                           n[i % 3] += in[static_cast<size_t>(i)] * in[static_cast<size_t>(9 + i / 3)];
                       return row_of(glm::dvec4(glm::normalize(n), 0.0), 3);
                   },
               .bound = {.absolute = 2e-5}};
    Probe project{
        .include = place.include,
        .signature = "vec4 world_to_clip(mat4 view_projection, vec3 world_position)",
        .truth =
            [](std::span<const double> in) { return row_of(matrix4(in) * glm::dvec4(in[16], in[17], in[18], 1.0), 4); },
        .bound = {.absolute = 1e-5, .relative = 1e-5}};
    for (int i = 0; i < 500; ++i) {
        Row row = random_matrix(random, 16);
        row[3] = row[7] = row[11] = 0, row[15] = 1;  // a model matrix is affine
        append(row, random.direction());
        place.inputs.push_back(row);
        row = random_matrix(random, 16);
        append(row, random.direction());
        project.inputs.push_back(row);
        Row normal = random_matrix(random, 9);
        for (int k = 0; k < 3; ++k) normal[static_cast<size_t>(4 * k)] += 3;  // far from singular
        append(normal, random.direction());
        turn.inputs.push_back(normal);
    }
    check.probe(place);
    check.probe(turn);
    check.probe(project);
}
