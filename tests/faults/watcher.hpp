// What the outside knows of the master's promises, and whether they are kept.
#pragma once

#include "common/core/hash.hpp"
#include "common/core/id.hpp"
#include "common/job/contact_map.hpp"
#include "master/journal_database.hpp"
#include "proto/message.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace cd::tests {

/// The way of a message.
struct Route {
    std::uint64_t from = 0; ///< Hosts.
    std::uint64_t to = 0;
    std::uint64_t connection = 0;
};

/// A job as the journal has it.
struct DurableJob {
    Bytes record;
    Bytes progress;
    Bytes end;
    std::vector<Bytes> groups;
    std::map<std::uint64_t, Sha256> results; ///< Of the groups.
    ContactMapTotal map;
    std::set<std::uint64_t> failed; ///< Of these.
};

/// Looks at what the master writes and says. Each member returns what is wrong; empty: nothing.
class Watcher {
  public:
    [[nodiscard]] std::string committed(std::span<const DatabaseChange> changes);
    [[nodiscard]] std::string master_says(const Route& route, const Message& message);
    [[nodiscard]] std::string worker_says(const Route& route, const Message& message);
    /// Messages that came to the master: what it may know of its workers' blocks.
    void master_hears(const Route& route, const Message& message);
    void master_began();

    [[nodiscard]] const std::map<JobId, DurableJob>& jobs() const { return jobs_; }
    [[nodiscard]] std::map<JobId, DurableJob>& jobs() { return jobs_; }
    [[nodiscard]] std::uint64_t scenarios_sent() const { return scenarios_sent_; }
    [[nodiscard]] std::uint64_t results_repeated() const { return results_repeated_; }
    [[nodiscard]] std::uint64_t recalled() const { return recalled_; }
    [[nodiscard]] std::uint64_t called_off() const { return called_off_; }

    JobId last_job;
    Bytes alarms; ///< As the journal has them.

  private:
    using Key = std::pair<JobId, std::uint64_t>;
    [[nodiscard]] std::string add_group(JobId job, const Bytes& bytes);
    [[nodiscard]] std::string sent(JobId job, std::span<const std::uint64_t> scenarios);
    void given_back(std::uint64_t worker, const Recalled& recalled);
    [[nodiscard]] std::string check_answers(std::uint64_t worker, const Results& results);
    [[nodiscard]] std::string check_kept(std::uint64_t worker, std::uint64_t sequence) const;
    [[nodiscard]] std::string check_sources(const FetchFromPeers& directions) const;

    std::map<JobId, DurableJob> jobs_;
    std::map<Key, unsigned> times_sent_;                   ///< In this life of the master.
    std::map<JobId, std::set<std::uint64_t>> done_before_; ///< This life.
    /// By worker (its process) and sequence.
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::vector<Key>> deliveries_;
    std::map<std::uint64_t, WorkerId> worker_ids_;           ///< By connection.
    std::set<std::tuple<WorkerId, TreeId, RootIndex>> held_; ///< As the master was told.
    /// Of ranges, in the order of their places; by worker (its process).
    std::map<std::pair<std::uint64_t, TaskId>, std::vector<std::uint64_t>> ranges_;
    std::map<std::pair<std::uint64_t, TaskId>, std::set<std::uint64_t>> given_back_;
    std::uint64_t scenarios_sent_ = 0;
    std::uint64_t recalled_ = 0;
    std::uint64_t called_off_ = 0;
    std::uint64_t results_repeated_ = 0;
};

[[nodiscard]] std::vector<std::uint64_t> scenarios_in(const Results& results);

} // namespace cd::tests
