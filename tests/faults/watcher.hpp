// What the outside knows of the master's promises, and whether they are kept.
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

/// The way of a message.
struct Route {
    std::uint64_t from = 0; ///< Hosts.
    std::uint64_t to = 0;
    std::uint64_t connection = 0;
};

struct DurableResult {
    Sha256 digest;
    WorkerProcess author = 0;
    bool is_witnessed = false; ///< It was compared with a right answer, or is one.
};

/// A job as the journal has it.
struct DurableJob {
    Bytes record;
    const KnownJob* known = nullptr;
    Bytes progress;
    Bytes end;
    std::vector<Bytes> groups;
    std::map<std::uint64_t, DurableResult> results; ///< Of the groups.
    ContactMapTotal map;
    std::set<std::uint64_t> failed; ///< Of these.
    std::set<std::uint64_t> borne;  ///< Wrong ones, of which the master could not know.

    [[nodiscard]] bool is_right(std::uint64_t scenario) const;
};

/// Looks at what the master writes and says. Each member returns what is wrong; empty: nothing.
class Watcher {
  public:
    [[nodiscard]] std::string committed(std::span<const DatabaseChange> changes);
    [[nodiscard]] std::string master_says(const Route& route, const Message& message);
    [[nodiscard]] std::string worker_says(const Route& route, const Message& message);
    /// Messages that came to the master: what it may know of its workers' blocks.
    [[nodiscard]] std::string master_hears(const Route& route, const Message& message);
    void master_began();
    /// The session that the master, in this life, gave the worker (its process) last; 0: none.
    [[nodiscard]] WorkerId session_of(std::uint64_t worker) const;
    /// The worker has said over its last connection what the master has not heard: that the block
    /// has gone, that it is wanted, or all that is there.
    [[nodiscard]] bool
    is_correction_under_way(std::uint64_t worker, TreeId tree, RootIndex root) const;
    /// The master has asked its journal to write that the job has ended.
    void ends(JobId job);

    [[nodiscard]] const std::map<JobId, DurableJob>& jobs() const { return jobs_; }
    [[nodiscard]] std::map<JobId, DurableJob>& jobs() { return jobs_; }
    [[nodiscard]] std::uint64_t scenarios_sent() const { return scenarios_sent_; }
    [[nodiscard]] std::uint64_t results_repeated() const { return results_repeated_; }
    [[nodiscard]] std::uint64_t recalled() const { return recalled_; }
    /// Workers of which the master has heard results.
    [[nodiscard]] std::size_t answering() const { return answering_.size(); }
    [[nodiscard]] std::uint64_t called_off() const { return called_off_; }
    /// Messages of a connection whose worker had greeted on another one,
    [[nodiscard]] std::uint64_t late_messages() const { return late_messages_; }
    /// results that the master took of a session before,
    [[nodiscard]] std::uint64_t late_results() const { return late_results_; }
    /// and greetings that would go on with a session of which it knew nothing any more.
    [[nodiscard]] std::uint64_t old_sessions() const { return old_sessions_; }
    [[nodiscard]] std::uint64_t corrected() const { return corrected_; }

    JobId last_job;
    Bytes alarms; ///< As the journal has them.
    Lies lies;
    /// The workers (their processes) that the master has in quarantine now.
    std::function<std::set<std::uint64_t>()> quarantine;

  private:
    using Key = std::pair<JobId, std::uint64_t>;
    [[nodiscard]] std::string add_group(JobId job, const Bytes& bytes);
    [[nodiscard]] std::string sent(JobId job, std::span<const std::uint64_t> scenarios);
    [[nodiscard]] std::string check_awaited(JobId job) const;
    void given_back(std::uint64_t worker, const Recalled& recalled);
    [[nodiscard]] std::string check_answers(std::uint64_t worker, const Results& results);
    [[nodiscard]] std::string check_kept(std::uint64_t worker, std::uint64_t sequence);
    [[nodiscard]] std::string check_sources(const FetchFromPeers& directions) const;
    // Workers that are now and then wrong (watcher_lies.cpp).
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
    std::map<Key, unsigned> times_sent_;                   ///< In all lives of the master.
    std::map<JobId, std::set<std::uint64_t>> done_before_; ///< This life of the master.
    /// Workers (their processes) that have results of the job in the journal, and of which the
    /// master, in this life, has not yet heard what else they bring;
    std::map<JobId, std::set<std::uint64_t>> awaited_;
    std::chrono::steady_clock::time_point awaited_until_; ///< for which it waits no longer.
    /// By worker (its process) and sequence.
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::vector<Key>> deliveries_;
    std::map<std::uint64_t, WorkerId> worker_ids_;           ///< By connection.
    std::map<std::uint64_t, Hello> hellos_;                  ///< The same, of workers.
    std::map<std::uint64_t, std::uint64_t> connections_;     ///< By worker, the last one.
    std::set<std::pair<std::uint64_t, TaskId>> tasks_given_; ///< In this life, to whom.
    std::uint64_t late_messages_ = 0;
    std::uint64_t late_results_ = 0;
    std::uint64_t old_sessions_ = 0;
    std::set<std::tuple<WorkerId, TreeId, RootIndex>> held_; ///< As the master was told.
    std::map<std::uint64_t, WorkerId> sessions_; ///< By worker (its process), this life.
    struct Corrections {
        std::uint64_t connection = 0;
        std::map<std::pair<TreeId, RootIndex>, std::size_t> blocks; ///< In how many messages.
        std::size_t standings = 0;
    };
    /// By worker (its process): what the master has not heard of its last connection.
    std::map<std::uint64_t, Corrections> corrections_;
    /// Of ranges, in the order of their places; by worker (its process).
    std::map<std::pair<std::uint64_t, TaskId>, std::vector<std::uint64_t>> ranges_;
    std::map<std::pair<std::uint64_t, TaskId>, std::set<std::uint64_t>> given_back_;
    /// Who told a lie that was compared with a right result,
    std::set<std::pair<JobId, std::uint64_t>> refuted_;
    /// and who was in quarantine when the job ended.
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
