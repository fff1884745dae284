// Choice by device between two ways to the same picture: measured once, then kept on disk.
#pragma once
#include "common/app/chapter.h"

namespace lightwalk {

struct DeviceChoice {
    std::string knob;   ///< its path
    std::string value;  ///< the fastest here
    std::string line;   ///< both times
};

/// Sets the defaults of the choices `shaded`, and of a packed G-buffer's lights, that neither the command line nor the
/// scene has set. `device` names what
/// is kept, `measure` gives the milliseconds of a small picture with the knobs as they are. The first value stays
/// unless another takes less than 0.9 of its time.
std::vector<DeviceChoice> choose_by_device(const KnobList& knobs, const std::string& device,
                                           const std::function<double()>& measure);

/// The same for a loaded chapter: a picture of 480 by 270 pixels. None on a software device, where both ways take as
/// long, so that tests and pictures depend on no measurement.
std::vector<DeviceChoice> choose_by_device(Chapter& chapter, Gpu& gpu);

}  // namespace lightwalk
