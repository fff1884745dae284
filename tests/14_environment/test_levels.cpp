// Where the environment is read: the level of each sample, the texels of a picture, and the windows of each degree.
#include <glm/gtc/packing.hpp>

#include "light_fixture.h"

using namespace lightwalk;

namespace {

/// For TEST_CASE_METHOD: a cube with its level numbers as contents, so that reads reveal their level.
struct OnLevels : OnLight {
    Pipeline fill = compute_pipeline("fill a level", R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar) uniform LevelBlock { float level; };
layout(rgba16f) writeonly uniform image2DArray result;
void main() {
    if (all(lessThan(gl_GlobalInvocationID.xy, uvec2(imageSize(result).xy))))
        imageStore(result, ivec3(gl_GlobalInvocationID), vec4(level));
})");
    Pipeline sums = compute_pipeline("sums of samples", R"(
#include "14_environment/image_light.glsl"
#include "14_environment/unoccluded.glsl"
layout(local_size_x = 1) in;
layout(scalar) uniform LookBlock { vec3 to_eye; float alpha; } look;
layout(scalar) writeonly buffer SumsBuffer { vec2 sums; };
void main() {
    uint samples = uint(image_light.samples);
    LitFromAround s = LitFromAround(vec3(0.0), vec3(0.0, 0.0, 1.0), look.to_eye, vec3(1.0), look.alpha,
                                    Blend(1.0, vec3(1.0), vec3(1.0)));
    sums = vec2(reflection_of_samples(s, look.to_eye.z, samples, image_light.sample_bias).g,
                diffuse_of_samples(s.position, s.normal, samples).g);
})");
    Pipeline filter = compute({.shader = "14_environment/prefilter.comp"});

    OnLevels() { load("", glm::vec3(1)); }

    void number(const Image& cube) {
        for (uint32_t level = 0; level < cube.desc.mips; ++level) {
            const ImageView view = cube.as_array().mip(level);
            frame.compute("fill", {.writes = {view}}, [&](Compute& pass) {
                pass.use(fill).set("level", float(level)).set("result", view);
                pass.dispatch_threads(glm::uvec3(glm::uvec2(view.size()), 6));
            });
        }
    }

    /// Reflected and diffuse light of so many samples, of a white surface that faces +z.
    glm::vec2 summed(glm::vec3 to_eye, double alpha, uint32_t count, double bias) {
        light.method.set("sampled");
        light.samples.value = int(count);
        light.sample_bias.value = float(bias);
        light.record(frame, scene);
        number(light.sky.radiance);
        const Buffer out(gpu.device, {.name = "sums", .bytes = sizeof(glm::vec2)});
        frame.compute("sums", {.writes = {out}, .with = {light}}, [&](Compute& pass) {
            pass.use(sums).set("look", glm::vec4(to_eye, alpha)).set("sums", out).dispatch({1, 1, 1});
        });
        frame.end();
        frame.begin({4, 4}, 0);
        owner.begin_frame(gpu, {4, 4});
        return read<glm::vec2>(out)[0];
    }
};

/// Sample i of `count`: the half vector as 14.importance_sample_ggx makes it of Hammersley's points.
glm::dvec3 half_vector(uint32_t i, uint32_t count, double alpha) {
    double turned = 0, digit = 0.5;
    for (uint32_t rest = i; rest != 0; rest /= 2, digit /= 2) turned += rest % 2 * digit;
    const double x = (i + 0.5) / count, phi = truth::around * turned;
    const double c2 = (1 - x) / (1 + (alpha * alpha - 1) * x), s = std::sqrt(1 - c2);
    return {s * std::cos(phi), s * std::sin(phi), std::sqrt(c2)};
}

/// The level of a cube of 256 texels a side with texels as large as a sample's share of the sphere.
double level_of(double density, uint32_t count, double bias) {
    const double texel = 2 * truth::around / (6.0 * 256 * 256);
    return std::clamp(0.5 * std::log2(1 / (count * density * texel)) + bias, 0.0, 8.0);
}

}  // namespace

TEST_CASE_METHOD(OnLevels,
                 "each sample of a reflection is read from the level whose texels are as large as its share") {
    for (const uint32_t count : {1u, 4u, 64u})
        for (const double bias : {0.0, 1.5})
            for (const double alpha : {0.05, 0.3, 1.0})
                for (const double n_dot_v : {1.0, 0.4}) {
                    const glm::dvec3 v(std::sqrt(1 - n_dot_v * n_dot_v), 0, n_dot_v);
                    double right = 0, weights = 0;
                    for (uint32_t i = 0; i < count; ++i) {
                        const glm::dvec3 h = half_vector(i, count, alpha);
                        const double v_dot_h = glm::dot(v, h);
                        const glm::dvec3 l = 2 * v_dot_h * h - v;
                        if (l.z <= 0 || v_dot_h <= 0) continue;
                        const double weight = truth::ggx_visibility(l.z, n_dot_v, alpha) * l.z * 4 * v_dot_h / h.z;
                        const double density = truth::ggx_density(h.z, alpha) * h.z / (4 * v_dot_h);
                        weights += weight / count;
                        right += weight / count * level_of(density, count, bias);
                    }
                    const glm::vec2 found = summed(glm::vec3(v), alpha, count, bias);
                    INFO(count << " samples, bias " << bias << ", alpha " << alpha << ", n.v " << n_dot_v);
                    // A sum turned about the normal has the same levels; rounding of levels is 1/256.
                    CHECK(double(found.x) == Approx(right).margin(0.01 * weights + 0.004 * right + 1e-6));
                }
}

TEST_CASE_METHOD(OnLevels, "each sample of diffuse light is read one level above that of its share") {
    for (const uint32_t count : {1u, 16u, 256u}) {
        double right = 0;
        for (uint32_t i = 0; i < count; ++i)
            right += level_of(2 * std::sqrt(1 - (i + 0.5) / count) / truth::around, count, 1) / count;
        CHECK(double(summed({0, 0, 1}, 1, count, 0).y) == Approx(right).margin(0.01));
    }
}

TEST_CASE_METHOD(OnLevels, "the prefiltered cube's samples come from the levels of their shares, at each roughness") {
    light.prefilter.samples.value = 64;
    light.prefilter.bias.value = 0.5f;
    number(light.sky.radiance);
    prefilter_faces(frame, {filter, light.sky.radiance, light.sky.prefiltered, {light.prefilter}});
    frame.end();
    for (uint32_t level = 1; level < 7; ++level) {
        const double alpha = std::pow(level / 6.0, 2);
        double right = 0, weights = 0;
        for (uint32_t i = 0; i < 64; ++i) {
            const glm::dvec3 h = half_vector(i, 64, alpha);
            const double n_dot_l = 2 * h.z * h.z - 1;
            if (n_dot_l <= 0) continue;
            weights += n_dot_l;
            right += n_dot_l * level_of(truth::ggx_density(h.z, alpha) / 4, 64, 0.5);
        }
        const auto found = read<uint64_t>(light.sky.prefiltered.as_array().mip(level));
        INFO("level " << level);
        for (const uint64_t texel : {found.front(), found[found.size() / 3], found.back()})
            CHECK(double(glm::unpackHalf4x16(texel).g) == Approx(right / weights).margin(0.02));
    }
    frame.begin({4, 4}, 0);
}

TEST_CASE_METHOD(OnLevels, "box-filtered levels are as wide as the lobe, prefiltered ones as rough as the surface") {
    for (const double roughness : {0.05, 0.3, 0.6, 1.0}) {
        const double alpha = roughness * roughness;
        const LookedAt surface{{0, 0, 1}, {0, 0, 1}, glm::vec3(1), float(alpha)};
        INFO("roughness " << roughness);
        light.method.set("box_mips");
        light.record(frame, scene);
        number(light.sky.radiance);
        const double texels = 2 * std::atan(alpha) / (truth::around / 4) * 256;
        CHECK(double(shown_now({surface})[0].specular.g) == Approx(std::max(std::log2(texels), 0.0)).margin(0.02));
        light.method.set("prefiltered");
        light.record(frame, scene);
        number(light.sky.prefiltered);
        const Shown found = shown_now({surface})[0];
        CHECK(double(found.specular.g / (1 - found.diffuse_share.g)) == Approx(6 * roughness).margin(0.03));
    }
}

TEST_CASE_METHOD(OnLight,
                 "a cube's texel is the mean of four places of the picture, across its seam and at its poles") {
    const Pipeline to_cube = compute({.shader = "14_environment/equirect_to_cube.comp"});
    const Pipeline noise = compute_pipeline("noise", R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D result;
void main() {
    uvec2 at = gl_GlobalInvocationID.xy;
    uint v = at.x * 1664525u + at.y * 22695477u + 1013904223u;
    v = (v ^ (v >> 15u)) * 2246822519u;
    if (all(lessThan(at, uvec2(imageSize(result))))) imageStore(result, ivec2(at), vec4(float(v >> 8u) / 16777216.0));
})");
    const Image picture = image({.name = "picture", .size = {128, 64}, .mips = 2});
    for (const uint32_t side : {16u, 64u, 8u}) {  // the last is read from the second level
        const uint32_t level = side == 8 ? 1 : 0;
        const Image cube = image({.name = "cube", .size = {side, side}, .layers = 6, .cube = true});
        for (uint32_t i = 0; i < 2; ++i)
            frame.compute("noise", {.writes = {picture.mip(i)}}, [&](Compute& pass) {
                pass.use(noise).set("result", picture.mip(i)).dispatch_threads(glm::uvec2(picture.mip(i).size()));
            });
        frame.compute("cube", {.reads = {picture}, .writes = {cube.as_array().mip(0)}}, [&](Compute& pass) {
            pass.use(to_cube).set("picture", picture).set("limit", 0.9f).set("cube", cube.as_array().mip(0));
            pass.dispatch_threads(glm::uvec3(side, side, 6));
        });
        frame.end();
        const auto texels = read<uint64_t>(picture.mip(level)), found = read<uint64_t>(cube.as_array().mip(0));
        const int width = int(picture.mip(level).size().x), height = int(picture.mip(level).size().y);
        const auto texel = [&](int x, int y) {
            const int in_x = (x + width) % width, in_y = std::clamp(y, 0, height - 1);
            return double(glm::unpackHalf4x16(texels[size_t(in_y) * size_t(width) + size_t(in_x)]).g);
        };
        const auto bilinear = [&](glm::dvec2 uv) {
            const double x = uv.x * width - 0.5, y = std::clamp(uv.y * height - 0.5, 0.0, height - 1.0);
            const int left = int(std::floor(x)), up = int(std::floor(y));
            const double s = x - left, t = y - up;
            return (1 - t) * ((1 - s) * texel(left, up) + s * texel(left + 1, up)) +
                   t * ((1 - s) * texel(left, up + 1) + s * texel(left + 1, up + 1));
        };
        double worst = 0;
        for (uint32_t i = 0; i < found.size(); ++i) {
            const uint32_t x = i % side, y = i / side % side, face = i / (side * side);
            double right = 0;
            for (int k = 0; k < 4; ++k) {
                const double s = (2 * x + k % 2 + 0.5) / side - 1, t = (2 * y + k / 2 + 0.5) / side - 1;
                const glm::dvec3 of_faces[] = {{1, -t, -s}, {-1, -t, s}, {s, 1, t},
                                               {s, -1, -t}, {s, -t, 1},  {-s, -t, -1}};
                right += 0.25 * std::min(bilinear(truth::equirect(of_faces[face])), double(0.9f));
            }
            worst = std::max(worst, std::fabs(double(glm::unpackHalf4x16(found[i]).g) - right));
        }
        INFO("faces of " << side << ": " << worst);
        CHECK(worst < 0.005);
        frame.begin({4, 4}, 0);
    }
}

TEST_CASE_METHOD(OnLight,
                 "a window takes its factor of each of nine coefficients, by the degree, of pictures and cubes") {
    load(64, 32, [](glm::dvec3 d) {
        const double one = 1 + 0.5 * d.x + 0.4 * d.y - 0.3 * d.z;
        return glm::dvec3(one * one + 0.6 * d.x * d.y - 0.2 * d.z * d.x);
    });
    const auto coefficients = [&](const char* window) {
        light.sh_window.set(window);
        light.record(frame, scene);
        draw_picture();
        frame.end();
        const std::array both{read<glm::vec4>(light.sky.sh), read<glm::vec4>(light.drawn.sh)};
        frame.begin({4, 4}, 0);
        owner.begin_frame(gpu, {4, 4});
        return both;
    };
    const auto whole = coefficients("none"), hann = coefficients("hann"), sinc = coefficients("sinc4");
    for (size_t source = 0; source < 2; ++source)
        for (size_t i = 0; i < 9; ++i) {
            const double degree = std::floor(std::sqrt(double(i))), x = truth::around / 6 * degree;
            INFO((source ? "cube" : "picture") << " " << i);
            REQUIRE(std::fabs(whole[source][i].g) > 0.02f);
            CHECK(double(hann[source][i].g / whole[source][i].g) ==
                  Approx(0.5 + 0.5 * std::cos(truth::around / 10 * degree)).margin(1e-4));
            CHECK(double(sinc[source][i].g / whole[source][i].g) ==
                  Approx(degree > 0 ? std::pow(std::sin(x) / x, 4) : 1.0).margin(1e-4));
        }
}
