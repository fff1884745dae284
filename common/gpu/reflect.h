// Shader bindings reflected from SPIR-V, so that GLSL states no set or binding numbers.
#pragma once
#include <vulkan/vulkan.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/files.h"

namespace lightwalk {

/// Binding name with its hash; literals are hashed at compile time.
struct BindingName {
    template <size_t length>
    consteval BindingName(const char (&literal)[length])
        : text(literal, length - 1), hash(hash_bytes({literal, length - 1})) {}
    template <class T>
    requires(std::is_convertible_v<const T&, std::string_view> && !std::is_array_v<T>) BindingName(const T& name)
        : text(name), hash(hash_bytes(text)) {}
    std::string_view text;
    uint64_t hash;
};

/// Component type of an image's texels, as shaders see them.
enum class Texels { floats, integers, unsigned_integers };

/// As shaders see texels of a format: normalised numbers are floats.
Texels texels_of(VkFormat format);

struct BlockMember {
    enum class Type { number, integer, unsigned_integer, other };
    std::string name;
    Type type = Type::other;
    uint32_t offset = 0;
    uint32_t components = 1;
};

/// Binding by its GLSL name. A block without instance name has its only member's name, or its own if it has several.
struct Binding {
    std::string name;
    uint64_t hash = 0;
    uint64_t layout = 0;  ///< equal for blocks with equal members
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_MAX_ENUM;
    uint32_t number = 0;
    uint32_t count = 1;
    uint32_t first = 0;  ///< index of its first element among all bindings' elements
    VkImageViewType view_type = VK_IMAGE_VIEW_TYPE_2D;
    VkFormat format = VK_FORMAT_UNDEFINED;  ///< storage images: from layout(); undefined: any
    Texels texels = Texels::floats;         ///< images: type of a texel's components in the shader
    bool multisampled = false;
    bool compares = false;  ///< sampler2DShadow and its like
    VkShaderStageFlags stages = 0;
    uint32_t bytes = 0;
    uint32_t stride = 0;     ///< storage buffer that is one array: bytes of an element
    bool writable = false;   ///< storage buffer or image without `readonly`
    bool readable = true;    ///< image without `writeonly`
    bool by_thread = false;  ///< 2-D image stored to at gl_GlobalInvocationID.xy alone
    bool used = true;        ///< statically used by main(); others are not bound
    std::vector<BlockMember> members;
    uint32_t offset_of_number = 0;  ///< word of the module that holds the binding number
};

/// Input or output of a stage.
struct Varying {
    std::string name;
    uint32_t location = 0, components = 1;
    Texels type = Texels::floats;
};

struct Reflection {
    std::vector<Binding> bindings;
    std::vector<Varying> inputs, outputs;
    glm::uvec3 local_size{1};
    uint32_t shared_bytes = 0;
};

/// Throws Failure if the module is invalid, or declares what passes do not set: push constants, sets other than 0,
/// textures apart from their samplers, arrays without a size, blocks that are not laid out as in C++ (`scalar`).
Reflection reflect(const std::vector<uint32_t>& spirv);

}  // namespace lightwalk
