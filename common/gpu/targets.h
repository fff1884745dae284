// The statement of a pass: its targets, and the resources it reads and writes.
#pragma once
#include <concepts>
#include <functional>

#include "common/gpu/barrier.h"
#include "common/gpu/given.h"
#include "common/gpu/pipeline.h"

namespace lightwalk {

/// An image or a buffer in a pass's statement; implicit from anything convertible to a view.
struct Resource {
    ImageView view;
    const Buffer* buffer = nullptr;
    Resource() = default;
    template <class T>
    requires std::convertible_to<const T&, ImageView> Resource(const T& image) : view(image) {}
    Resource(const Buffer& b) : buffer(&b) {}
    explicit operator bool() const { return view || buffer; }
};

/// A target and its contents at the start of the pass. A view's first mip; its first layer, or as many as the pass
/// states.
struct Attachment {
    enum class Load { clear, keep, discard, read_only };
    ImageView view;
    Load load = Load::clear;
    glm::vec4 color{0.0f, 0.0f, 0.0f, 1.0f};
    float depth = 0.0f;      ///< reversed: 0 is farthest
    ImageView resolve_into;  ///< none: its samples stay apart
    Attachment() = default;
    template <class T>
    requires std::convertible_to<const T&, ImageView> Attachment(const T& image) : view(image) {}
};

/// Cleared: the default of a target.
Attachment clear(const ImageView& view, const glm::vec4& color = {0.0f, 0.0f, 0.0f, 1.0f});
Attachment clear(const ImageView& view, float depth);
/// Drawn over.
Attachment keep(const ImageView& view);
/// Holds anything: for a pass that draws every pixel.
Attachment discard(const ImageView& view);
/// Depth that is tested against, not written, and may be sampled in the same pass.
Attachment read_only(const ImageView& view);
/// The mean of each pixel's samples goes into another image when the pass ends; of depth, the first sample.
Attachment resolve(Attachment from, const ImageView& into);

/// A module in a pass's statement.
using With = std::reference_wrapper<const Given>;

// [raster_targets]
/// A raster pass draws into `color` and `depth`; its shaders may read and write other stated resources. Unstated
/// resources cannot be bound, except for uploads. A target is cleared by default: `.color = {clear(f.hdr, sky),
/// keep(normals)}, .depth = read_only(f.depth)`.
struct RasterTargets {
    std::vector<Attachment> color;
    Attachment depth;
    std::vector<Resource> reads, writes;
    std::vector<With> with;        ///< modules: their macros, uniforms, reads and bindings
    uint32_t layers = 1;           ///< of every target, for geometry shaders that write gl_Layer
    glm::uvec2 size{0};            ///< pixels, where there is no target; 0: the frame's
    std::optional<Mixing> mixing;  ///< overrules the blending and the depth writing of every pipeline used
};
// [/raster_targets]

/// A compute pass; resources in both lists are read and written.
struct ComputeAccess {
    std::vector<Resource> reads, writes;
    std::vector<With> with;
};

/// A resource as a pass may bind it.
struct Stated {
    Resource resource;
    VkImageLayout layout;
    bool read, writable;
};

/// The targets of one pass, checked. Throws Failure, with the pass's name, if they differ in size or samples.
struct Rendering {
    /// `shows_discarded`: fills discarded targets with bright magenta, or the nearest depth.
    void set(const std::string& pass, const RasterTargets& targets, glm::uvec2 frame_size,
             bool shows_discarded = false);
    void begin(VkCommandBuffer commands) const;
    void add_barriers(Barriers& barriers) const;

    TargetFormats formats;
    glm::uvec2 size{0};
    uint32_t layers = 1;
    std::vector<std::pair<ImageView, Access>> accesses;
    std::vector<ImageView> loaded;  ///< targets with contents kept

  private:
    VkRenderingAttachmentInfo add(const std::string& pass, Attachment target, bool is_depth, bool shows_discarded);
    std::vector<VkRenderingAttachmentInfo> color_;
    VkRenderingAttachmentInfo depth_{};
};

/// All that is given to a pass by the modules it names, and by `root` (may be null). Throws Failure if two are of
/// one kind: they would share their names in its shaders.
void all_given(std::vector<const Given*>& all, const std::string& pass, const std::vector<With>& with,
               const Given* root);

/// `reads`, and the reads of the modules given.
void with_given(std::vector<Resource>& all, const std::vector<Resource>& reads, const std::vector<const Given*>& given);

/// Resources that the shaders of a pass may bind, beside its targets. Throws Failure for overlapping parts that
/// differ.
void state(std::vector<Stated>& result, const std::string& pass, const std::vector<Resource>& reads,
           const std::vector<Resource>& writes, const RasterTargets* targets = nullptr);

/// The barriers for that.
void add_barriers(Barriers& barriers, bool compute, const std::vector<Stated>& stated);

}  // namespace lightwalk
