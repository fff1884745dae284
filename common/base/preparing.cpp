#include "common/base/preparing.h"

namespace lightwalk {

std::function<void(const std::string&)>& on_preparing() {
    static thread_local std::function<void(const std::string&)> listener;
    return listener;
}

void announce(const std::string& what) {
    if (on_preparing()) on_preparing()(what);
}

}  // namespace lightwalk
