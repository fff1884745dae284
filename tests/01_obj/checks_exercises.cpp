// The check of chapter 01's shader exercise.
#include "common/check/check.h"

using namespace lightwalk;

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

// A matrix by its effect, if simple.
std::string words(const std::string&, std::span<const double> v) {
    const size_t side = v.size() == 16 ? 4 : v.size() == 9 ? 3 : 0;
    if (side == 0) return "";
    std::string moved;
    size_t different = 0;
    for (size_t i = 0; i < v.size(); ++i)
        if (v[i] != (i % (side + 1) == 0 ? 1.0 : 0.0)) {
            ++different;
            moved += (moved.empty() ? "" : ", ") + ("[" + std::to_string(i / side) + "][" + std::to_string(i % side)) +
                     "] = " + number_text(v[i]);
        }
    if (different == 0) return "the identity";
    return different <= 4 ? "the identity but for " + moved : "a matrix of random numbers";
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
    place.words = project.words = turn.words = words;
    place.hint = [](auto in, auto out) -> std::string {
        const glm::dvec4 direction = matrix4(in) * glm::dvec4(in[16], in[17], in[18], 0.0);
        return std::fabs(out[0] - direction.x) + std::fabs(out[1] - direction.y) + std::fabs(out[2] - direction.z) <
                       1e-4
                   ? "the translation is missing: a point has w = 1"
                   : "a matrix stands left of the vector that it transforms";
    };
    turn.hint = [](auto, auto out) -> std::string {
        const double length = std::sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
        return std::fabs(length - 1) > 1e-4 ? "stretching changes a normal's length: make it 1 again"
                                            : "the normal matrix stands left of the normal";
    };
    // Cases that can be followed on paper come first.
    const Row identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, identity3{1, 0, 0, 0, 1, 0, 0, 0, 1};
    const auto with = [](Row matrix, const Row& changes, const Row& vector) {
        for (size_t i = 0; i + 1 < changes.size(); i += 2) matrix[static_cast<size_t>(changes[i])] = changes[i + 1];
        matrix.insert(matrix.end(), vector.begin(), vector.end());
        return matrix;
    };
    for (Probe* one : {&place, &project})
        one->inputs = {with(identity, {}, {1, 2, 3}), with(identity, {12, 5, 13, -1}, {1, 2, 3}),
                       with(identity, {0, 2}, {1, 2, 3}), with(identity, {0, 0, 1, 1, 4, -1, 5, 0}, {1, 2, 3})};
    turn.inputs = {with(identity3, {}, {0, 1, 0}), with(identity3, {4, 0.5}, {0, 1, 0}),
                   with(identity3, {0, 0, 1, 1, 3, -1, 4, 0}, {1, 0, 0})};
    for (int i = 0; i < 500; ++i) {
        Row row = random_matrix(random, 16);
        row[3] = row[7] = row[11] = 0;  // a model matrix is affine
        row[15] = 1;
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
