// Chapter 18: the playground, an editor of everything.
#include "18_playground/editor_window.h"
#include "common/window/run.h"

using namespace lightwalk;

CHAPTER(EditorWindow)
