// The recording of 14.prefilter_faces's check, made in the student's process.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "common/check/recorded.h"
#include "common/check/trial.h"

namespace lightwalk {

/// The two frames of FacesStage.
TRIAL("14.prefilter_faces", std::vector<RecordedFrame>, try_prefilter_faces, uint32_t texels, uint32_t levels);

}  // namespace lightwalk
