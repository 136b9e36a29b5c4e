#include "master/dispatch/range_choice.hpp"

#include <algorithm>

namespace cd {

bool prefers_ranges(const RangeCosts& costs) {
    const MissingCosts& missing = costs.missing;
    if (missing.all == 0 && costs.threads_workers > 0) {
        return true;
    }
    if (!missing.matched || !missing.any) {
        return false;
    }
    const double feeding =
        std::max(costs.matching, costs.analysis / std::max(costs.threads_master, 1.0));
    const double waiting = std::max(
        0.0, costs.threads_workers * feeding - costs.work - costs.analysis - *missing.matched);
    const double sending = costs.analysed_bytes * missing.of_byte;
    const double saved = costs.matching + waiting + sending;
    const double scenarios = static_cast<double>(costs.scenarios_left);
    double fetched = scenarios * std::max(0.0, *missing.any - *missing.matched);
    if (missing.all_fits) {
        fetched = std::min(fetched, missing.all);
    }
    return fetched < scenarios * saved;
}

} // namespace cd
