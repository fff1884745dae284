#include "14_environment/paint_error.h"

#include <cmath>
#include <cstring>
#include <glm/gtc/constants.hpp>

#include "14_environment/paint_walk.h"

namespace lightwalk {
namespace {

struct Reference {
    std::vector<glm::vec3> cosines;  // n·l, n·v, l·v
    std::vector<glm::dvec3> brdf;
};

Reference by_walks() {
    Reference reference;
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto direction = [&] {
        const double u = uniform(engine), turn = 2 * glm::pi<double>() * uniform(engine);
        return glm::dvec3(std::sqrt(u) * std::cos(turn), std::sqrt(u) * std::sin(turn), std::sqrt(1 - u));
    };
    for (int i = 0; i < 1024; ++i) {
        const LightAndView seen{direction(), direction()};
        reference.cosines.emplace_back(seen.to_light.z, seen.to_eye.z, glm::dot(seen.to_light, seen.to_eye));
        reference.brdf.push_back(walked_brdf({}, seen, 4096, 2));
    }
    return reference;
}

}  // namespace

std::vector<glm::vec3> looked_up(Gpu& gpu, CarPaint& paint, const std::vector<glm::vec3>& cosines) {
    const Pipeline look = compute({.shader = "14_environment/paint_directions.comp"});
    const Buffer in = gpu.upload("cosines", cosines);
    const Buffer out(gpu.device, {.name = "found", .bytes = sizeof(glm::vec3) * cosines.size()});
    Frame frame(gpu);
    frame.begin({4, 4}, 0);
    paint.record(frame);
    frame.compute("paint directions", {.reads = {in}, .writes = {out}, .with = {paint}}, [&](Compute& pass) {
        pass.use(look).set("cosines", in).set("found", out);
        pass.dispatch_threads(glm::uvec2(static_cast<uint32_t>(cosines.size()), 1));
    });
    frame.end();
    std::vector<glm::vec3> found(cosines.size());
    std::memcpy(found.data(), gpu.read_back(out).data(), sizeof(glm::vec3) * found.size());
    return found;
}

double direction_error(Gpu& gpu, CarPaint& paint) {
    static const Reference reference = by_walks();
    const std::vector<glm::vec3> found = looked_up(gpu, paint, reference.cosines);
    double error = 0, all = 0;
    for (size_t i = 0; i < found.size(); ++i) {
        const glm::dvec3 off = glm::dvec3(found[i]) - reference.brdf[i];
        error += glm::dot(off, off);
        all += glm::dot(reference.brdf[i], reference.brdf[i]);
    }
    return std::sqrt(error / all);
}

}  // namespace lightwalk
