// Analysis of where shaders store and sample texels.
#pragma once
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace lightwalk {

/// Images by variable id. An index that comes about otherwise than by conversions and copies, or coordinates also by
/// adding a constant, count as other ones.
struct TexelAccess {
    std::unordered_set<uint32_t> stored_by_thread;  ///< at gl_GlobalInvocationID.xy and nowhere else
    std::unordered_set<uint32_t>
        sampled_at_pixels;  ///< with coordinates that are gl_GlobalInvocationID or gl_FragCoord
};
TexelAccess texel_access(const std::vector<uint32_t>& spirv);

}  // namespace lightwalk
