// A progress message during long work.
#pragma once
#include <chrono>
#include <string>

namespace lightwalk {

/// Says "drawing: 512 of 4096 samples" on stderr: nothing in the first 3 s, then at most every 10 s; on a terminal one
/// line that is drawn over, and gone at the end.
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
