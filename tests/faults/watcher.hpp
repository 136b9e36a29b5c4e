// Checks the master's promises from outside.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/id.hpp"
#include "common/job/result/contact_map.hpp"
#include "master/journal/journal_database.hpp"
#include "master/journal/result_group.hpp"
#include "proto/codec/message.hpp"
#include "tests/faults/jobs.hpp"
#include "tests/faults/lies.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace cd::tests {

/// Sender, receiver and connection of a message.
struct Route {
    std::uint64_t from = 0; ///< A host.
    std::uint64_t to = 0;
    std::uint64_t connection = 0;
};

struct DurableResult {
    Sha256 digest;
    InstanceId author = 0;
    bool is_witnessed = false; ///< It was compared with a right answer, or is one.
};

/// A job as recorded in the journal.
struct DurableJob {
    Bytes record;
    const KnownJob* known = nullptr;
    Bytes progress;
    Bytes end;
    std::vector<Bytes> groups;
    std::map<std::uint64_t, DurableResult> results; ///< Results in `groups` that count.
    std::set<std::uint64_t> withdrawn; ///< Scenarios that had a result of an exposed worker.
    ContactMapTotal map;
    std::set<std::uint64_t> failed; ///< Failed scenarios among `results`.
    std::set<std::uint64_t> borne;  ///< Wrong results that the master could not detect.

    [[nodiscard]] bool is_right(std::uint64_t scenario) const;
};

/// Checks the master's writes and messages. Members that return a string return the problem; empty
/// if none.
class Watcher {
  public:
    [[nodiscard]] std::string committed(std::span<const DatabaseChange> changes);
    [[nodiscard]] std::string master_says(const Route& route, const Message& message);
    [[nodiscard]] std::string worker_says(const Route& route, const Message& message);
    /// Notes a message that reached the master, and so what the master may know of workers' blocks.
    [[nodiscard]] std::string master_hears(const Route& route, const Message& message);
    void master_began();
    /// Returns the last session this master incarnation gave the worker instance; 0 if none.
    [[nodiscard]] WorkerId session_of(std::uint64_t worker) const;
    /// True if a message unread by the master, on the worker's last connection, says that the block
    /// is gone or wanted, or lists all blocks.
    [[nodiscard]] bool
    is_correction_under_way(std::uint64_t worker, TreeId tree, RootIndex root) const;
    /// Notes that the master asked its journal to record the job's end.
    void ends(JobId job);

    [[nodiscard]] const std::map<JobId, DurableJob>& jobs() const { return jobs_; }
    [[nodiscard]] std::map<JobId, DurableJob>& jobs() { return jobs_; }
    [[nodiscard]] std::uint64_t scenarios_sent() const { return scenarios_sent_; }
    [[nodiscard]] std::uint64_t results_repeated() const { return results_repeated_; }
    [[nodiscard]] std::uint64_t recalled() const { return recalled_; }
    /// Number of workers whose results reached the master.
    [[nodiscard]] std::size_t answering() const { return answering_.size(); }
    [[nodiscard]] std::uint64_t called_off() const { return called_off_; }
    /// Messages of a connection whose worker had greeted on another one.
    [[nodiscard]] std::uint64_t late_messages() const { return late_messages_; }
    /// Result messages of earlier sessions that the master accepted.
    [[nodiscard]] std::uint64_t late_results() const { return late_results_; }
    /// Greetings that tried to resume a session unknown to the master.
    [[nodiscard]] std::uint64_t old_sessions() const { return old_sessions_; }
    [[nodiscard]] std::uint64_t corrected() const { return corrected_; }

    JobId last_job;
    Bytes alarms; ///< As recorded in the journal.
    Lies lies;
    /// Returns the worker instances that are now in quarantine.
    std::function<std::set<std::uint64_t>()> quarantine;

  private:
    using Key = std::pair<JobId, std::uint64_t>;
    [[nodiscard]] std::string add_group(JobId job, const Bytes& bytes);
    void withdraw(DurableJob& job, InstanceId author);
    [[nodiscard]] std::string sent(JobId job, std::span<const std::uint64_t> scenarios);
    [[nodiscard]] std::string check_awaited(JobId job) const;
    void given_back(std::uint64_t worker, const Recalled& recalled);
    [[nodiscard]] std::string check_answers(std::uint64_t worker, const Results& results);
    [[nodiscard]] std::string check_kept(std::uint64_t worker, std::uint64_t sequence);
    [[nodiscard]] std::string check_sources(const FetchFromPeers& directions) const;
    // Checks of workers that now and then give wrong results (watcher_lies.cpp).
    void acknowledged(std::uint64_t worker, JobId job, std::uint64_t scenario);
    [[nodiscard]] std::string check_end(JobId id, DurableJob& job) const;
    [[nodiscard]] bool may_be_wrong(const DurableResult& result,
                                    std::uint64_t author,
                                    const std::set<std::uint64_t>& quarantined) const;
    [[nodiscard]] std::string welcomed(const Route& route, const Welcome& welcome);
    void note_held(WorkerId worker, const Message& message);
    void note_correction(const Route& route, const Message& message, bool is_heard);
    [[nodiscard]] std::string check_quarantined(const Route& route, const Message& message) const;

    std::map<JobId, DurableJob> jobs_;
    std::map<Key, unsigned> times_sent_;                   ///< Across master incarnations.
    std::map<JobId, std::set<std::uint64_t>> done_before_; ///< Results on disk when this master
                                                           ///< incarnation began.
    /// Worker instances with results of the job in the journal whose further results this master
    /// incarnation has not yet received.
    std::map<JobId, std::set<std::uint64_t>> awaited_;
    std::chrono::steady_clock::time_point awaited_until_; ///< End of the wait for `awaited_`.
    /// Scenarios by worker instance and sequence number.
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::vector<Key>> deliveries_;
    std::map<std::uint64_t, WorkerId> worker_ids_;           ///< By connection.
    std::map<std::uint64_t, Hello> hellos_;                  ///< Workers' greetings, by connection.
    std::map<std::uint64_t, std::uint64_t> connections_;     ///< Last connection of each worker.
    std::set<std::pair<std::uint64_t, TaskId>> tasks_given_; ///< Worker and task; this incarnation.
    std::uint64_t late_messages_ = 0;
    std::uint64_t late_results_ = 0;
    std::uint64_t old_sessions_ = 0;
    std::set<std::tuple<WorkerId, TreeId, RootIndex>> held_; ///< According to messages to the
                                                             ///< master.
    std::map<std::uint64_t, WorkerId> sessions_; ///< By worker instance; this incarnation.
    struct Corrections {
        std::uint64_t connection = 0;
        std::map<std::pair<TreeId, RootIndex>, std::size_t> blocks; ///< Number of messages about
                                                                    ///< each block.
        std::size_t standings = 0;
    };
    /// By worker instance: messages of its last connection that the master has not read.
    std::map<std::uint64_t, Corrections> corrections_;
    /// Scenarios of ranges in order of position, by worker instance and task.
    std::map<std::pair<std::uint64_t, TaskId>, std::vector<std::uint64_t>> ranges_;
    std::map<std::pair<std::uint64_t, TaskId>, std::set<std::uint64_t>> given_back_;
    /// Wrong results that were compared with a right one: job and worker.
    std::set<std::pair<JobId, std::uint64_t>> refuted_;
    /// Workers in quarantine when the job ended.
    std::map<JobId, std::set<std::uint64_t>> quarantined_at_end_;
    std::uint64_t corrected_ = 0;
    std::uint64_t scenarios_sent_ = 0;
    std::set<std::uint64_t> answering_;
    std::uint64_t recalled_ = 0;
    std::uint64_t called_off_ = 0;
    std::uint64_t results_repeated_ = 0;
};

[[nodiscard]] std::vector<std::uint64_t> scenarios_in(const Results& results);

} // namespace cd::tests
