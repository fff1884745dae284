// What tests of the filters share: a picture from numbers, and what the module makes of it.
#pragma once
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "../common/gpu_fixture.h"
#include "13_mlaa/mlaa.h"
#include "13_mlaa/truth.h"
#include "common/app/read_picture.h"

namespace lightwalk {

inline const std::vector<std::string> filters{"fxaa_like", "mlaa", "smaa_like"};

struct OnMlaa {
    struct Owner : Module {
    } owner;
    Mlaa antialias{owner, "mlaa"};
    Gpu& gpu = validated_device();
    Frame frame{gpu};
    Image picture;
    std::vector<uint64_t> before;  ///< its texels

    OnMlaa() { antialias.count.value = true; }
    ~OnMlaa() { CHECK_NOTHROW(gpu.device.check_validation()); }

    /// Records the filter on a picture of light(x, y), which is a number or a vec3.
    template <class Light>
    ImageRgb filter(const std::string& method, glm::uvec2 size, const Light& light) {
        antialias.method.set(method);
        before.clear();
        for (uint32_t y = 0; y < size.y; ++y)
            for (uint32_t x = 0; x < size.x; ++x)
                before.push_back(glm::packHalf4x16(glm::vec4(glm::vec3(light(int(x), int(y))), 0.25f)));
        if (!picture || picture.desc.size != size) picture = Image(gpu.device, {.name = "picture", .size = size});
        frame.begin({4, 4}, 0);
        frame.upload("picture", picture, std::as_bytes(std::span(before)));
        antialias.record(frame, picture);
        frame.end();
        return read_linear(gpu, picture);
    }

    std::vector<uint64_t> after() { return OnDevice::numbers<uint64_t>(gpu.read_back(picture)); }

    size_t changed_texels() {
        const std::vector<uint64_t> now = after();
        size_t changed = 0;
        for (size_t i = 0; i < now.size(); ++i) changed += now[i] != before[i];
        return changed;
    }
};

/// White below a line through `point` (pixels, their middles at whole numbers) that rises by the angle to the right.
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
            square += std::pow(double(found.at(x, y).g) - exact, 2), ++count;
        }
    return std::sqrt(square / std::max(count, 1.0));
}

}  // namespace lightwalk
