// Pictures that are drawn ahead of time.
#pragma once

namespace lightwalk {

/// While one lives, this thread records pictures that nobody sees: drawings build the pipelines that later ones may need.
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
