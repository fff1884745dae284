// The recording of 02.record_mist's check, made in the student's process.
#pragma once
#include <vector>

#include "common/check/recorded.h"
#include "common/check/trial.h"

namespace lightwalk {

/// The two frames of MistStage.
TRIAL("02.record_mist", std::vector<RecordedFrame>, try_record_mist, float red, float blue);

}  // namespace lightwalk
