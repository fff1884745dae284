// Car paint: its table against integrals, and its reflection of the scene's lights against matt white.
#include "../common/module_fixture.h"
#include "01_obj/camera_view.h"
#include "14_environment/lit_around.h"
#include "14_environment/truth.h"
#include "catch.h"

using namespace lightwalk;

namespace {

constexpr double coat_f0 = 0.04, coat_index = 1.5;

/// Transmittance of the coat at that cosine: Schlick's formula.
double through(double cosine) { return (1 - coat_f0) * (1 - std::pow(1 - cosine, 5)); }

double below_coat(double cosine) { return std::sqrt(1 - (1 - cosine * cosine) / (coat_index * coat_index)); }

/// A square of 2 m that faces +z, of one material.
Model square(const Material& material) {
    Model model;
    model.materials = {material};
    Mesh& mesh = model.meshes.emplace_back();
    for (const glm::vec2 p : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
        mesh.vertices.push_back({glm::vec3(p, 0.0f), {0, 0, 1}, p});
        mesh.bounds.add(mesh.vertices.back().position);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.parts = {{0, 6, 0}};
    model.nodes.push_back({.name = "root", .meshes = {0}});
    return model;
}

struct OnPaint : OnModules {
    ImageLight light{owner, "environment"};
    LitAround objects{owner, "objects", light};

    /// The table's texel: column n·v, row n·l; rows 64 and 65 are albedos of pigment and of flakes.
    std::vector<glm::vec4> table() {
        begin({4, 4});
        objects.paint.record(frame);
        frame.end();
        std::vector<glm::vec4> texels;
        for (const uint64_t one : read<uint64_t>(objects.paint.table.mip(0)))
            texels.push_back(glm::unpackHalf4x16(one));
        return texels;
    }

    /// Red of a square of that material in the light of a sun, without any surroundings.
    double shown(const Material& material, glm::vec3 to_sun, glm::vec3 eye) {
        SceneFile file;
        file.ambient = glm::vec3(0);
        file.objects = {SceneObject{.name = "square", .parent = {}, .model = "models/cube.obj"}};
        file.lights = {Light{.direction = -to_sun}};
        Scene scene;
        scene.load(gpu, file, [&](const auto&) { return square(material); });
        owner.prepare_all(gpu, scene);
        const View view = view_of({.position = 20.0f * eye, .target = glm::vec3(0), .fov_y_rad = 0.02f}, {4, 4});
        begin(view.size);
        light.record(frame, scene);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(0));
        lightwalk::draw(frame, view, canvas, {objects});
        frame.end();
        return double(read_linear(gpu, frame.hdr).at(2, 2).r);
    }
};

}  // namespace

TEST_CASE_METHOD(OnPaint, "paint below its coat shows n·l of a light, as matt white does, twice through the coat") {
    objects.paint.flakes.value = 0;
    objects.paint.color.value = objects.paint.edge_color.value = glm::vec3(0.5f);
    const auto at = [](double cosine, glm::dvec3 side) {
        return glm::vec3(std::sqrt(1 - cosine * cosine) * side + glm::dvec3(0, 0, cosine));
    };
    // The sun and the eye lie a quarter of a turn apart: no gloss.
    for (const double l : {1.0, 0.7, 0.4, 0.15})
        for (const double v : {0.95, 0.5}) {
            INFO("n.l " << l << ", n.v " << v);
            const glm::vec3 to_sun = at(l, {0, 1, 0}), eye = at(v, {1, 0, 0});
            const double white = shown({{.name = "chalk", .diffuse = glm::vec3(1)}}, to_sun, eye);
            const double paint = shown({{.name = "paint", .shininess = 1000}}, to_sun, eye);
            CHECK(white > 0);
            CHECK(white ==
                  Approx(l * shown({{.name = "chalk", .diffuse = glm::vec3(1)}}, {0, 0, 1}, eye)).epsilon(0.005));
            CHECK(paint == Approx(0.5 * through(l) * through(v) * white).epsilon(0.01));
        }
}

TEST_CASE_METHOD(OnPaint,
                 "the paint's albedos are the integrals of its BRDF, and a pigment's is known in closed form") {
    objects.paint.flakes.value = 0.4f;
    const auto texels = table();
    const auto texel = [&](int v, int row) { return double(texels[size_t(row) * 64 + size_t(v)].r); };
    for (const int v : {4, 16, 40, 63}) {
        double sum = 0;
        for (int l = 0; l < 64; ++l) sum += (l == 63 ? 0.5 : 1.0) * truth::around * l / 63.0 * texel(v, l) / 63;
        INFO("n.v " << v / 63.0);
        CHECK(texel(v, 64) + texel(v, 65) == Approx(sum).epsilon(0.01));
    }
    // Of 1 - (1 - x)^5, weighed by 2 x: 20/21.
    objects.paint.flakes.value = 0;
    objects.paint.color.value = objects.paint.edge_color.value = glm::vec3(0.5f);
    const auto plain = table();
    for (const size_t v : {size_t(4), size_t(16), size_t(40), size_t(63)})
        CHECK(double(plain[64 * 64 + v].r) ==
              Approx(0.5 * through(double(v) / 63) * (1 - coat_f0) * 20 / 21).epsilon(0.003));
}

TEST_CASE_METHOD(OnPaint, "flakes send back what rays that are refracted, mirrored and refracted again carry",
                 "[14.flakes]") {
    objects.paint.flakes.value = 1;
    objects.paint.flake_color.value = glm::vec3(1);
    for (const float roughness : {0.1f, 0.45f, 1.0f}) {
        objects.paint.flake_roughness.value = roughness;
        const double alpha = std::pow(double(roughness), 2);
        const auto texels = table();
        for (const size_t x : {size_t(16), size_t(40), size_t(63)}) {
            const double n_dot_v = double(x) / 63, v = below_coat(n_dot_v);
            const glm::dvec3 to_eye(std::sqrt(1 - v * v), 0, v);
            double energy = 0;
            const int n = 400;
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) {
                    // Half vectors as dense as D n.h; then the share that masking and shadowing leave.
                    const double turn = truth::around * (i + 0.5) / n, u = (j + 0.5) / n;
                    const double c = std::sqrt((1 - u) / (1 + (alpha * alpha - 1) * u)), s = std::sqrt(1 - c * c);
                    const glm::dvec3 half(s * std::cos(turn), s * std::sin(turn), c);
                    const double facing = glm::dot(to_eye, half);
                    const glm::dvec3 to_light = 2 * facing * half - to_eye;
                    const double sine = coat_index * std::hypot(to_light.x, to_light.y);
                    if (facing <= 0 || to_light.z <= 0 || sine >= 1) continue;  // reflected back into the paint
                    const double seen = 4 * to_light.z * v * truth::ggx_visibility(to_light.z, v, alpha);
                    energy +=
                        seen * facing / (v * c) * through(std::sqrt(1 - sine * sine)) * through(n_dot_v) / (n * n);
                }
            INFO("roughness " << roughness << ", n.v " << n_dot_v);
            CHECK(double(texels[65 * 64 + x].r) == Approx(energy).epsilon(0.03));
            CHECK(energy < 1);
        }
    }
}
