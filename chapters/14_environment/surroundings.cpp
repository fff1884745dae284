#include "14_environment/surroundings.h"

#include <unordered_map>

#include "common/base/shared_lock.h"

namespace lightwalk {

Surroundings::Surroundings(Module& owner, Music* heard)
    : World(owner), sphere(*this, "sphere", light, heard ? *heard : music) {
    objects.maps.method.change_default("normal");
    music.in_use = [this, heard] { return !heard && sphere.shown; };
}

void Surroundings::record(Frame& frame) {
    // Cubes of light, made once from the picture of the surroundings, or from six views of the scene itself.
    light.record(frame, scene());
    probe.record(frame, scene(), light, {backdrop, objects});
}

namespace {

constexpr uint32_t parts = 100;  // 200,000 triangles

}  // namespace

BeatSphere::BeatSphere(Module& owner, std::string name, const ImageLight& light, Music& music)
    : Drawing(owner, std::move(name), "beat"), light_(light), music_(music) {
    in_use = [this] { return bool(shown); };
}

Geodesic geodesic_sphere(uint32_t count) {
    constexpr double a = 0.5257311121191336, b = 0.8506508083520399;
    constexpr glm::dvec3 corners[12] = {{-a, b, 0},  {a, b, 0},  {-a, -b, 0}, {a, -b, 0}, {0, -a, b},  {0, a, b},
                                        {0, -a, -b}, {0, a, -b}, {b, 0, -a},  {b, 0, a},  {-b, 0, -a}, {-b, 0, a}};
    constexpr uint32_t faces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                       {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                       {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                       {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    Geodesic sphere;
    // A vertex is known by how much it has of which corner; on an edge two faces say the same.
    std::unordered_map<uint64_t, uint32_t> known;
    const auto vertex = [&](const uint32_t(&face)[3], uint32_t i, uint32_t j) {
        std::array<std::pair<uint32_t, uint32_t>, 3> of{{{face[0], count - i - j}, {face[1], i}, {face[2], j}}};
        std::sort(of.begin(), of.end());
        uint64_t key = 0;
        glm::dvec3 sum(0.0);
        for (const auto& [corner, share] : of) {
            if (share == 0) continue;
            key = key << 16 | corner << 12 | share;
            sum += double(share) * corners[corner];
        }
        const auto [place, added] = known.emplace(key, uint32_t(sphere.directions.size()));
        if (added) sphere.directions.push_back(glm::vec3(glm::normalize(sum)));
        return place->second;
    };
    for (const auto& face : faces)
        for (uint32_t i = 0; i < count; ++i)
            for (uint32_t j = 0; i + j < count; ++j) {
                const uint32_t at = vertex(face, i, j), right = vertex(face, i + 1, j), up = vertex(face, i, j + 1);
                sphere.indices.insert(sphere.indices.end(), {at, right, up});
                if (i + j + 1 < count)
                    sphere.indices.insert(sphere.indices.end(), {right, vertex(face, i + 1, j + 1), up});
            }
    return sphere;
}

void BeatSphere::prepare(Gpu& gpu, Scene&) {
    if (directions_) return;
    const Geodesic sphere = unlocked([] { return geodesic_sphere(parts); });
    directions_ = gpu.upload("sphere directions", sphere.directions);
    indices_ = gpu.upload("sphere indices", sphere.indices);
}

bool BeatSphere::animated() const { return music_.animated(); }

void BeatSphere::update(Frame& frame) {
    const double time_s = double(frame.time_s);
    const Levels levels = music_.levels(time_s);
    // In double: after an hour, too, the angle has six digits.
    const double turn = std::remainder(glm::radians(double(spin_deg_per_s)) * time_s, 2 * M_PI);
    const glm::mat4 to_world = glm::rotate(glm::rotate(glm::mat4(1.0f), glm::radians(tilt_deg.value), {1, 0, 0}),
                                           static_cast<float>(turn), {0, 1, 0});
    now_ = {.center = center,
            .radius_m = radius_m,
            .heights = glm::vec3(low.value, middle.value, high.value) * glm::vec3(levels),
            .brightness = brightness,
            .blur = blur,
            .frequencies = frequencies,
            .glow = glow * levels.w,
            .from_world = glm::transpose(glm::mat3(to_world))};
}

void BeatSphere::bind(Pass& pass) const { pass.set_if_present("beat_now", now_); }

void BeatSphere::shade_ground(Frame& frame, const View& view, Canvas& canvas) {
    const struct {
        glm::vec3 sphere_light;
        float height_m;
    } now{glm::vec3(0.3f) + 0.3f * now_.glow * look.glow.value, ground_y};
    const ImageView depth = canvas.depth(frame), color = canvas.color(frame);
    frame.compute(
        "beat ground", {.reads = {depth, color}, .writes = {color}, .with = {*this, light_}}, [&](Compute& pass) {
            pass.use(ground_).set("depth", depth, nearest_clamp).set("picture", color).set("rays", view_rays(view));
            pass.set("ground", now).dispatch_threads(view.size);
        });
}

void BeatSphere::draw(Frame& frame, const View& view, Canvas& canvas) {
    if (!shown) return;
    if (ground) shade_ground(frame, view, canvas);
    frame.raster("beat sphere",
                 {.color = {canvas.color_target()}, .depth = canvas.depth_target(), .with = {*this, light_}},
                 [&](Raster& pass) {
                     pass.use(surface_).set("directions", directions_);
                     pass.draw_indexed(indices_, 0, 20 * 3 * parts * parts);
                 });
}

}  // namespace lightwalk
