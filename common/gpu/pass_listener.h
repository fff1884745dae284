// A listener to the passes of a frame, and how a frame of a check differs from any other.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "common/gpu/targets.h"

namespace lightwalk {

struct Sampler;

/// Receives everything recorded into a frame, in order, except for module bindings (Given::bind).
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
    /// A transfer pass, a buffer, indices, an indirect draw or dispatch.
    virtual void does_more(std::string_view what) = 0;
};

/// Extra behaviour of a frame. Stated when the frame is created: nothing that records into it can change this.
struct FrameWatch {
    PassListener* listener = nullptr;
    /// Fills discarded targets with a conspicuous value. Most devices leave the old contents there, so code that
    /// relies on them works by chance.
    bool shows_discarded = false;
};

}  // namespace lightwalk
