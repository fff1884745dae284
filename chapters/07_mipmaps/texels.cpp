#include "07_mipmaps/texels.h"

#include <cstring>
#include <glm/gtc/packing.hpp>

#include "07_mipmaps/truth.h"
#include "common/base/error.h"

namespace lightwalk {
namespace {

glm::vec4 unpack(const std::byte* from, VkFormat format) {
    const auto as = [&](auto value) {
        std::memcpy(&value, from, sizeof value);
        return value;
    };
    switch (format) {
        case VK_FORMAT_R8G8B8A8_SRGB:
        case VK_FORMAT_R8G8B8A8_UNORM:
            return glm::unpackUnorm4x8(as(uint32_t{}));
        case VK_FORMAT_R16G16B16A16_UNORM:
            return glm::unpackUnorm4x16(as(uint64_t{}));
        case VK_FORMAT_R16G16B16A16_SFLOAT:
            return glm::unpackHalf4x16(as(uint64_t{}));
        case VK_FORMAT_R16G16_UNORM:
            return {glm::unpackUnorm2x16(as(uint32_t{})), 0, 1};
        case VK_FORMAT_R16G16_SFLOAT:
            return {glm::unpackHalf2x16(as(uint32_t{})), 0, 1};
        case VK_FORMAT_R16_UNORM:
            return {glm::unpackUnorm1x16(as(uint16_t{})), 0, 0, 1};
        case VK_FORMAT_R32_SFLOAT:
            return {as(float{}), 0, 0, 1};
        case VK_FORMAT_R32G32B32A32_SFLOAT:
            return as(glm::vec4{});
        default:
            throw Failure("levels in {} are not read as numbers", name_of(format));
    }
}

void pack(std::byte* into, glm::vec4 v, VkFormat format) {
    const auto put = [&](const auto& value) { std::memcpy(into, &value, sizeof value); };
    switch (format) {
        case VK_FORMAT_R8G8B8A8_SRGB:
        case VK_FORMAT_R8G8B8A8_UNORM:
            return put(glm::packUnorm4x8(v));
        case VK_FORMAT_R16G16B16A16_UNORM:
            return put(glm::packUnorm4x16(v));
        case VK_FORMAT_R16G16B16A16_SFLOAT:
            return put(glm::packHalf4x16(v));
        case VK_FORMAT_R16G16_UNORM:
            return put(glm::packUnorm2x16(glm::vec2(v)));
        case VK_FORMAT_R16G16_SFLOAT:
            return put(glm::packHalf2x16(glm::vec2(v)));
        case VK_FORMAT_R16_UNORM:
            return put(glm::packUnorm1x16(v.r));
        case VK_FORMAT_R32_SFLOAT:
            return put(v.r);
        case VK_FORMAT_R32G32B32A32_SFLOAT:
            return put(v);
        default:
            throw Failure("numbers are not written as {}", name_of(format));
    }
}

}  // namespace

truth::Texels read_texels(Gpu& gpu, const ImageView& view) {
    const ImageView first = view.as_array().layer(0).mip(0);
    const std::vector<std::byte> bytes = gpu.read_back(first);
    truth::Texels result{glm::uvec2(first.size()), {}};
    const VkFormat format = view.image->desc.format;
    result.values.reserve(size_t(result.size.x) * result.size.y);
    for (size_t i = 0; i < bytes.size(); i += texel_bytes(format))
        result.values.emplace_back(unpack(&bytes[i], format));
    return result;
}

std::vector<std::byte> to_bytes(const truth::Texels& texels, VkFormat format) {
    const size_t each = texel_bytes(format);
    std::vector<std::byte> bytes(each * texels.values.size());
    for (size_t i = 0; i < texels.values.size(); ++i) pack(&bytes[each * i], glm::vec4(texels.values[i]), format);
    return bytes;
}

truth::Texels decoded(truth::Texels texels, Content content) {
    for (glm::dvec4& texel : texels.values) texel = truth::decode(content, texel);
    return texels;
}

std::vector<double> level_errors(Gpu& gpu, const ImageView& image, Content content) {
    const truth::Texels first = decoded(read_texels(gpu, image), content);
    std::vector<double> errors;
    for (uint32_t m = 1; m < image.mips; ++m) {
        const truth::Texels found = decoded(read_texels(gpu, image.mip(m)), content);
        errors.push_back(truth::rmse(truth::area_mean(first, found.size), found));
    }
    return errors;
}

}  // namespace lightwalk
