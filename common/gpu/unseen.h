// Warm-up frames.
#pragma once

namespace lightwalk {

/// Scope in which this thread records frames that are not shown, so drawings also build pipelines needed later.
class Unseen {
  public:
    Unseen() { ++alive(); }
    ~Unseen() { --alive(); }
    Unseen(const Unseen&) = delete;
    static bool is_recorded() { return alive() > 0; }

  private:
    static int& alive() {
        static thread_local int count = 0;
        return count;
    }
};

}  // namespace lightwalk
