// Sketches of all that the coordinator does not compute itself: a workload gives their sizes and
// times.
#pragma once

#include "bench/cluster/model/workload.hpp"
#include "common/core/check.hpp"
#include "master/base/event_loop.hpp"
#include "master/compute/job_geometry.hpp"
#include "master/journal/journal.hpp"
#include "proto/channel/network.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cd::bench {

/// The master's thread in simulated time, in seconds.
class SketchLoop final : public EventLoop {
  public:
    using Function = std::function<void()>;

    [[nodiscard]] Time now() const override { return now_; }
    void post(Function function) override {
        (recorded_ == nullptr ? ready_ : *recorded_).push_back(std::move(function));
    }
    void after(Duration delay, Function function) override {
        timers_.emplace(now_ + delay, std::move(function));
    }
    void close() override { timers_.clear(); }

    /// Advances the time, which never decreases, and makes the functions ready that are due.
    void time_is(double seconds);
    /// Time of the next function that waits for a delay, in seconds.
    [[nodiscard]] std::optional<double> next_timer() const;
    /// Runs the functions that are ready, and those that they post. Returns false if there is none.
    bool run_ready();
    /// Runs a function of a pool thread. Returns the functions that it posts.
    [[nodiscard]] std::deque<Function> record(const Function& function);

  private:
    Time now_{};
    std::deque<Function> ready_;
    std::multimap<Time, Function> timers_;
    std::deque<Function>* recorded_ = nullptr; ///< Null outside of `record`.
};

/// Keeps the functions until the simulation runs them.
class SketchPool final : public Pool {
  public:
    explicit SketchPool(unsigned threads) : threads_(threads) {}
    void post(std::function<void()> function) override { waiting.push_back(std::move(function)); }
    [[nodiscard]] unsigned size() const override { return threads_; }

    std::deque<std::function<void()>> waiting;

  private:
    unsigned threads_;
};

/// Runs functions at once: their time is not simulated.
class InstantPool final : public Pool {
  public:
    void post(std::function<void()> function) override { function(); }
    [[nodiscard]] unsigned size() const override { return 1; }
};

/// The blocks of one body. A block that is sent has no bytes.
class SketchCut final : public Cut {
  public:
    SketchCut(const std::vector<BlockCost>& blocks, const BlockCost& top)
        : blocks_(blocks), top_(top) {}

    [[nodiscard]] std::uint32_t depth() const override { return 0; }
    [[nodiscard]] SubtreeForm form() const override { return SubtreeForm::Wide; }
    [[nodiscard]] std::uint32_t triangle_count() const override { return 0; }
    [[nodiscard]] std::uint32_t root_count() const override {
        return static_cast<std::uint32_t>(blocks_.size());
    }
    [[nodiscard]] std::uint32_t triangles_under(RootIndex root) const override {
        return blocks_[root].triangles;
    }
    [[nodiscard]] const Sha256& hash(RootIndex /*root*/) const override { return hash_; }
    [[nodiscard]] std::uint64_t compressed_bytes(RootIndex root) const override {
        return root == top_root ? top_.bytes : blocks_[root].bytes;
    }
    [[nodiscard]] Result<SubtreeBlock> read(RootIndex root) const override { return block(root); }
    [[nodiscard]] SubtreeBlock block(RootIndex root) const override { return {root, hash_, {}}; }

  private:
    const std::vector<BlockCost>& blocks_;
    const BlockCost& top_;
    Sha256 hash_;
};

/// A single job with the two bodies of a workload, which outlives this object.
class SketchGeometry final : public Geometry {
  public:
    /// `analyse` analyses a scenario.
    SketchGeometry(const Workload& workload, std::function<Analysis(const Scenario&)> analyse)
        : workload_(workload), analyse_(std::move(analyse)) {}

    [[nodiscard]] StoreResult<JobGeometry> prepare(const Submit& /*submit*/) override {
        JobGeometry geometry;
        for (std::size_t tree = 0; tree < workload_.trees.size(); ++tree) {
            geometry.cuts.push_back(
                std::make_shared<SketchCut>(workload_.trees[tree], workload_.tops[tree]));
        }
        geometry.analysis.sketch = analyse_;
        return geometry;
    }
    [[nodiscard]] std::shared_ptr<const MeshHold> hold(std::vector<Sha256> /*meshes*/) override {
        return nullptr;
    }
    [[nodiscard]] std::vector<MeshStatus> meshes() const override { return {}; }

  private:
    const Workload& workload_;
    std::function<Analysis(const Scenario&)> analyse_;
};

/// Keeps no entry, but counts the results in those that are not committed.
class SketchJournal final : public Journal {
  public:
    SketchJournal() : Journal("") {}
    [[nodiscard]] Recovered take_recovered() override { return {}; }
    void start(JournalEvents events) override { events_ = std::move(events); }
    std::uint64_t add(JournalEntry entry) override {
        const auto* results = std::get_if<AddResults>(&entry);
        uncommitted_.push_back(results == nullptr ? 0 : results->results.size());
        return ++added_;
    }
    [[nodiscard]] std::uint64_t queued_bytes() const override { return 0; }
    [[nodiscard]] Result<JobRecord> job(JobId /*job*/) const override {
        return Error{ErrorCode::NotFound, "no job is kept"};
    }

    /// Number of results in each entry that is not committed.
    [[nodiscard]] const std::deque<std::size_t>& uncommitted() const { return uncommitted_; }
    /// Commits the first entry that is not committed.
    void commit() {
        uncommitted_.pop_front();
        events_.committed(added_ - uncommitted_.size());
    }

  private:
    JournalEvents events_;
    std::deque<std::size_t> uncommitted_;
    std::uint64_t added_ = 0;
};

/// A connection to a worker that passes each message to a function. The worker is never silent: at
/// each look more bytes have come from it. Aborts if the master cuts the worker off.
class SketchChannel final : public Channel {
  public:
    explicit SketchChannel(std::function<void(const Message&)> send) : send_(std::move(send)) {}

    [[nodiscard]] asio::awaitable<Result<Message>>
    receive(std::chrono::steady_clock::duration /*timeout*/) override {
        co_return Error{ErrorCode::Disconnected, "nothing is received here"};
    }
    void expect(Party /*party*/) override {}
    void send(const Message& message) override { send_(message); }
    [[nodiscard]] std::size_t queued_bytes() const override { return 0; }
    [[nodiscard]] asio::awaitable<void> wait_until_queued_below(std::size_t /*bytes*/) override {
        co_return;
    }
    void close(bool /*flush*/) override { CD_CHECK(false); }
    [[nodiscard]] bool is_open() const override { return true; }
    [[nodiscard]] asio::awaitable<void> wait_until_closed() override { co_return; }
    [[nodiscard]] const Traffic& traffic() const override {
        ++traffic_.bytes_received;
        return traffic_;
    }
    [[nodiscard]] const std::string& peer() const override { return name_; }
    [[nodiscard]] const std::string& peer_host() const override { return name_; }
    [[nodiscard]] const std::string& own_host() const override { return name_; }

  private:
    std::function<void(const Message&)> send_;
    mutable Traffic traffic_;
    std::string name_ = "simulated";
};

/// Every port is reached.
class SketchNetwork final : public Network {
  public:
    [[nodiscard]] asio::awaitable<Result<std::shared_ptr<Channel>>>
    connect(Target /*target*/, std::chrono::seconds /*timeout*/) override {
        co_return Error{ErrorCode::Disconnected, "nobody is there"};
    }
    [[nodiscard]] asio::awaitable<Status> reach(Endpoint /*endpoint*/,
                                                std::chrono::seconds /*timeout*/) override {
        co_return Done{};
    }
    [[nodiscard]] Result<std::unique_ptr<ChannelListener>>
    listen(const asio::any_io_executor& /*executor*/, const Endpoint& /*endpoint*/) override {
        return Error{ErrorCode::Io, "nobody listens here"};
    }
};

} // namespace cd::bench
