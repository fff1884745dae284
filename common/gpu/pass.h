// Recording interface of a raster or compute pass.
#pragma once
#include <functional>
#include <string_view>
#include <type_traits>

#include "common/gpu/gpu.h"
#include "common/gpu/targets.h"

namespace lightwalk {

class Frame;
struct PassListener;
class Raster;

/// Scratch lists of a pass, reused across passes to avoid allocations.
struct PassLists {
    struct Bound {
        bool set = false;
        uint32_t at = 0;
    };
    std::vector<const PassInputs*> given;
    std::pair<uint64_t, uint64_t> used;  ///< Pipeline::id and hash of the variant's macros
    std::vector<Resource> reads;
    std::vector<Stated> stated;
    Rendering rendering;
    Barriers barriers;
    std::vector<Macros> macros;
    std::vector<const Macros*> scopes;
    std::vector<Bound> bound;
    std::vector<std::byte> bytes;
    std::vector<VkDescriptorImageInfo> image_infos;
    std::vector<VkDescriptorBufferInfo> buffer_infos;
    std::vector<VkWriteDescriptorSet> writes;
};

struct Drawable {
    virtual ~Drawable() = default;
    virtual void draw(Raster& pass) const = 0;
};

/// Bindings by name, kept until another pipeline is used. Each draw or dispatch checks that none is missing.
class Pass {
  public:
    Pass(Frame& frame, const std::string& name, VkCommandBuffer commands, PassLists& lists);
    Pass(const Pass&) = delete;

    VkCommandBuffer commands;
    Frame& frame;
    const std::string& name;

    /// Cached look-up of a binding for repeated set(). False: absent in the current pipeline, set() has no effect.
    class Slot {
      public:
        explicit operator bool() const { return pipeline_; }

      private:
        friend class Pass;
        const BuiltPipeline* pipeline_ = nullptr;
        uint32_t number_ = 0;
    };
    Slot slot(const BindingName& binding) const;

    bool wants(const BindingName& binding) const { return static_cast<bool>(slot(binding)); }

    struct Name {
        template <size_t length>
        consteval Name(const char (&literal)[length]) : name(literal) {}
        template <class T>
        requires(std::is_convertible_v<const T&, std::string_view> && !std::is_array_v<T>) Name(const T& text)
            : name(text) {}
        Name(const BindingName& n) : name(n) {}
        Name(const Slot& s) : name(std::string_view()), slot(s), by_slot(true) {}
        BindingName name;
        Slot slot{};
        bool by_slot = false;
    };

    /// Sets a binding if the pipeline has it. For modules, which are used with any kind of pass and shader.
    void set_if_present(const BindingName& binding, const ImageView& view, const Sampler& sampler = linear_repeat) {
        set_images(slot(binding), {&view, 1}, sampler);
    }
    void set_if_present(const BindingName& binding, const Buffer& buffer) { set_buffer(slot(binding), buffer); }
    template <class T>
    requires(std::is_trivially_copyable_v<T> &&
             !std::convertible_to<const T&, ImageView>) void set_if_present(const BindingName& binding,
                                                                            const T& value) {
        set_bytes(slot(binding), std::as_bytes(std::span(&value, 1)));
    }

  protected:
    void bind(const Pipeline& pipeline, const Macros& variant, const TargetFormats& formats, VkPipelineBindPoint point);
    void set_images(const Name& binding, std::span<const ImageView> views, const Sampler& sampler);
    void set_buffer(const Name& binding, const Buffer& buffer);
    void set_bytes(const Name& binding, std::span<const std::byte> bytes);
    /// Binds pending descriptors. False if there is no valid pipeline.
    bool flush();
    /// Throws Failure if the pass does not declare `buffer`, the source of indices or indirect commands, as read.
    void check_indirect(const Buffer& buffer) const;
    const BuiltPipeline* pipeline_ = nullptr;
    /// Null without a listener, and while modules bind.
    PassListener* listener() const;
    const TargetFormats& formats() const { return lists_.rendering.formats; }

  private:
    bool modules_bind_ = false;
    const Binding* find(const Name& binding) const;
    void check_stated(std::string_view use, const Buffer& buffer, bool writes) const;
    const Stated* stated(const ImageView& view, bool writes) const;
    [[noreturn]] void fail_unstated(std::string_view use, bool writes) const;
    VkDescriptorImageInfo image_info(const Binding& binding, ImageView view, const Sampler& sampler) const;
    template <class Info>
    void store(const Binding& binding, uint32_t element, std::vector<Info>& infos, const Info& info);
    void set_block(const Binding& binding, std::span<const std::byte> bytes);
    PassLists& lists_;
    size_t missing_ = 0;
    bool dirty_ = true;
    VkPipelineBindPoint point_ = VK_PIPELINE_BIND_POINT_GRAPHICS;
};

template <class Self>
class PassSetters : public Pass {
  public:
    using Pass::Pass;
    /// Sampled image, or storage image (the view's first mip).
    Self& set(const Name& binding, const ImageView& view, const Sampler& sampler = linear_repeat) {
        set_images(binding, {&view, 1}, sampler);
        return self();
    }
    /// Array of images; the last view fills the remaining elements.
    Self& set(const Name& binding, std::span<const ImageView> views, const Sampler& sampler = linear_repeat) {
        set_images(binding, views, sampler);
        return self();
    }
    Self& set(const Name& binding, const Buffer& buffer) {
        set_buffer(binding, buffer);
        return self();
    }
    /// Uniform block; `value` is copied immediately.
    template <class T>
    requires(std::is_trivially_copyable_v<T> && !std::convertible_to<const T&, ImageView> &&
             !std::convertible_to<const T&, std::span<const ImageView>>) Self& set(const Name& binding,
                                                                                   const T& value) {
        set_bytes(binding, std::as_bytes(std::span(&value, 1)));
        return self();
    }

  private:
    Self& self() { return static_cast<Self&>(*this); }
};

class Raster : public PassSetters<Raster> {
  public:
    using PassSetters::PassSetters;
    /// `variant`: macros for this use; they override the pass's macros.
    Raster& use(const Pipeline& pipeline, const Macros& variant = {});

    /// Front faces are clockwise, for mirroring transforms. Until the next use().
    Raster& mirrored(bool mirrors);
    /// Disables culling if true, else the pipeline's mode. Until the next use().
    Raster& two_sided(bool both);

    Raster& draw(uint32_t vertices, uint32_t instances = 1, uint32_t first_instance = 0);
    /// Indices are 32-bit.
    Raster& draw_indexed(const Buffer& indices, uint32_t first_index, uint32_t count, uint32_t instances = 1,
                         uint32_t first_instance = 0);
    /// `count` VkDrawIndirectCommands from byte `offset` (multiple of 4). The pass must declare `draws` as read.
    Raster& draw_indirect(const Buffer& draws, uint32_t count = 1, VkDeviceSize offset = 0);
    /// `count` VkDrawIndexedIndirectCommands from byte `offset` (multiple of 4), with 32-bit indices.
    Raster& draw_indexed_indirect(const Buffer& indices, const Buffer& draws, uint32_t count = 1,
                                  VkDeviceSize offset = 0);
    Raster& draw(const Drawable& drawable);

  private:
    void bind_indices(const Buffer& indices);
    void check_draws(const Buffer& draws, uint32_t count, VkDeviceSize offset, uint32_t stride) const;
    bool mirrored_ = false, two_sided_ = false;
    VkCullModeFlags cull_ = VK_CULL_MODE_NONE;
    VkBuffer indices_ = VK_NULL_HANDLE;
};

class Compute : public PassSetters<Compute> {
  public:
    using PassSetters::PassSetters;
    Compute& use(const Pipeline& pipeline, const Macros& variant = {});
    /// Rounds up to whole workgroups.
    Compute& dispatch_threads(glm::uvec3 threads);
    Compute& dispatch_threads(glm::uvec2 threads) { return dispatch_threads(glm::uvec3(threads, 1)); }
    Compute& dispatch(glm::uvec3 groups);
    /// VkDispatchIndirectCommand at byte `offset` (multiple of 4). The pass must declare `groups` as read.
    Compute& dispatch_indirect(const Buffer& groups, VkDeviceSize offset = 0);
    /// Memory barrier: earlier writes of this pass become visible to later dispatches.
    Compute& wait();
};

}  // namespace lightwalk
