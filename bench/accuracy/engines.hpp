// Every engine of this build.
#pragma once

#include "bench/peers/engines/engine.hpp"

#include <string>
#include <vector>

namespace cd::bench {

struct Engines {
    std::vector<Engine> all;          ///< Our engines first.
    std::vector<std::string> missing; ///< Peers whose libraries were not installed at build time.
};

[[nodiscard]] Engines all_engines();

} // namespace cd::bench
