// Waiting for a device.
#pragma once
#include "common/gpu/device.h"

namespace lightwalk {

/// The answer of `wait`, which is given Device::timeout_ns() and answers VK_TIMEOUT after that. What a software device
/// does is done by this process: on a busy machine it is waited for again, ten times in all, until the process was given
/// as much of the processors' time.
VkResult wait_for(const Device& device, const std::function<VkResult(uint64_t most_ns)>& wait);

}  // namespace lightwalk
