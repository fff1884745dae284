#include "05_shadow_maps/wrong_shares.h"

#include <array>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <nlohmann/json.hpp>

#include "05_shadow_maps/shadow_error.h"

namespace lightwalk {

void wrong_shares(Gpu& gpu, const Image& picture, nlohmann::json& error) {
    const std::vector<std::byte> texels = gpu.read_back(picture);
    std::array<size_t, 6> count{};
    for (size_t i = 6; i < texels.size(); i += 8) {
        uint16_t alpha = 0;
        std::memcpy(&alpha, texels.data() + i, 2);
        ++count.at(static_cast<size_t>(glm::unpackHalf1x16(alpha)));
    }
    const double surface = std::max(1.0, static_cast<double>(texels.size() / 8 - count[0]));
    const auto add = [&](const char* name, uint32_t kind) {
        error[name] = 100.0 * static_cast<double>(count.at(1 + kind)) / surface;
    };
    add("acne", SHADOW_ACNE);
    add("peter_panning", SHADOW_PETER_PANNING);
    add("leak", SHADOW_LEAK);
    add("edge", SHADOW_EDGE);
}

}  // namespace lightwalk
