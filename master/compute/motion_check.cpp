#include "master/compute/motion_check.hpp"

#include "common/job/run_motion.hpp"

#include <cmath>
#include <limits>

namespace cd {

const char* problem_of_motion(const JobMaterial& material,
                              const Scenario& scenario,
                              const ScenarioResult& result) {
    if (!result.motion) {
        return nullptr; // It failed.
    }
    const Query& query = material.query;
    const Result<Motion> motion = motion_of(scenario, query, radii_of(material.radii, scenario));
    if (!motion) {
        return "has an outcome of a motion that is none";
    }
    if (result.motion->until != query.motion->until ||
        result.motion->depth != motion.value().depth()) {
        return "has an outcome of another motion";
    }
    const double open_within =
        std::nextafter(query.motion->resolution + query.clearance.value_or(0),
                       std::numeric_limits<double>::infinity());
    const bool is_bound = result.motion->end == MotionEnd::Limit
                              ? std::isinf(result.distance_bound)
                              : result.distance_bound <= open_within;
    return result.kind != ScenarioClass::Undecided || is_bound
               ? nullptr
               : "has a bound that the resolution does not give";
}

} // namespace cd
