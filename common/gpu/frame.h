// One frame: targets, recorded passes, GPU times.
#pragma once
#include <functional>

#include "common/base/function_ref.h"
#include "common/gpu/pass.h"
#include "common/gpu/pass_listener.h"
#include "common/gpu/read_back.h"
#include "common/gpu/recording.h"

namespace lightwalk {

/// Tile of a larger image, rendered at that image's resolution.
struct Crop {
    glm::uvec2 whole{0};
    glm::uvec2 origin{0};   ///< first pixel of the tile, in the whole image
    glm::vec2 shift{0.0f};  ///< sub-pixel jitter for anti-aliasing, -0.5 to 0.5 pixels
};

class Globals {
  public:
    std::vector<std::byte>& operator[](const BindingName& name) {
        for (auto& [hash, bytes] : all_)
            if (hash == name.hash) return bytes;
        return all_.emplace_back(name.hash, std::vector<std::byte>()).second;
    }
    const std::vector<std::byte>* find(const Binding& block) const {
        for (const auto& [hash, bytes] : all_)
            if (hash == block.hash && !bytes.empty()) return &bytes;
        return nullptr;
    }
    /// Leaves all blocks unset.
    void clear() {
        for (auto& [hash, bytes] : all_) bytes.clear();
    }

  private:
    std::vector<std::pair<uint64_t, std::vector<std::byte>>> all_;
};

class Frame {
  public:
    explicit Frame(Gpu& gpu, const FrameWatch& watch = {});
    ~Frame();
    Frame(const Frame&) = delete;

    Gpu& gpu;
    glm::uvec2 size{0};
    float time_s = 0;
    unsigned seed = 0;
    Image hdr;     ///< RGBA16F, linear: the chapters' render target
    Image depth;   ///< D32F, reversed: 1 at the near plane, 0 at the far plane
    Image output;  ///< RGBA8, sRGB-encoded: the final picture

    const PassInputs* root = nullptr;  ///< the chapter: its macros and uniforms go into every pass
    Crop crop;
    struct {
        int index = 0, count = 1;  ///< sub-frames averaged into one picture
    } samples;
    int gathered = 0;  ///< frames since the last cold start (Module::accumulation)

    const Image& linear() const { return samples.count > 1 ? mean_ : hdr; }

    /// Marks `image` as tone-mapped. Throws Failure if it already is: tone mapping applies once per frame.
    void apply_tones(const std::string& who, const Image& image) const;
    /// Throws Failure if `image` was tone-mapped in this frame: `who` needs linear light.
    void need_light(const std::string& who, const Image& image) const;

    size_t begun = 0;

    /// Unique number of the frame being recorded; 0: none.
    uint64_t number() const { return recording().use; }

    /// Starts recording; resizes the targets. Throws Failure while the device records another frame.
    void begin(glm::uvec2 size_in_pixels, float time_in_seconds);

    /// Passes run in order and do not nest. A pass whose callback throws is still submitted. Throws Failure if a pass
    /// reads an image that no pass of this frame wrote, unless it was uploaded or is marked Image::Desc::kept: its
    /// contents would be stale or undefined.
    /// Messages begin with the file and line of the statement, `where`.
    void raster(const std::string& name, const RasterTargets& targets, FunctionRef<void(Raster&)> record,
                SourceLocation where = SourceLocation::current());
    void compute(const std::string& name, const ComputeAccess& access, FunctionRef<void(Compute&)> record,
                 SourceLocation where = SourceLocation::current());
    void transfer(const std::string& name, const ComputeAccess& access, FunctionRef<void(VkCommandBuffer)> record,
                  SourceLocation where = SourceLocation::current());

    /// Transfer pass that fills `buffer`, enlarged as needed; all later passes may read it. `bytes` are copied now.
    void upload(const std::string& name, Buffer& buffer, std::span<const std::byte> bytes);
    template <class T>
    void upload(const std::string& name, Buffer& buffer, const std::vector<T>& items) {
        upload(name, buffer, std::as_bytes(std::span(items)));
        buffer.stride = sizeof(T);
    }
    /// Transfer pass that updates parts of an existing buffer: srcOffset in `bytes` to dstOffset in the buffer.
    void upload(const std::string& name, const Buffer& buffer, std::span<const std::byte> bytes,
                std::span<const VkBufferCopy> parts);
    /// Transfer pass that fills a view's first mip, tightly packed. Throws Failure if the byte count differs.
    void upload(const std::string& name, const ImageView& view, std::span<const std::byte> texels);

    /// Transfer pass that copies images (from, to) of equal format, size, mips and layers.
    void copy_images(const std::string& name, const std::vector<std::pair<ImageView, ImageView>>& views);

    /// Transfer pass that fills a colour image, for instance before a student's pass that may leave it unwritten.
    void fill(const std::string& name, const Image& image, glm::vec4 value);

    /// Transfer pass that copies to the host; `into` has the bytes once this frame has ended. For a view: its first
    /// mip, layer by layer, tightly packed. Throws Failure for a multisampled image.
    void read_back(const Buffer& buffer, ReadBack& into);
    void read_back(const ImageView& view, ReadBack& into);

    /// Submits the frame. With one frame in flight, waits for its end; otherwise begin() waits for the oldest frame. If
    /// no pass ends within Device::timeout_ns(), the process exits with the name of the running pass. Fills `times` and
    /// the read-backs of ended frames.
    void end(VkSemaphore wait = VK_NULL_HANDLE, VkSemaphore signal = VK_NULL_HANDLE);

    void finish();

    /// Sets the maximum number of frames in flight, initially 1. With 2, times and read-backs arrive a frame later.
    void set_frames_in_flight(size_t in_flight);

    std::vector<PassTime> times;  ///< last ended frame, in pass order
    std::function<void(const std::vector<PassTime>&)> on_ended;
    double recording_ms = 0;  ///< CPU time of recording the last frame

    /// 2-D single-sampled images written by this frame's passes, in order, for inspection.
    std::vector<std::pair<std::string, ImageView>> outputs;

    /// Called after each pass that wrote an image, before another pass can overwrite it.
    std::function<void()> after_pass;

    Globals globals;

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
    size_t current_ = 0;
    bool in_pass_ = false;
    PassLists lists_;
    Image mean_;
    Owned<VkSemaphore, vkDestroySemaphore> timeline_;
    uint64_t submitted_ = 0;
};

}  // namespace lightwalk
