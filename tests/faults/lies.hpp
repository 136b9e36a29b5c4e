// Workers that now and then return wrong results which are plausible by themselves: a fault of
// memory or code.
#pragma once

#include "common/core/id.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <set>
#include <tuple>

namespace cd::tests {

/// Records which wrong results were sent, and by whom.
class Lies {
  public:
    /// So few liars never lie about one scenario, so the scenario identifies the liar.
    static constexpr unsigned liars_max = 2;

    /// Returns what liar number `liar` on `host` sends instead of `truth`; always the same for one
    /// scenario.
    [[nodiscard]] Results told_by(std::uint64_t host, unsigned liar, const Results& truth);

    /// True if the host has sent a wrong result of the scenario.
    [[nodiscard]] bool is_told(std::uint64_t host, JobId job, std::uint64_t scenario) const {
        return told_.contains({job, scenario, host});
    }
    /// Returns the host that sent a wrong result of the scenario; 0 if none did.
    [[nodiscard]] std::uint64_t author_of(JobId job, std::uint64_t scenario) const;
    [[nodiscard]] bool is_liar(std::uint64_t host) const { return liars_.contains(host); }
    [[nodiscard]] std::uint64_t count() const { return told_.size(); }

  private:
    std::set<std::tuple<JobId, std::uint64_t, std::uint64_t>> told_;
    std::set<std::uint64_t> liars_; ///< Hosts that have sent any wrong result.
};

} // namespace cd::tests
