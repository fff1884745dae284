// The recording of 12.blur_irradiance's check, made in the student's process.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "common/check/recorded.h"
#include "common/check/trial.h"

namespace lightwalk {

/// The frame of BlurStage.
TRIAL("12.blur_irradiance", RecordedFrame, try_blur_irradiance, int count);

}  // namespace lightwalk
