#include "common/scene/asset_path.h"

#include <algorithm>
#include <string>

namespace lightwalk {
namespace fs = std::filesystem;

fs::path resolve_file(std::string_view written, const fs::path& folder) {
    if (written.size() > 1 && written.front() == '"' && written.back() == '"')
        written = written.substr(1, written.size() - 2);
    std::string name(written);
    std::replace(name.begin(), name.end(), '\\', '/');
    if (name.size() > 2 && name[1] == ':' && name[2] == '/') name = fs::path(name).filename();
    return (folder / name).lexically_normal();
}

}  // namespace lightwalk
