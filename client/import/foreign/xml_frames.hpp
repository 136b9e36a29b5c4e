// Units and axes of the mesh formats that are XML: COLLADA, AMF and 3MF.
#pragma once

#include "client/import/imported_mesh.hpp"

#include <filesystem>
#include <optional>
#include <string_view>

namespace cd {

/// Returns the frame of a COLLADA document; by default metres and Y up, as in COLLADA 1.4.1. The
/// text may be damaged.
[[nodiscard]] DeclaredFrame collada_frame(std::string_view text);

/// Returns the frame of an AMF document or a 3MF model; by default millimetres, as in both
/// standards; nothing for an unknown unit. The text may end anywhere after its first element.
[[nodiscard]] std::optional<DeclaredFrame> additive_frame(std::string_view text);

/// Returns the frame of a 3MF archive; nothing for an unknown unit, and for an archive that is
/// damaged or has no model.
[[nodiscard]] std::optional<DeclaredFrame> three_mf_frame(const std::filesystem::path& path);

} // namespace cd
