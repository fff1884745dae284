#include "common/gpu/reflect.h"

#include <spirv_cross/spirv_cross_c.h>

#include <set>

#include "common/base/error.h"

namespace lightwalk {
namespace {

struct Context {
    spvc_context handle = nullptr;
    spvc_compiler compiler = nullptr;
    explicit Context(const std::vector<uint32_t>& spirv) {
        spvc_parsed_ir ir = nullptr;
        if (spvc_context_create(&handle) != SPVC_SUCCESS) throw Failure("spirv-cross: no context");
        if (spvc_context_parse_spirv(handle, spirv.data(), spirv.size(), &ir) != SPVC_SUCCESS ||
            spvc_context_create_compiler(handle, SPVC_BACKEND_NONE, ir, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler) !=
                SPVC_SUCCESS) {
            const std::string why = spvc_context_get_last_error_string(handle);
            spvc_context_destroy(handle);
            throw Failure("spirv-cross: {}", why);
        }
    }
    ~Context() { spvc_context_destroy(handle); }
    Context(const Context&) = delete;
};

std::string name_of(spvc_compiler compiler, const spvc_reflected_resource& resource, spvc_type type, bool block) {
    const std::string variable = spvc_compiler_get_name(compiler, resource.id);
    if (!block || !variable.empty()) return variable.empty() ? resource.name : variable;
    if (spvc_type_get_num_member_types(type) == 1)
        return spvc_compiler_get_member_name(compiler, resource.base_type_id, 0);
    return spvc_compiler_get_name(compiler, resource.base_type_id);
}

uint64_t layout_of(const Binding& block) {
    uint64_t layout = hash_bytes(block.name);
    for (const BlockMember& member : block.members) {
        const uint32_t rest[] = {static_cast<uint32_t>(member.type), member.offset, member.components, block.bytes};
        layout = hash_bytes({reinterpret_cast<const char*>(rest), sizeof rest}, hash_bytes(member.name, layout));
    }
    return layout;
}

std::vector<BlockMember> members_of(spvc_compiler compiler, const spvc_reflected_resource& resource, spvc_type type) {
    std::vector<BlockMember> result(spvc_type_get_num_member_types(type));
    for (unsigned i = 0; i < result.size(); ++i) {
        BlockMember& member = result[i];
        member.name = spvc_compiler_get_member_name(compiler, resource.base_type_id, i);
        spvc_compiler_type_struct_member_offset(compiler, type, i, &member.offset);
        const spvc_type member_type = spvc_compiler_get_type_handle(compiler, spvc_type_get_member_type(type, i));
        member.components = spvc_type_get_vector_size(member_type);
        if (spvc_type_get_columns(member_type) > 1 || spvc_type_get_num_array_dimensions(member_type)) continue;
        switch (spvc_type_get_basetype(member_type)) {
            case SPVC_BASETYPE_FP32:
                member.type = BlockMember::Type::number;
                break;
            case SPVC_BASETYPE_INT32:
                member.type = BlockMember::Type::integer;
                break;
            case SPVC_BASETYPE_UINT32:
                member.type = BlockMember::Type::unsigned_integer;
                break;
            default:
                break;
        }
    }
    return result;
}

bool writable(spvc_compiler compiler, const spvc_reflected_resource& resource, bool block) {
    if (spvc_compiler_has_decoration(compiler, resource.id, SpvDecorationNonWritable)) return false;
    if (!block) return true;
    const SpvDecoration* decorations = nullptr;
    size_t count = 0;
    if (spvc_compiler_get_buffer_block_decorations(compiler, resource.id, &decorations, &count) == SPVC_SUCCESS)
        for (size_t i = 0; i < count; ++i)
            if (decorations[i] == SpvDecorationNonWritable) return false;
    return true;
}

std::set<spvc_variable_id> ids_of(spvc_resources resources, spvc_resource_type kind) {
    const spvc_reflected_resource* list = nullptr;
    size_t count = 0;
    spvc_resources_get_resource_list_for_type(resources, kind, &list, &count);
    std::set<spvc_variable_id> ids;
    for (size_t i = 0; i < count; ++i) ids.insert(list[i].id);
    return ids;
}

VkImageViewType view_type_of(spvc_type type) {
    const bool array = spvc_type_get_image_arrayed(type);
    switch (spvc_type_get_image_dimension(type)) {
        case SpvDim3D:
            return VK_IMAGE_VIEW_TYPE_3D;
        case SpvDimCube:
            return array ? VK_IMAGE_VIEW_TYPE_CUBE_ARRAY : VK_IMAGE_VIEW_TYPE_CUBE;
        default:
            return array ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D;
    }
}

VkFormat storage_format_of(spvc_type type) {
    switch (spvc_type_get_image_storage_format(type)) {
        case SpvImageFormatRgba32f:
            return VK_FORMAT_R32G32B32A32_SFLOAT;
        case SpvImageFormatRgba16f:
            return VK_FORMAT_R16G16B16A16_SFLOAT;
        case SpvImageFormatRgba8:
            return VK_FORMAT_R8G8B8A8_UNORM;
        case SpvImageFormatRg32f:
            return VK_FORMAT_R32G32_SFLOAT;
        case SpvImageFormatRg16f:
            return VK_FORMAT_R16G16_SFLOAT;
        case SpvImageFormatR32f:
            return VK_FORMAT_R32_SFLOAT;
        case SpvImageFormatR16f:
            return VK_FORMAT_R16_SFLOAT;
        case SpvImageFormatR8:
            return VK_FORMAT_R8_UNORM;
        case SpvImageFormatR32ui:
            return VK_FORMAT_R32_UINT;
        default:
            return VK_FORMAT_UNDEFINED;
    }
}

}  // namespace

Reflection reflect(const std::vector<uint32_t>& spirv) {
    const Context context(spirv);
    const spvc_compiler compiler = context.compiler;
    Reflection result;
    spvc_resources resources = nullptr;
    if (spvc_compiler_create_shader_resources(compiler, &resources) != SPVC_SUCCESS)
        throw Failure("spirv-cross: no resources");
    spvc_set active = nullptr;
    spvc_resources used = nullptr;
    if (spvc_compiler_get_active_interface_variables(compiler, &active) != SPVC_SUCCESS ||
        spvc_compiler_create_shader_resources_for_active_variables(compiler, &used, active) != SPVC_SUCCESS)
        throw Failure("spirv-cross: no list of the resources in use");
    struct Kind {
        spvc_resource_type kind;
        VkDescriptorType type;
    };
    for (const auto& [kind, type] : {Kind{SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER},
                                     Kind{SPVC_RESOURCE_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
                                     Kind{SPVC_RESOURCE_TYPE_SAMPLED_IMAGE, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
                                     Kind{SPVC_RESOURCE_TYPE_STORAGE_IMAGE, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE}}) {
        const spvc_reflected_resource* list = nullptr;
        size_t count = 0;
        spvc_resources_get_resource_list_for_type(resources, kind, &list, &count);
        const std::set<spvc_variable_id> in_use = ids_of(used, kind);
        for (size_t i = 0; i < count; ++i) {
            const bool block = type == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER || type == VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
            const spvc_type base = spvc_compiler_get_type_handle(compiler, list[i].base_type_id);
            Binding binding{.name = name_of(compiler, list[i], base, block), .type = type};
            binding.hash = hash_bytes(binding.name);
            binding.used = in_use.count(list[i].id) > 0;
            const spvc_type whole = spvc_compiler_get_type_handle(compiler, list[i].type_id);
            for (unsigned d = 0; d < spvc_type_get_num_array_dimensions(whole); ++d)
                binding.count *= spvc_type_get_array_dimension(whole, d);
            if (binding.count == 0) throw Failure("'{}' is an array without a size", binding.name);
            if (!block) binding.view_type = view_type_of(base);
            if (type == VK_DESCRIPTOR_TYPE_STORAGE_IMAGE) binding.format = storage_format_of(base);
            if (type == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER) {
                size_t bytes = 0;
                spvc_compiler_get_declared_struct_size(compiler, base, &bytes);
                binding.bytes = static_cast<uint32_t>(bytes);
                binding.members = members_of(compiler, list[i], base);
                binding.layout = layout_of(binding);
            } else if (type != VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER) {
                binding.writable = writable(compiler, list[i], block);
                binding.readable = !spvc_compiler_has_decoration(compiler, list[i].id, SpvDecorationNonReadable);
            }
            if (!spvc_compiler_get_binary_offset_for_decoration(compiler, list[i].id, SpvDecorationBinding,
                                                                &binding.offset_of_number))
                throw Failure("'{}' has no binding number to replace", binding.name);
            result.bindings.push_back(std::move(binding));
        }
    }
    if (spvc_compiler_get_execution_model(compiler) == SpvExecutionModelGLCompute)
        for (unsigned i = 0; i < 3; ++i)
            result.local_size[static_cast<int>(i)] =
                spvc_compiler_get_execution_mode_argument_by_index(compiler, SpvExecutionModeLocalSize, i);
    return result;
}

}  // namespace lightwalk
