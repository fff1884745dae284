// A glTF file that is being written.
#pragma once
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string>

namespace lightwalk {

struct GltfWriter {
    using json = nlohmann::ordered_json;

    std::filesystem::path target;
    json out;
    std::string bytes;                                   ///< of the buffer
    std::map<std::filesystem::path, std::string> files;  ///< images that are made here, beside the target
    std::set<std::string> extensions;

    /// Appends to a list of the file. Returns the place.
    int push(const char* list, json value) {
        out[list].push_back(std::move(value));
        return static_cast<int>(out[list].size()) - 1;
    }

    /// Bytes of the buffer as a view. `use`: the view's target, 0: none.
    int view(std::span<const std::byte> data, int use = 0) {
        while (bytes.size() % 4) bytes.push_back('\0');
        json own{{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", data.size()}};
        if (use) own["target"] = use;
        bytes.append(reinterpret_cast<const char*>(data.data()), data.size());
        return push("bufferViews", own);
    }
};

}  // namespace lightwalk
