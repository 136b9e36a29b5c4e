// The vehicles of a traffic simulation, as the job file describes them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace cd {

class TomlFields;

/// The key `fcd` of [poses]: the file in which SUMO wrote where its vehicles are (floating car
/// data), and the bodies that the vehicles have.
struct FcdSpec {
    std::filesystem::path path;
    /// The entry of [bodies] for each vehicle type. SUMO calls it `type` in the file: the id of a
    /// vType, not its vClass.
    std::map<std::string, std::string> types;
    double z = 0;                   ///< Height of vehicles without one, in the job's unit.
    double length_factor = 1;       ///< Factor from metres, SUMO's unit, to the job's.
    bool skips_other_types = false; ///< Vehicles whose type `types` does not name are left out.
    std::uint32_t line = 0;         ///< Line in the job file.
};

/// Reads the key `fcd` of a table. `job_unit` is the job's unit, `job_file` the job file. Throws a
/// `Refusal`.
[[nodiscard]] FcdSpec read_fcd_spec(const TomlFields& poses,
                                    const std::string& job_unit,
                                    const std::filesystem::path& job_file);

} // namespace cd
