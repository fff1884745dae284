// Model files that a test writes.
#pragma once
#include "common/base/files.h"
#include "common/scene/import.h"
#include "file_fixture.h"

namespace lightwalk {

inline Model model_of(const std::string& name, std::string_view bytes) {
    const FileFolder folder;
    write_file(folder / name, bytes);
    return import_model(folder / name);
}

inline std::string error_of_model(const std::string& name, std::string_view bytes) {
    return refusal_of([&] { model_of(name, bytes); });
}

}  // namespace lightwalk
