#include "bench/peers/engines/fcl_engine.hpp"
#include "bench/peers/engines/peers.hpp"

namespace cd::bench {

void add_fcl_obbrss(std::vector<Engine>& engines) {
    engines.push_back(fcl_mesh_engine<fcl::OBBRSS<double>>("FCL OBBRSS double"));
}

} // namespace cd::bench
