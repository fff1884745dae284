// Model files that a test writes.
#pragma once
#include <unistd.h>

#include <functional>

#include "catch.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/scene/import.h"
#include "file_fixture.h"

namespace lightwalk {

inline Model model_of(const std::string& name, std::string_view bytes) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / fmt::format("lightwalk_import_text_{}", getpid());
    std::filesystem::create_directories(folder);
    write_file(folder / name, bytes);
    struct Remove {
        std::filesystem::path folder;
        ~Remove() { std::filesystem::remove_all(folder); }
    } remove{folder};
    return import_model(folder / name);
}

inline std::string error_of_model(const std::string& name, std::string_view bytes) {
    return refusal_of([&] { model_of(name, bytes); });
}

}  // namespace lightwalk
