#include "19_ambiance/ahead.h"

#include <algorithm>
#include <utility>

namespace lightwalk {

Ahead::Ahead(Make make) : make_(std::move(make)), thread_([this] { run(); }) {}

Ahead::~Ahead() {
    stop_ = true;
    wake();
    const SharedLock::Unlocked others;
    thread_.join();
}

void Ahead::ask(const std::vector<size_t>& places) {
    asked_.assign(places.begin(), places.end());
    std::erase_if(asked_, [&](size_t place) { return is_making(place) || made_.contains(place); });
    if (!asked_.empty()) wake();
}

void Ahead::wake() {
    if (std::exchange(sleeps_, false)) wake_.release();
}

std::map<size_t, std::unique_ptr<FilmPart>> Ahead::take() {
    if (failed_) std::rethrow_exception(std::exchange(failed_, nullptr));
    return std::exchange(made_, {});
}

void Ahead::wait() {
    const auto count = made_.size();
    while (is_busy() && made_.size() == count && !failed_) {
        const SharedLock::Unlocked others;
        done_.acquire();
    }
}

void Ahead::run() {
    SharedLock::stop_when(&stop_);
    SharedLock::lock();
    while (!stop_) {
        if (asked_.empty()) {
            sleeps_ = true;
            const SharedLock::Unlocked others;
            wake_.acquire();
            continue;
        }
        making_ = asked_.front();
        asked_.pop_front();
        try {
            made_[*making_] = make_(*making_);
        } catch (const SharedLock::Stopped&) {
            // Nobody waits for it.
        } catch (...) {
            failed_ = std::current_exception();
            asked_.clear();
        }
        making_.reset();
        done_.release();
    }
    SharedLock::unlock();
}

}  // namespace lightwalk
