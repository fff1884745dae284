// The ground's functions one by one: rays against all triangles, the morph of vertices, the footprint of a pixel.
#include <fmt/core.h>

#include <cmath>

#include "common/check/probe.h"
#include "land_fixture.h"

using namespace lightwalk;

namespace {

/// For TEST_CASE_METHOD: ground of 32 x 32 cells, each 62.5 m wide, with known heights.
struct OnCells : OnLand {
    std::vector<float> heights;

    OnCells() {
        ground.levels.value = 5;
        ground.span_km.value = 2;
        ground.detail_m.value = 0;
        ground.height_scale.value = 6;
        make();
    }
    void make() {
        begin(size);
        ground.record(frame, true);
        frame.end();
        heights = read<float>(ground.heights().mip(0));
    }
    glm::dvec3 point(int x, int z) const {
        const LandMap& map = ground.map();
        return {double(map.corner.x) + double(map.spacing_m) * x, heights[size_t(z) * size_t(map.samples) + size_t(x)],
                double(map.corner.y) + double(map.spacing_m) * z};
    }

    /// Output of the shader `text` for each row of numbers: `outputs` floats. It has in_at() and `result[]`.
    std::vector<float> run(
        const std::string& text, const std::vector<float>& rows, size_t outputs, size_t row_floats,
        const std::function<void(Compute&)>& set = [](Compute&) {}) {
        const Pipeline pipeline =
            compute_pipeline("numbers of the ground",
                             "layout(local_size_x = 64) in;\n"
                             "layout(scalar) readonly buffer RowsBlock { float rows[]; };\n"
                             "layout(scalar) writeonly buffer ResultBlock { float result[]; };\n" +
                                 text);
        const Buffer in = gpu.upload("rows", rows);
        const size_t count = rows.size() / row_floats;
        const Buffer out(gpu.device, {.name = "result", .bytes = 4 * outputs * count});
        begin(size);
        frame.compute("numbers", {.reads = {in}, .writes = {out}, .with = {ground, land}}, [&](Compute& pass) {
            pass.use(pipeline).set("rows", in).set("result", out);
            set(pass);
            pass.dispatch_threads(glm::uvec2(uint32_t(count), 1));
        });
        frame.end();
        return read<float>(out);
    }
};

}  // namespace

TEST_CASE_METHOD(OnCells, "a ray ends where it first comes down through a triangle, never on one seen from below") {
    const int cells = ground.map().samples - 1;
    Random random(15);
    std::vector<float> rows;
    std::vector<std::pair<glm::dvec3, glm::dvec3>> rays;
    for (int i = 0; i < 600; ++i) {
        const bool from_below = i % 3 == 0;
        const int x = int(random.uniform(2, cells - 2)), z = int(random.uniform(2, cells - 2));
        const glm::dvec3 from =
            point(x, z) + glm::dvec3(random.uniform(-90, 90),
                                     from_below ? -random.uniform(5, 300) : random.uniform(100, 900),
                                     random.uniform(-90, 90));
        glm::dvec3 along(random.direction());
        if (from_below != (along.y > 0)) along.y = -along.y;
        if (std::fabs(along.y) < 0.02) along.y = from_below ? 0.3 : -0.3;
        const glm::vec3 eye(from), ray(along);
        for (const float number : {eye.x, eye.y, eye.z, ray.x, ray.y, ray.z}) rows.push_back(number);
        rays.emplace_back(eye, ray);
    }
    const auto found = run(R"(
#include "15_terrain_water/land_march.glsl"
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < uint(result.length()))
        result[i] = march(vec3(rows[6u * i], rows[6u * i + 1u], rows[6u * i + 2u]),
                          vec3(rows[6u * i + 3u], rows[6u * i + 4u], rows[6u * i + 5u]));
})",
                           rows, 1, 6);
    int met = 0, missed = 0, past = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        const auto& [eye, ray] = rays[i];
        double nearest = 1e30;
        bool grazes = false, from_behind = false;
        for (int z = 0; z < cells; ++z)
            for (int x = 0; x < cells; ++x)
                for (int half = 0; half < 2; ++half) {
                    const glm::dvec3 b = point(x + 1, z), c = point(x, z + 1),
                                     a = half ? point(x + 1, z + 1) : point(x, z);
                    const glm::dvec3 up = half ? glm::cross(b - a, c - a) : glm::cross(c - a, b - a);
                    const double t = glm::dot(a - eye, up) / glm::dot(ray, up);
                    const glm::dvec3 at = eye + t * ray;
                    // Barycentric, seen from above.
                    const auto area = [](glm::dvec3 p, glm::dvec3 q, glm::dvec3 r) {
                        return (q.x - p.x) * (r.z - p.z) - (q.z - p.z) * (r.x - p.x);
                    };
                    const double whole = area(a, b, c), u = area(at, b, c) / whole, v = area(a, at, c) / whole,
                                 w = 1 - u - v;
                    const double least = std::min({u, v, w});
                    if (t <= 0 || least < -1e-3) continue;
                    grazes |= least < 1e-3 || std::fabs(glm::dot(ray, glm::normalize(up))) < 1e-2;
                    if (glm::dot(ray, up) < 0)
                        nearest = std::min(nearest, t);
                    else
                        from_behind = true;
                }
        if (grazes) continue;
        INFO("ray " << i << " finds " << found[i] << ", right is " << nearest);
        if (nearest < 1e30) {
            CHECK(double(found[i]) == Approx(nearest).epsilon(1e-4).margin(0.02));
            ++met;
        } else {
            CHECK(found[i] < 0);
            ++missed;
            past += from_behind;
        }
    }
    fmt::print("{} rays come down on the ground, {} miss it, {} of these leave it from below\n", met, missed, past);
    CHECK(met > 250);
    CHECK(past > 80);
}

TEST_CASE_METHOD(
    OnCells, "a vertex has moved to its coarser place where the least wrong of the chunks it touches may be drawn") {
    ground.levels.value = 8;
    ground.span_km.value = 8;
    make();
    struct {
        glm::mat4 to_clip{1.0f};
        glm::vec3 from;
        float metres_per_m;
        int fixed_level = -1;
    } view;
    view.from = {0, 900, 0};
    const int top = ground.map().top;
    std::vector<std::vector<float>> errors;
    for (int level = 0; level <= top; ++level) errors.push_back(read<float>(ground.errors().mip(uint32_t(level))));
    std::vector<float> rows;
    for (int level = 0; level < top; ++level)
        for (int z = 0; z < ground.map().samples; z += std::max(8, 1 << level))
            for (int x = 0; x < ground.map().samples; x += std::max(8, 1 << level))
                for (const int number : {x, z, level}) rows.push_back(float(number));
    int whole = 0, none = 0, differ = 0;
    for (const float metres_per_m : {0.003f, 0.006f, 0.008f, 0.012f}) {
        view.metres_per_m = metres_per_m;
        const auto found = run(R"(
#define gl_VertexIndex 0
#define gl_InstanceIndex 0
#define gl_Position unused_position
#define main unused_main
vec4 unused_position;
#include "15_terrain_water/land_chunks.vert"
#undef main
void main() {
    uint i = gl_GlobalInvocationID.x;
    ivec2 at = ivec2(rows[3u * i], rows[3u * i + 1u]);
    if (i < uint(result.length())) result[i] = morphed(at, chunk_point(at), int(rows[3u * i + 2u]));
})",
                               rows, 1, 3, [&](Compute& pass) { pass.set("chunk_view", view); });
        for (size_t i = 0; i < found.size(); ++i) {
            const int x = int(rows[3 * i]), z = int(rows[3 * i + 1]), level = int(rows[3 * i + 2]) + 1;
            const int side = CHUNK_CELLS << level, chunks = 1 << (top - level);
            double least = 1e30, most = 0;
            for (int cz = 0; cz < chunks; ++cz)
                for (int cx = 0; cx < chunks; ++cx)
                    if (x >= cx * side && x <= (cx + 1) * side && z >= cz * side && z <= (cz + 1) * side) {
                        const double error = double(errors[size_t(level)][size_t(cz * chunks + cx)]);
                        least = std::min(least, error);
                        most = std::max(most, error);
                    }
            const double allowed = glm::length(point(x, z) - glm::dvec3(view.from)) * double(view.metres_per_m);
            INFO("sample " << x << ", " << z << " of level " << level - 1 << ": errors " << least << " to " << most
                           << ", allowed " << allowed);
            // Before any of the chunks may be drawn: all of the way. Long before: none of it.
            if (allowed > 0.9995 * least) {
                CHECK(found[i] == 1.0f);
                ++whole;
                differ += allowed < 0.9 * most;
            } else if (allowed < 0.699 * least) {
                CHECK(found[i] == 0.0f);
                ++none;
            }
            if (allowed > 0.701 * least && allowed < 0.998 * least) CHECK((found[i] > 0 && found[i] < 1));
        }
    }
    fmt::print("{} vertices have moved, {} of them at a chunk that is too wrong; {} stand\n", whole, differ, none);
    CHECK(differ > 20);
    CHECK(none > 50);
}

TEST_CASE_METHOD(OnCells, "ground at a low angle is read as finely as the pixel is long on it, up to 17 times") {
    // Substitutes for the textures of land_seen().
    std::vector<float> rows;
    for (int i = 0; i < 200; ++i) {
        const float angle = 0.0157f * float(i) / 2;
        const glm::vec3 at(point(3 + i % 20, 5 + i / 20));
        for (const float number : {at.x, at.z, std::cos(angle), -std::sin(angle)}) rows.push_back(number);
    }
    const auto found = run(R"(
#include "15_terrain_water/ground.glsl"
#include "15_terrain_water/land_shadow.glsl"
#include "15_terrain_water/land_materials.glsl"
#define land_surface(position, normal, footprint) LandSurface(vec3(footprint), normal, 1.0)
#include "15_terrain_water/no_sun_shadow.glsl"
#include "15_terrain_water/land_light.glsl"
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (4u * i >= uint(rows.length())) return;
    vec3 normal, position = vec3(rows[4u * i], 0.0, rows[4u * i + 1u]);
    LandSurface surface = land_seen(position, vec3(rows[4u * i + 2u], rows[4u * i + 3u], 0.0), 2.0, normal);
    result[4u * i] = surface.albedo.r;
    for (int k = 0; k < 3; ++k) result[4u * i + 1u + uint(k)] = normal[k];
})",
                           rows, 4, 4);
    int stretched = 0, held = 0;
    for (size_t i = 0; i < found.size() / 4; ++i) {
        const glm::dvec3 normal(found[4 * i + 1], found[4 * i + 2], found[4 * i + 3]);
        const double cosine = -glm::dot(glm::dvec3(rows[4 * i + 2], rows[4 * i + 3], 0), normal);
        INFO("seen at a cosine of " << cosine);
        const int x = 3 + int(i) % 20, z = 5 + int(i) / 20;
        const glm::dvec3 across = point(x + 1, z) - point(x - 1, z), down = point(x, z + 1) - point(x, z - 1);
        CHECK(glm::length(normal - glm::normalize(glm::cross(down, across))) < 5e-3);
        // The side of a square with the pixel's area on the ground.
        CHECK(double(found[4 * i]) == Approx(2 / std::sqrt(std::max(cosine, 0.06))).epsilon(2e-3));
        (cosine > 0.06 ? stretched : held) += 1;
    }
    CHECK(stretched > 50);
    CHECK(held > 5);
}
