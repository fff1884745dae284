// Names of Vulkan enumerators, from vulkan.hpp.
#define VULKAN_HPP_NO_SMART_HANDLE
#define VULKAN_HPP_NO_STRUCT_CONSTRUCTORS
#include <vulkan/vulkan.hpp>
// Not self-contained: needs vulkan.hpp before it.
#include <vulkan/vulkan_format_traits.hpp>
#include <vulkan/vulkan_to_string.hpp>

#include "common/base/error.h"
#include "common/gpu/image.h"
#include "common/gpu/reflect.h"

namespace lightwalk {

std::string name_of(VkResult result) { return vk::to_string(static_cast<vk::Result>(result)); }
std::string name_of(VkFormat format) { return vk::to_string(static_cast<vk::Format>(format)); }

Texels texels_of(VkFormat format) {
    static const auto of_all = [] {
        std::array<Texels, VK_FORMAT_ASTC_12x12_SRGB_BLOCK + 1> all{};
        for (size_t i = 1; i < all.size(); ++i) {
            const std::string_view kind = vk::componentNumericFormat(static_cast<vk::Format>(i), 0);
            all[i] = kind == "UINT" ? Texels::unsigned_integers : kind == "SINT" ? Texels::integers : Texels::floats;
        }
        return all;
    }();
    return size_t(format) < of_all.size() ? of_all[size_t(format)] : Texels::floats;
}

uint32_t texel_bytes(VkFormat format) {
    const auto traits = static_cast<vk::Format>(format);
    if (vk::blockSize(traits) == 0 || vk::texelsPerBlock(traits) != 1)
        throw Failure("texel_bytes: a texel of {} is no number of bytes", name_of(format));
    return vk::blockSize(traits);
}

}  // namespace lightwalk
