// Announcement of work that may take long.
#pragma once
#include <functional>
#include <string>

namespace lightwalk {

/// Listener, told before each step what is prepared: a module's path or a shader's file. On any thread; null: none.
std::function<void(const std::string&)>& on_preparing();

void announce(const std::string& what);

}  // namespace lightwalk
