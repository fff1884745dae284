// Chapter 18: the playground, an editor of everything. Its frame is Playground::frame() in playground.cpp, which knows no
// window; EditorWindow puts panels, the mouse and keys over it.
#include "18_playground/editor_window.h"
#include "common/window/run.h"

using namespace lightwalk;

CHAPTER(EditorWindow)
