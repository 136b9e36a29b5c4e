// Writes VTK's XML format for surfaces (.vtp), which ParaView reads.
#pragma once

#include "client/formats/number_array.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/types.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// An array with a row of `columns` numbers for each point or cell. The name is plain ASCII.
struct VtpArray {
    std::string name;
    NumberArray numbers;
    unsigned columns = 1;
};

/// Texts that belong to the whole file.
struct VtpTexts {
    std::string name;
    std::vector<std::string> texts; ///< Written as UTF-8; other bytes and NUL become U+FFFD.
};

/// Cells of one kind: cell i has the points connectivity[ends[i - 1]] to connectivity[ends[i] - 1].
struct VtpCells {
    NumberArray connectivity;
    NumberArray ends;
};

/// A surface: points with arrays, and cells with arrays. The rows of a cell array are for the dots,
/// then the lines, then the triangles.
struct VtpData {
    NumberArray points; ///< Three numbers for each point.
    std::vector<VtpArray> point_arrays;
    VtpCells dots;
    VtpCells lines;
    VtpCells triangles;
    std::vector<VtpArray> cell_arrays; ///< The first one colours the surface when it is opened.
    std::vector<VtpTexts> texts;
};

/// Writes a surface, whole or not at all: XML with appended raw data and headers of 64 bits
/// (https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html). Errors: Io naming the
/// file; Interrupted.
[[nodiscard]] Status
write_vtp(const VtpData& data, const std::filesystem::path& path, const StopCheck& stop);

/// Returns cells of `size` points each: the points `first`, `first` + 1, ... in turn.
[[nodiscard]] VtpCells
consecutive_cells(std::uint64_t count, unsigned size, std::uint64_t first = 0);
/// Returns a mesh's triangles as cells. The mesh must outlive them.
[[nodiscard]] VtpCells triangle_cells(const Mesh& mesh);

/// Returns the coordinates of points, as `F4` or `F8`. The points must outlive the array.
[[nodiscard]] NumberArray coordinates(std::span<const Vec3> points, NpyType type);

/// The files that a series shows at one time.
struct VtpStep {
    std::uint64_t time = 0;
    std::vector<std::string> files; ///< Paths relative to the series, without special characters.
};

/// Returns the text of a series (.pvd).
[[nodiscard]] std::string pvd_text(std::span<const VtpStep> steps);

} // namespace cd
