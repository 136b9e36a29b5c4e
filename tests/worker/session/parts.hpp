// Surroundings of a part of a session in its tests: a hub, and a master that records its messages.
#pragma once

#include "tests/worker/session_stage.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace cd::tests {

class TestHub : public SessionHub {
  public:
    using SessionHub::end_threads;
    using SessionHub::SessionHub;
    void settle() override {
        ++settled;
        on_settle();
    }

    std::function<void()> on_settle = [] {};
    std::size_t settled = 0;
};

struct RecordingMaster : MasterLink {
    void send(const Message& message) override { sent.push_back(message); }
    void send_results(Results of_one) override { sent.emplace_back(std::move(of_one)); }
    bool takes_results() override { return has_room; }
    void refuse(const Error& error) override { refused.push_back(error.detail); }
    [[nodiscard]] bool is_open() const override { return true; }
    [[nodiscard]] bool is_within_host() const override { return is_local; }

    /// Returns the messages of one type, in order.
    template <class T>
    [[nodiscard]] std::vector<T> all() const {
        std::vector<T> found;
        for (const Message& message : sent) {
            if (const T* one = std::get_if<T>(&message)) {
                found.push_back(*one);
            }
        }
        return found;
    }

    std::vector<Message> sent;
    std::vector<std::string> refused;
    bool has_room = true;
    bool is_local = false;
};

/// A hub with one thread, and no connection.
struct HubStage : testing::Test {
    /// Runs events until the condition holds.
    void run_until(const std::function<bool()>& is_enough) {
        while (!is_enough()) {
            ASSERT_NE(context.run_one_for(patience), 0u) << "nothing more happens";
        }
    }

    asio::io_context context;
    asio::executor_work_guard<asio::io_context::executor_type> work{context.get_executor()};
    Executor executor{context.get_executor(), 1};
    std::shared_ptr<TestHub> hub = std::make_shared<TestHub>(executor);
    RecordingMaster master;
};

inline AddJob add_job(JobId job = JobId{1}, const Query& query = {}) {
    return AddJob{job, {tree_a, tree_b}, query, std::nullopt};
}

} // namespace cd::tests
