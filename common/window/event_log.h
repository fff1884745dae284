// A log of events on standard output, one line each, for tests and debugging. The window system's own are "key" for each one that goes down, "size W H", "minimised" and "restored".
#pragma once
#include <string>

namespace lightwalk {

/// Default: nothing is logged.
void log_events(bool on);

void log_event(const std::string& text);

/// Logs where the widget drawn last is, in window coordinates, when it has moved: "place NAME left top right bottom".
void log_place(const std::string& name);

/// Logs the panel's mouse state of this frame when it changes: "mouse x y buttons wheel", the position in window
/// coordinates, a bit for each pressed button, and the notches turned since the start.
void log_mouse();

/// Logs that a frame was drawn: "frame NUMBER", " keys" where some wait for the next one, " text" where a field has them,
/// " picture" where the picture, too, was drawn.
void log_frame(bool keys_wait, bool picture_is_new);

}  // namespace lightwalk
