#include "common/gpu/sampler.h"

#include <fmt/core.h>

#include <algorithm>

namespace lightwalk {
namespace {

VkFilter vk(Filter filter) { return filter == Filter::linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST; }

VkSamplerAddressMode vk(Wrap wrap) {
    switch (wrap) {
        case Wrap::repeat:
            return VK_SAMPLER_ADDRESS_MODE_REPEAT;
        case Wrap::mirror:
            return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
        case Wrap::clamp:
            return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
        case Wrap::border:
            break;
    }
    return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER;
}

VkBorderColor vk(Border border) {
    switch (border) {
        case Border::transparent_black:
            return VK_BORDER_COLOR_FLOAT_TRANSPARENT_BLACK;
        case Border::opaque_black:
            return VK_BORDER_COLOR_FLOAT_OPAQUE_BLACK;
        case Border::opaque_white:
            break;
    }
    return VK_BORDER_COLOR_FLOAT_OPAQUE_WHITE;
}

}  // namespace

VkSampler Samplers::operator[](const Sampler& sampler) {
    for (const auto& [known, made] : made_)
        if (known == sampler) return made;
    constexpr float most = 16;  // that every device with anisotropic filters has (the limit maxSamplerAnisotropy)
    const VkSamplerCreateInfo info{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                   .magFilter = vk(sampler.filter),
                                   .minFilter = vk(sampler.filter),
                                   .mipmapMode = sampler.mip_filter == Filter::linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR
                                                                                      : VK_SAMPLER_MIPMAP_MODE_NEAREST,
                                   .addressModeU = vk(sampler.wrap),
                                   .addressModeV = vk(sampler.wrap_v.value_or(sampler.wrap)),
                                   .addressModeW = vk(sampler.wrap),
                                   .mipLodBias = sampler.lod_bias,
                                   .anisotropyEnable = sampler.anisotropy > 1.0f,
                                   .maxAnisotropy = std::clamp(sampler.anisotropy, 1.0f, most),
                                   .compareEnable = sampler.compare != Compare::off,
                                   .compareOp = compare_op(sampler.compare),
                                   .minLod = sampler.min_lod,
                                   .maxLod = sampler.max_lod,
                                   .borderColor = vk(sampler.border)};
    Owned<VkSampler, vkDestroySampler> made;
    check(vkCreateSampler(device_.handle, &info, nullptr, made.put(device_.handle)), "vkCreateSampler");
    made_.emplace_back(sampler, std::move(made));
    const VkSampler handle = made_.back().second;
    device_.set_name(VK_OBJECT_TYPE_SAMPLER, reinterpret_cast<uint64_t>(handle),
                     fmt::format("sampler {}", made_.size()));
    return handle;
}

}  // namespace lightwalk
