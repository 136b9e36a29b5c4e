// The first event of a run's motions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace cd {

/// What a motion leads to, in the time of its poses.
struct FirstEvent {
    /// Whether the bodies are nearer than the clearance, touch, or are free of each other.
    enum class Kind : std::uint8_t { Near, Contact, Free };

    Kind kind = Kind::Contact;
    std::uint64_t scenario = 0;
    double from = 0; ///< Not yet so, but perhaps in open parts of the time. Of Free: in contact.
    double to = 0;   ///< Proven to be so.
};

/// Replaces `first` by an event that is proven earlier.
void keep_first(const std::optional<FirstEvent>& event, std::optional<FirstEvent>& first);

/// Says when: "between t 2.5 and 5", "at t 10", "from t 27.5 on".
[[nodiscard]] std::string time_text(const FirstEvent& event);

/// Returns the line of the summary: "  first contact between t 2.5 and 5 in scenario 3" and a
/// newline. Empty without an event.
[[nodiscard]] std::string first_event_line(const std::optional<FirstEvent>& event);

} // namespace cd
