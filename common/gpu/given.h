// A module's contribution to a pass: macros, uniforms, resources read, and bindings.
#pragma once
#include <span>
#include <vector>

#include "common/gpu/macros.h"
#include "common/gpu/reflect.h"

namespace lightwalk {

class Pass;
struct Resource;

/// A pass states it in `.with`; Module is the one there is.
class Given {
  public:
    virtual ~Given() = default;

    /// Kind that names the macros, blocks and bindings; a pass takes one of each kind.
    virtual const std::string& kind() const = 0;
    virtual Macros macros() const = 0;

    /// The bytes of a uniform block, where it is this one's; else none. Good until the next call. Throws Failure if the shader's members do
    /// not fit.
    virtual std::span<const std::byte> block(const Binding& binding) const = 0;

    /// Resources that the pass reads on its behalf.
    virtual std::vector<Resource> reads() const;

    /// Sets those of its bindings that the current pipeline uses; called after each use().
    virtual void bind(Pass&) const {}

    /// Adds it and its dependencies.
    virtual void expand(std::vector<const Given*>& into) const { into.push_back(this); }
};

}  // namespace lightwalk
