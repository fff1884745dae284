// Chapter 19: a film of all chapters, with music, that can be set to any time. Its frame is Ambiance::frame() in
// ambiance.cpp, which knows no window; FilmWindow puts the timeline over it.
#include "19_ambiance/film_window.h"
#include "common/window/run.h"

using namespace lightwalk;

CHAPTER(FilmWindow)
