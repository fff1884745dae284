#include "common/gpu/slices.h"

#include <algorithm>
#include <chrono>
#include <cstring>

#include "common/base/error.h"
#include "common/gpu/barrier.h"

namespace lightwalk {

const Buffer& Slices::staged(Gpu& gpu, std::span<const std::byte> bytes) {
    if (!staging_) staging_ = Buffer(gpu.device, {.name = "slice", .bytes = slice_bytes, .host_visible = true});
    std::memcpy(staging_.mapped, bytes.data(), bytes.size());
    gpu.uploaded_bytes += bytes.size();
    return staging_;
}

void Slices::add(Buffer& to, const std::string& name, std::span<const std::byte> bytes) {
    add([&to, name, size = bytes.size()](Gpu& gpu) {
        to = Buffer(gpu.device, {.name = name, .bytes = size});
        to.constant = true;
    });
    for (size_t at = 0; at < bytes.size(); at += slice_bytes)
        add([this, &to, at, part = bytes.subspan(at, std::min(slice_bytes, bytes.size() - at))](Gpu& gpu) {
            const VkBufferCopy region{.dstOffset = at, .size = part.size()};
            gpu.submit_now([&, from = staged(gpu, part).handle](VkCommandBuffer commands) {
                barrier(commands, to, transfer_write);
                vkCmdCopyBuffer(commands, from, to.handle, 1, &region);
                barrier(commands, to, any_read);
            });
        });
}

// Slices are groups of rows, since the first mip of a large image exceeds one slice.
void Slices::add(Image& to, const std::vector<std::vector<std::byte>>& levels) {
    const ImageView whole(to);
    for (uint32_t m = 0; m < levels.size(); ++m) {
        const std::span<const std::byte> texels(levels[m]);
        const glm::uvec3 size = whole.mip(m).size();
        if (texels.size() != byte_count(whole.mip(m)))
            throw Failure("level {} of {} has {} bytes", m, to.desc.name, texels.size());
        const size_t row_bytes = texels.size() / size.y;
        const auto most = static_cast<uint32_t>(std::max<size_t>(slice_bytes / row_bytes, 1));
        for (uint32_t y = 0; y < size.y; y += most) {
            const uint32_t rows = std::min(most, size.y - y);
            add([this, &to, m, y, rows, width = size.x,
                 part = texels.subspan(y * row_bytes, rows * row_bytes)](Gpu& gpu) {
                const ImageView level = ImageView(to).mip(m);
                const VkBufferImageCopy region{.imageSubresource = level.first_mip_layers(),
                                               .imageOffset = {0, static_cast<int32_t>(y), 0},
                                               .imageExtent = {width, rows, 1}};
                gpu.submit_now([&, from = staged(gpu, part).handle](VkCommandBuffer commands) {
                    barrier(commands, level, transfer_write);
                    vkCmdCopyBufferToImage(commands, from, to.handle, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
                });
            });
        }
    }
    add([&to](Gpu& gpu) {
        gpu.submit_now([&](VkCommandBuffer commands) { barrier(commands, ImageView(to), any_read); });
        to.constant = true;
    });
}

bool Slices::step(Gpu& gpu, double budget_ms) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    while (!waiting_.empty()) {
        waiting_.front()(gpu);
        waiting_.pop_front();
        if (std::chrono::duration<double, std::milli>(Clock::now() - start).count() > budget_ms) break;
    }
    return waiting_.empty();
}

}  // namespace lightwalk
