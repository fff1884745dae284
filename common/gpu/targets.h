// Declaration of a pass: targets, and resources read and written.
#pragma once
#include <concepts>
#include <functional>

#include "common/gpu/barrier.h"
#include "common/gpu/pass_inputs.h"
#include "common/gpu/pipeline.h"

namespace lightwalk {

struct Resource {
    ImageView view;
    const Buffer* buffer = nullptr;
    Resource() = default;
    template <class T>
    requires std::convertible_to<const T&, ImageView> Resource(const T& image) : view(image) {}
    Resource(const Buffer& b) : buffer(&b) {}
    explicit operator bool() const { return view || buffer; }
};

/// Render target and its load operation: the view's first mip and as many layers as the pass declares.
struct Attachment {
    enum class Load { clear, keep, discard, read_only };
    ImageView view;
    Load load = Load::clear;
    glm::vec4 color{0.0f, 0.0f, 0.0f, 1.0f};
    float depth = 0.0f;      ///< reversed: 0 is farthest
    ImageView resolve_into;  ///< none: samples are not resolved
    Attachment() = default;
    template <class T>
    requires std::convertible_to<const T&, ImageView> Attachment(const T& image) : view(image) {}
};

/// Target cleared at the start of the pass. The default.
Attachment clear(const ImageView& view, const glm::vec4& color = {0.0f, 0.0f, 0.0f, 1.0f});
Attachment clear(const ImageView& view, float depth);
Attachment keep(const ImageView& view);
/// Target with undefined contents, for passes that write every pixel.
Attachment discard(const ImageView& view);
/// Depth target for testing only; may also be sampled in the same pass.
Attachment read_only(const ImageView& view);
/// Resolves the samples into `into` at the end of the pass: mean for colour, first sample for depth.
Attachment resolve(Attachment from, const ImageView& into);

using With = std::reference_wrapper<const PassInputs>;

/// Raster pass declaration. Shaders may bind the listed resources, the depth target if read_only, and uploads; nothing
/// else. Example: `.color = {clear(f.hdr, sky), keep(normals)}, .depth = read_only(f.depth)`.
struct RasterTargets {
    std::vector<Attachment> color;
    Attachment depth;
    std::vector<Resource> reads, writes;
    std::vector<With> with;                       ///< modules: their macros, uniforms, reads and bindings
    uint32_t layers = 1;                          ///< layers per target, for geometry shaders that write gl_Layer
    glm::uvec2 size{0};                           ///< pixels; used without targets; 0: the frame's size
    std::optional<BlendOverride> blend_override;  ///< overrides every pipeline's blending and depth writes
};

/// Compute or transfer pass declaration. Resources in both lists are read and written.
struct ComputeAccess {
    std::vector<Resource> reads, writes;
    std::vector<With> with;
};

struct Stated {
    Resource resource;
    VkImageLayout layout;
    bool read, writable;
};

struct Rendering {
    /// `shows_discarded`: see FrameWatch. Throws Failure if targets differ in size or samples.
    void set(const std::string& pass, const RasterTargets& targets, glm::uvec2 frame_size,
             bool shows_discarded = false);
    void begin(VkCommandBuffer commands) const;
    void add_barriers(Barriers& barriers) const;

    TargetFormats formats;
    glm::uvec2 size{0};
    uint32_t layers = 1;
    std::vector<std::pair<ImageView, Access>> accesses;
    std::vector<ImageView> loaded;

  private:
    VkRenderingAttachmentInfo add(const std::string& pass, Attachment target, bool is_depth, bool shows_discarded);
    std::vector<VkRenderingAttachmentInfo> color_;
    VkRenderingAttachmentInfo depth_{};
};

/// Modules of a pass and of `root` (may be null), with dependencies. Throws Failure for two of one kind.
void all_inputs(std::vector<const PassInputs*>& all, const std::string& pass, const std::vector<With>& with,
                const PassInputs* root);

void with_inputs(std::vector<Resource>& all, const std::vector<Resource>& reads,
                 const std::vector<const PassInputs*>& given);

/// Resources that a pass's shaders may bind. Throws Failure for overlapping parts with different access.
void state(std::vector<Stated>& result, const std::string& pass, const std::vector<Resource>& reads,
           const std::vector<Resource>& writes, const RasterTargets* targets = nullptr);

void add_barriers(Barriers& barriers, bool compute, const std::vector<Stated>& stated);

}  // namespace lightwalk
