// Keys that are pressed and released between two frames.
#pragma once

struct GLFWwindow;

namespace lightwalk {

/// Dear ImGui before 1.87 reads key states once per frame and loses a key pressed and released within one: Return
/// held for 10 ms in a window that takes 100 ms per frame. From here on each key changes at most once per frame, and
/// later events wait, in order; text too. A modifier released in the frame in which its key was pressed is held until
/// a frame has seen both: Ctrl+A is not A. Later versions of Dear ImGui do the former themselves, not the latter.
/// Call it after Dear ImGui has installed its callbacks.
void hold_short_keys(GLFWwindow* window);

/// Releases the next queued input before a frame reads the keys.
void pass_short_keys();

/// A frame has read the keys. Before any others are noted.
void note_keys_were_read();

/// Whether a key waits for a later frame.
bool short_keys_wait();

}  // namespace lightwalk
