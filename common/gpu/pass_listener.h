// Observation of the passes recorded into a frame, for tests and exercise checks.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "common/gpu/targets.h"

namespace lightwalk {

struct Sampler;

/// Receives all recorded calls in order, except module bindings (PassInputs::bind).
struct PassListener {
    virtual ~PassListener() = default;
    virtual void begins(const std::string& pass, const RasterTargets& targets) = 0;
    virtual void begins(const std::string& pass, const ComputeAccess& access) = 0;
    virtual void uses(const Pipeline& pipeline, const Macros& variant) = 0;
    virtual void sets(std::string_view binding, std::span<const ImageView> views, const Sampler& sampler) = 0;
    virtual void sets(std::string_view binding, std::span<const std::byte> bytes) = 0;
    virtual void draws(uint32_t vertices, uint32_t instances, uint32_t first_instance) = 0;
    virtual void dispatches(glm::uvec3 groups) = 0;
    virtual void waits() = 0;
    /// Any other command: transfer pass, buffer binding, indexed or indirect draw, indirect dispatch.
    virtual void does_more(std::string_view what) = 0;
};

/// Test options of a frame, fixed at creation so that recorded code cannot change them.
struct FrameWatch {
    PassListener* listener = nullptr;
    /// Fills discarded targets with a conspicuous value, since most devices keep the old contents.
    bool shows_discarded = false;
};

}  // namespace lightwalk
