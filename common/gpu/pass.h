// Operations available while a pass is recorded.
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

/// What a pass lists while it is recorded. A frame keeps it from pass to pass, so that few of them take memory.
struct PassLists {
    struct Bound {
        bool set = false;
        uint32_t at = 0;  ///< of a uniform block's bytes
    };
    std::vector<const Given*> given;
    std::pair<uint64_t, uint64_t> used;  ///< Pipeline::id, and the hash of the variant's macros
    std::vector<Resource> reads;
    std::vector<Stated> stated;
    Rendering rendering;
    Barriers barriers;
    std::vector<Macros> macros;                      ///< of the modules given
    std::vector<const Macros*> scopes;               ///< the same, and the variant's
    std::vector<Bound> bound;                        ///< by binding number
    std::vector<std::byte> bytes;                    ///< of all uniform blocks
    std::vector<VkDescriptorImageInfo> image_infos;  ///< by element
    std::vector<VkDescriptorBufferInfo> buffer_infos;
    std::vector<VkWriteDescriptorSet> writes;
};

/// An object drawn through the pass's bindings and draw functions.
struct Drawable {
    virtual ~Drawable() = default;
    virtual void draw(Raster& pass) const = 0;
};

/// Bindings by name.
/// set() is remembered until the next use() of another pipeline; a draw or dispatch checks that
/// nothing is missing.
class Pass {
  public:
    Pass(Frame& frame, const std::string& name, VkCommandBuffer commands, PassLists& lists);
    Pass(const Pass&) = delete;

    VkCommandBuffer commands;
    Frame& frame;
    const std::string& name;

    /// A binding of the pipeline in use, looked up once, for many set(). False if its shaders have none of that
    /// name; setting it then does nothing.
    class Slot {
      public:
        explicit operator bool() const { return pipeline_; }

      private:
        friend class Pass;
        const BuiltPipeline* pipeline_ = nullptr;
        uint32_t number_ = 0;
    };
    Slot slot(const BindingName& binding) const;

    /// True if the pipeline in use has a binding of that name.
    bool wants(const BindingName& binding) const { return static_cast<bool>(slot(binding)); }

    /// Argument of set(): a binding's name in the shaders, or a slot.
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

    /// set() if the pipeline has such a binding; for modules, which know neither the kind of pass nor its shaders.
    void offer(const BindingName& binding, const ImageView& view, const Sampler& sampler = linear_repeat) {
        set_images(slot(binding), {&view, 1}, sampler);
    }
    void offer(const BindingName& binding, const Buffer& buffer) { set_buffer(slot(binding), buffer); }
    template <class T>
    requires(std::is_trivially_copyable_v<T> &&
             !std::convertible_to<const T&, ImageView>) void offer(const BindingName& binding, const T& value) {
        set_bytes(slot(binding), std::as_bytes(std::span(&value, 1)));
    }

  protected:
    void bind(const Pipeline& pipeline, const Macros& variant, const TargetFormats& formats, VkPipelineBindPoint point);
    void set_images(const Name& binding, std::span<const ImageView> views, const Sampler& sampler);
    void set_buffer(const Name& binding, const Buffer& buffer);
    /// As many bytes as the block has.
    void set_bytes(const Name& binding, std::span<const std::byte> bytes);
    /// Binds changed settings. False if there is no pipeline to draw with.
    bool flush();
    /// Throws Failure if the pass does not read a buffer that draws, dispatches or indices come from.
    void check_indirect(const Buffer& buffer) const;
    const BuiltPipeline* pipeline_ = nullptr;
    /// Null if nobody listens, and while modules bind.
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
    size_t missing_ = 0;  ///< bindings that were not set since use()
    bool dirty_ = true;   ///< bindings have changed since the last draw or dispatch
    VkPipelineBindPoint point_ = VK_PIPELINE_BIND_POINT_GRAPHICS;
};

/// The setters, returning the pass they belong to so that a draw reads as one sentence. A name may be a slot.
template <class Self>
class PassSetters : public Pass {
  public:
    using Pass::Pass;
    /// A view to sample, or its first mip as a storage image.
    Self& set(const Name& binding, const ImageView& view, const Sampler& sampler = linear_repeat) {
        set_images(binding, {&view, 1}, sampler);
        return self();
    }
    /// Sets an array's elements from the first on; the last view fills the remaining ones.
    Self& set(const Name& binding, std::span<const ImageView> views, const Sampler& sampler = linear_repeat) {
        set_images(binding, views, sampler);
        return self();
    }
    Self& set(const Name& binding, const Buffer& buffer) {
        set_buffer(binding, buffer);
        return self();
    }
    /// A uniform block, copied now.
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
    /// `variant`: macros for this use only, taking precedence over the pass's.
    Raster& use(const Pipeline& pipeline, const Macros& variant = {});

    /// Until the next use(): the transform mirrors, so front faces are clockwise (true).
    Raster& mirrored(bool mirrors);
    /// Until the next use(): no culling (true), or the pipeline's.
    Raster& two_sided(bool both);

    Raster& draw(uint32_t vertices, uint32_t instances = 1, uint32_t first_instance = 0);
    /// With 32-bit indices.
    Raster& draw_indexed(const Buffer& indices, uint32_t first_index, uint32_t count, uint32_t instances = 1,
                         uint32_t first_instance = 0);
    /// `count` draws as VkDrawIndirectCommands in a buffer that the pass reads, from byte `offset` (a multiple of 4)
    /// on.
    Raster& draw_indirect(const Buffer& draws, uint32_t count = 1, VkDeviceSize offset = 0);
    /// The same with indices, as VkDrawIndexedIndirectCommands.
    Raster& draw_indexed_indirect(const Buffer& indices, const Buffer& draws, uint32_t count = 1,
                                  VkDeviceSize offset = 0);
    Raster& draw(const Drawable& drawable);

  private:
    void bind_indices(const Buffer& indices);
    void check_draws(const Buffer& draws, uint32_t count, VkDeviceSize offset, uint32_t stride) const;
    bool mirrored_ = false, two_sided_ = false;
    VkCullModeFlags cull_ = VK_CULL_MODE_NONE;  ///< of the pipeline in use
    VkBuffer indices_ = VK_NULL_HANDLE;
};

class Compute : public PassSetters<Compute> {
  public:
    using PassSetters::PassSetters;
    Compute& use(const Pipeline& pipeline, const Macros& variant = {});
    /// At least `threads` invocations: rounded up to whole workgroups.
    Compute& dispatch_threads(glm::uvec3 threads);
    Compute& dispatch_threads(glm::uvec2 threads) { return dispatch_threads(glm::uvec3(threads, 1)); }
    Compute& dispatch(glm::uvec3 groups);
    /// As many groups as a VkDispatchIndirectCommand says in a buffer that the pass reads, at byte `offset` (a multiple
    /// of 4).
    Compute& dispatch_indirect(const Buffer& groups, VkDeviceSize offset = 0);
    /// Makes earlier writes of this pass visible to later dispatches.
    Compute& wait();
};

}  // namespace lightwalk
