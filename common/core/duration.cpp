#include "common/core/duration.hpp"

#include <charconv>
#include <cstdint>

namespace cd {

namespace {

constexpr std::uint64_t seconds_max = 100ull * 365 * 24 * 3600;

/// Returns the number of seconds in the unit s, m, h or d; 0 for any other letter.
std::uint64_t seconds_of(char unit) {
    switch (unit) {
    case 's':
        return 1;
    case 'm':
        return 60;
    case 'h':
        return 3600;
    case 'd':
        return 24 * 3600;
    default:
        return 0;
    }
}

} // namespace

Result<std::chrono::seconds> parse_duration(std::string_view text) {
    std::uint64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    const std::uint64_t unit = end - rest == 1 ? seconds_of(*rest) : 0;
    if (error != std::errc() || unit == 0 || number > seconds_max / unit) {
        return Error{ErrorCode::BadInput,
                     "'" + std::string(text) + "' is no duration: expected such as 30m, 24h or 7d"};
    }
    return std::chrono::seconds(number * unit);
}

} // namespace cd
