#include "client/base/units.hpp"

#include <array>
#include <cstddef>

namespace cd {

namespace {

constexpr std::array<std::string_view, 6> names{"m", "cm", "mm", "km", "in", "ft"};
/// Sizes in tenths of a millimetre are integers, so a ratio of two is rounded only once.
constexpr std::array<double, 6> tenths_of_mm{10'000, 100, 10, 10'000'000, 254, 3'048};

std::optional<double> size_of(std::string_view name) {
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] == name) {
            return tenths_of_mm[i];
        }
    }
    return std::nullopt;
}

} // namespace

std::span<const std::string_view> unit_names() {
    return names;
}

std::optional<double> unit_factor(std::string_view from, std::string_view to) {
    const auto from_size = size_of(from);
    const auto to_size = size_of(to);
    if (!from_size || !to_size) {
        return std::nullopt;
    }
    return *from_size / *to_size;
}

std::optional<double> unit_factor_of_metres(double metres, std::string_view to) {
    constexpr double tenths_of_mm_in_metre = 10'000;
    const auto to_size = size_of(to);
    if (!to_size) {
        return std::nullopt;
    }
    return metres * tenths_of_mm_in_metre / *to_size;
}

} // namespace cd
