// Icons of Font Awesome 4.7, which Overlay adds to its fonts where the package fonts-font-awesome is installed.
#pragma once
#include <string>

namespace lightwalk {

namespace icon {
inline constexpr const char *folder = "\uf07c", *undo = "\uf0e2", *redo = "\uf01e", *list = "\uf03a", *help = "\uf059",
                            *move = "\uf047", *turn = "\uf021", *scale = "\uf065", *world = "\uf0ac",
                            *object = "\uf1b2", *group = "\uf247", *sun = "\uf185", *lamp = "\uf0eb", *spot = "\uf192",
                            *scatter = "\uf074", *eye = "\uf06e", *hidden = "\uf070", *lock = "\uf023",
                            *camera = "\uf03d", *effects = "\uf0d0", *image = "\uf03e", *cloud = "\uf0c2",
                            *water = "\uf043", *fog = "\uf0c9", *terrain = "\uf1fe", *scene = "\uf0e8";
}  // namespace icon

bool has_icons();  ///< once there is an Overlay

/// "icon text", or the text alone where the font is not installed.
inline std::string with_icon(const char* icon, const std::string& text) {
    return has_icons() ? std::string(icon) + " " + text : text;
}

/// The icon alone, or the text.
inline const char* icon_or(const char* icon, const char* text) { return has_icons() ? icon : text; }

}  // namespace lightwalk
