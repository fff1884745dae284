#include "18_playground/picking_error.h"

#include <map>
#include <nlohmann/json.hpp>

#include "18_playground/playground.h"

namespace lightwalk {
namespace {

std::vector<uint32_t> ids_of(Playground& chapter, Gpu& gpu, glm::uvec2 size) {
    Frame own(gpu);
    render(chapter, own, {size, 0.0f, 0, {}});
    const auto bytes = gpu.read_back(chapter.picker.ids);
    std::vector<uint32_t> ids(bytes.size() / sizeof(uint32_t));
    std::memcpy(ids.data(), bytes.data(), bytes.size());
    return ids;
}

}  // namespace

double wrong_picks(const std::vector<uint32_t>& found, const std::vector<uint32_t>& fine, glm::uvec2 size,
                   uint32_t times) {
    size_t wrong = 0;
    for (uint32_t y = 0; y < size.y; ++y)
        for (uint32_t x = 0; x < size.x; ++x) {
            std::map<uint32_t, uint32_t> covered;
            uint32_t most = 0;
            for (uint32_t v = 0; v < times; ++v)
                for (uint32_t u = 0; u < times; ++u)
                    most = std::max(most, ++covered[fine[(y * times + v) * size.x * times + x * times + u]]);
            const auto own = covered.find(found[y * size.x + x]);
            const uint32_t share = own == covered.end() ? 0 : own->second;
            wrong += share + times * times / 8 < most;
        }
    return double(wrong) / double(size.x * size.y);
}

void measure_picking(Playground& chapter, Gpu& gpu, glm::uvec2 size, nlohmann::json& error) {
    constexpr uint32_t times = 8;
    const glm::uvec2 own = glm::min(size, glm::uvec2(240, 136));
    chapter.show.set("ids");
    const std::vector<uint32_t> found = ids_of(chapter, gpu, own);
    chapter.picker.method.set("ids");
    error["wrong_picks"] = wrong_picks(found, ids_of(chapter, gpu, own * times), own, times);
}

}  // namespace lightwalk
