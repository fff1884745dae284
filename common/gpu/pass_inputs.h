// Contribution of a module to a pass: macros, uniforms, resources read, bindings.
#pragma once
#include <span>
#include <vector>

#include "common/gpu/macros.h"
#include "common/gpu/reflect.h"

namespace lightwalk {

class Pass;
struct Resource;

class PassInputs {
  public:
    virtual ~PassInputs() = default;

    /// Prefix of its macros, blocks and bindings. A pass accepts one instance of each kind.
    virtual const std::string& kind() const = 0;
    virtual Macros macros() const = 0;

    /// Contents of a uniform block, until the next call; empty: unknown block. Throws Failure if members differ.
    virtual std::span<const std::byte> block(const Binding& binding) const = 0;

    virtual std::vector<Resource> reads() const;

    /// Sets this module's bindings in the pass's current pipeline. Called after each use().
    virtual void bind(Pass&) const {}

    virtual void expand(std::vector<const PassInputs*>& into) const { into.push_back(this); }
};

}  // namespace lightwalk
