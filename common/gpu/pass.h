// Recording interface of a raster or compute pass.
#pragma once
#include <functional>
#include <string_view>
#include <type_traits>

#include "common/base/error.h"
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
    std::pair<uint64_t, Macros> used;  ///< Pipeline::id and the variant
    std::vector<Resource> reads;
    std::vector<Stated> stated;
    Rendering rendering;
    Barriers barriers;
    std::vector<Macros> macros;
    std::vector<const Macros*> scopes;
    std::vector<Bound> bound;
    std::vector<std::byte> bytes;
    std::vector<VkDescriptorImageInfo> image_infos;
    std::vector<ImageView> views;  ///< by element, as image_infos
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
    Pass(Frame& frame, const std::string& name, VkCommandBuffer commands, PassLists& lists, SourceLocation where);
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

    /// Throws Failure if the pass states an image in its writes, and draws and dispatches nothing, or if it sets a
    /// binding after its last draw or dispatch.
    void check_ended() const;

    struct Name {
        template <size_t length>
        consteval Name(const char (&literal)[length], SourceLocation at = SourceLocation::current())
            : name(literal), where(at) {}
        template <class T>
        requires(std::is_convertible_v<const T&, std::string_view> && !std::is_array_v<T>)
            Name(const T& text, SourceLocation at = SourceLocation::current())
            : name(text), where(at) {}
        Name(const BindingName& n, SourceLocation at = SourceLocation::current()) : name(n), where(at) {}
        Name(const Slot& s, SourceLocation at = SourceLocation::current())
            : name(std::string_view()), slot(s), where(at), by_slot(true) {}
        BindingName name;
        Slot slot{};
        SourceLocation where;  ///< the statement that sets it
        bool by_slot = false;
    };

    /// Sets a binding if the pipeline has it. For modules, which are used with any kind of pass and shader.
    void set_if_present(const BindingName& binding, const ImageView& view, const Sampler& sampler = linear_repeat) {
        set_images({slot(binding), where_}, {&view, 1}, sampler);
    }
    void set_if_present(const BindingName& binding, const Buffer& buffer) {
        set_buffer({slot(binding), where_}, buffer);
    }
    template <class T>
    requires(std::is_trivially_copyable_v<T> &&
             !std::convertible_to<const T&, ImageView>) void set_if_present(const BindingName& binding,
                                                                            const T& value) {
        set_bytes({slot(binding), where_}, std::as_bytes(std::span(&value, 1)), component_of<T>());
    }

  protected:
    void bind(const Pipeline& pipeline, const Macros& variant, const TargetFormats& formats, VkPipelineBindPoint point,
              const SourceLocation& where);
    /// Throws Failure with file and line.
    template <class... Values>
    [[noreturn]] void fail(const SourceLocation& where, fmt::format_string<Values...> format,
                           Values&&... values) const {
        throw Failure("{}: pass '{}'{}", place_of(where), name, fmt::format(format, std::forward<Values>(values)...));
    }
    /// Throws Failure if no pipeline was chosen.
    void check_used() const {
        if (!used_) fail(where_, " draws or dispatches before pass.use(pipeline)");
    }
    const SourceLocation where_;  ///< the pass's statement
    void set_images(const Name& binding, std::span<const ImageView> views, const Sampler& sampler);
    void set_buffer(const Name& binding, const Buffer& buffer);
    /// `type`: of a number or vector; other: a structure.
    void set_bytes(const Name& binding, std::span<const std::byte> bytes, BlockMember::Type type);
    template <class T>
    static constexpr BlockMember::Type component_of() {
        if constexpr (requires { typename T::value_type; }) return component_of<typename T::value_type>();
        return std::is_same_v<T, float>      ? BlockMember::Type::number
               : std::is_same_v<T, int>      ? BlockMember::Type::integer
               : std::is_same_v<T, uint32_t> ? BlockMember::Type::unsigned_integer
                                             : BlockMember::Type::other;
    }
    /// Binds pending descriptors. False if there is no valid pipeline.
    bool flush();
    void values_are_read() { unread_ = nullptr, drawn_ = true; }
    /// Throws Failure where each thread writes its own texel, and texels have no thread or workgroups no texel.
    void check_workgroups(const glm::uvec3& groups) const;
    /// Throws Failure if the pass does not declare `buffer`, the source of indices or indirect commands, as read.
    void check_indirect(const Buffer& buffer) const;
    const BuiltPipeline* pipeline_ = nullptr;
    /// Null without a listener, and while modules bind.
    PassListener* listener() const;
    const TargetFormats& formats() const { return lists_.rendering.formats; }

  private:
    bool modules_bind_ = false;
    bool used_ = false;
    bool drawn_ = false;               ///< with the pipeline in use
    const Binding* unread_ = nullptr;  ///< set since the last draw or dispatch
    SourceLocation unread_where_;
    void note_set(const Name& name_in_shader, const Binding& binding);
    const Binding* find(const Name& binding) const;
    void check_stated(const SourceLocation& where, std::string_view use, const Buffer& buffer, bool writes) const;
    const Stated* stated(const ImageView& view, bool writes) const;
    [[noreturn]] void fail_unstated(const SourceLocation& where, std::string_view use, bool writes) const;
    VkDescriptorImageInfo image_info(const SourceLocation& where, const Binding& binding, ImageView& view,
                                     const Sampler& sampler) const;
    void check_view(const SourceLocation& where, const Binding& binding, const ImageView& view) const;
    void check_sampler(const SourceLocation& where, const Binding& binding, const ImageView& view,
                       const Sampler& sampler) const;
    void check_not_sampled() const;
    template <class Info>
    void store(const Binding& binding, uint32_t element, std::vector<Info>& infos, const Info& info);
    void set_block(const SourceLocation& where, const Binding& binding, std::span<const std::byte> bytes);
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
        this->set_bytes(binding, std::as_bytes(std::span(&value, 1)), this->template component_of<T>());
        return self();
    }

  private:
    Self& self() { return static_cast<Self&>(*this); }
};

class Raster : public PassSetters<Raster> {
  public:
    using PassSetters::PassSetters;
    /// `variant`: macros for this use; they override the pass's macros.
    Raster& use(const Pipeline& pipeline, const Macros& variant = {}, SourceLocation where = SourceLocation::current());

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
    Compute& use(const Pipeline& pipeline, const Macros& variant = {},
                 SourceLocation where = SourceLocation::current());
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
