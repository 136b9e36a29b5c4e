// The map of a job's contacts in files.
#pragma once

#include "client/export/result_writer.hpp"
#include "common/job/result/contact_map.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace cd {

/// With format csv map.csv, a row a triangle: the body's name, triangle, scenarios, part; with npz
/// map.npz with an array (K,2) named after each body, each row a triangle and its scenarios;
/// without either map.csv. Triangles ascend, and those in contact in no scenario have no row. Where
/// the map counts only the first N pairs of each scenario, both say so: the CSV's column is named
/// scenarios_of_first_N_pairs, and the NPZ has an array first_pairs that holds N.
/// Errors: Io naming the file.
[[nodiscard]] Status write_map_files(const ContactMap& map,
                                     const std::filesystem::path& dir,
                                     const std::vector<std::string>& formats,
                                     const ExportContext& context);

} // namespace cd
