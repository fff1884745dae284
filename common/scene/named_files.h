// The files that a model file names.
#pragma once
#include <filesystem>
#include <string>

namespace lightwalk {

/// glTF and Collada name files by URIs, in which a space is %20 (RFC 3986, 2.1).
std::string decode_uri(std::string_view text);

/// What a reader of a model file has before it: the bytes of the file and, of a glTF file, those of the files that it names
/// by the key "uri", each once. Throws InputError where the file itself is none.
size_t bytes_to_import(const std::filesystem::path& path);

}  // namespace lightwalk
