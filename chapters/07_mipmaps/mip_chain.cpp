#include "07_mipmaps/mip_chain.h"

#include "common/base/error.h"

namespace lightwalk {
namespace {

constexpr uint32_t tile = 64, tiles_across = 64;  // as in single_pass.comp
constexpr uint32_t most_levels = 12;              // 64×64 tiles of 64×64 texels

VkOffset3D corner(const ImageView& view) {
    const glm::ivec3 size(view.size());
    return {size.x, size.y, 1};
}

void grow(Device& device, Buffer& buffer, const char* name, VkDeviceSize bytes) {
    if (buffer.bytes < bytes) buffer = Buffer(device, {.name = name, .bytes = bytes});
}

}  // namespace

Content MipChain::content_of(const ImageView& image, Content what) const {
    if (!content.is("each")) return static_cast<Content>(content.index);
    if (what != Content::each) return what;
    return image.image->desc.format == VK_FORMAT_R8G8B8A8_SRGB ? Content::srgb : Content::linear;
}

// [record]
void MipChain::record(Frame& frame, const ImageView& image, Content what, float cutoff) {
    if (method.is("none") || image.mips < 2) return;
    what = content_of(image, what);
    const Macros variant{{content.macro(), std::to_string(static_cast<int>(what))}};
    if (method.is("blit"))
        record_blits(frame, image);
    else if (method.is("single_pass"))
        record_single_pass(frame, image, variant);
    else
        record_levels(frame, image, variant);
    if (what == Content::cutout && !method.is("blit")) coverage_.record(frame, image, cutoff);
}
// [/record]

// What every driver has: a picture drawn smaller, with a linear filter. It knows sRGB, and nothing of normals or alpha.
void MipChain::record_blits(Frame& frame, const ImageView& image) {
    ImageView smaller = image;
    smaller.first_mip += 1, smaller.mips -= 1;
    frame.transfer("mips by blits", {.reads = {image.mip(0)}, .writes = {smaller}}, [&](VkCommandBuffer commands) {
        for (uint32_t m = 1; m < image.mips; ++m) {
            const ImageView from = image.mip(m - 1), to = image.mip(m);
            if (m > 1) barrier(commands, from, transfer_read);
            const VkImageBlit half{.srcSubresource = from.first_mip_layers(),
                                   .srcOffsets = {{}, corner(from)},
                                   .dstSubresource = to.first_mip_layers(),
                                   .dstOffsets = {{}, corner(to)}};
            vkCmdBlitImage(commands, from.image->handle, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to.image->handle,
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &half, VK_FILTER_LINEAR);
        }
    });
}

// [levels]
void MipChain::record_levels(Frame& frame, const ImageView& image, const Macros& variant) {
    const Pipeline& filter = method.is("box") ? box_ : method.is("polyphase") ? polyphase_ : kaiser_;
    ComputeAccess access;
    for (uint32_t m = 0; m < image.mips; ++m) {
        access.reads.push_back(plain_level(image, m));
        if (m > 0) access.writes.push_back(plain_level(image, m));
    }
    access.with = {*this};
    frame.compute("mips by levels", access, [&](Compute& pass) {
        pass.use(filter, variant);
        for (uint32_t m = 1; m < image.mips; ++m) {
            if (m > 1) pass.wait();  // for the level before
            const ImageView level = plain_level(image, m);
            pass.set("source", plain_level(image, m - 1), nearest_clamp).set("level", level);
            pass.dispatch_threads(glm::uvec3(glm::uvec2(level.size()), level.layers));
        }
    });
}
// [/levels]

// [single]
void MipChain::record_single_pass(Frame& frame, const ImageView& image, const Macros& variant) {
    grow(frame.gpu.device, tiles_, "mip tiles", sizeof(glm::vec4) * tiles_across * tiles_across * image.layers);
    grow(frame.gpu.device, finished_, "mip workgroups finished", sizeof(uint32_t) * image.layers);
    for (uint32_t base = 0; base + 1 < image.mips;) {
        // Beyond 64×64 tiles the last workgroup could not finish what they leave: six levels, then again.
        const glm::uvec2 size(image.mip(base).size());
        const bool whole = glm::all(glm::lessThanEqual(size >> 6u, glm::uvec2(tiles_across)));
        const uint32_t made = std::min(image.mips - 1 - base, whole ? most_levels : most_levels / 2);
        std::vector<ImageView> levels;
        for (uint32_t m = 1; m <= made; ++m) levels.push_back(plain_level(image, base + m));
        ComputeAccess access{.reads = {plain_level(image, base), tiles_, finished_},
                             .writes = {levels.begin(), levels.end()},
                             .with = {*this}};
        access.writes.insert(access.writes.end(), {tiles_, finished_});
        frame.compute("mips in one pass", access, [&](Compute& pass) {
            // Always: a dispatch that was broken off, or a student's, may have left any number.
            pass.use(clear_).set("words", finished_).dispatch_threads(glm::uvec2(image.layers, 1)).wait();
            pass.use(single_pass_, variant);
            pass.set("source", plain_level(image, base), bilinear ? linear_clamp : nearest_clamp);
            pass.set("levels", levels).set("tile_means", tiles_).set("chain", static_cast<int>(made));
            pass.offer("finished", finished_);  // an exercise of the chapter's: it may not be there yet
            pass.dispatch(glm::uvec3((size + tile - 1u) / tile, image.layers));
        });
        base += made;
    }
}
// [/single]

}  // namespace lightwalk
