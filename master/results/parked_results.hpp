// Results that wait for the disk or for their job's geometry.
#pragma once

#include "common/core/id.hpp"
#include "master/base/instance_id.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace cd {

/// A message of results on its way into a job.
struct IncomingResults {
    std::shared_ptr<const Author> author;
    std::shared_ptr<const Results> message;
    /// The worker may send further messages.
    std::function<void()> done;
};

/// Results that wait hold up their worker only when they exceed the memory set aside for them.
class ParkedResults {
  public:
    explicit ParkedResults(std::uint64_t bytes_max) : bytes_max_(bytes_max) {}

    /// Parks a late message until its job can compare it. A copy of a parked message is dropped.
    void park(IncomingResults late);
    [[nodiscard]] bool has_any(JobId job) const;
    /// Removes all messages of the job.
    [[nodiscard]] std::vector<IncomingResults> take(JobId job);
    /// Removes all messages of a worker that has left.
    void forget(WorkerId worker);

    /// Counts a message that the caller keeps. Lets its worker go on while memory is left.
    void count(IncomingResults& kept);
    /// The caller keeps the message no longer.
    void uncount(const IncomingResults& kept);

  private:
    using Key = std::tuple<JobId, WorkerId, std::uint64_t>; ///< And sequence number.

    std::uint64_t bytes_max_;
    std::uint64_t bytes_ = 0;
    std::map<Key, IncomingResults> late_;
};

} // namespace cd
