// Units of length, and the factors between them.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace cd {

/// The names that `unit_factor` knows: m, cm, mm, km, in, ft.
[[nodiscard]] std::span<const std::string_view> unit_names();

/// What a length in `from` is multiplied by to be in `to`: the true ratio, rounded once. Nothing
/// when a name is unknown.
[[nodiscard]] std::optional<double> unit_factor(std::string_view from, std::string_view to);

/// What a length in units of so many metres is multiplied by to be in `to`. Nothing when the name
/// is unknown.
[[nodiscard]] std::optional<double> unit_factor_of_metres(double metres, std::string_view to);

} // namespace cd
