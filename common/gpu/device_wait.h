// Waiting for the device with a time limit.
#pragma once
#include "common/gpu/device.h"

namespace lightwalk {

/// Calls `wait` with Device::timeout_ns(); for software devices up to ten times, until that much CPU time is used.
VkResult wait_for(const Device& device, const std::function<VkResult(uint64_t most_ns)>& wait);

}  // namespace lightwalk
