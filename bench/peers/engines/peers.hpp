// Third-party engines. Each is built where its library is installed.
#pragma once

#include "bench/peers/engines/engine.hpp"

#include <string>
#include <vector>

namespace cd::bench {

/// Appends every installed engine. Returns the names of the engines whose libraries were missing at
/// build time, with a line on stderr for each.
std::vector<std::string> add_peers(std::vector<Engine>& engines);

void add_fcl_double(std::vector<Engine>& engines);
void add_fcl_float(std::vector<Engine>& engines);
void add_bullet(std::vector<Engine>& engines);
void add_ode(std::vector<Engine>& engines);
void add_ccd(std::vector<Engine>& engines);
void add_cgal(std::vector<Engine>& engines);

// Engines for whole meshes only.
void add_fcl_obbrss(std::vector<Engine>& engines);
void add_cgal_meshes(std::vector<Engine>& engines);
void add_embree(std::vector<Engine>& engines);

} // namespace cd::bench
