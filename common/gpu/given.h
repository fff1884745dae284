// What a module hands to a pass: macros, uniforms, what its shaders read, and the bindings themselves.
#pragma once
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

    /// Whose shaders' macros, blocks and bindings these are: one of a kind goes into a pass.
    virtual const std::string& kind() const = 0;
    virtual Macros macros() const = 0;

    /// The bytes of a uniform block, where it is this one's; else none. Throws Failure where the shader's members do
    /// not fit.
    virtual std::vector<std::byte> block(const Binding& binding) const = 0;

    /// What the pass reads on its behalf.
    virtual std::vector<Resource> reads() const;

    /// Sets those of its bindings that the pipeline in use wants; called after each use().
    virtual void bind(Pass&) const {}

    /// Adds it and what it brings along.
    virtual void expand(std::vector<const Given*>& into) const { into.push_back(this); }
};

}  // namespace lightwalk
