// Titles of chapters.
#pragma once
#include <string>

namespace lightwalk {

/// The first heading of docs/NN_name.md without a leading "Chapter NN:"; where there is none, the name in words.
std::string chapter_title(const std::string& chapter);

}  // namespace lightwalk
