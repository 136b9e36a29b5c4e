#include "bench/peers/fcl_engine.hpp"
#include "bench/peers/peers.hpp"

namespace cd::bench {

void add_fcl_obbrss(std::vector<Engine>& engines) {
    engines.push_back(fcl_mesh_engine<fcl::OBBRSS<double>>("FCL OBBRSS double"));
}

} // namespace cd::bench
