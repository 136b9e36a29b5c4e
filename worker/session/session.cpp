#include "worker/session/session.hpp"

#include "common/core/host/log.hpp"
#include "proto/codec/codec.hpp"

#include <utility>

namespace cd {

struct Session::Router {
    Session& session;

    Status operator()(AddTree& add) { return session.blocks_.add_tree(add); }
    Status operator()(RemoveTree& remove) {
        session.tasks_.remove_jobs_of(remove.tree);
        session.blocks_.park_tree(remove.tree);
        return Done{};
    }
    Status operator()(Subtrees& subtrees) {
        session.blocks_.receive(std::move(subtrees));
        return Done{};
    }
    Status operator()(FetchFromPeers& directions) {
        session.blocks_.fetch(std::move(directions));
        return Done{};
    }
    Status operator()(Hint& hint) { return session.blocks_.hint(hint); }

    Status operator()(AddJob& add) { return session.tasks_.add_job(std::move(add)); }
    Status operator()(RemoveJob& remove) {
        session.tasks_.remove_job(remove.job);
        return Done{};
    }
    Status operator()(WorkUnit& unit) { return session.tasks_.add(std::move(unit)); }
    Status operator()(Recall& recall) {
        session.tasks_.recall(recall);
        return Done{};
    }
    Status operator()(DropScenario& drop) {
        session.tasks_.drop(drop);
        return Done{};
    }

    Status operator()(ResultsKept& kept) {
        session.link_.results_kept(kept.sequences);
        session.settle_soon(); // There may be room for more results, or the drain may be over.
        return Done{};
    }
    /// Handles the answer to this worker's own Drain, or the master's request to leave.
    Status operator()(Drain& /*drain*/) {
        log_debug("draining: the master sends no more tasks");
        session.draining_ = true;
        session.stop();
        session.settle_soon();
        return Done{};
    }
    Status operator()(Terminate& terminate) {
        log_info("terminated by the master: reason=\"{}\"", terminate.reason);
        session.link_.end(SessionEnd::Terminated, terminate.reason);
        return Done{};
    }
    Status operator()(Failure& failure) {
        session.link_.end(SessionEnd::Disagreed, "the master says: " + failure.detail);
        return Done{};
    }
    Status operator()(Heartbeat& /*heartbeat*/) { return Done{}; }
    /// Refuses messages of all other types.
    template <class T>
    Status operator()(T& message) {
        const std::uint16_t type = message_type(Message(std::move(message)));
        return Error{ErrorCode::BadFrame,
                     "message '" + std::string(message_name(type)) + "' is not for a worker"};
    }
};

Session::Session(std::shared_ptr<Channel> channel,
                 Executor& executor,
                 std::shared_ptr<CarryOver> keep,
                 PeerParts peers,
                 const SessionTimes& times)
    : SessionHub(executor),
      link_(*this,
            std::move(channel),
            keep,
            times,
            {[this](Message& message) { return std::visit(Router{*this}, message); },
             [this] { send_heartbeat(); }}),
      blocks_(*this, link_, keep, std::move(peers)),
      tasks_(*this, link_, blocks_, keep->computed) {}

asio::awaitable<SessionEnd> Session::run() {
    link_.begin(blocks_.cache().parked());
    blocks_.serve_peers();
    co_return co_await serve();
}

asio::awaitable<SessionEnd> Session::resume(std::shared_ptr<Channel> channel) {
    Inventory inventory;
    inventory.trees = blocks_.inventory();
    tasks_.book().add_to(inventory);
    link_.resume(std::move(channel), inventory);
    blocks_.ask_again();
    if (tasks_.is_stopping()) {
        link_.send(Drain{});
    }
    settle_soon();
    co_return co_await serve();
}

asio::awaitable<SessionEnd> Session::serve() {
    const std::shared_ptr<SessionHub> self = shared_from_this();
    const SessionEnd end = co_await link_.serve();
    if (end != SessionEnd::Lost) {
        leave();
    }
    co_return end;
}

/// Continuations that threads deliver after `leave` change nothing.
void Session::leave() {
    if (end_threads()) {
        tasks_.leave();
        blocks_.leave();
    }
}

void Session::settle() {
    if (over()->load() || link_.has_ended()) {
        return;
    }
    const bool have_tasks_ended = tasks_.settle(blocks_.settle());
    if (have_tasks_ended) {
        send_heartbeat(); // The master needs the final counts when a job ends.
    }
    // The session ends once the master has written the last results to disk.
    if (draining_ && !has_tasks() && !link_.has_unkept_results() && is_connected()) {
        link_.end(SessionEnd::Drained, {}, true);
    }
}

void Session::send_heartbeat() {
    link_.send(Heartbeat{++heartbeats_,
                         cache().bytes(),
                         tasks_.book().unanswered(),
                         blocks_.traffic(),
                         tasks_.longest()});
}

} // namespace cd
