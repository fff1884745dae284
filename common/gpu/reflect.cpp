#include "common/gpu/reflect.h"

#include <spirv_cross/spirv_cross_c.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "common/base/error.h"
#include "common/gpu/texel_stores.h"

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

Texels components_of(spvc_type type) {
    switch (spvc_type_get_basetype(type)) {
        case SPVC_BASETYPE_INT32:
            return Texels::integers;
        case SPVC_BASETYPE_UINT32:
            return Texels::unsigned_integers;
        default:
            return Texels::floats;
    }
}

Texels texels_of(spvc_compiler compiler, spvc_type type) {
    return components_of(spvc_compiler_get_type_handle(compiler, spvc_type_get_image_sampled_type(type)));
}

// An array of inputs or outputs, such as a geometry shader's, is one entry. The second source of a blend
// (index 1) belongs to its target's first output.
std::vector<Varying> varyings_of(spvc_compiler compiler, spvc_resources resources, spvc_resource_type kind) {
    const spvc_reflected_resource* list = nullptr;
    size_t count = 0;
    spvc_resources_get_resource_list_for_type(resources, kind, &list, &count);
    std::vector<Varying> result;
    for (size_t i = 0; i < count; ++i) {
        if (spvc_compiler_get_decoration(compiler, list[i].id, SpvDecorationIndex) != 0) continue;
        const spvc_type type = spvc_compiler_get_type_handle(compiler, list[i].type_id);
        result.push_back({.name = list[i].name,
                          .location = spvc_compiler_get_decoration(compiler, list[i].id, SpvDecorationLocation),
                          .components = spvc_type_get_vector_size(type) * spvc_type_get_columns(type),
                          .type = components_of(type)});
    }
    return result;
}

// Bytes of all shared variables, without padding. SPIRV-Cross lists none.
uint32_t shared_bytes_of(const std::vector<uint32_t>& spirv) {
    std::map<uint32_t, uint32_t> bytes, constants, pointees;  // by id
    uint32_t sum = 0;
    constexpr size_t header_words = 5;
    for (size_t at = header_words; at < spirv.size(); at += std::max(spirv[at] >> SpvWordCountShift, 1u)) {
        const uint32_t* const word = &spirv[at];
        const uint32_t count = word[0] >> SpvWordCountShift;
        switch (word[0] & SpvOpCodeMask) {
            case SpvOpTypeBool:
                bytes[word[1]] = 4;
                break;
            case SpvOpTypeInt:
            case SpvOpTypeFloat:
                bytes[word[1]] = word[2] / 8;
                break;
            case SpvOpTypeVector:
            case SpvOpTypeMatrix:
                bytes[word[1]] = bytes[word[2]] * word[3];
                break;
            case SpvOpTypeArray:
                bytes[word[1]] = bytes[word[2]] * constants[word[3]];
                break;
            case SpvOpTypeStruct:
                for (uint32_t i = 2; i < count; ++i) bytes[word[1]] += bytes[word[i]];
                break;
            case SpvOpTypePointer:
                pointees[word[1]] = word[3];
                break;
            case SpvOpConstant:
                constants[word[2]] = word[3];
                break;
            case SpvOpVariable:
                if (word[3] == SpvStorageClassWorkgroup) sum += bytes[pointees[word[1]]];
                break;
            case SpvOpFunction:
                return sum;
            default:
                break;
        }
    }
    return sum;
}

VkFormat storage_format_of(spvc_type type) {
    // Vulkan specification 1.3, "Compatibility Between SPIR-V Image Formats and Vulkan Formats".
    static constexpr std::pair<SpvImageFormat, VkFormat> formats[] = {
        {SpvImageFormatRgba32f, VK_FORMAT_R32G32B32A32_SFLOAT},
        {SpvImageFormatRgba16f, VK_FORMAT_R16G16B16A16_SFLOAT},
        {SpvImageFormatR32f, VK_FORMAT_R32_SFLOAT},
        {SpvImageFormatRgba8, VK_FORMAT_R8G8B8A8_UNORM},
        {SpvImageFormatRgba8Snorm, VK_FORMAT_R8G8B8A8_SNORM},
        {SpvImageFormatRg32f, VK_FORMAT_R32G32_SFLOAT},
        {SpvImageFormatRg16f, VK_FORMAT_R16G16_SFLOAT},
        {SpvImageFormatR11fG11fB10f, VK_FORMAT_B10G11R11_UFLOAT_PACK32},
        {SpvImageFormatR16f, VK_FORMAT_R16_SFLOAT},
        {SpvImageFormatRgba16, VK_FORMAT_R16G16B16A16_UNORM},
        {SpvImageFormatRgb10A2, VK_FORMAT_A2B10G10R10_UNORM_PACK32},
        {SpvImageFormatRg16, VK_FORMAT_R16G16_UNORM},
        {SpvImageFormatRg8, VK_FORMAT_R8G8_UNORM},
        {SpvImageFormatR16, VK_FORMAT_R16_UNORM},
        {SpvImageFormatR8, VK_FORMAT_R8_UNORM},
        {SpvImageFormatRgba16Snorm, VK_FORMAT_R16G16B16A16_SNORM},
        {SpvImageFormatRg16Snorm, VK_FORMAT_R16G16_SNORM},
        {SpvImageFormatRg8Snorm, VK_FORMAT_R8G8_SNORM},
        {SpvImageFormatR16Snorm, VK_FORMAT_R16_SNORM},
        {SpvImageFormatR8Snorm, VK_FORMAT_R8_SNORM},
        {SpvImageFormatRgba32i, VK_FORMAT_R32G32B32A32_SINT},
        {SpvImageFormatRgba16i, VK_FORMAT_R16G16B16A16_SINT},
        {SpvImageFormatRgba8i, VK_FORMAT_R8G8B8A8_SINT},
        {SpvImageFormatR32i, VK_FORMAT_R32_SINT},
        {SpvImageFormatRg32i, VK_FORMAT_R32G32_SINT},
        {SpvImageFormatRg16i, VK_FORMAT_R16G16_SINT},
        {SpvImageFormatRg8i, VK_FORMAT_R8G8_SINT},
        {SpvImageFormatR16i, VK_FORMAT_R16_SINT},
        {SpvImageFormatR8i, VK_FORMAT_R8_SINT},
        {SpvImageFormatRgba32ui, VK_FORMAT_R32G32B32A32_UINT},
        {SpvImageFormatRgba16ui, VK_FORMAT_R16G16B16A16_UINT},
        {SpvImageFormatRgba8ui, VK_FORMAT_R8G8B8A8_UINT},
        {SpvImageFormatR32ui, VK_FORMAT_R32_UINT},
        {SpvImageFormatRgb10a2ui, VK_FORMAT_A2B10G10R10_UINT_PACK32},
        {SpvImageFormatRg32ui, VK_FORMAT_R32G32_UINT},
        {SpvImageFormatRg16ui, VK_FORMAT_R16G16_UINT},
        {SpvImageFormatRg8ui, VK_FORMAT_R8G8_UINT},
        {SpvImageFormatR16ui, VK_FORMAT_R16_UINT},
        {SpvImageFormatR8ui, VK_FORMAT_R8_UINT},
    };
    const SpvImageFormat wanted = spvc_type_get_image_storage_format(type);
    for (const auto& [format, result] : formats)
        if (format == wanted) return result;
    return VK_FORMAT_UNDEFINED;
}

struct Extent {
    uint32_t bytes = 0, alignment = 1;
};

uint32_t round_up(uint32_t at, uint32_t alignment) { return (at + alignment - 1) / alignment * alignment; }

// Size and alignment by GL_EXT_scalar_block_layout, the rules of C++. Throws Failure where `block` is laid out otherwise.
class ScalarLayout {
  public:
    ScalarLayout(spvc_compiler compiler, std::string block) : compiler_(compiler), block_(std::move(block)) {}

    Extent of_struct(spvc_type type) const {
        Extent all;
        for (unsigned i = 0; i < spvc_type_get_num_member_types(type); ++i) {
            const spvc_type member = spvc_compiler_get_type_handle(compiler_, spvc_type_get_member_type(type, i));
            const Extent one = of_member(type, i, member);
            const uint32_t at = round_up(all.bytes, one.alignment);
            unsigned offset = 0;
            spvc_compiler_type_struct_member_offset(compiler_, type, i, &offset);
            if (offset != at) refuse(type, i, "offset", offset, at);
            all = {at + one.bytes, std::max(all.alignment, one.alignment)};
        }
        return {round_up(all.bytes, all.alignment), all.alignment};
    }

  private:
    [[noreturn]] void refuse(spvc_type type, unsigned member, const char* what, unsigned is, unsigned wanted) const {
        const char* name = spvc_compiler_get_member_name(compiler_, spvc_type_get_base_type_id(type), member);
        throw Failure("block '{}': {} of '{}' is {}, in C++ {}; declare the block with layout(scalar)", block_, what,
                      name, is, wanted);
    }

    Extent of_member(spvc_type type, unsigned i, spvc_type member) const {
        Extent one = of_element(type, i, member);
        const unsigned dimensions = spvc_type_get_num_array_dimensions(member);
        unsigned stride = 0;
        if (dimensions == 1 &&
            spvc_compiler_type_struct_member_array_stride(compiler_, type, i, &stride) == SPVC_SUCCESS &&
            stride != one.bytes)
            refuse(type, i, "array stride", stride, one.bytes);
        for (unsigned d = 0; d < dimensions; ++d) one.bytes *= spvc_type_get_array_dimension(member, d);
        return one;
    }

    Extent of_element(spvc_type type, unsigned i, spvc_type member) const {
        if (spvc_type_get_basetype(member) == SPVC_BASETYPE_STRUCT) return of_struct(member);
        const uint32_t component = std::max(spvc_type_get_bit_width(member) / 8, 1u);
        const uint32_t columns = spvc_type_get_columns(member), rows = spvc_type_get_vector_size(member);
        unsigned stride = 0;
        if (columns > 1 &&
            spvc_compiler_type_struct_member_matrix_stride(compiler_, type, i, &stride) == SPVC_SUCCESS &&
            stride != rows * component)
            refuse(type, i, "matrix stride", stride, rows * component);
        return {columns * rows * component, component};
    }

    spvc_compiler compiler_;
    std::string block_;
};

// Bindings are set by name: a module declares nothing that has no name in C++.
void refuse_unset(spvc_compiler compiler, spvc_resources resources) {
    struct Unset {
        spvc_resource_type kind;
        const char* what;
    };
    for (const auto& [kind, what] :
         {Unset{SPVC_RESOURCE_TYPE_PUSH_CONSTANT,
                "is a push-constant block, which no pass sets; declare layout(scalar) uniform, and set it by name"},
          Unset{SPVC_RESOURCE_TYPE_SEPARATE_IMAGE, "is a texture without a sampler; declare a sampler2D"},
          Unset{SPVC_RESOURCE_TYPE_SEPARATE_SAMPLERS, "is a sampler without a texture; declare a sampler2D"},
          Unset{SPVC_RESOURCE_TYPE_SUBPASS_INPUT, "is a subpass input, which no pass has; declare a sampler2D"}}) {
        const spvc_reflected_resource* list = nullptr;
        size_t count = 0;
        spvc_resources_get_resource_list_for_type(resources, kind, &list, &count);
        if (count == 0) continue;
        const std::string name = spvc_compiler_get_name(compiler, list[0].id);
        throw Failure("'{}' {}", name.empty() ? spvc_compiler_get_name(compiler, list[0].base_type_id) : name, what);
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
    refuse_unset(compiler, resources);
    const TexelAccess texels = texel_access(spirv);
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
            if (const unsigned set = spvc_compiler_get_decoration(compiler, list[i].id, SpvDecorationDescriptorSet))
                throw Failure("'{}' is in set {}; declare it without set and binding, and set it by name", binding.name,
                              set);
            if (texels.sampled_at_pixels.contains(list[i].id))
                throw Failure("'{}' is sampled at a pixel, and texture() takes 0 to 1; use texelFetch()", binding.name);
            if (block) ScalarLayout(compiler, binding.name).of_struct(base);
            if (!block) {
                binding.view_type = view_type_of(base);
                binding.texels = texels_of(compiler, base);
                binding.multisampled = spvc_type_get_image_multisampled(base);
                binding.compares = spvc_type_get_image_is_depth(base);
            }
            if (type == VK_DESCRIPTOR_TYPE_STORAGE_IMAGE) {
                binding.format = storage_format_of(base);
                binding.by_thread =
                    binding.view_type == VK_IMAGE_VIEW_TYPE_2D && texels.stored_by_thread.contains(list[i].id);
            }
            if (type == VK_DESCRIPTOR_TYPE_STORAGE_BUFFER && spvc_type_get_num_member_types(base) == 1)
                spvc_compiler_type_struct_member_array_stride(compiler, base, 0, &binding.stride);
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
    result.inputs = varyings_of(compiler, used, SPVC_RESOURCE_TYPE_STAGE_INPUT);
    result.outputs = varyings_of(compiler, resources, SPVC_RESOURCE_TYPE_STAGE_OUTPUT);
    result.shared_bytes = shared_bytes_of(spirv);
    if (spvc_compiler_get_execution_model(compiler) == SpvExecutionModelGLCompute)
        for (unsigned i = 0; i < 3; ++i)
            result.local_size[static_cast<int>(i)] =
                spvc_compiler_get_execution_mode_argument_by_index(compiler, SpvExecutionModeLocalSize, i);
    return result;
}

}  // namespace lightwalk
