// A worker's session with a master, from the Welcome to its end, over one or more connections.
#pragma once

#include "common/core/limits/wire.hpp"
#include "proto/channel/channel.hpp"
#include "worker/cache/subtree_cache.hpp"
#include "worker/execution/executor.hpp"
#include "worker/execution/scenario_clock.hpp"
#include "worker/execution/task.hpp"
#include "worker/execution/worker_job.hpp"
#include "worker/peers/fetcher.hpp"
#include "worker/peers/peer_links.hpp"
#include "worker/peers/peer_server.hpp"
#include "worker/session/traffic_book.hpp"
#include "worker/session/worker_keep.hpp"

#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace cd {

/// How a session, or its connection, ended.
enum class SessionEnd {
    Lost,       ///< The connection broke; another one may resume the session.
    Disagreed,  ///< Master and worker disagree on the state; a new session follows.
    Drained,    ///< All work is answered or returned.
    Terminated, ///< The master sent Terminate.
};

/// The parts of a session that exchange blocks with other workers.
struct PeerParts {
    std::shared_ptr<PeerServer> server; ///< Null: serves no blocks.
    PeerKey key;                        ///< From the Welcome.
    std::string name;                   ///< This worker's name, for the logs of peers.
    std::shared_ptr<const TlsSlot> tls = std::make_shared<TlsSlot>();
};

/// Heartbeat timing, as set by the master.
struct SessionTimes {
    std::chrono::milliseconds heartbeat = limits::heartbeat_period;
    /// Silence after which the worker considers its connection broken.
    std::chrono::milliseconds silent_after =
        limits::heartbeats_missed_max * std::chrono::milliseconds(limits::heartbeat_period);
    /// Silence after which the master reassigns the worker's tasks. Not below `silent_after`.
    std::chrono::milliseconds lost_after = limits::peer_lost_after;

    [[nodiscard]] static SessionTimes of(const Welcome& welcome);
};

/// Holds the trees, subtrees and tasks that one master has assigned. Outlives its connection:
/// threads keep computing, and the next connection finds the state unchanged. When the session
/// ends, subtrees and unacknowledged results move to `WorkerKeep`, and threads skip its remaining
/// work. All members run on the channel's thread.
class Session : public std::enable_shared_from_this<Session> {
  public:
    Session(std::shared_ptr<Channel> channel,
            Executor& executor,
            std::uint64_t cache_bytes,
            PeerParts peers = {},
            std::shared_ptr<WorkerKeep> keep = nullptr, ///< Null: no earlier session.
            const SessionTimes& times = {});
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    ~Session();

    /// Serves the master until the connection ends. Call it once. After Lost, call `resume` or
    /// `leave`.
    [[nodiscard]] asio::awaitable<SessionEnd> run();
    /// Resumes over another connection, after a Welcome with `is_resumed`.
    [[nodiscard]] asio::awaitable<SessionEnd> resume(std::shared_ptr<Channel> channel);
    /// Replaces the silence timeout of `SessionTimes`, from the next connection on.
    void bear_silence_for(std::chrono::milliseconds time) { times_.silent_after = time; }
    /// Whether the last connection ended by the silence timeout.
    [[nodiscard]] bool met_silence() const { return met_silence_; }
    /// Ends a session that has no connection.
    void leave();

    /// Drains: finishes and sends the running scenarios, and returns all others, including those
    /// still in transit. `run` returns Drained when the master has answered Drain and acknowledged
    /// all results. Without a connection, the drain starts on the next one.
    void stop();
    /// Stops and returns the running scenarios too. Call it after `stop`.
    void hand_back();
    /// Evicts the least recently used unpinned subtrees until the cache takes at most `bytes`, when
    /// the host needs memory. Returns the number of evicted subtrees.
    std::size_t let_go(std::uint64_t bytes);
    [[nodiscard]] const SubtreeCache& cache() const { return cache_; }
    [[nodiscard]] bool is_connected() const { return channel_->is_open(); }

    /// Whether any task has not ended.
    [[nodiscard]] bool has_tasks() const { return !tasks_.empty(); }
    /// Why the last connection or the session was lost, for logs.
    [[nodiscard]] const std::string& reason() const { return reason_; }

  private:
    using Token = Fetcher::Token;
    struct Place {
        TaskId task;
        std::size_t scenario = 0;
        /// Set by the thread that begins the scenario or by its return, whichever is first. Null
        /// before the scenario is submitted to a thread.
        std::shared_ptr<std::atomic<bool>> has_begun;
    };

    void take_up();
    void stand();
    asio::awaitable<SessionEnd> serve();
    // Coroutines hold `self`, because they may start after the session has ended.
    static asio::awaitable<void> send_heartbeats(std::shared_ptr<Session> self);
    [[nodiscard]] std::optional<RunningScenario> longest() const;
    void send_heartbeat();
    [[nodiscard]] std::uint64_t unanswered() const; ///< Unanswered scenarios of all tasks.
    static asio::awaitable<void> resume_when_sent(std::shared_ptr<Session> self);

    Status handle(Message& message);
    Status handle(AddTree& add);
    Status handle(RemoveTree& remove);
    Status handle(Subtrees& subtrees);
    Status handle(FetchFromPeers& directions);
    Status handle(AddJob& add);
    Status handle(RemoveJob& remove);
    Status handle(DropScenario& drop);
    Status handle(Batch& batch);
    Status handle(ScenarioRange& range);
    Status handle(Recall& recall);
    Status handle(Hint& hint);
    Status handle(ResultsKept& kept);
    Status handle(Drain& drain);
    Status handle(Terminate& terminate);
    Status handle(Heartbeat& heartbeat);
    Status handle(Failure& failure);
    template <class T>
    Status handle(T& message); ///< Refuses all other types.

    /// Decodes a block on a thread. `source` is the sender; 0 is the master.
    void open_soon(TreeId tree, SubtreeBlock block, WorkerId source);
    void block_opened(const SubtreeKey& key,
                      const Result<OpenedBlock>& opened,
                      const std::shared_ptr<const SubtreeBlock>& block,
                      WorkerId source);
    asio::awaitable<void> fetch_from_peers(std::shared_ptr<Session> self,
                                           FetchFromPeers directions);
    void serve_peers();
    /// Errors: BadFrame for an unknown job.
    [[nodiscard]] Result<std::shared_ptr<const WorkerJob>> find_job(TaskId task, JobId job) const;
    /// Adds the task. Null if its id exists already.
    Task* take_task(Task task);
    /// Queues a scenario with known roots until its subtrees and a thread are available.
    void wait_for_subtrees(const Task& task, std::size_t scenario);
    void scenario_ran(Token token, const std::optional<FinishedScenarios>& finished);
    void walked(TaskId task, Walked walked);
    [[nodiscard]] std::shared_ptr<ScenarioClock> new_clock(JobId job);
    void add_results(Task& task, const FinishedScenarios& finished);
    // ---- Scenarios that have not begun (session_recall.cpp) -----------------------------------
    /// Drops the scenarios that match `concerned` and have not begun. Returns the dropped ones.
    std::vector<Place> drop_unbegun(const std::function<bool(const Place&)>& concerned);
    void drop_unstarted(const std::function<bool(const Task&)>& concerned);
    void abandon(const std::function<bool(const Task&)>& concerned);
    void refuse(const Error& error);

    void settle_soon();
    void settle();
    void note_asked(const Fetcher::Step& step);
    void send_evicted();
    void send_held();
    /// Requests the upper trees that descents of the job need.
    void want_tops(const WorkerJob& job);
    [[nodiscard]] bool has_tops(const WorkerJob& job) const;
    void send_wants(const std::vector<SubtreeKey>& want);
    void start_ready();
    [[nodiscard]] bool start_next();
    void start(Token token);
    void start_walk(Task& task);
    /// The first task with scenarios for a descent, or null.
    [[nodiscard]] Task* next_to_walk();
    void flush_soon();
    void flush(Task& task);
    void flush_all();
    void end_finished_tasks();
    void end_when_drained();

    std::shared_ptr<Channel> channel_;
    Executor& executor_;
    std::shared_ptr<WorkerKeep> keep_;
    SubtreeCache cache_; ///< Moved from `keep_`, and back by `leave`.
    Fetcher fetcher_;
    PeerParts peers_;
    PeerLinks links_;
    std::map<TreeId, std::vector<RootIndex>> held_; ///< Blocks not yet reported in a Held.
    TrafficBook traffic_;
    std::uint64_t heartbeats_ = 0;
    std::map<JobId, std::shared_ptr<const WorkerJob>> jobs_;
    std::map<TaskId, Task> tasks_;
    std::map<Token, Place> places_; ///< Unanswered scenarios with known roots.
    std::deque<Token> ready_;       ///< Scenarios that only wait for a thread.
    std::size_t running_ = 0;       ///< Jobs submitted to the executor.
    Token next_token_ = 1;
    /// Clocks of the submitted jobs, which own them.
    std::list<std::weak_ptr<const ScenarioClock>> clocks_;
    SessionTimes times_;
    bool met_silence_ = false;
    std::shared_ptr<std::atomic<bool>> abandoned_; ///< Tells threads that the session is over.

    bool settling_ = false;
    bool waiting_for_queue_ = false;
    bool flushing_soon_ = false;
    bool stopping_ = false;             ///< Set by `stop`.
    bool draining_ = false;             ///< The master sends no more tasks.
    SessionEnd end_ = SessionEnd::Lost; ///< Lost until another reason is known.
    std::string reason_;
    asio::steady_timer heartbeat_timer_;
    asio::steady_timer flush_timer_;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

} // namespace cd
