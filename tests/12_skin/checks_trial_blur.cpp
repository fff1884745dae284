// The chain of 12.blur_irradiance, recorded.
#include "blur_stage.h"
#include "trials.h"

namespace lightwalk {

RecordedFrame try_blur_irradiance(int count) {
    Recorder recorder;
    BlurStage stage(count, &recorder);
    stage.begin();
    return recorder.listen(stage.cast, "blur_irradiance", [&] {
        blur_irradiance(stage.frame,
                        {stage.line, stage.irradiance, stage.stretch, stage.between, stage.pointers, stage.sum});
    });
}

}  // namespace lightwalk
