// The device with its samplers, pipelines, uploads and read-backs.
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

    /// A device-local buffer holding `bytes`, through a staging buffer. Every pass may read it. Waits: for loading; in
    /// a frame, Frame::upload.
    Buffer upload(const std::string& name, std::span<const std::byte> bytes);
    template <class T>
    Buffer upload(const std::string& name, const std::vector<T>& items) {
        return upload(name, std::as_bytes(std::span(items)));
    }

    /// Fills an image of one mip level, layer by layer, from tightly packed texels. Throws Failure for another number of
    /// bytes.
    void upload(Image& image, std::span<const std::byte> texels);

    /// Fills every mip level: `levels` has as many as the image, each all layers, tightly packed (common/image/mip_levels.h).
    void upload(Image& image, const std::vector<std::vector<std::byte>>& levels);

    /// The texels of the view's first mip, layer by layer, tightly packed. Waits; in a frame, Frame::read_back. Throws
    /// Failure for an image with several samples.
    std::vector<std::byte> read_back(const ImageView& view);
    std::vector<std::byte> read_back(const Buffer& buffer);

    /// Records, submits and waits: for uploads and read-backs, not for frames.
    void submit_now(const std::function<void(VkCommandBuffer)>& record);

    /// Bytes uploaded so far, to show that nothing is uploaded twice.
    uint64_t uploaded_bytes = 0;

  private:
    Owned<VkCommandPool, vkDestroyCommandPool> pool_;
};

/// The view's first mip, all its layers, tightly packed in a buffer from byte `offset` on.
VkBufferImageCopy region_of(VkDeviceSize offset, const ImageView& view);

/// Copies between a buffer, from byte `offset` on, and the view's first mip, all its layers. The image is in the layout
/// for transfers.
void copy(VkCommandBuffer commands, VkBuffer from, VkDeviceSize offset, const ImageView& to);
void copy(VkCommandBuffer commands, const ImageView& from, VkBuffer to);

/// Ends the process at once with a line on stderr and exit code 1: the device is still busy with a command that never
/// ends, so that destroying anything would wait for ever.
[[noreturn]] void abandon_device(const std::string& message);

/// Called with the message before the process ends so; empty: the line goes to stderr alone.
std::function<void(const std::string&)>& on_abandoned_device();

}  // namespace lightwalk
