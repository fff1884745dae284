#include "common/window/lesson_pages.h"

#include <fstream>
#include <regex>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/window/event_log.h"

namespace lightwalk {

std::string LessonPages::open(const std::string& name) {
    // An exercise has a page that leads on to its heading: openers drop the part of an address behind the #.
    const bool exercise = name.size() > 2 && name[2] == '.';
    const std::filesystem::path pages = course_root() / "build" / "docs";
    const std::filesystem::path page = exercise ? pages / "open" / (name + ".html") : pages / (name + ".html");
    std::error_code error;
    if (!std::filesystem::is_regular_file(page, error)) {
        log_event("no page " + name);
        return std::filesystem::is_directory(pages, error)
                   ? "The lessons' pages have none of " + name + "; ./course docs rebuilds them."
                   : "The lessons' pages are not made yet: ./course docs makes them.";
    }
    page_ = page.string();
    try {
        opener_ = std::make_unique<ChildProcess>("xdg-open", std::vector{page_}, ChildProcess::Kind::detached);
    } catch (const Failure&) {
        log_event("no opener " + page_);
        return "There is no xdg-open to show it with; open " + page_;
    }
    log_event("lesson " + page_);
    return "opening the lesson of " + name;
}

std::string LessonPages::poll() {
    if (!opener_) return {};
    const std::optional<int> code = opener_->poll();
    if (!code) return {};
    opener_.reset();
    if (*code != 0) log_event("opener failed " + std::to_string(*code));
    return *code == 0 ? "" : "xdg-open found nothing to show it with; open " + page_;
}

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
