// A mesh file of a job, and how it is read.
#pragma once

#include "client/import/imported_mesh.hpp"
#include "common/core/result.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

namespace cd {

class TomlFields;

struct BodySpec {
    std::filesystem::path path;
    std::string unit;    ///< Unit of coordinates; empty: the mesh file's, or else the job's.
    std::string name;    ///< If empty: in messages the file's name, in exports `export_name`.
    std::string up = {}; ///< "y": the file's y becomes z; "z" or empty: no turn.
    bool rounds_to_float = false; ///< Round coordinates to floats.
    /// The point of the mesh, in the job's unit and after `up`, that becomes its origin.
    std::array<double, 3> origin = {};
    /// The unit that the mesh file declares, if `unit` is empty; set when the file is read.
    std::string declared_unit = {};
};

/// Reads the keys mesh, unit, up, precision and origin of a body's table. `job` is the job file.
/// Throws a `Refusal`.
[[nodiscard]] BodySpec read_mesh(const TomlFields& fields, const std::filesystem::path& job);

/// Returns the options to import a body's file. Errors: BadInput for an unknown unit.
[[nodiscard]] Result<ImportOptions> import_options(const BodySpec& body,
                                                   const std::string& job_unit);

/// Returns the error BadInput "JOB:LINE: DETAIL", or "JOB: DETAIL" for line 0.
[[nodiscard]] Error
error_in_job(const std::filesystem::path& job, std::uint32_t line, const std::string& detail);

/// Returns a path that a job file names: relative paths start at the file's folder. "-" stands for
/// standard input and stays.
[[nodiscard]] std::filesystem::path beside(const std::filesystem::path& job,
                                           const std::string& path);

} // namespace cd
