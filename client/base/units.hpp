// Units of length, and the factors between them.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace cd {

/// Returns the names that `unit_factor` knows: m, cm, mm, km, in, ft.
[[nodiscard]] std::span<const std::string_view> unit_names();

/// Returns the factor from the unit `from` to the unit `to`: the exact ratio, rounded once. Returns
/// nothing for an unknown name.
[[nodiscard]] std::optional<double> unit_factor(std::string_view from, std::string_view to);

/// Returns the factor from a unit of `metres` metres to the unit `to`; nothing if `to` is unknown.
[[nodiscard]] std::optional<double> unit_factor_of_metres(double metres, std::string_view to);

} // namespace cd
