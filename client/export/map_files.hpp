// Writes a job's contact map into files.
#pragma once

#include "client/export/result_writer.hpp"
#include "common/job/result/contact_map.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace cd {

/// Format csv gives map.csv with a row per triangle: the body's name, triangle, scenarios, part.
/// Format npz gives map.npz with an array (K,2) named after each body: triangle, scenarios. If
/// `formats` has neither, map.csv is written. Triangles ascend; those without contact have no row.
/// If the map counts only the first N pairs of each scenario, both files say so: the CSV's column
/// is named scenarios_of_first_N_pairs, and the NPZ has an array first_pairs that holds N. Errors:
/// Io naming the file.
[[nodiscard]] Status write_map_files(const ContactMap& map,
                                     const std::filesystem::path& dir,
                                     const std::vector<std::string>& formats,
                                     const ExportContext& context);

} // namespace cd
