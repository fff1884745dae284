// The two frames of 14.prefilter_faces, recorded.
#include "faces_stage.h"
#include "trials.h"

namespace lightwalk {

std::vector<RecordedFrame> try_prefilter_faces(uint32_t texels, uint32_t levels) {
    Recorder recorder;
    FacesStage stage(texels, levels, &recorder);
    std::vector<RecordedFrame> recorded;
    for (const float light : {1.0f, 2.0f}) {
        stage.begin(light);
        recorded.push_back(recorder.listen(stage.cast, "prefilter_faces", [&] {
            prefilter_faces(stage.frame, {stage.filter, stage.radiance, stage.prefiltered, {stage.giving}});
        }));
    }
    return recorded;
}

}  // namespace lightwalk
