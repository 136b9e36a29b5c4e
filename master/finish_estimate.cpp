#include "master/finish_estimate.hpp"

#include "common/core/limits.hpp"

#include <algorithm>

namespace cd {

FinishTerms estimate_finish(const WorkerPowers& worker, const ScenarioNeeds& needs) {
    FinishTerms terms;
    terms.backlog = 1e-9 * worker.backlog_ns / (worker.speed * worker.threads);
    // Blocks come one after the other: those it needs are among what is under way.
    terms.coming = std::min(static_cast<double>(needs.coming_bytes) / worker.bytes_per_second,
                            worker.transfers_seconds);
    terms.transfer = static_cast<double>(needs.missing_bytes) / worker.bytes_per_second;
    terms.blocks = static_cast<double>(needs.missing_blocks) * limits::block_seconds;
    if (needs.memory_bytes > worker.room_bytes) {
        const auto evicted = static_cast<double>(needs.memory_bytes - worker.room_bytes);
        terms.eviction = evicted * needs.bytes_of_memory / worker.bytes_per_second;
    }
    terms.work = 1e-9 * static_cast<double>(needs.cost_ns) / worker.speed;
    return terms;
}

} // namespace cd
