// External files of model files.
#pragma once
#include <filesystem>
#include <string>

namespace lightwalk {

/// Decodes percent-encoded URIs (RFC 3986, 2.1), as used by glTF and Collada.
std::string decode_uri(std::string_view text);

/// Bytes of a model file and, for glTF, of the files it references. Throws InputError if the model file is missing.
size_t bytes_to_import(const std::filesystem::path& path);

}  // namespace lightwalk
