// The worlds that a film's scenes can show, by kind.
#pragma once
#include <functional>
#include <map>
#include <memory>

#include "common/app/world.h"

namespace lightwalk {

struct Music;

/// Makes a world with the owner's members. `heard`: the film's music; null: the scene's own.
using MakeWorld = std::function<std::unique_ptr<World>(Module& owner, Music* heard)>;
const std::map<std::string, MakeWorld>& film_worlds();

}  // namespace lightwalk
