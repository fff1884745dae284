// Checks of 04.tangent_frame.
#include <cfenv>

#include "04_surface_maps/exercises.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

std::string show(glm::vec3 v) {
    for (int i = 0; i < 3; ++i)
        if (std::fabs(v[i]) < 1e-6f) v[i] = 0;  // rounding residue
    char text[96];
    std::snprintf(text, sizeof text, "(%.4g, %.4g, %.4g)", double(v.x), double(v.y), double(v.z));
    return text;
}

struct Case {
    std::string what;
    Vertex a, b, c;
};

// A triangle on a plane through `origin` where u goes along `per_u` and v along `per_v`, both in metres.
Case on_plane(std::string what, glm::vec3 origin, glm::vec3 per_u, glm::vec3 per_v, glm::vec3 normal) {
    const auto vertex = [&](float u, float v) {
        return Vertex{origin + u * per_u + v * per_v, glm::normalize(normal), {u, v}};
    };
    return {std::move(what), vertex(0.2f, 0.1f), vertex(0.9f, 0.25f), vertex(0.3f, 0.8f)};
}

bool is_unit_and_perpendicular(const TangentFrame& frame, glm::vec3 normal) {
    return std::fabs(glm::length(frame.tangent) - 1) < 1e-4f && std::fabs(glm::dot(frame.tangent, normal)) < 1e-4f;
}

}  // namespace

// Calls it and checks whether the processor flagged a division by 0, even if the result was unused.
static TangentFrame frame_of(Check& check, const std::string& what, const Vertex& a, const Vertex& b, const Vertex& c) {
    TangentFrame frame{};
    check.call(
        what,
        [&]() -> std::string {
            std::feclearexcept(FE_ALL_EXCEPT);
            frame = tangent_frame(a, b, c);
            return std::fetestexcept(FE_DIVBYZERO | FE_INVALID) ? what +
                                                                      ": it divides by 0, or takes the length of what "
                                                                      "is not there; C++ leaves open what that gives"
                                                                : "";
        },
        "ask whether the determinant is 0 before the division, not what came out after it");
    return frame;
}

CHECK_EXERCISE("04.tangent_frame", "two edges are two equations for dP/du and dP/dv; what if their determinant is 0?") {
    const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    std::vector<Case> cases = {
        on_plane("a wall with u to the right and v up", {0, 0, 0}, x, y, z),
        on_plane("a wall with u up and v to the left", {1, 2, 3}, y, -x, z),
        on_plane("a wall with two metres for each u and half a metre for each v", {0, 0, 0}, 2.0f * x, 0.5f * y, z),
        on_plane("a mirrored wall, u to the left", {0, 0, 0}, -x, y, z),
        on_plane("a mirrored wall, v down", {0, 0, 0}, x, -y, z),
        on_plane("a floor", {0, -1, 0}, x, -z, y),
        on_plane("a slanting plane", {0, 0, 0}, glm::vec3(1, 1, 0), glm::vec3(-1, 1, 1), glm::cross(x + y, y + z - x)),
        on_plane("a plane whose u and v are not at right angles", {0, 0, 0}, x, glm::vec3(0.5f, 1, 0), z),
        on_plane("a normal that leans, as a smooth one does", {0, 0, 0}, x, y, {0.3f, -0.2f, 1})};
    for (const Case& c : cases) {
        const TangentFrame frame = frame_of(check, c.what, c.a, c.b, c.c);
        // Expected frame, by construction.
        const glm::mat2 uv(c.b.uv - c.a.uv, c.c.uv - c.a.uv);
        const glm::mat2x3 edges(c.b.position - c.a.position, c.c.position - c.a.position);
        const glm::mat2x3 per = edges * glm::inverse(uv);
        const glm::vec3 tangent = glm::normalize(per[0] - c.a.normal * glm::dot(c.a.normal, per[0]));
        const float side = glm::dot(glm::cross(c.a.normal, tangent), per[1]) < 0 ? -1.0f : 1.0f;
        check.expect(glm::length(frame.tangent - tangent) < 1e-3f,
                     c.what + ": the tangent is " + show(frame.tangent) + ", expected " + show(tangent),
                     std::fabs(glm::dot(frame.tangent, c.a.normal)) > 1e-3f
                         ? "take away what points along the normal: tangent - normal * dot(normal, tangent)"
                         : "the tangent is the direction in which u grows and v stays");
        check.expect(frame.handedness == side,
                     c.what + ": the handedness is " + number_text(double(frame.handedness)) + ", expected " +
                         number_text(double(side)),
                     "1 where dot(cross(normal, tangent), dP/dv) is above 0, else -1");
        check.expect(frame.cos_uv == 0, c.what + ": cos_uv is " + number_text(double(frame.cos_uv)) + ", expected 0",
                     "the caller fills it in, for all triangles at a vertex");
        const glm::vec2 metres(glm::length(per[0]), glm::length(per[1]));
        check.expect(
            glm::length(frame.metres_per_uv - metres) < 1e-3f,
            c.what + ": metres_per_uv is " + show({frame.metres_per_uv, 0}) + ", expected " + show({metres, 0}));
    }
    for (const glm::vec3 normal :
         {x, y, z, -z, glm::normalize(glm::vec3(1, 1, 1)), glm::normalize(glm::vec3(-2, 1, 0))}) {
        const auto none = [&](const std::string& what, glm::vec2 b, glm::vec2 c, glm::vec3 edge) {
            const glm::vec3 side = glm::cross(normal, std::fabs(normal.x) < 0.9f ? x : y);
            const TangentFrame frame =
                frame_of(check, what + ", normal " + show(normal), {glm::vec3(0), normal, {0.5f, 0.5f}},
                         {side, normal, b}, {edge, normal, c});
            check.expect(is_unit_and_perpendicular(frame, normal),
                         what + ", normal " + show(normal) + ": the tangent is " + show(frame.tangent) +
                             ", expected any unit vector perpendicular to the normal");
            check.expect(frame.handedness == 1 && frame.metres_per_uv == glm::vec2(0),
                         what + ": expected handedness 1 and metres_per_uv 0");
        };
        const glm::vec3 other = glm::cross(normal, glm::cross(normal, std::fabs(normal.x) < 0.9f ? x : y));
        none("texture coordinates that are all the same", {0.5f, 0.5f}, {0.5f, 0.5f}, other);
        none("texture coordinates on a line", {0.6f, 0.6f}, {0.9f, 0.9f}, other);
        none("a triangle without area and without texture", {0.5f, 0.5f}, {0.5f, 0.5f}, glm::vec3(0));
        none("a triangle two of whose corners are one point", {0.7f, 0.5f}, {0.5f, 0.8f}, glm::vec3(0));
    }
}
