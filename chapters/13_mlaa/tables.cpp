#include "13_mlaa/tables.h"

#include "13_mlaa/exercises.h"

namespace lightwalk {

std::vector<float> area_table() {
    const auto area_of = area.function();
    std::vector<float> table;
    for (int to_other = 1; to_other <= longest_reach; ++to_other)
        for (int to_end = 1; to_end <= longest_reach; ++to_end)
            table.push_back(area_of(to_end - 1, to_end + to_other - 1));
    return table;
}

std::vector<float> crossing_table() {
    const auto turn = [](int across) { return across == 1 ? -1.0f : across == 2 ? 1.0f : 0.0f; };
    std::vector<float> table;
    for (int at_other = 0; at_other < 4; ++at_other)
        for (int at_end = 0; at_end < 4; ++at_end) table.push_back(at_end == 3 ? -turn(at_other) : turn(at_end));
    return table;
}

}  // namespace lightwalk
