#include "common/window/titles.h"

#include <fstream>
#include <regex>

#include "common/base/files.h"

namespace lightwalk {

std::string chapter_title(const std::string& chapter) {
    std::ifstream lesson(course_root() / "docs" / (chapter + ".md"));
    static const std::regex heading(R"(#\s+(?:[Cc]hapter\s+)?(?:\d+\s*[:.·–-]*\s*)?(.*\S)\s*)");
    std::smatch match;
    for (std::string line; std::getline(lesson, line);)
        if (std::regex_match(line, match, heading)) return match[1];
    std::string title = chapter.size() > 3 ? chapter.substr(3) : chapter;
    for (char& c : title)
        if (c == '_') c = ' ';
    if (!title.empty()) title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    return title;
}

}  // namespace lightwalk
