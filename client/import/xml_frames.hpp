// Units and axes of the mesh formats that are XML: COLLADA, AMF and 3MF.
#pragma once

#include "client/import/declared_frame.hpp"

#include <filesystem>
#include <optional>
#include <string_view>

namespace cd {

/// Of a COLLADA document: metres and Y where it says nothing, as COLLADA 1.4.1 has it. The text may
/// be damaged.
[[nodiscard]] DeclaredFrame collada_frame(std::string_view text);

/// Of an AMF document, or a 3MF's model: millimetres where it says nothing, as both standards have
/// it. Nothing where the unit is not known. The text may end anywhere behind its first element.
[[nodiscard]] std::optional<DeclaredFrame> additive_frame(std::string_view text);

/// Of a 3MF archive. Nothing where it is damaged, or has no model.
[[nodiscard]] std::optional<DeclaredFrame> three_mf_frame(const std::filesystem::path& path);

} // namespace cd
