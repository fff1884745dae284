#include "common/gpu/targets.h"

#include <algorithm>

#include "common/base/error.h"

namespace lightwalk {
namespace {

constexpr VkPipelineStageFlags2 raster_stages =
    VK_PIPELINE_STAGE_2_PRE_RASTERIZATION_SHADERS_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
constexpr VkPipelineStageFlags2 depth_stages =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;

constexpr Access color_access{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                              VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT,
                              VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, true};
constexpr Access depth_access{
    depth_stages, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT,
    VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, true};
// Depth resolve is synchronised as colour output.
constexpr Access depth_resolve_access{depth_stages | color_access.stages, depth_access.access | color_access.access,
                                      VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, true};

constexpr Access read_only_access{depth_stages | raster_stages,
                                  VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_SHADER_READ_BIT,
                                  VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL, false};

Access shader_access(bool compute, bool reads, bool writes, bool buffer) {
    Access access{.stages = compute ? VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT : raster_stages,
                  .access = VK_ACCESS_2_NONE,
                  .layout = writes ? VK_IMAGE_LAYOUT_GENERAL : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                  .writes = writes};
    if (reads) access.access |= VK_ACCESS_2_SHADER_READ_BIT;
    if (writes) access.access |= VK_ACCESS_2_SHADER_WRITE_BIT | VK_ACCESS_2_SHADER_READ_BIT;
    // Compute passes synchronise indirect commands in Pass::check_indirect().
    if (buffer && reads && !compute) {
        access.stages |= VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT;
        access.access |= VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT | VK_ACCESS_2_INDEX_READ_BIT;
    }
    return access;
}

bool same(const Resource& a, const Resource& b) { return a.view == b.view && a.buffer == b.buffer; }

bool contains(const std::vector<Resource>& list, const Resource& wanted) {
    for (const Resource& r : list)
        if (same(r, wanted)) return true;
    return false;
}

bool overlap(const Resource& a, const Resource& b) { return a.view && b.view && a.view.overlaps(b.view); }

ImageView target_view(const ImageView& view, uint32_t layers) {
    const ImageView mip = view.mip(0);
    if (layers > 1) return mip.layer_range(0, layers);
    return mip.type == VK_IMAGE_VIEW_TYPE_2D ? mip : mip.layer(0);
}

Attachment with(const ImageView& view, Attachment::Load load) {
    Attachment target(view);
    target.load = load;
    return target;
}

}  // namespace

Attachment clear(const ImageView& view, const glm::vec4& color) {
    Attachment target(view);
    target.color = color;
    return target;
}

Attachment clear(const ImageView& view, float depth) {
    Attachment target(view);
    target.depth = depth;
    return target;
}

Attachment keep(const ImageView& view) { return with(view, Attachment::Load::keep); }
Attachment discard(const ImageView& view) { return with(view, Attachment::Load::discard); }
Attachment read_only(const ImageView& view) { return with(view, Attachment::Load::read_only); }

Attachment resolve(Attachment from, const ImageView& into) {
    from.resolve_into = into;
    return from;
}

void Rendering::set(const std::string& pass, const RasterTargets& targets, glm::uvec2 frame_size,
                    bool shows_discarded) {
    layers = targets.layers;
    size = glm::uvec2(0);
    accesses.clear();
    loaded.clear();
    color_.clear();
    depth_ = {};
    formats.color.clear();
    formats.depth = VK_FORMAT_UNDEFINED;
    formats.depth_read_only = false;
    formats.samples = 1;
    formats.blend_override = targets.blend_override;
    for (const Attachment& target : targets.color) color_.push_back(add(pass, target, false, shows_discarded));
    if (targets.depth.view) depth_ = add(pass, targets.depth, true, shows_discarded);
    // One absent colour target: without any, Mesa 25's lavapipe blends later targets like the first (lvp_execute.c).
    if (color_.empty()) {
        formats.color = {VK_FORMAT_UNDEFINED};
        color_ = {{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO}};
    }
    if (size == glm::uvec2(0)) size = targets.size == glm::uvec2(0) ? frame_size : targets.size;
}

VkRenderingAttachmentInfo Rendering::add(const std::string& pass, Attachment target, bool is_depth,
                                         bool shows_discarded) {
    if (shows_discarded && target.load == Attachment::Load::discard) {
        target.load = Attachment::Load::clear;
        target.color = {1e3f, 0.0f, 1e3f, 1.0f};
        target.depth = 1.0f;
    }
    const auto fail = [&](const std::string& why) {
        throw Failure("pass '{}': target {} {}", pass, target.view.name(), why);
    };
    if (!target.view) throw Failure("pass '{}' has a target without an image", pass);
    if (!target.view.image->handle)
        throw Failure("pass '{}': a target has no size: a Target has one in Chapter::frame, an Image after ensure()",
                      pass);
    const ImageView view = target_view(target.view, layers);
    const Image::Desc& desc = view.image->desc;
    const bool read_only = target.load == Attachment::Load::read_only;
    if (is_depth != view.image->is_depth()) fail(is_depth ? "is no depth image" : "is a depth image");
    if (read_only && !is_depth) fail("cannot be read-only: only depth can");
    const glm::uvec2 extent(view.size());
    if (!accesses.empty() && (extent != size || desc.samples != formats.samples))
        fail("differs in size or samples from the pass's others");
    for (const auto& [other, access] : accesses)
        if (other.overlaps(view)) fail("is stated twice");
    size = extent;
    formats.samples = desc.samples;
    (is_depth ? formats.depth : formats.color.emplace_back()) = desc.format;
    formats.depth_read_only |= read_only;
    if (read_only || target.load == Attachment::Load::keep) loaded.push_back(view);
    const bool resolves = static_cast<bool>(target.resolve_into);
    accesses.emplace_back(view, read_only   ? read_only_access
                                : !is_depth ? color_access
                                : resolves  ? depth_resolve_access
                                            : depth_access);
    const VkClearColorValue color{.float32 = {target.color.r, target.color.g, target.color.b, target.color.a}};
    VkRenderingAttachmentInfo info{
        .sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
        .imageView = view.handle(),
        .imageLayout = accesses.back().second.layout,
        .loadOp = target.load == Attachment::Load::clear     ? VK_ATTACHMENT_LOAD_OP_CLEAR
                  : target.load == Attachment::Load::discard ? VK_ATTACHMENT_LOAD_OP_DONT_CARE
                                                             : VK_ATTACHMENT_LOAD_OP_LOAD,
        .storeOp = read_only ? VK_ATTACHMENT_STORE_OP_NONE : VK_ATTACHMENT_STORE_OP_STORE,
        .clearValue = is_depth ? VkClearValue{.depthStencil = {.depth = target.depth}} : VkClearValue{.color = color}};
    if (resolves) {
        const ImageView into = target_view(target.resolve_into, layers);
        if (into.image->desc.samples != 1 || desc.samples == 1 || glm::uvec2(into.size()) != extent ||
            into.image->desc.format != desc.format)
            fail("cannot be resolved into " + into.name() +
                 ": that takes several samples into one, of the same size and format");
        info.resolveMode = is_depth ? VK_RESOLVE_MODE_SAMPLE_ZERO_BIT : VK_RESOLVE_MODE_AVERAGE_BIT;
        info.resolveImageView = into.handle();
        info.resolveImageLayout = info.imageLayout;
        accesses.emplace_back(into, accesses.back().second);
    }
    return info;
}

void Rendering::add_barriers(Barriers& barriers) const {
    for (const auto& [view, access] : accesses) {
        barriers.add(view, access);
        if (access.writes) view.image->constant = false;
    }
}

void Rendering::begin(VkCommandBuffer commands) const {
    const VkRect2D area{.extent = {size.x, size.y}};
    const VkRenderingInfo info{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                               .renderArea = area,
                               .layerCount = layers,
                               .colorAttachmentCount = static_cast<uint32_t>(color_.size()),
                               .pColorAttachments = color_.data(),
                               .pDepthAttachment = depth_.imageView ? &depth_ : nullptr};
    const VkViewport viewport{.width = float(size.x), .height = float(size.y), .maxDepth = 1.0f};
    vkCmdBeginRendering(commands, &info);
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &area);
    vkCmdSetFrontFace(commands, VK_FRONT_FACE_COUNTER_CLOCKWISE);
}

void state(std::vector<Stated>& result, const std::string& pass, const std::vector<Resource>& reads,
           const std::vector<Resource>& writes, const RasterTargets* targets) {
    result.clear();
    for (const auto* list : {&reads, &writes})
        for (const Resource& r : *list)
            if (r.view && !r.view.image->handle)
                throw Failure(
                    "pass '{}' states an image without a size: a Target has one in Chapter::frame, an Image after "
                    "ensure()",
                    pass);
    for (const Resource& w : writes) result.push_back({w, VK_IMAGE_LAYOUT_GENERAL, contains(reads, w), true});
    if (targets && targets->depth.load == Attachment::Load::read_only)
        result.push_back(
            {target_view(targets->depth.view, targets->layers), VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL, true, false});
    for (const Resource& r : reads) {
        const auto is_this = [&](const Stated& s) { return same(s.resource, r); };
        if (std::none_of(result.begin(), result.end(), is_this))
            result.push_back({r, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, true, false});
    }
    const auto fail = [&](const ImageView& a, const ImageView& b) {
        throw Failure("pass '{}' uses {} and {}, which overlap, in different ways; state mips or layers apart", pass,
                      a.name(), b.name());
    };
    for (size_t i = 0; i < result.size(); ++i)
        for (size_t j = i + 1; j < result.size(); ++j)
            if (result[i].layout != result[j].layout && overlap(result[i].resource, result[j].resource))
                fail(result[i].resource.view, result[j].resource.view);
    if (!targets) return;
    const auto check_target = [&](const Attachment& target) {
        for (const Stated& s : result)
            if (target.view && s.layout != VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL && s.resource.view &&
                target_view(target.view, targets->layers).overlaps(s.resource.view))
                fail(s.resource.view, target.view);
    };
    for (const Attachment& target : targets->color) check_target(target);
    check_target(targets->depth);
}

void add_barriers(Barriers& barriers, bool compute, const std::vector<Stated>& stated) {
    for (const Stated& s : stated) {
        if (s.layout == VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL) continue;
        const Access access = shader_access(compute, s.read, s.writable, s.resource.buffer != nullptr);
        if (s.resource.buffer) {
            barriers.add(*s.resource.buffer, access);
            if (s.writable) s.resource.buffer->constant = false;
        } else {
            barriers.add(s.resource.view, access);
            if (s.writable) s.resource.view.image->constant = false;
        }
    }
}

std::vector<Resource> PassInputs::reads() const { return {}; }

void all_inputs(std::vector<const PassInputs*>& all, const std::string& pass, const std::vector<With>& with,
                const PassInputs* root) {
    all.clear();
    if (root) all.push_back(root);
    for (const PassInputs& given : with) given.expand(all);
    for (size_t i = 0; i < all.size(); ++i)
        for (size_t j = 0; j < i; ++j)
            if (all[i]->kind() == all[j]->kind())
                throw Failure("pass '{}' is given two modules of the kind '{}'; it takes one", pass, all[i]->kind());
}

void with_inputs(std::vector<Resource>& all, const std::vector<Resource>& reads,
                 const std::vector<const PassInputs*>& given) {
    all = reads;
    for (const PassInputs* one : given)
        for (const Resource& resource : one->reads()) all.push_back(resource);
}

}  // namespace lightwalk
