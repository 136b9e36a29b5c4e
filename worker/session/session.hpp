// One connection to a master, from the welcome to its end.
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

/// How a session ended, and what its worker does next.
enum class SessionEnd {
    Lost,       ///< Of the connection: the session may go on over another one.
    Disagreed,  ///< About what the worker has: another session sets it right.
    Drained,    ///< All that was here is answered or handed back.
    Terminated, ///< The master said so.
};

/// What a session needs to give blocks to other workers and to take them from these.
struct PeerParts {
    std::shared_ptr<PeerServer> server; ///< Null: others get nothing here.
    PeerKey key;                        ///< From the welcome.
    std::string name;                   ///< Of this worker, for the others' logs.
    std::shared_ptr<const TlsSlot> tls = std::make_shared<TlsSlot>();
};

/// What the master says about heartbeats.
struct SessionTimes {
    std::chrono::milliseconds heartbeat = limits::heartbeat_period;
    /// A connection on which nothing came for so long is taken for broken.
    std::chrono::milliseconds silent_after =
        limits::heartbeats_missed_max * std::chrono::milliseconds(limits::heartbeat_period);
    /// After such a silence of this worker its work goes to others. Not below `silent_after`.
    std::chrono::milliseconds lost_after = limits::peer_lost_after;

    [[nodiscard]] static SessionTimes of(const Welcome& welcome);
};

/// Holds what one master has given to this worker: trees, subtrees, tasks. It outlives its
/// connection: threads go on, and all is as it was when another connection comes. Subtrees, and
/// results that are not acknowledged, stay with the worker when the session ends; threads that
/// still run for it are told to skip the rest. All members run on the channel's thread.
class Session : public std::enable_shared_from_this<Session> {
  public:
    Session(std::shared_ptr<Channel> channel,
            Executor& executor,
            std::uint64_t cache_bytes,
            PeerParts peers = {},
            std::shared_ptr<WorkerKeep> keep = nullptr, ///< Null: nothing comes from before.
            const SessionTimes& times = {});
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    ~Session();

    /// Serves the master until the connection ends. Called once. Lost: either `resume` or `leave`
    /// follows.
    [[nodiscard]] asio::awaitable<SessionEnd> run();
    /// Goes on over another connection, on which the master has said that it does, too.
    [[nodiscard]] asio::awaitable<SessionEnd> resume(std::shared_ptr<Channel> channel);
    /// From the next connection on; instead of the time that the master's heartbeats suggest.
    void bear_silence_for(std::chrono::milliseconds time) { times_.silent_after = time; }
    /// The last connection ended because nothing came.
    [[nodiscard]] bool met_silence() const { return met_silence_; }
    /// Ends a session that has no connection.
    void leave();

    /// Takes no more and begins nothing more; what runs is finished and sent, the rest of each task
    /// handed back, as is what is still on its way here. When the master has said that nothing more
    /// is, and has all results for good, `run` returns Drained. Before `run`, or in a session that
    /// has no connection, it holds for the next one.
    void stop();
    /// After `stop`: what runs is not finished, either, but handed back.
    void hand_back();
    /// The host needs memory: of the subtrees that nothing here waits for or uses, those leave that
    /// went unused for longest, until all together take no more. How many.
    std::size_t let_go(std::uint64_t bytes);
    /// What is here now.
    [[nodiscard]] const SubtreeCache& cache() const { return cache_; }
    /// Over which it goes on, until it is closed.
    [[nodiscard]] bool is_connected() const { return channel_->is_open(); }

    /// There are tasks that the master has not heard the end of.
    [[nodiscard]] bool has_tasks() const { return !tasks_.empty(); }
    /// Why the session was lost.
    [[nodiscard]] const std::string& reason() const { return reason_; }

  private:
    using Token = Fetcher::Token;
    struct Place {
        TaskId task;
        std::size_t scenario = 0;
        /// Of one at the threads: whoever sets it first begins the scenario, or gives it back.
        std::shared_ptr<std::atomic<bool>> has_begun;
    };

    void take_up();
    void stand();
    asio::awaitable<SessionEnd> serve();
    // These begin some time after they were spawned, and the session may have ended by then.
    static asio::awaitable<void> send_heartbeats(std::shared_ptr<Session> self);
    [[nodiscard]] std::optional<RunningScenario> longest() const;
    void send_heartbeat();
    [[nodiscard]] std::uint64_t unanswered() const; ///< Scenarios of all tasks.
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
    Status handle(T& message); ///< All others.

    /// Whoever gave a block; 0 is the master.
    void open_soon(TreeId tree, SubtreeBlock block, WorkerId source);
    void block_opened(const SubtreeKey& key,
                      const Result<OpenedBlock>& opened,
                      const std::shared_ptr<const SubtreeBlock>& block,
                      WorkerId source);
    asio::awaitable<void> fetch_from_peers(std::shared_ptr<Session> self,
                                           FetchFromPeers directions);
    void serve_peers();
    /// Errors: BadFrame for a job that is not here.
    [[nodiscard]] Result<std::shared_ptr<const WorkerJob>> find_job(TaskId task, JobId job) const;
    /// Null when a task of that number is here.
    Task* take_task(Task task);
    /// A scenario whose roots are known joins those that wait for subtrees, or for a thread.
    void wait_for_subtrees(const Task& task, std::size_t scenario);
    void scenario_ran(Token token, const std::optional<FinishedScenarios>& finished);
    void walked(TaskId task, Walked walked);
    [[nodiscard]] std::shared_ptr<ScenarioClock> new_clock(JobId job);
    void add_results(Task& task, const FinishedScenarios& finished);
    // What has not begun (session_recall.cpp).
    /// Scenarios of which `concerned` is true go, unless they have begun. Those that went.
    std::vector<Place> drop_unbegun(const std::function<bool(const Place&)>& concerned);
    void drop_unstarted(const std::function<bool(const Task&)>& concerned);
    void abandon(const std::function<bool(const Task&)>& concerned);
    void refuse(const Error& error);

    void settle_soon();
    void settle();
    void note_asked(const Fetcher::Step& step);
    void send_evicted();
    void send_held();
    /// What a walk down the job's trees needs.
    void want_tops(const WorkerJob& job);
    [[nodiscard]] bool has_tops(const WorkerJob& job) const;
    void send_wants(const std::vector<SubtreeKey>& want);
    void start_ready();
    [[nodiscard]] bool start_next();
    void start(Token token);
    void start_walk(Task& task);
    /// Null when none has anything to be walked.
    [[nodiscard]] Task* next_to_walk();
    void flush_soon();
    void flush(Task& task);
    void flush_all();
    void end_finished_tasks();
    void end_when_drained();

    std::shared_ptr<Channel> channel_;
    Executor& executor_;
    std::shared_ptr<WorkerKeep> keep_;
    SubtreeCache cache_; ///< Taken from `keep_`, and given back.
    Fetcher fetcher_;
    PeerParts peers_;
    PeerLinks links_;
    std::map<TreeId, std::vector<RootIndex>> held_; ///< Filled since the master was told.
    TrafficBook traffic_;
    std::uint64_t heartbeats_ = 0;
    std::map<JobId, std::shared_ptr<const WorkerJob>> jobs_;
    std::map<TaskId, Task> tasks_;
    std::map<Token, Place> places_; ///< Of each scenario not yet answered, but those to be walked.
    std::deque<Token> ready_;       ///< Have their subtrees, wait for a thread.
    std::size_t running_ = 0;       ///< At the threads.
    Token next_token_ = 1;
    /// Of what is at the threads; gone with it.
    std::list<std::weak_ptr<const ScenarioClock>> clocks_;
    SessionTimes times_;
    bool met_silence_ = false;
    std::shared_ptr<std::atomic<bool>> abandoned_; ///< Threads skip what nobody waits for.

    bool settling_ = false;
    bool waiting_for_queue_ = false;
    bool flushing_soon_ = false;
    bool stopping_ = false;             ///< This host wants to end.
    bool draining_ = false;             ///< No more comes: the session ends when the last task has.
    SessionEnd end_ = SessionEnd::Lost; ///< As far as is known.
    std::string reason_;
    asio::steady_timer heartbeat_timer_;
    asio::steady_timer flush_timer_;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

} // namespace cd
