// Names from outside, made fit for a file.
#pragma once
#include <string>

namespace lightwalk {

/// Bytes that the character at the beginning of `text` takes in UTF-8; 0 where it is none: cut off, overlong, a
/// surrogate, beyond U+10FFFF.
size_t utf8_length(std::string_view text);

}  // namespace lightwalk
