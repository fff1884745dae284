// What a pass states and what it can do while it is recorded.
#pragma once
#include <functional>
#include <map>
#include <set>
#include <type_traits>

#include "common/gpu/given.h"
#include "common/gpu/gpu.h"

namespace lightwalk {

class Frame;
class Raster;

/// An image or a buffer in a pass's statement.
struct Resource {
    const Image* image = nullptr;
    const Buffer* buffer = nullptr;
    Resource() = default;
    Resource(const Image& i) : image(&i) {}
    Resource(const Buffer& b) : buffer(&b) {}
    explicit operator bool() const { return image || buffer; }
};

/// A module in a pass's statement.
using With = std::reference_wrapper<const Given>;

// [raster_targets]
/// A raster pass draws into `color` and `depth` and may read and write other resources in its shaders. What it does not
/// state it cannot bind; what was uploaded once needs no statement.
struct RasterTargets {
    std::vector<Resource> color;
    Resource depth;
    std::vector<Resource> reads, writes;
    std::vector<With> with;  ///< modules: their macros, uniforms, reads and bindings
    glm::vec4 clear{0.0f, 0.0f, 0.0f, 1.0f};
    bool keep = false;        ///< draw over what the targets hold instead of clearing them
    bool keep_depth = false;  ///< the same for depth alone
};
// [/raster_targets]

/// A compute pass; what stands in both lists is read and written.
struct ComputeAccess {
    std::vector<Resource> reads, writes;
    std::vector<With> with;
};

/// What is drawn by binding things to the pass and calling its draw functions.
struct Drawable {
    virtual ~Drawable() = default;
    virtual void draw(Raster& pass) const = 0;
};

/// Bindings by name. set() is remembered until the next use(); a draw or dispatch checks that nothing is missing.
class Pass {
  public:
    Pass(Frame& frame, std::string name, VkCommandBuffer commands, const std::vector<Resource>& reads,
         const std::vector<Resource>& writes, const std::vector<const Given*>& given);
    Pass(const Pass&) = delete;

    VkCommandBuffer commands;
    Frame& frame;
    const std::string name;

    /// True where the pipeline in use has a binding of that name.
    bool wants(const std::string& binding) const;

    // For modules, which do not know whether the pass draws or computes; where the shader lacks the name, nothing.
    void offer(const std::string& binding, const Image& image, Sampling sampling) {
        if (wants(binding)) set_image(binding, image, sampling, -1);
    }
    void offer(const std::string& binding, const Buffer& buffer) {
        if (wants(binding)) set_buffer(binding, buffer);
    }
    template <class T>
    requires(std::is_trivially_copyable_v<T>) void offer(const std::string& binding, const T& value) {
        if (wants(binding)) set_bytes(binding, std::as_bytes(std::span(&value, 1)));
    }

  protected:
    void bind(const Pipeline& pipeline, const Macros& variant, const TargetFormats& formats, VkPipelineBindPoint point);
    void set_image(const std::string& binding, const Image& image, Sampling sampling, int mip);
    void set_buffer(const std::string& binding, const Buffer& buffer);
    void set_bytes(const std::string& binding, std::span<const std::byte> bytes);
    /// Pushes what was set. False where there is no pipeline to draw with.
    bool flush();
    const BuiltPipeline* pipeline_ = nullptr;

  private:
    const Binding& find(const std::string& binding) const;
    void check_stated(const std::string& binding, const void* resource, bool constant, bool writes) const;
    struct Bound {
        VkDescriptorBufferInfo buffer{};
        VkDescriptorImageInfo image{};
        bool dirty = false;
    };
    std::map<uint32_t, Bound> bound_;
    std::set<const void*> readable_, writable_;
    const std::vector<const Given*> given_;
    std::vector<Macros> macros_;
    VkPipelineBindPoint point_ = VK_PIPELINE_BIND_POINT_GRAPHICS;
};

/// The setters, returning the pass they belong to so that a draw reads as one sentence.
template <class Self>
class PassSetters : public Pass {
  public:
    using Pass::Pass;
    Self& set(const std::string& binding, const Image& image, Sampling sampling = Sampling::linear_repeat) {
        set_image(binding, image, sampling, -1);
        return self();
    }
    /// One mip level, as a storage image or to sample.
    Self& set_mip(const std::string& binding, const Image& image, uint32_t mip) {
        set_image(binding, image, Sampling::nearest_clamp, static_cast<int>(mip));
        return self();
    }
    Self& set(const std::string& binding, const Buffer& buffer) {
        set_buffer(binding, buffer);
        return self();
    }
    /// A uniform block, copied now.
    template <class T>
    requires(std::is_trivially_copyable_v<T>) Self& set(const std::string& binding, const T& value) {
        set_bytes(binding, std::as_bytes(std::span(&value, 1)));
        return self();
    }

  private:
    Self& self() { return static_cast<Self&>(*this); }
};

class Raster : public PassSetters<Raster> {
  public:
    using PassSetters::PassSetters;
    TargetFormats formats;
    /// `variant`: macros for this use alone, over those of the pass.
    Raster& use(const Pipeline& pipeline, const Macros& variant = {});
    /// Until the next use(): what is drawn was mirrored, so that its front is clockwise rather than counter-clockwise.
    Raster& mirrored(bool is_mirrored);
    Raster& draw(uint32_t vertices, uint32_t instances = 1, uint32_t first_instance = 0);
    Raster& draw_indexed(const Buffer& indices, uint32_t first_index, uint32_t count, uint32_t instances = 1,
                         uint32_t first_instance = 0);
    Raster& draw(const Drawable& drawable);
};

class Compute : public PassSetters<Compute> {
  public:
    using PassSetters::PassSetters;
    Compute& use(const Pipeline& pipeline, const Macros& variant = {});
    /// At least `threads` invocations: rounded up to whole workgroups.
    Compute& dispatch_threads(glm::uvec3 threads);
    Compute& dispatch_threads(glm::uvec2 threads) { return dispatch_threads(glm::uvec3(threads, 1)); }
    Compute& dispatch(glm::uvec3 groups);
};

}  // namespace lightwalk
