#include "light_fixture.h"

#include <fmt/core.h>
#include <unistd.h>

namespace lightwalk {

OnLight::OnLight()
    : look(compute_pipeline("look at surfaces", R"(
#include "14_environment/image_light.glsl"
#include "14_environment/unoccluded.glsl"
layout(local_size_x = 64) in;
struct LookedAt { vec3 normal, to_eye, f0; float alpha; vec3 body; uint has_metalness; };
struct Shown { vec3 diffuse, specular, diffuse_share; };
layout(scalar) readonly buffer LookedAtBuffer { LookedAt looked_at[]; };
layout(scalar) writeonly buffer ShownBuffer { Shown shown[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(looked_at.length())) return;
    LookedAt s = looked_at[i];
    Blend blend = blend_of(s.f0, s.body, s.has_metalness == 1u);
    FromAround r = reflected_from_around(LitFromAround(vec3(0.0), s.normal, s.to_eye, s.f0, s.alpha, blend));
    shown[i] = Shown(diffuse_light(vec3(0.0), s.normal), r.specular, r.diffuse_share);
})")) {}

OnLight::~OnLight() {
    for (const auto& file : made) std::filesystem::remove(file);
}

void OnLight::load(const std::string& image, glm::vec3 ambient) {
    SceneFile file;
    file.ambient = ambient;
    if (!image.empty()) file.environment.image = image;
    scene.load(gpu, file, [](const auto&) -> Model { return {}; });
    owner.begin_frame(gpu, {4, 4});
    light.prepare(gpu, scene);
    light.record(frame, scene);
}

void OnLight::load(int width, int height, const std::function<glm::dvec3(glm::dvec3)>& radiance) {
    ImageRgb picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.at(x, y) = glm::vec3(radiance(truth::direction_at({(x + 0.5) / width, (y + 0.5) / height})));
    made.push_back(std::filesystem::temp_directory_path() /
                   fmt::format("lightwalk_light_{}_{}.pfm", getpid(), made.size()));
    write_pfm(made.back(), picture);
    load(made.back().string());
}

void OnLight::draw_picture() {
    const Pipeline to_cube = compute({.shader = "14_environment/equirect_to_cube.comp"});
    const ImageView cube = light.drawn.radiance.as_array().mip(0);
    frame.compute("cube", {.reads = {*scene.environment}, .writes = {cube}}, [&](Compute& pass) {
        pass.use(to_cube).set("picture", *scene.environment).set("limit", 65504.0f).set("cube", cube);
        pass.dispatch_threads(glm::uvec3(cube.size().x, cube.size().y, 6));
    });
    light.record_drawn(frame, {});
}

std::vector<Shown> OnLight::shown(const std::vector<LookedAt>& surfaces) {
    light.record(frame, scene);
    return shown_now(surfaces);
}

std::vector<Shown> OnLight::shown_now(const std::vector<LookedAt>& surfaces) {
    const Buffer in = gpu.upload("looked at", surfaces);
    const Buffer out(gpu.device, {.name = "shown", .bytes = sizeof(Shown) * surfaces.size()});
    frame.compute("look", {.reads = {in}, .writes = {out}, .with = {light}}, [&](Compute& pass) {
        pass.use(look).set("looked_at", in).set("shown", out);
        pass.dispatch_threads(glm::uvec2(static_cast<uint32_t>(surfaces.size()), 1));
    });
    frame.end();
    const auto found = read<Shown>(out);
    frame.begin({4, 4}, 0);
    owner.begin_frame(gpu, {4, 4});
    return found;
}

std::vector<glm::vec3> OnLight::diffuse(const std::vector<glm::vec3>& normals) {
    std::vector<LookedAt> surfaces;
    for (const glm::vec3 n : normals) surfaces.push_back({n, n, glm::vec3(0), 1.0f});
    std::vector<glm::vec3> light_of;
    for (const Shown& one : shown(surfaces)) light_of.push_back(one.diffuse);
    return light_of;
}

std::vector<glm::vec3> all_around(int count) {
    std::vector<glm::vec3> directions{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int i = 0; i < count; ++i) {
        const double y = 1 - (2 * i + 1) / double(count), turn = 2.399963 * i, across = std::sqrt(1 - y * y);
        directions.push_back(glm::dvec3(across * std::cos(turn), y, across * std::sin(turn)));
    }
    return directions;
}

std::vector<glm::dvec3> true_diffuse(const ImageRgb& picture, const std::vector<glm::vec3>& normals) {
    std::vector<glm::dvec3> sums(normals.size(), glm::dvec3(0));
    for (int y = 0; y < picture.height; ++y) {
        const double solid_angle = truth::equirect_solid_angle(y, picture.width, picture.height);
        for (int x = 0; x < picture.width; ++x) {
            const glm::dvec3 l = truth::direction_at({(x + 0.5) / picture.width, (y + 0.5) / double(picture.height)});
            const glm::dvec3 arriving = solid_angle * 2.0 / truth::around * glm::dvec3(picture.at(x, y));
            for (size_t i = 0; i < normals.size(); ++i)
                sums[i] += arriving * std::max(0.0, glm::dot(glm::dvec3(normals[i]), l));
        }
    }
    return sums;
}

}  // namespace lightwalk
