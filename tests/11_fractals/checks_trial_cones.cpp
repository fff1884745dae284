// The two frames of 11.record_cones, recorded.
#include "cones_stage.h"
#include "trials.h"

namespace lightwalk {

std::vector<RecordedFrame> try_record_cones(glm::ivec2 size) {
    Recorder recorder;
    ConesStage stage(size, &recorder);
    std::vector<RecordedFrame> recorded;
    for (const float number : {1.0f, 2.0f}) {
        stage.begin(number);
        recorded.push_back(recorder.listen(stage.cast, "record_cones", [&] {
            record_cones(stage.frame, {stage.cone, stage.march, stage.starts, stage.found, {stage.now}});
        }));
    }
    return recorded;
}

}  // namespace lightwalk
