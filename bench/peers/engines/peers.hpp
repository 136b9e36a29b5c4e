// Third-party engines. Each function has its own file, built where its library is installed.
#pragma once

#include "bench/peers/engines/engine.hpp"

#include <vector>

namespace cd::bench {

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
