// One frame: its targets, the passes recorded into it, and how long each took.
#pragma once
#include <functional>

#include "common/base/function_ref.h"
#include "common/gpu/pass.h"
#include "common/gpu/pass_listener.h"
#include "common/gpu/read_back.h"
#include "common/gpu/recording.h"

namespace lightwalk {

/// The part of a larger picture that a frame draws, at that picture's own resolution.
struct Crop {
    glm::uvec2 whole{0};    ///< pixels of the whole picture
    glm::uvec2 origin{0};   ///< of the frame's first pixel in it
    glm::vec2 shift{0.0f};  ///< of the whole picture within a pixel, for anti-aliasing: -0.5 to 0.5 pixels
};

/// Bytes of uniform blocks by name. They are few.
class Globals {
  public:
    std::vector<std::byte>& operator[](const BindingName& name) {
        for (auto& [hash, bytes] : all_)
            if (hash == name.hash) return bytes;
        return all_.emplace_back(name.hash, std::vector<std::byte>()).second;
    }
    const std::vector<std::byte>* find(const Binding& block) const {
        for (const auto& [hash, bytes] : all_)
            if (hash == block.hash) return &bytes;
        return nullptr;
    }

  private:
    std::vector<std::pair<uint64_t, std::vector<std::byte>>> all_;
};

/// Records passes in order and submits them at once. A pass that never ends is named.
/// Large (38 functions, 25 members): what one command buffer records, and its targets.
class Frame {
  public:
    explicit Frame(Gpu& gpu, const FrameWatch& watch = {});
    ~Frame();
    Frame(const Frame&) = delete;

    Gpu& gpu;
    glm::uvec2 size{0};  ///< pixels
    float time_s = 0;
    unsigned seed = 0;
    Image hdr;     ///< RGBA16F, linear: the chapters' target
    Image depth;   ///< D32F, reversed: 1 at the near plane, 0 at the far one
    Image output;  ///< RGBA8, sRGB-encoded: the picture

    const Given* root = nullptr;  ///< the chapter: its macros and its uniform block go into every pass
    Crop crop;
    struct {
        int index = 0, count = 1;  ///< among the frames averaged into one picture
    } samples;
    int gathered = 0;  ///< frames before this one since the last cold start (Module::gathering)

    /// The picture in linear light: hdr, or the mean of several.
    const Image& linear() const { return samples.count > 1 ? mean_ : hdr; }

    /// Notes a tone curve, which may be applied once a frame: throws Failure the second time.
    void apply_tones(const std::string& who, const Image& image) const;
    /// Throws Failure if a tone curve was applied to the image in this frame: `who` needs linear light.
    void need_light(const std::string& who, const Image& image) const;

    size_t begun = 0;  ///< frames that began so far

    /// Another one for each frame that begins; 0 while none is recorded.
    uint64_t number() const { return recording().use; }

    /// Starts recording; recreates the targets if the size has changed. Throws Failure if another frame of this
    /// device is being recorded, since frames that depend on each other must run in order.
    void begin(glm::uvec2 size_in_pixels, float time_in_seconds);

    /// Passes are recorded one after the other, never nested. One that throws is submitted all the same. Throws
    /// Failure if a pass reads an image that no pass of this frame wrote, unless it was uploaded or keeps its
    /// contents (Image::Desc::kept): it would show an earlier frame, or undefined memory.
    void raster(const std::string& name, const RasterTargets& targets, FunctionRef<void(Raster&)> record);
    void compute(const std::string& name, const ComputeAccess& access, FunctionRef<void(Compute&)> record);
    void transfer(const std::string& name, const ComputeAccess& access, FunctionRef<void(VkCommandBuffer)> record);

    /// A transfer pass that fills the buffer, which is made, or made larger, where it is too small; every later pass
    /// may read it. `bytes` are copied now. `name` is the pass's and a new buffer's.
    void upload(const std::string& name, Buffer& buffer, std::span<const std::byte> bytes);
    template <class T>
    void upload(const std::string& name, Buffer& buffer, const std::vector<T>& items) {
        upload(name, buffer, std::as_bytes(std::span(items)));
    }
    /// The same for parts of a buffer that was made before, from byte srcOffset of `bytes` to its own dstOffset each.
    void upload(const std::string& name, const Buffer& buffer, std::span<const std::byte> bytes,
                std::span<const VkBufferCopy> parts);
    /// The same for a view's first mip, all its layers, tightly packed; passes state the image as they did before.
    /// Throws Failure for another number of bytes.
    void upload(const std::string& name, const ImageView& view, std::span<const std::byte> texels);

    /// A transfer pass that copies views to others of the same format, size, mips and layers: (from, into).
    void copy_images(const std::string& name, const std::vector<std::pair<ImageView, ImageView>>& views);

    /// A transfer pass that fills a colour image, in case a student's pass leaves it unwritten before a later pass
    /// reads it.
    void fill(const std::string& name, const Image& image, glm::vec4 value);

    /// A transfer pass after which, when this frame has ended, `into` has the bytes; of a view, the first mip's texels,
    /// layer by layer, tightly packed. Throws Failure for an image with several samples.
    void read_back(const Buffer& buffer, ReadBack& into);
    void read_back(const ImageView& view, ReadBack& into);

    /// Submits. With one frame in flight it waits for it, else begin() waits for the oldest one. Where no pass ends within
    /// Device::timeout_ns, the process ends with the running one's name. Fills `times` and the read-backs of frames that
    /// have ended.
    void end(VkSemaphore wait = VK_NULL_HANDLE, VkSemaphore signal = VK_NULL_HANDLE);

    /// Waits for all frames in recording.
    void finish();

    /// Most frames that are recorded or running at a time, 1 at first. With 2 the processor records one while the device
    /// draws the one before, and times and read-backs arrive a frame later.
    void fly(size_t in_flight);

    std::vector<PassTime> times;                                 ///< of the last frame that ended, in order
    std::function<void(const std::vector<PassTime>&)> on_ended;  ///< called with the times of each frame, in order
    double recording_ms = 0;                                     ///< processor time that recording the last frame took

    /// Outputs of this frame's passes, in order, for viewing: 2-D images with one sample.
    std::vector<std::pair<std::string, ImageView>> outputs;

    /// Called after each pass that wrote an image, before a later pass can overwrite it.
    std::function<void()> after_pass;

    /// Uniform blocks that every shader may name: bytes by name.
    Globals globals;

    // For Pass.
    VkDescriptorBufferInfo copy_to_arena(std::span<const std::byte> bytes);
    VkDescriptorSet descriptor_set(const BuiltPipeline& pipeline, std::span<VkWriteDescriptorSet> writes) {
        return recording().sets.make(pipeline, writes);
    }

  private:
    friend class Pass;
    const FrameWatch watch_;
    Recording& recording() const { return *recordings_[current_]; }
    VkCommandBuffer begin_pass(const std::string& name, const char* stage);
    void end_pass();
    void check_reads(const std::string& pass, const std::vector<Stated>& stated, const Rendering* targets) const;
    void note_writes(const std::vector<Stated>& stated, const Rendering* targets) const;
    template <class Record, class End>
    void record_and_end(const Record& record, const End& end);
    void add_output(const std::string& name, const ImageView& view);
    void run_after_pass(size_t outputs_before);
    const Buffer& staging_for(ReadBack& into, const std::string& name, VkDeviceSize bytes);
    void submit(VkSemaphore wait, VkSemaphore signal);
    void make_room();
    void wait_for(const Recording& one);
    void retire(Recording& one);
    std::vector<std::unique_ptr<Recording>> recordings_;
    size_t current_ = 0;  ///< the one in the making, or the last
    bool in_pass_ = false;
    PassLists lists_;
    Image mean_;
    Owned<VkSemaphore, vkDestroySemaphore> timeline_;  ///< counts submissions that have ended
    uint64_t submitted_ = 0;
};

}  // namespace lightwalk
