#include "common/gpu/pass.h"

#include <algorithm>
#include <cstring>

#include "common/base/error.h"
#include "common/gpu/frame.h"
#include "common/gpu/hidden_blocks.h"

namespace lightwalk {
namespace {

bool equal(const VkDescriptorBufferInfo& a, const VkDescriptorBufferInfo& b) {
    return a.buffer == b.buffer && a.offset == b.offset && a.range == b.range;
}

bool equal(const VkDescriptorImageInfo& a, const VkDescriptorImageInfo& b) {
    return a.sampler == b.sampler && a.imageView == b.imageView && a.imageLayout == b.imageLayout;
}

const char* shape(VkImageViewType type) {
    constexpr const char* names[] = {"1-D", "2-D", "3-D", "cube", "1-D array", "2-D array", "cube array"};
    return names[type];
}

const char* shape(const ImageView& view) {
    return view.is_volume() && view.type != VK_IMAGE_VIEW_TYPE_3D ? "a slice, which can be drawn into alone"
                                                                  : shape(view.type);
}

// Changes a view's type to the one the shader declares. False if its layers do not fit.
bool turn_into(ImageView& view, VkImageViewType wanted) {
    if (view.is_volume()) return wanted == VK_IMAGE_VIEW_TYPE_3D && view.type == wanted;
    const bool is_cube = view.image->desc.cube;
    const bool possible = wanted == VK_IMAGE_VIEW_TYPE_2D           ? view.layers == 1
                          : wanted == VK_IMAGE_VIEW_TYPE_CUBE       ? is_cube && view.layers == 6
                          : wanted == VK_IMAGE_VIEW_TYPE_CUBE_ARRAY ? is_cube && view.layers % 6 == 0
                                                                    : wanted == VK_IMAGE_VIEW_TYPE_2D_ARRAY;
    if (possible) view.type = wanted;
    return possible;
}

// Storage images are read in the general layout. Earlier dispatches of the pass have sampled in theirs.
void turn_general(VkCommandBuffer commands, Stated& stated, PassLists& lists) {
    constexpr Access loads{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_READ_BIT, VK_IMAGE_LAYOUT_GENERAL,
                           false};
    barrier(commands, stated.resource.view, loads);
    stated.layout = loads.layout;
    for (size_t i = 0; i < lists.views.size(); ++i)
        if (lists.views[i] && stated.resource.view.contains(lists.views[i]))
            lists.image_infos[i].imageLayout = loads.layout;
}

}  // namespace

Pass::Pass(Frame& owner, const std::string& pass_name, VkCommandBuffer frame_commands, PassLists& lists,
           SourceLocation where)
    : commands(frame_commands), frame(owner), name(pass_name), where_(where), lists_(lists) {
    lists_.macros.clear();
    lists_.scopes.clear();
    for (const PassInputs* one : lists_.given) lists_.macros.push_back(one->macros());
    for (const Macros& macros : lists_.macros) lists_.scopes.push_back(&macros);
    lists_.scopes.push_back(nullptr);
}

Pass::Slot Pass::slot(const BindingName& binding) const {
    Slot result;
    const Binding* const found = pipeline_ ? pipeline_->find(binding) : nullptr;
    if (!found || !found->used) return result;
    result.pipeline_ = pipeline_;
    result.number_ = found->number;
    return result;
}

// Null if nothing is to be set: no pipeline, empty slot, or unused binding.
const Binding* Pass::find(const Name& binding) const {
    if (!used_) fail(binding.where, " sets a binding before pass.use(pipeline)");
    if (!pipeline_ || (binding.by_slot && !binding.slot)) return nullptr;
    if (binding.by_slot) {
        if (binding.slot.pipeline_ == pipeline_) return &pipeline_->bindings[binding.slot.number_];
        fail(binding.where, " sets a slot of a pipeline that is not in use any more");
    }
    if (const Binding* found = pipeline_->find(binding.name)) return found->used ? found : nullptr;
    std::string known;
    for (const Binding& b : pipeline_->bindings) known += (known.empty() ? "" : ", ") + b.name;
    fail(binding.where, ": its shaders have no binding '{}'; they have: {}", binding.name.text, known);
}

void Pass::fail_unstated(const SourceLocation& where, std::string_view use, bool writes) const {
    fail(where, " binds '{}' without stating it in its {}", use, writes ? "writes" : "reads");
}

const Stated* Pass::stated(const ImageView& view, bool writes) const {
    for (const Stated& s : lists_.stated)
        if (s.resource.view && (s.writable || !writes) && s.resource.view.contains(view)) return &s;
    return nullptr;
}

void Pass::check_stated(const SourceLocation& where, std::string_view use, const Buffer& buffer, bool writes) const {
    if (buffer.constant && !writes) return;
    for (const Stated& s : lists_.stated)
        if (s.resource.buffer == &buffer && (s.writable || !writes)) return;
    fail_unstated(where, use, writes);
}

// Indirect commands of compute passes wait here: a wait for every buffer read costs 2.5 µs per pass on an H100.
void Pass::check_indirect(const Buffer& buffer) const {
    if (buffer.constant) return;
    for (const Stated& s : lists_.stated) {
        if (s.resource.buffer != &buffer || !s.read) continue;
        constexpr Access commands_read{VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT};
        if (s.writable) {  // an earlier dispatch of this pass writes it
            barrier(commands, {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                               .srcStageMask = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                               .srcAccessMask = VK_ACCESS_2_SHADER_WRITE_BIT,
                               .dstStageMask = commands_read.stages,
                               .dstAccessMask = commands_read.access});
            buffer.history.readers |= commands_read.stages;
        } else if (point_ == VK_PIPELINE_BIND_POINT_COMPUTE) {
            barrier(commands, buffer, commands_read);
        }
        return;
    }
    fail_unstated(where_, buffer.name, false);
}

void Pass::bind(const Pipeline& wanted, const Macros& variant, const TargetFormats& formats, VkPipelineBindPoint point,
                const SourceLocation& where) {
    if (wanted.is_compute != (point == VK_PIPELINE_BIND_POINT_COMPUTE))
        fail(where, ": {} is a pipeline for frame.{}", wanted.shaders().back(),
             wanted.is_compute ? "compute" : "raster");
    used_ = true;
    if (pipeline_ && lists_.used.first == wanted.id && lists_.used.second == variant) return;
    lists_.used = {wanted.id, variant};
    lists_.scopes.back() = &variant;
    const BuiltPipeline* const pipeline = frame.gpu.pipelines.get(wanted, formats, lists_.scopes);
    if (pipeline && pipeline == pipeline_) return;
    if (unread_) check_ended();
    drawn_ = false;
    pipeline_ = pipeline;
    point_ = point;
    if (!pipeline) {  // while its shader does not compile, what it would write is left as it is
        frame.note_writes(lists_.stated, nullptr);
        return;
    }
    if (!pipeline->mismatch.empty()) fail(where, ": {}: {}", wanted.shaders().back(), pipeline->mismatch);
    vkCmdBindPipeline(commands, point, pipeline->handle);
    if (frame.gpu.device.software_paths) {
        const uint32_t index = 0;
        vkCmdPushConstants(commands, pipeline->layout, hidden_index.stageFlags, 0, sizeof index, &index);
    }
    lists_.bound.assign(pipeline->bindings.size(), {});
    size_t bytes_in_all = 0;
    for (const Binding& binding : pipeline->bindings) {
        lists_.bound[binding.number].at = static_cast<uint32_t>(bytes_in_all);
        if (binding.used) bytes_in_all += binding.bytes;
    }
    lists_.bytes.resize(bytes_in_all);
    missing_ = static_cast<size_t>(std::ranges::count(pipeline->bindings, true, &Binding::used));
    dirty_ = true;
    lists_.image_infos.assign(pipeline->descriptors, {});
    lists_.views.assign(pipeline->descriptors, {});
    lists_.buffer_infos.assign(pipeline->descriptors, {});
    if (listener()) listener()->uses(wanted, variant);
    modules_bind_ = true;
    for (const Binding& binding : pipeline->bindings) {
        if (!binding.used || binding.type != VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER) continue;
        if (const auto* bytes = frame.globals.find(binding)) {
            set_block(where, binding, *bytes);
            continue;
        }
        for (const PassInputs* given : lists_.given) {
            std::span<const std::byte> bytes;
            check_at(where, [&] { bytes = given->block(binding); });
            if (!bytes.empty()) set_block(where, binding, bytes);
        }
    }
    for (const PassInputs* given : lists_.given) given->bind(*this);
    modules_bind_ = false;
}

PassListener* Pass::listener() const { return modules_bind_ ? nullptr : frame.watch_.listener; }

template <class Info>
void Pass::store(const Binding& binding, uint32_t element, std::vector<Info>& infos, const Info& info) {
    Info& known = infos[binding.first + element];
    if (equal(known, info)) return;
    known = info;
    dirty_ = true;
}

// Disagreements between a view and the shader's declaration.
void Pass::check_view(const SourceLocation& where, const Binding& binding, const ImageView& view) const {
    const VkFormat format = view.format == VK_FORMAT_UNDEFINED ? view.image->desc.format : view.format;
    const auto differs = [&](std::string_view shader, std::string_view image) {
        fail(where, ": '{}' is {} in the shader, and {} is {}", binding.name, shader, view.name(), image);
    };
    if (binding.format != VK_FORMAT_UNDEFINED && binding.format != format)
        differs(name_of(binding.format), name_of(format));
    constexpr std::string_view texels[] = {"an image of floats", "an image of integers",
                                           "an image of unsigned integers"};
    if (const Texels own = texels_of(format); own != binding.texels)
        differs(texels[size_t(binding.texels)], name_of(format));
    if (binding.multisampled != (view.image->desc.samples > 1))
        differs(binding.multisampled ? "multisampled" : "not multisampled",
                binding.multisampled ? "not" : "multisampled: resolve it first");
}

void Pass::check_sampler(const SourceLocation& where, const Binding& binding, const ImageView& view,
                         const Sampler& sampler) const {
    if (binding.compares && sampler.compare == Compare::off)
        fail(where, ": '{}' compares in the shader, and its sampler does not; set Sampler::compare", binding.name);
    if (!binding.compares && sampler.compare != Compare::off)
        fail(where, ": '{}' is read in the shader, and its sampler compares; declare a sampler2DShadow", binding.name);
    if (binding.compares && !view.image->is_depth())
        fail(where, ": '{}' compares depths in the shader, and {} is no depth image", binding.name, view.name());
    const bool is_filtered = sampler.filter == Filter::linear || sampler.mip_filter == Filter::linear;
    if (!binding.compares && is_filtered && (view.image->is_depth() || binding.texels != Texels::floats))
        fail(where, ": '{}' would be filtered, and {} is {}, which has no filter; set it with nearest_clamp",
             binding.name, view.name(), name_of(view.image->desc.format));
}

void Pass::check_ended() const {
    if (unread_)
        fail(unread_where_, " sets '{}' after its last draw or dispatch, so that nothing reads it", unread_->name);
    for (const Stated& one : lists_.stated) {
        const ImageView& view = one.resource.view;
        if (!one.writable || !view) continue;
        if (view.image->written_in != frame.number())
            fail(where_, " states {} in its writes, and draws and dispatches nothing", view.name());
    }
}

// `view` becomes the part and the type that the shader declares.
VkDescriptorImageInfo Pass::image_info(const SourceLocation& where, const Binding& binding, ImageView& view,
                                       const Sampler& sampler) const {
    const bool storage = binding.type == VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    if (!view || !view.image->handle)
        fail(where, ": '{}' gets an image without a size: a Target has one in Chapter::frame, an Image after ensure()",
             binding.name);
    if (storage && view.mips > 1) view = view.mip(0);
    if (!turn_into(view, binding.view_type))
        fail(where, ": '{}' is {} in the shader, and {} is {}", binding.name, shape(binding.view_type), view.name(),
             shape(view));
    check_view(where, binding, view);
    if (!storage) check_sampler(where, binding, view, sampler);
    if (storage && !view.image->is_storable())
        fail(where, ": '{}' is a storage image in the shader, and the device has none of {}, which {} is", binding.name,
             name_of(view.image->desc.format), view.name());
    const Stated* found = stated(view, storage && binding.writable);
    if (found && storage && found->layout != VK_IMAGE_LAYOUT_GENERAL) {
        if (point_ != VK_PIPELINE_BIND_POINT_COMPUTE || view.image->constant)
            fail(
                where,
                ": '{}' is a readonly image in the shader; raster passes and uploaded images are only sampled: declare "
                "a sampler and use texelFetch(), or state {} in writes, too",
                binding.name, view.name());
        turn_general(commands, *std::ranges::find_if(lists_.stated, [&](const Stated& s) { return &s == found; }),
                     lists_);
    }
    if (!found && (!view.image->constant || storage)) fail_unstated(where, binding.name, binding.writable);
    if (found && !found->read && storage && binding.readable)
        fail(where,
             ": '{}' is not writeonly in the shader, and {} is stated in writes alone; declare it writeonly, or "
             "state it in reads, too",
             binding.name, view.name());
    if (found && !found->read && !storage) fail_unstated(where, binding.name, false);
    return {.sampler = storage ? VK_NULL_HANDLE : frame.gpu.samplers[sampler],
            .imageView = view.handle(),
            .imageLayout = found ? found->layout : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
}

void Pass::set_images(const Name& name_in_shader, std::span<const ImageView> views, const Sampler& sampler) {
    const Binding* found = find(name_in_shader);
    if (!found) return;
    const Binding& binding = *found;
    const SourceLocation& where = name_in_shader.where;
    if (listener()) listener()->sets(binding.name, views, sampler);
    if (binding.type != VK_DESCRIPTOR_TYPE_STORAGE_IMAGE && binding.type != VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER)
        fail(where, ": '{}' is a buffer in the shader, not an image", binding.name);
    if (views.empty() || views.size() > binding.count)
        fail(where, ": '{}' has {} elements in the shader and gets {}", binding.name, binding.count, views.size());
    VkDescriptorImageInfo info{};
    ImageView view;
    for (uint32_t i = 0; i < binding.count; ++i) {
        if (i < views.size()) {
            view = views[i];
            info = image_info(where, binding, view, sampler);
        }
        store(binding, i, lists_.image_infos, info);
        lists_.views[binding.first + i] = view;
    }
    missing_ -= !std::exchange(lists_.bound[binding.number].set, true);
    note_set(name_in_shader, binding);
}

void Pass::set_buffer(const Name& name_in_shader, const Buffer& buffer) {
    const Binding* binding = find(name_in_shader);
    if (!binding) return;
    const SourceLocation& where = name_in_shader.where;
    if (listener()) listener()->does_more("the buffer '" + binding->name + "'");
    if (binding->type != VK_DESCRIPTOR_TYPE_STORAGE_BUFFER)
        fail(where, ": '{}' is not a storage buffer in the shader", binding->name);
    if (binding->count > 1) fail(where, ": '{}' is an array of buffers, which passes do not bind", binding->name);
    if (!buffer.handle) return;  // a module's that is not prepared: refused by the draw, unless another is set
    // Vectors may be read by their components.
    const auto divides = [](uint32_t a, uint32_t b) { return a == 0 || b % a == 0; };
    if (!divides(buffer.stride, binding->stride) && !divides(binding->stride, buffer.stride))
        fail(where, ": an element of '{}' has {} bytes in the shader, and one of {} has {} in C++", binding->name,
             binding->stride, buffer.name, buffer.stride);
    check_stated(where, binding->name, buffer, binding->writable);
    store(*binding, 0, lists_.buffer_infos, {.buffer = buffer.handle, .offset = 0, .range = buffer.bytes});
    missing_ -= !std::exchange(lists_.bound[binding->number].set, true);
    note_set(name_in_shader, *binding);
}

void Pass::set_bytes(const Name& name_in_shader, std::span<const std::byte> bytes, BlockMember::Type type) {
    const Binding* const binding = find(name_in_shader);
    if (!binding) return;
    using Type = BlockMember::Type;
    if (type != Type::other && binding->members.size() == 1) {
        const Type own = binding->members[0].type;
        if (own != Type::other && (own == Type::number) != (type == Type::number))
            fail(name_in_shader.where, ": '{}' is {} in C++ and {} in the shader, which would take its bits",
                 binding->name, type == Type::number ? "a float" : "an integer",
                 own == Type::number ? "a float" : "an integer");
    }
    set_block(name_in_shader.where, *binding, bytes);
    note_set(name_in_shader, *binding);
}

void Pass::note_set(const Name& name_in_shader, const Binding& binding) {
    if (!drawn_ || modules_bind_) return;
    unread_ = &binding;
    unread_where_ = name_in_shader.where;
}

void Pass::set_block(const SourceLocation& where, const Binding& binding, std::span<const std::byte> bytes) {
    if (listener()) listener()->sets(binding.name, bytes);
    if (binding.type != VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER)
        fail(where, ": '{}' is not a uniform block in the shader", binding.name);
    if (bytes.size() != binding.bytes)
        fail(where, ": '{}' is {} bytes in C++ and {} in the shader", binding.name, bytes.size(), binding.bytes);
    PassLists::Bound& bound = lists_.bound[binding.number];
    // Host copy for comparison: reading mapped device memory can be slow.
    std::byte* const known = lists_.bytes.data() + bound.at;
    if (!bound.set || std::memcmp(known, bytes.data(), bytes.size()) != 0) {
        std::memcpy(known, bytes.data(), bytes.size());
        store(binding, 0, lists_.buffer_infos, frame.copy_to_arena(bytes));
    }
    missing_ -= !std::exchange(bound.set, true);
}

// A dispatch that samples what it writes reads either value.
void Pass::check_not_sampled() const {
    const auto each = [&](const Binding& binding, const auto& visit) {
        for (uint32_t i = 0; i < binding.count; ++i) visit(lists_.views[binding.first + i]);
    };
    for (const Binding& written : pipeline_->bindings) {
        if (!written.used || written.type != VK_DESCRIPTOR_TYPE_STORAGE_IMAGE || !written.writable) continue;
        for (const Binding& sampled : pipeline_->bindings) {
            if (!sampled.used || sampled.type != VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER) continue;
            each(written, [&](const ImageView& into) {
                each(sampled, [&](const ImageView& from) {
                    if (into.overlaps(from))
                        fail(where_,
                             " samples {} as '{}' and writes it as '{}' at once; write another image, or read it in "
                             "place by imageLoad()",
                             from.name(), sampled.name, written.name);
                });
            });
        }
    }
}

void Pass::check_workgroups(const glm::uvec3& groups) const {
    const glm::uvec2 stated(groups), local(pipeline_->local_size);
    glm::uvec2 needed(0), size(0);
    const Binding* largest = nullptr;
    bool stores_more = false;
    for (const Binding& binding : pipeline_->bindings) {
        if (!binding.used || !binding.writable) continue;
        stores_more |= !binding.by_thread;
        if (!binding.by_thread) continue;
        const glm::uvec2 texels(lists_.views[binding.first].size()), own = (texels + local - 1u) / local;
        if (glm::all(glm::lessThanEqual(own, needed))) continue;
        needed = glm::max(own, needed);
        size = texels;
        largest = &binding;
    }
    if (!largest || stated == needed) return;
    if (stores_more && glm::all(glm::greaterThanEqual(stated, needed))) return;
    fail(where_,
         " dispatches {}×{} workgroups of {}×{} threads; '{}' has {}×{} texels and needs {}×{}: dispatch_threads(size) "
         "counts texels",
         stated.x, stated.y, local.x, local.y, largest->name, size.x, size.y, needed.x, needed.y);
}

bool Pass::flush() {
    check_used();
    values_are_read();
    if (!pipeline_) return false;
    if (missing_ > 0)
        for (const Binding& binding : pipeline_->bindings)
            if (binding.used && !lists_.bound[binding.number].set)
                fail(where_, " draws or dispatches without '{}' being set{}", binding.name,
                     binding.name == "view"                              ? "; set_view(frame) sets it"
                     : binding.type == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER ? "; is its module stated in .with?"
                                                                         : "");
    if (!dirty_) return true;
    dirty_ = false;
    if (pipeline_->samples_and_writes) check_not_sampled();
    lists_.writes.clear();
    for (const Binding& binding : pipeline_->bindings) {
        if (!binding.used) continue;
        lists_.writes.push_back({.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                 .dstBinding = binding.number,
                                 .descriptorCount = binding.count,
                                 .descriptorType = binding.type,
                                 .pImageInfo = &lists_.image_infos[binding.first],
                                 .pBufferInfo = &lists_.buffer_infos[binding.first]});
    }
    frame.note_writes(lists_.stated, nullptr);
    const VkDescriptorSet set = frame.descriptor_set(*pipeline_, lists_.writes);
    vkCmdBindDescriptorSets(commands, point_, pipeline_->layout, 0, 1, &set, 0, nullptr);
    return true;
}

}  // namespace lightwalk
