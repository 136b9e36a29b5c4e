#include "web/status/growth_text.hpp"

#include "common/core/words.hpp"
#include "web/status/table.hpp"

#include <nlohmann/json.hpp>

namespace cd {

std::string growth_text(const std::optional<Growth>& growth) {
    if (!growth) {
        return "";
    }
    const auto seconds = [](double time) { return cell_text(time, CellKind::Seconds); };
    const std::string now = seconds(growth->seconds);
    const GrowthPoint& worth = growth->worth;
    if (worth.workers == 0) {
        return "more workers: none would be used well; " + now + " are left, with 1 more " +
               seconds(growth->more.empty() ? growth->seconds : growth->more.front().seconds) +
               "\n";
    }
    return "more workers: " + std::to_string(worth.workers) +
           " more: " + fixed_text(growth->seconds / worth.seconds, 1) + " times as fast (" +
           seconds(worth.seconds) + " left instead of " + now + ")\n";
}

nlohmann::ordered_json growth_json(const std::optional<Growth>& growth) {
    if (!growth) {
        return nullptr;
    }
    const auto point = [&](const GrowthPoint& at) {
        return nlohmann::ordered_json{{"workers", at.workers},
                                      {"seconds", at.seconds},
                                      {"times", growth->seconds / at.seconds}};
    };
    nlohmann::ordered_json more = nlohmann::ordered_json::array();
    for (const GrowthPoint& at : growth->more) {
        more.push_back(point(at));
    }
    return {{"seconds", growth->seconds}, {"worth", point(growth->worth)}, {"more", more}};
}

} // namespace cd
