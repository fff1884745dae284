// Waiting for a device.
#pragma once
#include "common/gpu/device.h"

namespace lightwalk {

/// The result of `wait`, called with Device::timeout_ns() as its limit. A software device runs in this process: on a
/// busy machine the wait is repeated, up to ten times, until the process has received that much processor time.
VkResult wait_for(const Device& device, const std::function<VkResult(uint64_t most_ns)>& wait);

}  // namespace lightwalk
