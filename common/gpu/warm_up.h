// Warm-up frames.
#pragma once

namespace lightwalk {

/// Scope in which this thread records frames that are not shown, so drawings also build pipelines needed later.
class WarmUp {
  public:
    WarmUp() { ++alive(); }
    ~WarmUp() { --alive(); }
    WarmUp(const WarmUp&) = delete;
    static bool is_recording() { return alive() > 0; }

  private:
    static int& alive() {
        static thread_local int count = 0;
        return count;
    }
};

}  // namespace lightwalk
