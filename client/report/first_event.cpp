#include "client/report/first_event.hpp"

#include "common/core/words.hpp"

#include <array>
#include <cstddef>

namespace cd {

void keep_first(const std::optional<FirstEvent>& event, std::optional<FirstEvent>& first) {
    if (event && (!first || event->to < first->to)) {
        first = event;
    }
}

std::string time_text(const FirstEvent& event) {
    if (event.kind == FirstEvent::Kind::Free) {
        return "from t " + exact_text(event.to) + " on";
    }
    return event.from == event.to
               ? "at t " + exact_text(event.to)
               : "between t " + exact_text(event.from) + " and " + exact_text(event.to);
}

std::string first_event_line(const std::optional<FirstEvent>& event) {
    if (!event) {
        return {};
    }
    constexpr std::array<const char*, 3> titles{"near    ", "contact ", "free    "};
    return std::string("  first ") + titles[static_cast<std::size_t>(event->kind)] +
           time_text(*event) + " in scenario " + grouped(event->scenario) + "\n";
}

} // namespace cd
