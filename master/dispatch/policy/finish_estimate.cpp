#include "master/dispatch/policy/finish_estimate.hpp"

#include "common/core/timing/master.hpp"

#include <algorithm>

namespace cd {

FinishTerms estimate_finish(const WorkerPowers& worker, const ScenarioNeeds& needs) {
    FinishTerms terms;
    terms.backlog = 1e-9 * worker.backlog_ns / (worker.speed * worker.threads);
    // All blocks under way arrive one after the other, and the scenario's blocks are among them.
    terms.coming = std::min(static_cast<double>(needs.coming_bytes) / worker.bytes_per_second,
                            worker.transfers_seconds);
    terms.transfer = static_cast<double>(needs.missing_bytes) / worker.bytes_per_second;
    terms.blocks = static_cast<double>(needs.missing_blocks) * timing::block_seconds;
    // Blocks that fit into the free room evict nothing.
    const double fitting = static_cast<double>(worker.room_bytes) * needs.bytes_of_memory;
    const auto missing = static_cast<double>(needs.missing_bytes);
    if (needs.bytes_of_memory > 0 && missing > fitting) {
        terms.eviction = (missing - fitting) / worker.bytes_per_second;
    }
    terms.work = 1e-9 * static_cast<double>(needs.cost_ns) / worker.speed;
    return terms;
}

} // namespace cd
