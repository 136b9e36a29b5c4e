#include "tests/faults/simulation.hpp"

#include <array>
#include <utility>

namespace cd::tests {

namespace {

using Count = std::uint64_t Outcome::*;

constexpr std::array<std::pair<const char*, Count>, 21> all_counts{{
    {"events", &Outcome::events},
    {"checks", &Outcome::checks},
    {"blocks_checked", &Outcome::blocks_checked},
    {"scenarios", &Outcome::scenarios},
    {"scenarios_sent", &Outcome::scenarios_sent},
    {"failed", &Outcome::failed},
    {"results_repeated", &Outcome::results_repeated},
    {"masters", &Outcome::masters},
    {"workers", &Outcome::workers},
    {"answering", &Outcome::answering},
    {"cancelled", &Outcome::cancelled},
    {"recalled", &Outcome::recalled},
    {"copies", &Outcome::copies},
    {"called_off", &Outcome::called_off},
    {"late_messages", &Outcome::late_messages},
    {"late_results", &Outcome::late_results},
    {"old_sessions", &Outcome::old_sessions},
    {"lies", &Outcome::lies},
    {"found_out", &Outcome::found_out},
    {"corrected", &Outcome::corrected},
    {"borne", &Outcome::borne},
}};

} // namespace

Outcome& Outcome::operator+=(const Outcome& other) {
    problems.insert(problems.end(), other.problems.begin(), other.problems.end());
    seconds += other.seconds;
    for (const auto& [name, count] : all_counts) {
        this->*count += other.*count;
    }
    troubles += other.troubles;
    return *this;
}

std::string Outcome::counts() const {
    std::string text;
    for (const auto& [name, count] : all_counts) {
        text += std::string(text.empty() ? "" : " ") + name + "=" + std::to_string(this->*count);
    }
    return text + " " + troubles.text();
}

} // namespace cd::tests
