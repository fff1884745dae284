// Bindings of a shader, read from its SPIR-V, so that nobody writes set or binding numbers.
#pragma once
#include <vulkan/vulkan.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/files.h"

namespace lightwalk {

/// A binding's name, with the number by which pipelines find it: of a literal it is known to the compiler.
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

/// A member of a uniform block.
struct BlockMember {
    enum class Type { number, integer, unsigned_integer, other };
    std::string name;
    Type type = Type::other;
    uint32_t offset = 0;      ///< bytes
    uint32_t components = 1;  ///< 1 to 4
};

/// A binding by the name that GLSL code uses: the variable's; for a block without an instance name its only member's,
/// or the block's own where it has several.
struct Binding {
    std::string name;
    uint64_t hash = 0;    ///< BindingName::hash
    uint64_t layout = 0;  ///< the same for blocks with the same members
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_MAX_ENUM;
    uint32_t number = 0;
    uint32_t count = 1;                                 ///< elements of an array
    uint32_t first = 0;                                 ///< first element among all bindings' elements
    VkImageViewType view_type = VK_IMAGE_VIEW_TYPE_2D;  ///< of an image
    VkFormat format = VK_FORMAT_UNDEFINED;              ///< that a storage image's layout() names; undefined: any
    VkShaderStageFlags stages = 0;
    uint32_t bytes = 0;     ///< of a uniform block
    bool writable = false;  ///< a storage buffer or image without `readonly`
    bool readable = true;   ///< an image without `writeonly`
    bool used = true;       ///< reachable from main(); unused declarations are not bound
    std::vector<BlockMember> members;
    uint32_t offset_of_number = 0;  ///< word of the module that holds the binding number
};

struct Reflection {
    std::vector<Binding> bindings;
    glm::uvec3 local_size{1};  ///< of a compute shader
};

/// Throws Failure if the module cannot be read or an array of bindings has no size.
Reflection reflect(const std::vector<uint32_t>& spirv);

}  // namespace lightwalk
