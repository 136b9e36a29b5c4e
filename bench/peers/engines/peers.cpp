#include "bench/peers/engines/peers.hpp"

#include <cstdio>

namespace cd::bench {

std::vector<std::string> add_peers([[maybe_unused]] std::vector<Engine>& engines) {
    std::vector<std::string> missing;
#ifdef CD_PEER_FCL
    add_fcl_double(engines);
    add_fcl_float(engines);
    add_fcl_obbrss(engines);
#else
    missing.emplace_back("FCL");
#endif
#ifdef CD_PEER_EMBREE
    add_embree(engines);
#else
    missing.emplace_back("Embree");
#endif
#ifdef CD_PEER_BULLET
    add_bullet(engines);
#else
    missing.emplace_back("Bullet");
#endif
#ifdef CD_PEER_ODE
    add_ode(engines);
#else
    missing.emplace_back("ODE");
#endif
#ifdef CD_PEER_CCD
    add_ccd(engines);
#else
    missing.emplace_back("libccd");
#endif
#ifdef CD_PEER_CGAL
    add_cgal(engines);
    add_cgal_meshes(engines);
#else
    missing.emplace_back("CGAL");
#endif
    for (const std::string& name : missing) {
        std::fprintf(
            stderr, "MISSING: %s was not installed at build time: no rows\n", name.c_str());
    }
    return missing;
}

} // namespace cd::bench
