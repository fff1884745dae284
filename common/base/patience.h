// Progress messages of long work.
#pragma once
#include <chrono>
#include <string>

namespace lightwalk {

/// Prints "drawing: 512 of 4096 samples" on stderr, after 3 s and then at most every 10 s.
class Patience {
  public:
    /// Activity and unit: "drawing", "samples".
    Patience(std::string what, std::string of) : what_(std::move(what)), of_(std::move(of)) {}
    ~Patience();
    Patience(const Patience&) = delete;
    void show(int done, int total);

  private:
    using Clock = std::chrono::steady_clock;
    const std::string what_, of_;
    Clock::time_point next_ = Clock::now() + std::chrono::seconds(3);
    bool drawn_ = false;
};

}  // namespace lightwalk
