// Result messages that wait for the disk or for their job's geometry.
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

/// A result message from its receipt until it is merged or dropped.
struct IncomingResults {
    std::shared_ptr<const Author> author;
    std::shared_ptr<const Results> message;
    /// Call to let the worker send further messages.
    std::function<void()> done;
    /// True if the message came before, so that its times and traffic are measured already.
    bool is_repeated = false;
};

/// Keeps waiting messages. Their workers may send more while the messages take at most `bytes_max`
/// bytes together; the worker of a message beyond that waits with it.
class ParkedResults {
  public:
    explicit ParkedResults(std::uint64_t bytes_max) : bytes_max_(bytes_max) {}

    /// Keeps a late message until `take` removes it. Drops a message that is parked already.
    void park(IncomingResults late);
    [[nodiscard]] bool has_any(JobId job) const;
    /// Removes and returns all parked messages of the job.
    [[nodiscard]] std::vector<IncomingResults> take(JobId job);
    /// Removes all messages of a worker that has left.
    void forget(WorkerId worker);

    /// Counts the memory of a message that the caller keeps, and calls `done` if memory is left.
    void count(IncomingResults& kept);
    /// Subtracts the memory of a message that was passed to `count`.
    void uncount(const IncomingResults& kept);

  private:
    using Key = std::tuple<JobId, WorkerId, std::uint64_t>; ///< Last: `Results::sequence`.

    std::uint64_t bytes_max_;
    std::uint64_t bytes_ = 0;
    std::map<Key, IncomingResults> late_;
};

} // namespace cd
