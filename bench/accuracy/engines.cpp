#include "bench/accuracy/engines.hpp"

#include "bench/accuracy/ours.hpp"
#include "bench/peers/engines/peers.hpp"

#include <utility>

namespace cd::bench {

Engines all_engines() {
    Engines engines{our_engines(), {}};
#ifdef CD_PEER_FCL
    add_fcl_double(engines.all);
    add_fcl_float(engines.all);
#else
    engines.missing.emplace_back("FCL");
#endif
#ifdef CD_PEER_BULLET
    add_bullet(engines.all);
#else
    engines.missing.emplace_back("Bullet");
#endif
#ifdef CD_PEER_ODE
    add_ode(engines.all);
#else
    engines.missing.emplace_back("ODE");
#endif
#ifdef CD_PEER_CCD
    add_ccd(engines.all);
#else
    engines.missing.emplace_back("libccd");
#endif
#ifdef CD_PEER_CGAL
    add_cgal(engines.all);
#else
    engines.missing.emplace_back("CGAL");
#endif
    return engines;
}

} // namespace cd::bench
