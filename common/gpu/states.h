// Fixed-function state of a graphics pipeline: depth test, blending, colour writes.
#pragma once
#include <vulkan/vulkan.h>

#include <initializer_list>
#include <utility>
#include <vector>

namespace lightwalk {

/// Comparison with the stored value. Reverse depth: nearer is greater. `off` applies to samplers only.
enum class Compare { off, never, less, equal, less_or_equal, greater, not_equal, greater_or_equal, always };

inline VkCompareOp compare_op(Compare compare) {
    return compare == Compare::off ? VK_COMPARE_OP_ALWAYS : static_cast<VkCompareOp>(static_cast<int>(compare) - 1);
}

/// Blend equations for the fragment (new) and the target (old), each for colour and alpha.
enum class Blend {
    opaque,         ///< new
    alpha,          ///< new · new alpha + old · (1 - new alpha)
    premultiplied,  ///< new + old · (1 - new alpha): colour already multiplied by alpha
    add,            ///< new + old
    multiply,       ///< new · old
    minimum,
    maximum,
    filtered  ///< new · new alpha + old · second output (location 0, index 1), a share for each channel
};

/// Depth bias: `constant` in units of the depth format (for floats, of the triangle's largest depth), `slope` times
/// max(|∂z/∂x|, |∂z/∂y|) per pixel. With reverse depth, negative values are farther.
struct DepthBias {
    float constant = 0, slope = 0;
    float clamp = 0;  ///< maximum magnitude, with the sign of the bias; 0: no limit
    explicit operator bool() const { return constant != 0 || slope != 0; }
};

constexpr VkColorComponentFlags write_nothing = 0;
constexpr VkColorComponentFlags write_rgb =
    VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT;
constexpr VkColorComponentFlags write_rgba = write_rgb | VK_COLOR_COMPONENT_A_BIT;

/// One value for all colour targets or one each: `.blend = Blend::add`, `.blend = {Blend::add, Blend::opaque}`.
template <class T>
class PerTarget {
  public:
    PerTarget(T all) : values_{all} {}
    PerTarget(std::initializer_list<T> each) : values_(each) {}
    explicit PerTarget(std::vector<T> each) : values_(std::move(each)) {}
    /// Targets beyond the list use its last value.
    T operator[](size_t target) const { return values_.at(target < values_.size() ? target : values_.size() - 1); }
    const std::vector<T>& values() const { return values_; }

  private:
    std::vector<T> values_;
};

/// Blend state that overrides a pass's pipelines, for methods that blend the draws of others.
struct BlendOverride {
    std::vector<Blend> blend;
    bool depth_write = false;
    auto operator<=>(const BlendOverride&) const = default;
};

}  // namespace lightwalk
