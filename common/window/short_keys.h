// Keys that are pressed and released between two frames.
#pragma once

struct GLFWwindow;

namespace lightwalk {

/// Dear ImGui before 1.87 reads the state of keys once per frame, so that a key pressed and released within one frame is
/// lost: Return held for 10 ms in a window that takes 100 ms per frame. From here on each key changes at most once per
/// frame, and what came after it waits, in order; text too. A modifier that is released within the frame in which its key
/// was pressed is held until a frame has seen both: Ctrl+A is no A. Later versions of Dear ImGui do the former themselves;
/// the latter is done here for them, too.
/// To be called after Dear ImGui has installed its callbacks.
void hold_short_keys(GLFWwindow* window);

/// Before a frame reads the keys: what may come next of what waits.
void pass_short_keys();

/// A frame has read the keys. Before any others are noted.
void note_keys_were_read();

/// Whether a key waits for a later frame.
bool short_keys_wait();

}  // namespace lightwalk
