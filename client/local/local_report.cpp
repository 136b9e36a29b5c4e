#include "client/local/local_report.hpp"

#include "common/core/words.hpp"

namespace cd {

RunReport report_of(const RunOutcome& outcome, const Query& query, unsigned threads) {
    RunReport report;
    report.summary = outcome.summary;
    report.query = query;
    report.digest = outcome.digest;
    report.execution.seconds = outcome.seconds;
    report.execution.statistics = outcome.statistics;
    report.execution.cost = outcome.cost;
    report.execution.where = counted(threads, "thread");
    return report;
}

} // namespace cd
