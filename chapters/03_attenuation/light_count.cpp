#include "03_attenuation/light_count.h"

#include <cstring>
#include <glm/gtc/packing.hpp>

namespace lightwalk {

double mean_light_count(Gpu& gpu, const Image& hdr) {
    const std::vector<std::byte> texels = gpu.read_back(hdr);
    double sum = 0;
    for (size_t i = 0; i < texels.size(); i += 8) {
        uint16_t alpha = 0;
        std::memcpy(&alpha, texels.data() + i + 6, 2);
        sum += static_cast<double>(glm::unpackHalf1x16(alpha));
    }
    return sum / (static_cast<double>(texels.size()) / 8);
}

}  // namespace lightwalk
