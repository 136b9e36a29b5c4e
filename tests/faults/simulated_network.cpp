#include "tests/faults/simulated_network.hpp"

#include "common/core/check.hpp"
#include "master/base/mutation.hpp"
#include "tests/faults/link_end.hpp"
#include "tests/faults/world.hpp"

#include <map>
#include <optional>
#include <utility>

namespace cd::tests {

using namespace std::chrono_literals;

namespace {

const Error nobody_there{ErrorCode::Disconnected, "nobody is there"};

// ---- The channel ------------------------------------------------------------------------------

class SimulatedChannel final : public Channel {
  public:
    explicit SimulatedChannel(std::shared_ptr<LinkEnd> end) : end_(std::move(end)) {}
    ~SimulatedChannel() override { end_->shut(!*end_->is_silent); }

    [[nodiscard]] asio::awaitable<Result<Message>>
    receive(std::chrono::steady_clock::duration timeout) override;
    void expect(Party party) override { end_->other_party = party; }
    void send(const Message& message) override;
    [[nodiscard]] std::size_t queued_bytes() const override { return end_->queued; }
    [[nodiscard]] asio::awaitable<void> wait_until_queued_below(std::size_t bytes) override;
    void close(bool /*flush*/) override { end_->shut(true); }
    [[nodiscard]] bool is_open() const override {
        return end_->open && !(end_->is_ended && end_->inbox.empty());
    }
    [[nodiscard]] asio::awaitable<void> wait_until_closed() override { co_return; }
    [[nodiscard]] const Traffic& traffic() const override { return end_->traffic; }
    [[nodiscard]] const std::string& peer() const override { return end_->other_host; }
    [[nodiscard]] const std::string& peer_host() const override { return end_->other_host; }
    [[nodiscard]] const std::string& own_host() const override { return end_->this_host; }

  private:
    std::shared_ptr<LinkEnd> end_;
};

asio::awaitable<Result<Message>>
SimulatedChannel::receive(std::chrono::steady_clock::duration timeout) {
    const std::shared_ptr<LinkEnd> end = end_;
    const Time deadline = std::chrono::steady_clock::now() + timeout;
    end->is_awaited = true;
    if (end->open && !end->inbox.empty()) {
        // Read each message in a turn of its own, so that other hosts' events come between.
        co_await asio::post(co_await asio::this_coro::executor, asio::use_awaitable);
    }
    for (;;) {
        if (auto message = end->take()) {
            co_return std::move(*message);
        }
        if (!end->open || end->is_ended) {
            end->open = false;
            end->drained.cancel();
            co_return Error{ErrorCode::Disconnected, "the peer closed the connection"};
        }
        if (std::chrono::steady_clock::now() >= deadline) {
            end->is_awaited = false;
            co_return Error{ErrorCode::Timeout, "nothing was received in time"};
        }
        end->arrived.expires_at(deadline);
        boost::system::error_code ignored;
        co_await end->arrived.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    }
}

void SimulatedChannel::send(const Message& message) {
    World& world = *World::current();
    const Host* from = world.find_host(end_->host);
    if (mutated(Mutation::EvictionNotTold) && std::holds_alternative<Evicted>(message)) {
        return;
    }
    const auto* results = std::get_if<Results>(&message);
    if (results != nullptr && from != nullptr && from->liar) {
        end_->send(world.watcher.lies.told_by(from->id, *from->liar, *results), is_open());
    } else {
        end_->send(message, is_open());
    }
}

asio::awaitable<void> SimulatedChannel::wait_until_queued_below(std::size_t bytes) {
    const std::shared_ptr<LinkEnd> end = end_;
    while (end->open && !(end->is_ended && end->inbox.empty()) && end->queued >= bytes) {
        boost::system::error_code ignored;
        co_await end->drained.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    }
}

// ---- Accepting --------------------------------------------------------------------------------

struct Listening {
    asio::any_io_executor executor;
    std::uint16_t port = 0;
    ChannelListener::OnIncoming on_incoming = nullptr;
};

std::map<std::uint16_t, std::weak_ptr<Listening>> listeners;

/// An end that no channel has yet.
struct Unaccepted {
    explicit Unaccepted(std::shared_ptr<LinkEnd> of) : end(std::move(of)) {}
    Unaccepted(const Unaccepted&) = delete;
    Unaccepted& operator=(const Unaccepted&) = delete;
    ~Unaccepted() {
        if (end != nullptr) {
            end->shut(!*end->is_silent);
        }
    }
    std::shared_ptr<LinkEnd> end;
};

void offer(const Listening& listening, const std::shared_ptr<LinkEnd>& end) {
    if (listening.on_incoming == nullptr) {
        return end->shut(true);
    }
    listening.on_incoming(
        {{},
         end->other_host,
         [offered = std::make_shared<Unaccepted>(end)](
             std::shared_ptr<const Tls>) -> asio::awaitable<Result<std::shared_ptr<Channel>>> {
             co_return std::make_shared<SimulatedChannel>(std::exchange(offered->end, nullptr));
         }});
}

class SimulatedListener final : public ChannelListener {
  public:
    explicit SimulatedListener(std::shared_ptr<Listening> listening)
        : listening_(std::move(listening)) {}

    [[nodiscard]] std::uint16_t port() const override { return listening_->port; }
    void start(OnIncoming on_incoming) override {
        listening_->on_incoming = std::move(on_incoming);
    }
    void close() override { listening_->on_incoming = nullptr; }

  private:
    std::shared_ptr<Listening> listening_;
};

// ---- Connecting -------------------------------------------------------------------------------

asio::awaitable<std::shared_ptr<Listening>> find_listener(Endpoint endpoint) {
    World& world = *World::current();
    const asio::any_io_executor executor = co_await asio::this_coro::executor;
    Host& from = *world.host_of(executor);
    asio::steady_timer timer(executor, world.between(latency_min, latency_max));
    co_await timer.async_wait(asio::use_awaitable);
    const std::shared_ptr<Listening> listener = listeners[endpoint.port].lock();
    Host* there = listener == nullptr ? nullptr : world.host_of(listener->executor);
    const bool reaches = there != nullptr && listener->on_incoming != nullptr &&
                         world.now() >= from.cut_off_until && world.now() >= there->cut_off_until &&
                         !world.is_severed(from, *there) && !world.is_severed(*there, from);
    co_return reaches ? listener : nullptr;
}

class SimulatedNetwork final : public Network {
  public:
    [[nodiscard]] asio::awaitable<Result<std::shared_ptr<Channel>>>
    connect(Target target, std::chrono::seconds timeout) override;
    [[nodiscard]] asio::awaitable<Status> reach(Endpoint endpoint,
                                                std::chrono::seconds /*timeout*/) override {
        const std::shared_ptr<Listening> listener = co_await find_listener(std::move(endpoint));
        co_return listener == nullptr ? Status(nobody_there) : Status(Done{});
    }
    [[nodiscard]] Result<std::unique_ptr<ChannelListener>>
    listen(const asio::any_io_executor& executor, const Endpoint& endpoint) override {
        const auto listening = std::make_shared<Listening>(Listening{executor, endpoint.port});
        listeners[endpoint.port] = listening;
        return std::unique_ptr<ChannelListener>(std::make_unique<SimulatedListener>(listening));
    }
};

asio::awaitable<Result<std::shared_ptr<Channel>>>
SimulatedNetwork::connect(Target target, std::chrono::seconds /*timeout*/) {
    const std::shared_ptr<Listening> listener = co_await find_listener(target.endpoint);
    if (listener == nullptr) {
        co_return nobody_there;
    }
    World& world = *World::current();
    const asio::any_io_executor executor = co_await asio::this_coro::executor;
    Host& from = *world.host_of(executor);
    Host* there = world.host_of(listener->executor);
    const auto here = std::make_shared<LinkEnd>(executor, from);
    const auto other = std::make_shared<LinkEnd>(listener->executor, *there);
    here->other_id = there->id;
    other->other_id = from.id;
    here->connection = other->connection = world.new_number();
    here->other = other;
    other->other = here;
    here->this_host = other->other_host = from.name;
    here->other_host = other->this_host = there->name;
    asio::post(listener->executor, [listener, other] { offer(*listener, other); });
    world.wake(*there);
    co_return std::make_shared<SimulatedChannel>(here);
}

} // namespace

Network& simulated_network() {
    static SimulatedNetwork network;
    return network;
}

} // namespace cd::tests
