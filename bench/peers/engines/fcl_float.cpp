#include "bench/peers/engines/fcl_engine.hpp"
#include "bench/peers/engines/peers.hpp"

namespace cd::bench {

void add_fcl_float(std::vector<Engine>& engines) {
    engines.push_back(fcl_engine<float>("FCL OBB float"));
}

} // namespace cd::bench
