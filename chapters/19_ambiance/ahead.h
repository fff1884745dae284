// Scenes of a film that a thread makes ready before they are shown.
#pragma once
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <semaphore>
#include <thread>
#include <vector>

#include "19_ambiance/part.h"
#include "common/base/shared_lock.h"

namespace lightwalk {

// [ahead]
/// Makes parts in the order asked for, one after the other, in turns with the thread that draws (common/base/shared_lock.h).
/// That thread alone calls these functions.
class Ahead {
  public:
    using Make = std::function<std::unique_ptr<FilmPart>(size_t place)>;
    explicit Ahead(Make make);
    ~Ahead();  ///< stops at the part's next file, shader or texture
    Ahead(const Ahead&) = delete;

    /// The parts to make from now on. Replaces earlier lists, but for the part in the making.
    void ask(const std::vector<size_t>& places);

    /// Parts that are ready. Rethrows what a maker threw.
    std::map<size_t, std::unique_ptr<FilmPart>> take();

    bool has(size_t place) const { return made_.contains(place); }
    bool is_making(size_t place) const { return making_ == place; }
    bool is_busy() const { return making_ || !asked_.empty(); }
    void wait();  ///< for the part in the making, or the next one
                  // [/ahead]

  private:
    void run();
    void wake();
    const Make make_;
    const SharedLock::InUse shared_;
    std::deque<size_t> asked_;
    std::optional<size_t> making_;
    std::map<size_t, std::unique_ptr<FilmPart>> made_;
    std::exception_ptr failed_;
    std::atomic<bool> stop_ = false;
    bool sleeps_ = false;
    std::counting_semaphore<> wake_{0}, done_{0};
    std::thread thread_;
};

}  // namespace lightwalk
