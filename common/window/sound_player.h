// Sound beside the picture, where the machine has a sound device.
#pragma once
#include <memory>

#include "common/base/sound.h"

namespace lightwalk {

/// Plays a sound and is the picture's clock: the time is the number of samples played. The two cannot drift apart, at
/// any actual device rate or frame time.
class SoundPlayer {
  public:
    SoundPlayer();
    ~SoundPlayer();
    SoundPlayer(const SoundPlayer&) = delete;

    /// Once a frame, with the time of the frame before; returns the time of this one. While the clock runs that is the
    /// time of the sample that is heard now; without a device, or where it has stopped asking for samples, `since_last_s`
    /// later. A time other than the one returned last is a jump: sound follows. While the clock stands the device is
    /// silent. `sound` may be another one each time, or null; it must stay until the next call. The first call with one
    /// opens the device; where there is none, one line says so, and nothing is played.
    double advance(const Sound* sound, double time_s, bool clock_runs, double since_last_s);

  private:
    struct Device;
    std::unique_ptr<Device> device_;
    bool tried_ = false, ran_ = false;
    double given_s_ = 0;  ///< the time returned last
};

}  // namespace lightwalk
