// A log of events on standard output, one line each, for tests and debugging. The window system's own are "key" for each one that goes down, "size W H", "minimised" and "restored".
#pragma once
#include <string>

namespace lightwalk {

/// What is logged: "on", "layout" for widgets too, or nothing.
void log_events(const std::string& what);

void log_event(const std::string& text);

/// Logs where the widget drawn last is, in window coordinates, when it has moved: "place NAME left top right bottom".
/// `text`: what stands in it, if that could be too wide. With "layout" a frame whose widgets differ from those of
/// the frame before lists all of them: "layout COUNT", then lines of tabs, "NAME WINDOW", the four edges, the left and right
/// end of its window's room, the width and height of the text, and the text.
void log_place(const std::string& name, const std::string& text = "");

/// Ends a frame's list of widgets; log_frame() does.
void log_layout();

/// Logs the panel's mouse state of this frame when it changes: "mouse x y buttons wheel", the position in window
/// coordinates, a bit for each pressed button, and the notches turned since the start.
void log_mouse();

/// Logs that a frame was drawn: "frame NUMBER", " keys" where some wait for the next one, " text" where a field has them,
/// " picture" where the picture, too, was drawn.
void log_frame(bool keys_wait, bool picture_is_new);

}  // namespace lightwalk
