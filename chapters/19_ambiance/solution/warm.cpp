#include <algorithm>

#include "19_ambiance/exercises.h"

namespace lightwalk::solution {

std::vector<int> warm(const std::vector<OnScreen>& scenes, double now_s, double ahead_s, int most) {
    std::vector<int> order;
    for (int i = 0; i < int(scenes.size()); ++i) order.push_back(i);
    const auto from = [&](int i) { return scenes[size_t(i)].from_s; };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return from(a) < from(b); });
    std::vector<int> ready;
    for (const int i : order)
        if (from(i) <= now_s && now_s < scenes[size_t(i)].to_s) ready.push_back(i);
    for (const int i : order)
        if (int(ready.size()) < most && from(i) > now_s && from(i) <= now_s + ahead_s) ready.push_back(i);
    return ready;
}

}  // namespace lightwalk::solution
