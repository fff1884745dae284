// How a texture is read: stated where it is bound, made once per device.
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

/// `pass.set("shadow_map", map, Sampler{.compare = Compare::greater, .wrap = Wrap::border})`.
struct Sampler {
    Filter filter = Filter::linear;        ///< between the texels of a mip
    Filter mip_filter = Filter::linear;    ///< between mips
    Compare compare = Compare::off;        ///< for sampler2DShadow: compares the reference with the stored depth
    Wrap wrap = Wrap::repeat;              ///< outside 0 to 1, in each direction
    std::optional<Wrap> wrap_v{};          ///< along v, where it differs
    Border border = Border::opaque_black;  ///< outside, with Wrap::border
    float anisotropy = 1;                  ///< samples along a slanted footprint, 1 to 16; at most the device's limit
    float min_lod = 0, max_lod = VK_LOD_CLAMP_NONE;  ///< mips of the bound view
    float lod_bias = 0;                              ///< mips; positive is blurrier
    bool operator==(const Sampler&) const = default;
};

inline constexpr Sampler linear_repeat{};
inline constexpr Sampler linear_clamp{.wrap = Wrap::clamp};
inline constexpr Sampler nearest_clamp{.filter = Filter::nearest, .mip_filter = Filter::nearest, .wrap = Wrap::clamp};
inline constexpr Sampler nearest_repeat{.filter = Filter::nearest, .mip_filter = Filter::nearest};

/// The device's samplers by value.
class Samplers {
  public:
    explicit Samplers(Device& device) : device_(device) {}
    Samplers(const Samplers&) = delete;
    VkSampler operator[](const Sampler& sampler);
    size_t size() const { return made_.size(); }

  private:
    Device& device_;
    std::vector<std::pair<Sampler, Owned<VkSampler, vkDestroySampler>>> made_;  ///< a few
};

}  // namespace lightwalk
