// Device with samplers, pipelines, and blocking transfers.
#pragma once
#include <functional>
#include <span>

#include "common/gpu/buffer.h"
#include "common/gpu/device.h"
#include "common/gpu/image.h"
#include "common/gpu/owned.h"
#include "common/gpu/pipeline.h"
#include "common/gpu/sampler.h"

namespace lightwalk {

class Gpu {
  public:
    explicit Gpu(const DeviceOptions& options);
    ~Gpu();
    Gpu(const Gpu&) = delete;

    Device device;
    Samplers samplers{device};
    PipelineLibrary pipelines{device};

    /// Device-local buffer with contents `bytes`, readable by every pass. Blocks; within a frame use Frame::upload().
    Buffer upload(const std::string& name, std::span<const std::byte> bytes);
    template <class T>
    Buffer upload(const std::string& name, const std::vector<T>& items) {
        Buffer buffer = upload(name, std::as_bytes(std::span(items)));
        buffer.stride = sizeof(T);
        return buffer;
    }

    /// Fills an image with one mip level, layer by layer, tightly packed. Throws Failure if the byte count differs.
    void upload(Image& image, std::span<const std::byte> texels);

    /// Fills every mip level: `levels` holds all layers of each, tightly packed (common/image/mip_levels.h).
    void upload(Image& image, const std::vector<std::vector<std::byte>>& levels);

    /// Texels of the view's first mip, layer by layer, tightly packed. Blocks. Throws Failure for a multisampled image.
    std::vector<std::byte> read_back(const ImageView& view);
    std::vector<std::byte> read_back(const Buffer& buffer);

    void submit_now(const std::function<void(VkCommandBuffer)>& record);

    uint64_t uploaded_bytes = 0;

  private:
    Owned<VkCommandPool, vkDestroyCommandPool> pool_;
};

/// Copy region of the view's first mip, all layers, tightly packed from byte `offset` on.
VkBufferImageCopy region_of(VkDeviceSize offset, const ImageView& view);

/// Copies between a buffer and the view's first mip, all layers. The image must be in the transfer layout.
void copy(VkCommandBuffer commands, VkBuffer from, VkDeviceSize offset, const ImageView& to);
void copy(VkCommandBuffer commands, const ImageView& from, VkBuffer to);

/// Exits immediately with code 1: after an endless command, destroying the device's objects would block for ever.
[[noreturn]] void abandon_device(const std::string& message);

/// Optional callback of abandon_device(), given the message before exit.
std::function<void(const std::string&)>& on_abandoned_device();

}  // namespace lightwalk
