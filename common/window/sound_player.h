// Sound beside the picture, where the machine has a sound device.
#pragma once
#include <memory>

#include "common/base/sound.h"

namespace lightwalk {

/// Plays a sound so that the sample of the chapter's time is heard. The picture's clock leads: while it stands the
/// device is silent, and where it has jumped, sound follows.
class SoundPlayer {
  public:
    SoundPlayer();
    ~SoundPlayer();
    SoundPlayer(const SoundPlayer&) = delete;

    /// Once a frame. `sound` may be another one each time, or null; it must stay until the next call. The first call
    /// with one opens the device; where there is none, one line says so, and nothing is played.
    void follow(const Sound* sound, double time_s, bool clock_runs);

  private:
    struct Device;
    std::unique_ptr<Device> device_;
    bool tried_ = false;
};

}  // namespace lightwalk
