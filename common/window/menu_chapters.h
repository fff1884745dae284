// Chapters of the menu: programs, titles and pictures.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "common/gpu/gpu.h"
#include "common/window/menu_programs.h"

namespace lightwalk {

struct MenuEntry {
    std::string chapter, title;
    std::filesystem::path program;
    Image picture;  ///< none if nothing has been drawn yet
};

/// Chapters that are built or being built beside this program, in order. `scale`: of the display.
std::vector<MenuEntry> find_chapters(Gpu& gpu, float scale, const MenuPrograms& programs);

}  // namespace lightwalk
