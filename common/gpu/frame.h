// One frame: its targets, the passes recorded into it, and how long each took.
#pragma once
#include <functional>
#include <map>

#include "common/gpu/pass.h"

namespace lightwalk {

struct PassTime {
    std::string name;
    std::string stage;  ///< raster, compute or transfer: where the time was spent
    double gpu_ms = 0;
};

/// The part of a larger picture that a frame draws, at that picture's own resolution.
struct Crop {
    glm::uvec2 whole{0};    ///< pixels of the whole picture
    glm::uvec2 origin{0};   ///< of the frame's first pixel in it
    glm::vec2 shift{0.0f};  ///< of the whole picture within a pixel, for anti-aliasing: -0.5 to 0.5 pixels
};

/// Records passes in order and submits them at once, one frame in flight. Every pass is a submission of its own that
/// counts a timeline semaphore up, so that a pass that never ends can be named.
class Frame {
  public:
    explicit Frame(Gpu& gpu);
    ~Frame();
    Frame(const Frame&) = delete;

    Gpu& gpu;
    glm::uvec2 size{0};  ///< pixels
    float time_s = 0;
    unsigned seed = 0;
    Image hdr;     ///< RGBA16F, linear: what chapters draw into
    Image depth;   ///< D32F, reversed: 1 at the near plane, 0 at the far one
    Image output;  ///< RGBA8, sRGB-encoded: the picture

    const Given* root = nullptr;  ///< the chapter: its macros and its uniform block go into every pass
    Crop crop;
    struct {
        int index = 0, count = 1;  ///< of the pictures whose mean is shown
    } samples;

    /// The picture in linear light: hdr, or the mean of several.
    const Image& linear() const { return samples.count > 1 ? mean_ : hdr; }

    /// Starts recording; makes the targets anew where the size has changed.
    void begin(glm::uvec2 size_in_pixels, float time_in_seconds);

    void raster(const std::string& name, const RasterTargets& targets, const std::function<void(Raster&)>& record);
    void compute(const std::string& name, const ComputeAccess& access, const std::function<void(Compute&)>& record);
    void transfer(const std::string& name, const ComputeAccess& access,
                  const std::function<void(VkCommandBuffer)>& record);

    /// An image that lives as long as the frame's size does not change, by name: for a pass's intermediate results.
    Image& image(const std::string& name, Image::Desc desc);

    /// Submits and waits. A pass that outlasts Device::timeout_ns ends the process with its name. Fills `times`.
    void end(VkSemaphore wait = VK_NULL_HANDLE, VkSemaphore signal = VK_NULL_HANDLE);

    std::vector<PassTime> times;  ///< of the last frame that ended, in order

    /// The image each pass of this frame wrote first, in order, to look at.
    std::vector<std::pair<std::string, const Image*>> outputs;

    /// Called after each pass that wrote an image, before a later pass can overwrite it: for whoever wants to look.
    std::function<void()> after_pass;

    /// Uniform blocks that every shader may name: bytes by name.
    std::map<std::string, std::vector<std::byte>> globals;

    // For Pass.
    VkDescriptorBufferInfo copy_to_arena(std::span<const std::byte> bytes);

  private:
    struct Recorded {
        std::string name, stage;
        VkCommandBuffer commands;
    };
    VkCommandBuffer begin_pass(const std::string& name, const char* stage);
    void end_pass();
    void run_after_pass(size_t outputs_before);
    void read_times();
    std::vector<Recorded> passes_;
    std::vector<VkCommandBuffer> free_commands_;
    std::map<std::string, Image> images_;
    Image mean_;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkQueryPool queries_ = VK_NULL_HANDLE;
    VkSemaphore timeline_ = VK_NULL_HANDLE;
    uint64_t counted_ = 0;
    std::vector<Buffer> arenas_;
    size_t arena_ = 0;
    VkDeviceSize arena_used_ = 0;
};

}  // namespace lightwalk
