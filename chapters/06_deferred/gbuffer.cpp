#include "06_deferred/gbuffer.h"

#include <fmt/core.h>

#include <glm/gtc/matrix_transform.hpp>

namespace lightwalk {

glm::mat4 clip_to_offset(const glm::mat4& view_projection, glm::vec3 eye) {
    // Double precision, since far / near may be 10,000.
    return glm::mat4(glm::inverse(glm::translate(glm::dmat4(view_projection), glm::dvec3(eye))));
}

std::vector<GBuffer::Texture> GBuffer::textures() const {
    constexpr VkFormat halves = VK_FORMAT_R16G16B16A16_SFLOAT, word = VK_FORMAT_R32_UINT;
    if (is_forward()) return {};
    if (method.is("packed") || method.is("tiled")) return {{"normals", word}, {"diffuse", word}, {"specular", word}};
    std::vector<Texture> all{{"normal", halves}, {"diffuse", halves}, {"specular", halves}};
    if (method.is("fat")) all.push_back({"position", VK_FORMAT_R32G32B32A32_SFLOAT});
    return all;
}

void GBuffer::begin(Frame& frame, const View& view, const ImageView& depth) {
    written_ = false;
    depth_ = depth;
    clip_to_offset_ = clip_to_offset(view.view_projection, view.eye);
    images_.clear();
    for (const Texture& t : textures()) {
        Image& image = made_[{view.id, t.name}];
        image.ensure(frame.gpu.device, {.name = "gbuffer " + t.name, .format = t.format, .size = view.size});
        images_.emplace_back("gbuffer_" + t.name, &image);
    }
}

std::vector<Attachment> GBuffer::targets(bool again) const {
    std::vector<Attachment> all;
    for (const auto& [name, image] : images_) all.push_back(again ? keep(*image) : discard(*image));
    return all;
}

uint32_t GBuffer::bytes_per_pixel() const {
    uint32_t bytes = 0;
    for (const Texture& t : textures()) bytes += texel_bytes(t.format);
    return bytes;
}

std::vector<std::string> GBuffer::status() const {
    if (is_forward()) return {};
    return {fmt::format("{} bytes a pixel beside depth", bytes_per_pixel())};
}

std::vector<Resource> GBuffer::reads() const {
    std::vector<Resource> all;
    if (written_)
        for (const auto& [name, image] : images_) all.emplace_back(*image);
    return all;
}

void GBuffer::bind(Pass& pass) const {
    pass.set_if_present("clip_to_offset", clip_to_offset_);
    if (!written_) return;
    pass.set_if_present("gbuffer_depth", depth_, nearest_clamp);
    for (const auto& [name, image] : images_) pass.set_if_present(name, *image, nearest_clamp);
}

}  // namespace lightwalk
