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

    /// Fills level 0 of every layer from tightly packed texels and makes the other mips by repeated halving. Throws
    /// Failure if the number of bytes is another.
    void upload(Image& image, std::span<const std::byte> texels);

    /// Fills every level of an image with one layer: `levels` has as many as the image, tightly packed, from level 0.
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

/// Makes the levels from `first` (1 at least) on, each by halving the one before it, in layouts for transfers.
void make_levels(VkCommandBuffer commands, Image& image, uint32_t first);

/// As make_levels(), `rows` of one level from row `first` on. The same texels, where they are some of the rows, only if the
/// level before has an even height.
void make_rows(VkCommandBuffer commands, Image& image, uint32_t level, uint32_t first, uint32_t rows);

/// Ends the process at once with a line on stderr and exit code 1: the device is still busy with a command that never
/// ends, so that destroying anything would wait for ever.
[[noreturn]] void abandon_device(const std::string& message);

/// Called with the message before the process ends so; empty: the line goes to stderr alone.
std::function<void(const std::string&)>& on_abandoned_device();

}  // namespace lightwalk
