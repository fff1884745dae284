#include "common/scene/asset_path.h"

#include <strings.h>

#include <algorithm>
#include <string>

namespace lightwalk {
namespace fs = std::filesystem;

namespace {

// Case-insensitive match, as on other operating systems; the first in order.
fs::path in_other_capitals(const fs::path& file) {
    fs::path found;
    std::error_code error;
    for (fs::directory_iterator entry(file.parent_path(), error), end; !error && entry != end; entry.increment(error))
        if (strcasecmp(entry->path().filename().c_str(), file.filename().c_str()) == 0 &&
            (found.empty() || entry->path() < found))
            found = entry->path();
    return found;
}

}  // namespace

fs::path resolve_file(std::string_view written, const fs::path& folder) {
    if (written.size() > 1 && written.front() == '"' && written.back() == '"')
        written = written.substr(1, written.size() - 2);
    std::string name(written);
    std::replace(name.begin(), name.end(), '\\', '/');
    if (name.size() > 2 && name[1] == ':' && name[2] == '/') name = fs::path(name).filename();
    const fs::path file = (folder / name).lexically_normal();
    std::error_code error;
    if (fs::exists(file, error)) return file;
    for (const fs::path& near : {file, folder / file.filename()})  // moved next to the model
        if (const fs::path found = in_other_capitals(near); !found.empty()) return found;
    return file;
}

}  // namespace lightwalk
