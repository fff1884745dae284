// Analysis of where compute shaders store texels.
#pragma once
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace lightwalk {

/// Storage images, by variable id, that are stored to at gl_GlobalInvocationID.xy and nowhere else. An index that comes
/// about otherwise than by conversions and copies counts as another one.
std::unordered_set<uint32_t> images_stored_by_thread(const std::vector<uint32_t>& spirv);

}  // namespace lightwalk
