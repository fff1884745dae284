// The whole program of a chapter.
#pragma once
#include "common/app/chapter.h"
#include "common/app/render.h"

namespace lightwalk {

/// Options, then a window, a picture, a study or a list. Returns the exit code.
int run_chapter(int argc, char** argv, const char* name, const MakeChapter& make);

}  // namespace lightwalk

#define CHAPTER(Type)                                                                                          \
    int main(int argc, char** argv) {                                                                          \
        return lightwalk::run_chapter(argc, argv, LIGHTWALK_CHAPTER, [] { return std::make_unique<Type>(); }); \
    }
