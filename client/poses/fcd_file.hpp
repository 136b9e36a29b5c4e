// Reads where the vehicles of SUMO are (floating car data, FCD).
#pragma once

#include "client/poses/traffic.hpp"
#include "client/spec/fcd_spec.hpp"
#include "common/core/result.hpp"

#include <istream>

namespace cd {

/// Reads the XML that `sumo --fcd-output` writes, in a stream: `timestep` elements with `vehicle`
/// elements in the root `fcd-export`. Persons, containers and unknown elements are passed over.
///
/// Errors: BadInput naming the line, for XML that is not well-formed, a document type (so that
/// there are no entities but XML's own), elements nested deeper than `limits::fcd_depth_max`, a
/// tag or comment of more than `limits::fcd_markup_bytes_max` bytes, and those of `TrafficBuilder`;
/// TooLarge if memory does not suffice; Io.
[[nodiscard]] Result<RoadTraffic> read_fcd_xml(std::istream& in, const FcdSpec& spec);

/// Reads SUMO's CSV of FCD, also what its script xml2csv.py makes: columns `timestep_time`,
/// `vehicle_id` and so on, or `time`, `id` and so on, separated by ';' or ','. Rows with one time
/// are a step, and follow each other. A row without an id has no vehicle. Other columns are not
/// read. Errors: BadInput naming the line, for a column that is missing or appears twice, a row of
/// another length, and those of `TrafficBuilder`; Io.
[[nodiscard]] Result<RoadTraffic> read_fcd_csv(std::istream& in, const FcdSpec& spec);

/// Reads a file by its ending, .xml or .csv. Errors: those of the readers, naming the file;
/// BadInput for a file that cannot be opened.
[[nodiscard]] Result<RoadTraffic> read_fcd_file(const FcdSpec& spec);

} // namespace cd
