// Text for people, a line at a time.
#pragma once
#include <cstdio>
#include <string>
#include <vector>

namespace lightwalk {

/// Appends a line as printf writes it, cut after 199 bytes.
template <class... Values>
void add_line(std::vector<std::string>& lines, const char* format, Values... values) {
    char text[200];
    std::snprintf(text, sizeof text, format, values...);
    lines.push_back(text);
}

}  // namespace lightwalk
