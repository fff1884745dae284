// Sampler states, given where a texture is bound and cached per device.
#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "common/gpu/device.h"
#include "common/gpu/owned.h"
#include "common/gpu/states.h"

namespace lightwalk {

enum class Filter { nearest, linear };
enum class Wrap { repeat, mirror, clamp, border };
enum class Border { transparent_black, opaque_black, opaque_white };

/// Example: `pass.set("shadow_map", map, Sampler{.compare = Compare::greater, .wrap = Wrap::border})`.
struct Sampler {
    Filter filter = Filter::linear;
    Filter mip_filter = Filter::linear;
    Compare compare = Compare::off;  ///< reference against stored depth, for sampler2DShadow
    Wrap wrap = Wrap::repeat;        ///< u, v and w, outside [0, 1]
    std::optional<Wrap> wrap_v{};    ///< v, if different
    Border border = Border::opaque_black;
    float anisotropy = 1;                            ///< maximum anisotropy, 1 to 16, clamped to the device's limit
    float min_lod = 0, max_lod = VK_LOD_CLAMP_NONE;  ///< mip levels of the bound view
    float lod_bias = 0;                              ///< mip levels; positive is blurrier
    bool operator==(const Sampler&) const = default;
};

inline constexpr Sampler linear_repeat{};
inline constexpr Sampler linear_clamp{.wrap = Wrap::clamp};
inline constexpr Sampler nearest_clamp{.filter = Filter::nearest, .mip_filter = Filter::nearest, .wrap = Wrap::clamp};
inline constexpr Sampler nearest_repeat{.filter = Filter::nearest, .mip_filter = Filter::nearest};

class Samplers {
  public:
    explicit Samplers(Device& device) : device_(device) {}
    Samplers(const Samplers&) = delete;
    VkSampler operator[](const Sampler& sampler);
    size_t size() const { return made_.size(); }

  private:
    Device& device_;
    std::vector<std::pair<Sampler, Owned<VkSampler, vkDestroySampler>>> made_;
};

}  // namespace lightwalk
