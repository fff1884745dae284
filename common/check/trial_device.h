// Device of trials that record frames (trial.h).
#pragma once
#include <string>

#include "common/gpu/device.h"

namespace lightwalk {

/// Any device, with validation: its first message goes to `first`, which must outlive the device.
inline DeviceOptions trial_device(std::string& first) {
    return {.name = "", .validate = true, .surface_extensions = {}, .on_message = [&first](const char* message) {
                if (first.empty()) first = message;
            }};
}

}  // namespace lightwalk
