// Announcement of work that may take long.
#pragma once
#include <functional>
#include <string>

namespace lightwalk {

/// This thread's listener, told before each step what is prepared: a module's path or a shader's file; null: none.
std::function<void(const std::string&)>& on_preparing();

void announce(const std::string& what);

}  // namespace lightwalk
