#include "common/base/patience.h"

#include <unistd.h>

#include <cstdio>

namespace lightwalk {

void Patience::show(int done, int total) {
    if (done >= total || Clock::now() < next_) return;
    drawn_ = isatty(STDERR_FILENO);
    std::fprintf(stderr, "%s%s: %d of %d %s%s", drawn_ ? "\r\033[K" : "", what_.c_str(), done, total, of_.c_str(),
                 drawn_ ? "" : "\n");
    next_ = Clock::now() + (drawn_ ? std::chrono::milliseconds(200) : std::chrono::seconds(10));
}

Patience::~Patience() {
    if (drawn_) std::fputs("\r\033[K", stderr);
}

}  // namespace lightwalk
