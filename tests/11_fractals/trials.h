// The recording of 11.record_cones's check, made in the student's process.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "common/check/recorded.h"
#include "common/check/trial.h"

namespace lightwalk {

/// The two frames of ConesStage.
TRIAL("11.record_cones", std::vector<RecordedFrame>, try_record_cones, glm::ivec2 size);

}  // namespace lightwalk
