// Workers whose results are now and then wrong, in a way that nobody sees who looks at one of them
// alone: a fault of memory or code.
#pragma once

#include "common/core/id.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <set>
#include <tuple>

namespace cd::tests {

/// What was told wrongly, and by whom.
class Lies {
  public:
    /// No two of so many are wrong about the same scenario, so that who tells a lie is known by it.
    static constexpr unsigned liars_max = 2;

    /// What the host says instead of this, being the liar of that number; of a scenario always the
    /// same.
    [[nodiscard]] Results told_by(std::uint64_t host, unsigned liar, const Results& truth);

    /// It has told a wrong result of the scenario.
    [[nodiscard]] bool is_told(std::uint64_t host, JobId job, std::uint64_t scenario) const {
        return told_.contains({job, scenario, host});
    }
    /// Who has; 0: nobody.
    [[nodiscard]] std::uint64_t author_of(JobId job, std::uint64_t scenario) const;
    [[nodiscard]] bool is_liar(std::uint64_t host) const { return liars_.contains(host); }
    [[nodiscard]] std::uint64_t count() const { return told_.size(); }

  private:
    std::set<std::tuple<JobId, std::uint64_t, std::uint64_t>> told_;
    std::set<std::uint64_t> liars_; ///< Who has told any.
};

} // namespace cd::tests
