// A worker's session with a master, from the Welcome to its end, over one or more connections.
#pragma once

#include "worker/session/block_inbox.hpp"
#include "worker/session/carry_over.hpp"
#include "worker/session/session_hub.hpp"
#include "worker/session/session_link.hpp"
#include "worker/session/task_runner.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace cd {

/// Routes messages between the link to the master, the blocks and the tasks. A session outlives its
/// connection: threads keep computing, and the next connection finds the state unchanged. When the
/// session ends, subtrees and unacknowledged results move to `CarryOver`, and threads skip its
/// remaining work. All members run on the executor's home.
class Session : public SessionHub {
  public:
    Session(std::shared_ptr<Channel> channel,
            Executor& executor,
            std::shared_ptr<CarryOver> keep,
            PeerParts peers = {},
            const SessionTimes& times = {});

    /// Serves the master until the connection ends. Call it once. After Lost, call `resume` or
    /// `leave`.
    [[nodiscard]] asio::awaitable<SessionEnd> run();
    /// Resumes the session over another connection, after a Welcome with `is_resumed`.
    [[nodiscard]] asio::awaitable<SessionEnd> resume(std::shared_ptr<Channel> channel);
    /// Ends a session that has no connection.
    void leave();

    /// Drains: finishes and sends the running scenarios, and returns all others, including
    /// scenarios still in transit. `run` returns Drained when the master has answered Drain and
    /// acknowledged all results. Without a connection, the drain starts on the next one.
    void stop() { tasks_.stop(); }
    /// Stops the running scenarios and returns them, too. Requires an earlier call of `stop`.
    void hand_back() { tasks_.hand_back(); }
    /// Evicts the least recently used unpinned subtrees until the cache takes at most `bytes`, when
    /// the host needs memory. Returns the number of evicted subtrees.
    std::size_t let_go(std::uint64_t bytes) { return blocks_.let_go(bytes); }
    [[nodiscard]] SessionLink& link() { return link_; }
    [[nodiscard]] const SubtreeCache& cache() const { return blocks_.cache(); }
    [[nodiscard]] bool is_connected() const { return link_.is_open(); }
    /// Whether any task has not ended.
    [[nodiscard]] bool has_tasks() const { return tasks_.book().has_tasks(); }

  private:
    struct Router; ///< Passes each message of the master to the part that handles its type.

    asio::awaitable<SessionEnd> serve();
    void settle() override;
    void send_heartbeat();

    SessionLink link_;
    BlockInbox blocks_;
    TaskRunner tasks_;
    bool draining_ = false;        ///< True: the master sends no more tasks.
    std::uint64_t heartbeats_ = 0; ///< Number of heartbeats sent.
};

} // namespace cd
