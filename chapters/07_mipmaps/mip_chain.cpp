#include "07_mipmaps/mip_chain.h"

#include "common/base/error.h"
#include "common/gpu/device_features.h"

namespace lightwalk {

namespace {

constexpr uint32_t tile = 64, tiles_across = 64;  // as in single_pass.comp
// Of more tiles the last workgroup is not worth waiting for: a second dispatch makes the rest.
constexpr uint32_t most_waited_for = 32 * 32;
constexpr uint32_t most_levels = 12;       // 64×64 tiles of 64×64 texels
constexpr uint32_t least_counters = 4096;  // of dispatches between two clears

VkOffset3D corner(const ImageView& view) {
    const glm::ivec3 size(view.size());
    return {size.x, size.y, 1};
}

bool grow(Device& device, Buffer& buffer, const char* name, VkDeviceSize bytes) {
    if (buffer.bytes >= bytes) return false;
    buffer = Buffer(device, {.name = name, .bytes = bytes});
    return true;
}

}  // namespace

MipChain::MipChain(Module& owner, std::string name) : Module(owner, std::move(name), "mips") {}

Content MipChain::content_of(const ImageView& image, Content what) const {
    if (!content.is("each")) return static_cast<Content>(content.index);
    if (what != Content::each) return what;
    return image.image->desc.format == VK_FORMAT_R8G8B8A8_SRGB ? Content::srgb : Content::linear;
}

void MipChain::record(Frame& frame, const ImageView& image, Content what, float cutoff) {
    if (method.is("none") || image.mips < 2) return;
    what = content_of(image, what);
    Macros variant{{content.macro(), std::to_string(static_cast<int>(what))}};
    if (method.is("blit"))
        record_blits(frame, image);
    else if (method.is("single_pass"))
        record_single_pass(frame, image, std::move(variant));
    else
        record_levels(frame, image, variant);
    if (what == Content::cutout && !method.is("blit")) coverage_.record(frame, image, cutoff);
}

// Blits with a linear filter, available everywhere. They know sRGB, but neither normals nor alpha.
void MipChain::record_blits(Frame& frame, const ImageView& image) {
    ImageView smaller = image;
    smaller.first_mip += 1;
    smaller.mips -= 1;
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

void MipChain::record_single_pass(Frame& frame, const ImageView& image, Macros variant) {
    Device& device = frame.gpu.device;
    if (!lanes_) lanes_ = Limits(device.physical).shuffling_lanes;
    variant.set("SUBGROUP_LANES", std::to_string(lanes_));
    grow(device, tiles_, "mip tiles", sizeof(glm::vec4) * tiles_across * tiles_across * image.layers);
    const uint32_t most_dispatches = (image.mips + most_levels / 2 - 1) / (most_levels / 2);
    const uint32_t counters = std::max(least_counters, most_dispatches * image.layers);
    const bool grown = grow(device, finished_, "mip workgroups finished", sizeof(uint32_t) * counters);
    const auto all = static_cast<uint32_t>(finished_.bytes / sizeof(uint32_t));
    const bool clears = grown || next_counter_ + most_dispatches * image.layers > all;
    if (clears) next_counter_ = 0;

    ComputeAccess access{.reads = {tiles_, finished_}, .writes = {tiles_, finished_}, .with = {*this}};
    std::vector<ImageView> levels;
    for (uint32_t m = 0; m < image.mips; ++m) levels.push_back(plain_level(image, m));
    access.reads.insert(access.reads.end(), levels.begin(), levels.end());
    access.writes.insert(access.writes.end(), levels.begin() + 1, levels.end());
    frame.compute("mips in one pass", access, [&](Compute& pass) {
        // Each dispatch has counters of its own, which nothing has touched since all were cleared: one that was broken
        // off, or a student's, may have left any number in those before.
        if (clears) pass.use(clear_).set("words", finished_).dispatch_threads(glm::uvec2(all, 1)).wait();
        for (uint32_t base = 0; base + 1 < image.mips;) {
            // Beyond 64×64 tiles one workgroup cannot finish the rest: six levels, then again.
            const glm::uvec2 size(levels[base].size()), tiles = (size + tile - 1u) / tile;
            const bool whole = glm::all(glm::lessThanEqual(size >> 6u, glm::uvec2(tiles_across)));
            const uint32_t made = std::min(image.mips - 1 - base, whole ? most_levels : most_levels / 2);
            const bool split = made > most_levels / 2 && tiles.x * tiles.y > most_waited_for;
            const auto dispatch = [&](const char* makes, glm::uvec2 groups) {
                variant.set("MAKES", makes);
                pass.use(single_pass_, variant).set("tile_means", tiles_);
                pass.set_if_present("finished", finished_);  // an exercise of the chapter's: it may not be there yet
                pass.set("source", levels[base], bilinear ? linear_clamp : nearest_clamp);
                pass.set("levels", std::span(levels).subspan(base + 1, made));
                pass.set("chain", glm::ivec2(made, next_counter_)).dispatch(glm::uvec3(groups, image.layers));
            };
            if (base > 0) pass.wait();
            dispatch(split ? "SIX" : "ALL", tiles);
            if (split) {
                pass.wait();
                dispatch("REST", {1, 1});
            }
            next_counter_ += image.layers;
            base += made;
        }
    });
}

namespace {

struct CoverageBlock {
    int level, levels;
    float cutoff;
};

/// Null: a format without alpha, of which nothing is cut out.
const char* glsl_format_with_alpha(VkFormat format) {
    switch (format) {
        case VK_FORMAT_R8G8B8A8_UNORM:
        case VK_FORMAT_R8G8B8A8_SRGB:
            return "rgba8";
        case VK_FORMAT_R16G16B16A16_SFLOAT:
            return "rgba16f";
        case VK_FORMAT_R32G32B32A32_SFLOAT:
            return "rgba32f";
        default:
            return nullptr;
    }
}

}  // namespace

void Coverage::record(Frame& frame, const ImageView& image, float cutoff) {
    const char* format = glsl_format_with_alpha(image.image->desc.format);
    if (!format) return;
    const uint32_t words = 256 * image.mips * image.layers;
    if (counts_.bytes < sizeof(uint32_t) * words) {
        counts_ = Buffer(frame.gpu.device, {.name = "alpha counts", .bytes = sizeof(uint32_t) * words});
        factors_ = Buffer(frame.gpu.device, {.name = "alpha factors", .bytes = sizeof(float) * words / 256});
    }
    ComputeAccess access{.reads = {counts_, factors_}, .writes = {counts_, factors_}, .with = {}};
    for (uint32_t m = 0; m < image.mips; ++m) {
        access.reads.push_back(plain_level(image, m));
        if (m > 0) access.writes.push_back(plain_level(image, m));
    }
    const auto threads = [&](uint32_t m) { return glm::uvec3(glm::uvec2(image.mip(m).size()), image.layers); };
    frame.compute("coverage", access, [&](Compute& pass) {
        CoverageBlock block{0, static_cast<int>(image.mips), cutoff};
        pass.use(clear_).set("words", counts_).dispatch_threads(glm::uvec2(words, 1)).wait();
        pass.use(count_).set("alpha_count", counts_).set("factors", factors_);
        for (uint32_t m = 0; m < image.mips; ++m) {
            block.level = static_cast<int>(m);
            pass.set("coverage", block)
                .set("source", plain_level(image, m), nearest_clamp)
                .dispatch_threads(threads(m));
        }
        pass.wait().use(find_).set("alpha_count", counts_).set("factors", factors_).set("coverage", block);
        pass.dispatch({image.mips, image.layers, 1}).wait();
        pass.use(scale_, {{"RESULT_FORMAT", format}}).set("alpha_count", counts_).set("factors", factors_);
        for (uint32_t m = 1; m < image.mips; ++m) {
            block.level = static_cast<int>(m);
            pass.set("coverage", block).set("result", plain_level(image, m)).dispatch_threads(threads(m));
        }
    });
}

}  // namespace lightwalk
