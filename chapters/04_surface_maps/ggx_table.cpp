#include "04_surface_maps/ggx_table.h"

#include <glm/gtc/packing.hpp>

#include "common/base/error.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

void GgxTable::load(Gpu& gpu) {
    if (albedos) return;
    const ImageRgb table = read_pfm(find_asset("tables/ggx.pfm"));
    if (table.width != size || table.height != 2 * size)
        throw InputError("tables/ggx.pfm: {}x{} texels; expected {}x{}", table.width, table.height, size, 2 * size);
    std::vector<uint64_t> upper, lower;
    for (int y = 0; y < size; ++y) {
        // In the last two channels means of A and B over views, by the cosine c = 1 - (1 - x)^2 of a column x: weights 2 c dc, by trapezoids.
        glm::vec3 sum(0);
        for (int x = 0; x < size; ++x) {
            const float left = 1 - float(x) / float(size - 1), cosine = 1 - left * left;
            const glm::vec3 b = table.at(x, size + y);
            sum += cosine * left * glm::vec3(b.y, b.z, 1.0f);
        }
        for (int x = 0; x < size; ++x) {
            const glm::vec3 a = table.at(x, y), b = table.at(x, size + y);
            upper.push_back(glm::packHalf4x16({a, b.x}));
            lower.push_back(glm::packHalf4x16({b.y, b.z, sum.x / sum.z, sum.y / sum.z}));
        }
    }
    cosines = Image(gpu.device, {.name = "GGX as cosines", .size = glm::uvec2(size)});
    albedos = Image(gpu.device, {.name = "GGX albedos", .size = glm::uvec2(size)});
    gpu.upload(cosines, std::as_bytes(std::span(upper)));
    gpu.upload(albedos, std::as_bytes(std::span(lower)));
}

}  // namespace lightwalk
