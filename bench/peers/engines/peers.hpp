// The engines of others. Each function stands in a file of its own, which is built where its
// library is installed.
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

// Of whole meshes only.
void add_fcl_obbrss(std::vector<Engine>& engines);
void add_cgal_meshes(std::vector<Engine>& engines);
void add_embree(std::vector<Engine>& engines);

} // namespace cd::bench
