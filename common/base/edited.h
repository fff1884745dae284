// Edits of shaders while a program runs.
#pragma once

namespace lightwalk {

/// A file of GLSL has changed: Exercises::version() is another number from now on, so that what was made once by a shader
/// (a table, a filtered cube, a shadow map) is made again.
void shaders_were_edited();

}  // namespace lightwalk
