// Shared by the tests of the filters: a synthetic picture, and the module's result.
#pragma once
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "../common/module_fixture.h"
#include "13_mlaa/mlaa.h"
#include "13_mlaa/truth.h"

namespace lightwalk {

inline const std::vector<std::string> filters{"fxaa_like", "mlaa", "smaa_like"};

struct OnMlaa : OnModules {
    Mlaa antialias{owner, "mlaa"};
    Image picture;
    std::vector<uint64_t> before;  ///< its texels

    OnMlaa() { antialias.count.value = true; }

    /// Records the filter on a picture of light(x, y), which is a number or a vec3.
    template <class Light>
    ImageRgb filter(const std::string& method, glm::uvec2 size, const Light& light) {
        antialias.method.set(method);
        before = half_texels(size, light, 0.25f);
        filter_frame(picture, size, before, [&] {
            antialias.record(frame, picture);
            if (antialias.follows_edges() && !antialias.doubles()) scan(size);
        });
        return read_linear(gpu, picture);
    }

    std::vector<uint64_t> after() { return read<uint64_t>(picture); }

    /// The distances beside edges, four bytes a pixel; 0 where the words of edges have none.
    std::vector<uint32_t> lengths(glm::ivec2 size) {
        auto words = numbers<uint32_t>(gpu.read_back(antialias.doubles() ? antialias.distances() : scanned_));
        const auto rows = numbers<uint32_t>(gpu.read_back(antialias.edge_rows()));
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const uint32_t edges = rows[size_t(y * ((size.x + 15) / 16) + x / 16)] >> x % 16;
                words[size_t(y * size.x + x)] &= (edges & 1 ? 0xffffu : 0u) | (edges >> 16 & 1 ? 0xffff0000u : 0u);
            }
        return words;
    }

    size_t changed_texels() {
        const std::vector<uint64_t> now = after();
        size_t changed = 0;
        for (size_t i = 0; i < now.size(); ++i) changed += now[i] != before[i];
        return changed;
    }

  private:
    /// The lengths that words of edges tell.
    void scan(glm::uvec2 size) {
        scanned_.ensure(gpu.device, {.name = "scanned", .format = VK_FORMAT_R32_UINT, .size = size});
        const ComputeAccess access{
            .reads = {antialias.edge_rows(), antialias.edge_columns()}, .writes = {scanned_}, .with = {antialias}};
        frame.compute("scanned", access, [&](Compute& pass) {
            pass.use(scan_).set("lengths", scanned_);
            antialias.set_edges(pass);
            pass.dispatch_threads(size);
        });
    }

    Image scanned_;
    const Pipeline scan_ = compute({.shader = "test/scanned_lengths.comp", .macros = {}, .source = R"(
#include "13_mlaa/lines.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(r32ui) writeonly uniform uimage2D lengths;
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(lengths)))) return;
    EdgeLine below = line_at(pixel, true), right = line_at(pixel, false);
    imageStore(lengths, pixel, uvec4(below.back << back_below | below.ahead << ahead_below | right.back << back_right | right.ahead << ahead_right));
})"});
};

/// White below a line through `point` (pixels, their middles at integers) that rises by the angle to the right.
struct Line {
    double angle_deg = 10;
    glm::dvec2 point{31.5, 31.5};
    glm::dvec2 normal() const {
        const double angle = glm::radians(angle_deg);
        return {std::sin(angle), std::cos(angle)};
    }
    float sample(int x, int y) const { return glm::dot(glm::dvec2(x, y) - point, normal()) > 0 ? 1.0f : 0.0f; }
    double exact(int x, int y) const { return truth::half_plane_coverage(point - glm::dvec2(x, y), normal()); }
};

/// The root of the mean squared error over the pixels through which the line runs, `margin` pixels from the border on.
inline double edge_error(const ImageRgb& found, const Line& line, int margin = 4) {
    double square = 0, count = 0;
    for (int y = margin; y < found.height - margin; ++y)
        for (int x = margin; x < found.width - margin; ++x) {
            const double exact = line.exact(x, y);
            if (exact < 1e-9 || exact > 1 - 1e-9) continue;
            square += std::pow(double(found.at(x, y).g) - exact, 2);
            ++count;
        }
    return std::sqrt(square / std::max(count, 1.0));
}

}  // namespace lightwalk
