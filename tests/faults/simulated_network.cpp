// Replaces connections by messages that take time and suffer faults on the way.
#include "common/core/check.hpp"
#include "master/base/mutation.hpp"
#include "proto/channel/channel.hpp"
#include "proto/channel/connection.hpp"
#include "proto/channel/endpoint.hpp"
#include "proto/channel/listener.hpp"
#include "tests/faults/link_end.hpp"
#include "tests/faults/world.hpp"

#include <fcntl.h>

#include <map>
#include <optional>
#include <utility>

namespace cd {

using namespace std::chrono_literals;
using tests::Duration;
using tests::Host;
using tests::latency_max;
using tests::latency_min;
using tests::LinkEnd;
using tests::Time;
using tests::World;

namespace {

const Error nobody_there{ErrorCode::Disconnected, "nobody is there"};

// One function that takes sockets makes all channels; this is the end for the next one.
std::shared_ptr<LinkEnd> next_end;

} // namespace

// ---- The channel ------------------------------------------------------------------------------

struct Channel::State {
    std::shared_ptr<LinkEnd> end;
};

Channel::Channel(std::shared_ptr<State> state) : state_(std::move(state)) {}

Channel::~Channel() {
    state_->end->shut(!*state_->end->is_silent);
}

std::shared_ptr<Channel> Channel::make(std::unique_ptr<Stream>, const StallBounds&) {
    return std::shared_ptr<Channel>(
        new Channel(std::make_shared<State>(State{std::exchange(next_end, nullptr)})));
}

asio::awaitable<Result<Message>> Channel::receive(std::chrono::steady_clock::duration timeout) {
    const std::shared_ptr<LinkEnd> end = state_->end;
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

void Channel::send(const Message& message) {
    World& world = *World::current();
    const Host* from = world.find_host(state_->end->host);
    if (mutated(Mutation::EvictionNotTold) && std::holds_alternative<Evicted>(message)) {
        return;
    }
    const auto* results = std::get_if<Results>(&message);
    if (results != nullptr && from != nullptr && from->liar) {
        state_->end->send(world.watcher.lies.told_by(from->id, *from->liar, *results), is_open());
    } else {
        state_->end->send(message, is_open());
    }
}

void Channel::expect(Party party) {
    state_->end->other_party = party;
}

asio::awaitable<void> Channel::wait_until_closed() {
    co_return;
}

std::size_t Channel::queued_bytes() const {
    return state_->end->queued;
}

asio::awaitable<void> Channel::wait_until_queued_below(std::size_t bytes) {
    const std::shared_ptr<LinkEnd> end = state_->end;
    while (is_open() && end->queued >= bytes) {
        boost::system::error_code ignored;
        co_await end->drained.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    }
}

void Channel::close(bool) {
    state_->end->shut(true);
}

bool Channel::is_open() const {
    return state_->end->open && !(state_->end->is_ended && state_->end->inbox.empty());
}

const Traffic& Channel::traffic() const {
    return state_->end->traffic;
}
const std::string& Channel::peer() const {
    return state_->end->other_host;
}
const std::string& Channel::peer_host() const {
    return state_->end->other_host;
}
const std::string& Channel::own_host() const {
    return state_->end->this_host;
}
bool Channel::is_secured() const {
    return false;
}
const std::optional<Identity>& Channel::peer_identity() const {
    static const std::optional<Identity> nobody;
    return nobody;
}
std::optional<Sha256> Channel::binding() const {
    return std::nullopt;
}

// ---- Connecting -------------------------------------------------------------------------------

namespace {

struct Listening {
    asio::any_io_executor executor;
    std::uint16_t port = 0;
    Listener::OnSocket on_socket = nullptr;
};

std::map<std::uint16_t, std::weak_ptr<Listening>> listeners;
/// Made but unaccepted connections, by the descriptor of the placeholder socket. Closing the socket
/// refuses the connection.
std::map<int, std::shared_ptr<LinkEnd>> backlog;

void offer(Listening& listening, std::shared_ptr<LinkEnd> end) {
    if (listening.on_socket == nullptr) {
        return end->shut(true);
    }
    asio::ip::tcp::socket socket(listening.executor, asio::ip::tcp::v4());
    const int descriptor = socket.native_handle();
    backlog[descriptor] = end;
    listening.on_socket(std::move(socket));
    if (::fcntl(descriptor, F_GETFD) < 0) {
        backlog.erase(descriptor);
        end->shut(true);
    }
}

} // namespace

struct Listener::State {
    std::shared_ptr<Listening> listening;
};

Result<std::unique_ptr<Listener>> Listener::open(const asio::any_io_executor& executor,
                                                 const Endpoint& endpoint) {
    const auto listening = std::make_shared<Listening>(Listening{executor, endpoint.port});
    listeners[endpoint.port] = listening;
    return std::unique_ptr<Listener>(new Listener(std::make_shared<State>(State{listening})));
}

Listener::Listener(std::shared_ptr<State> state) : state_(std::move(state)) {}

Listener::~Listener() {
    if (const Host* host = World::current()->host_of(state_->listening->executor)) {
        std::erase_if(backlog,
                      [&](const auto& waiting) { return waiting.second->host == host->id; });
    }
}

std::uint16_t Listener::port() const {
    return state_->listening->port;
}

void Listener::start(OnSocket on_socket) {
    state_->listening->on_socket = std::move(on_socket);
}

void Listener::close() {
    state_->listening->on_socket = nullptr;
}

asio::awaitable<std::shared_ptr<Listening>> find_listener(Endpoint endpoint) {
    World& world = *World::current();
    const asio::any_io_executor executor = co_await asio::this_coro::executor;
    Host& from = *world.host_of(executor);
    asio::steady_timer timer(executor, world.between(latency_min, latency_max));
    co_await timer.async_wait(asio::use_awaitable);
    const std::shared_ptr<Listening> listener = listeners[endpoint.port].lock();
    Host* there = listener == nullptr ? nullptr : world.host_of(listener->executor);
    const bool reaches = there != nullptr && listener->on_socket != nullptr &&
                         world.now() >= from.cut_off_until && world.now() >= there->cut_off_until &&
                         !world.is_severed(from, *there) && !world.is_severed(*there, from);
    co_return reaches ? listener : nullptr;
}

asio::awaitable<Status> reach(Endpoint endpoint, std::chrono::seconds) {
    const std::shared_ptr<Listening> listener = co_await find_listener(endpoint);
    co_return listener == nullptr ? Status(nobody_there) : Status(Done{});
}

asio::awaitable<Result<std::shared_ptr<Channel>>> connect(Target target, std::chrono::seconds) {
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
    next_end = here;
    co_return Channel::make(nullptr);
}

asio::awaitable<Result<std::shared_ptr<Channel>>>
accept_channel(asio::ip::tcp::socket socket, std::shared_ptr<const Tls>, Duration) {
    const auto waiting = backlog.extract(socket.native_handle());
    CD_CHECK(!waiting.empty());
    next_end = waiting.mapped();
    co_return Channel::make(nullptr);
}

} // namespace cd
