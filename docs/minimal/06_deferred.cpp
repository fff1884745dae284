// [minimal]
// Deferred shading: first store each pixel's surface, then light the stored pixels, tile by tile. Forward shading,
// which lights each fragment as it is drawn, must give the same picture. The camera looks along -z; metres.
#include <cmath>
#include <cstdio>
#include <glm/glm.hpp>
#include <random>
#include <vector>

using glm::vec3;
struct Light {
    vec3 position, color;
};
struct Surface {  // of a pixel; a real G-buffer packs it, and keeps z alone
    vec3 position{0, 0, -1e9}, normal{}, albedo{};
};
constexpr int side = 128, tile = 8;  // pixels
constexpr float range_m = 2;         // of each light
long evaluations = 0;                // of a light at a pixel

vec3 lit(const Light& light, const Surface& s) {
    ++evaluations;
    const vec3 way = light.position - s.position;
    const float inside = std::fmax(1 - glm::dot(way, way) / (range_m * range_m), 0.0f);
    return s.albedo * light.color * (inside * inside * std::fmax(glm::dot(s.normal, glm::normalize(way)), 0.0f));
}

int main() {
    std::mt19937 engine(1);
    const auto random = [&](float x, float y, float z) { return vec3(x, y, z) * (float(engine()) / 4294967296.0f); };
    const auto place = [&](float high) { return random(10, 0, 0) + random(0, 10, 0) + random(0, 0, high); };
    std::vector<Light> lights(100);
    for (Light& light : lights) light = {place(2), random(1, 0, 0) + vec3(0, 0.5, 1)};
    std::vector<Surface> gbuffer(side * side);
    std::vector<vec3> forward(side * side), deferred(side * side);
    for (int ball = 0; ball < 300; ++ball) {  // each with a radius of 0.7 m, drawn in no order
        const vec3 center = place(1), albedo = random(1, 1, 1);
        for (int i = 0; i < side * side; ++i) {
            const vec3 at = vec3(i % side, i / side, 0) * (10.0f / side), way = (at - center) * vec3(1, 1, 0);
            const float height = std::sqrt(std::fmax(0.49f - glm::dot(way, way), 0.0f));
            if (height == 0 || center.z + height <= gbuffer[i].position.z) continue;  // beside the ball, or hidden
            gbuffer[i] = {at + vec3(0, 0, center.z + height), (way + vec3(0, 0, height)) / 0.7f, albedo};
            forward[i] = vec3(0);
            for (const Light& light : lights) forward[i] += lit(light, gbuffer[i]);
        }
    }
    std::printf("forward %ld\n", evaluations);
    evaluations = 0;
    for (int t = 0; t < 16 * 16; ++t) {  // the tiles
        const auto pixel = [&](int k) { return (t / 16 * tile + k / tile) * side + t % 16 * tile + k % tile; };
        vec3 low(1e9f), high(-1e9f);  // the box around the tile's points
        for (int k = 0; k < tile * tile; ++k)
            low = glm::min(low, gbuffer[pixel(k)].position), high = glm::max(high, gbuffer[pixel(k)].position);
        for (const Light& light : lights)  // one test for 64 pixels: does the light's sphere reach the box?
            if (glm::distance(light.position, glm::clamp(light.position, low, high)) < range_m)
                for (int k = 0; k < tile * tile; ++k) deferred[pixel(k)] += lit(light, gbuffer[pixel(k)]);
    }
    std::printf("deferred %ld\ndifferent %d\n", evaluations, forward != deferred);
}
// [/minimal]
