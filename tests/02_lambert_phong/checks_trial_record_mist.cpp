// The two frames of 02.record_mist, recorded.
#include "mist_stage.h"
#include "trials.h"

namespace lightwalk {

std::vector<RecordedFrame> try_record_mist(float red, float blue) {
    Recorder recorder;
    MistStage stage(red, blue, &recorder);
    std::vector<RecordedFrame> recorded;
    for (const bool right : {false, true}) {
        stage.begin(right);
        recorded.push_back(recorder.listen(stage.cast, "record_mist", [&] {
            record_mist(stage.frame, {stage.sky, stage.mist, recorder.call(0)});
        }));
    }
    return recorded;
}

}  // namespace lightwalk
