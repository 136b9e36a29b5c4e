#include "proto/messages/cluster_options.hpp"

#include "common/core/limits/wire.hpp"

#include <iterator>

namespace cd {

namespace {

constexpr std::array<std::string_view, 3> mode_names{"auto", "always", "never"};

} // namespace

std::string_view to_text(AnalysisMode mode) {
    return mode_names[static_cast<std::size_t>(mode)];
}

std::optional<AnalysisMode> analysis_mode_from_text(std::string_view text) {
    const auto found = std::ranges::find(mode_names, text);
    return found == mode_names.end()
               ? std::nullopt
               : std::optional(static_cast<AnalysisMode>(found - mode_names.begin()));
}

std::span<const std::string_view> analysis_mode_names() {
    return mode_names;
}

const Strategy* find_strategy(std::string_view name) {
    const auto found = std::ranges::find(strategies, name, &Strategy::name);
    return found == strategies.end() ? nullptr : &*found;
}

std::vector<std::string_view> strategy_names() {
    std::vector<std::string_view> names;
    std::ranges::transform(strategies, std::back_inserter(names), &Strategy::name);
    return names;
}

bool is_strategy_name(std::string_view text) {
    return !text.empty() && text.size() <= limits::strategy_name_bytes_max &&
           text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == text.npos;
}

} // namespace cd
