// Instead of connections: messages that take their time, and have accidents on the way.
#include "common/core/check.hpp"
#include "common/core/limits.hpp"
#include "master/mutation.hpp"
#include "proto/channel.hpp"
#include "proto/codec.hpp"
#include "proto/listener.hpp"
#include "tests/faults/world.hpp"

#include <fcntl.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace cd {

using namespace std::chrono_literals;
using tests::Duration;
using tests::Host;
using tests::Time;
using tests::Trouble;
using tests::World;

namespace {

constexpr Duration latency_min = 50us;
constexpr Duration latency_max = 3ms;
/// A block counts as so much more than it has, so that queues fill up.
constexpr std::size_t block_bytes = 6u << 20;

std::size_t bytes_of(const Message& message) {
    std::size_t bytes = 100;
    if (const auto* subtrees = std::get_if<Subtrees>(&message)) {
        bytes += subtrees->blocks.size() * block_bytes;
    } else if (const auto* batch = std::get_if<Batch>(&message)) {
        bytes += batch->scenarios.size() + batch->pairs.size() * sizeof(batch->pairs.front());
    } else if (const auto* range = std::get_if<ScenarioRange>(&message)) {
        bytes += range->scenarios.size();
    } else if (const auto* results = std::get_if<Results>(&message)) {
        bytes += results->records.size();
    }
    return bytes;
}

std::string name_of(const Message& message) {
    return std::string(message_name(message_type(message)));
}

/// What a master takes again, or in another order, without harm to its jobs. (The order of what is
/// said of blocks counts, and a connection keeps it.)
bool may_be_odd(const Message& message) {
    return std::holds_alternative<Results>(message) || std::holds_alternative<EndOfTask>(message) ||
           std::holds_alternative<Heartbeat>(message);
}

/// A message on its way.
struct Letter {
    Message message;
    std::uint64_t number = 0;       ///< Of its sender, ascending.
    std::size_t bytes = 0;          ///< That its sender counts as queued until it comes.
    std::optional<Trouble> trouble; ///< What happens to it, which counts when it comes.
};

/// One end of a connection.
struct LinkEnd : std::enable_shared_from_this<LinkEnd> {
    LinkEnd(const asio::any_io_executor& executor, const Host& on)
        : host(on.id),
          is_silent(on.is_silent),
          arrived(executor, asio::steady_timer::time_point::max()),
          drained(executor, asio::steady_timer::time_point::max()) {}

    std::uint64_t host;
    std::uint64_t other_id = 0;
    std::uint64_t connection = 0;
    std::shared_ptr<const bool> is_silent;
    Party other_party = Party::Anyone; // Of what is lost the rest may come, and be no greeting.
    std::string other_host = "";
    std::string this_host = "";
    asio::steady_timer arrived;
    asio::steady_timer drained;
    std::deque<Message> inbox;
    bool is_awaited = false;         ///< Somebody receives.
    std::optional<Message> incoming; ///< Had come to whoever did when this end was closed.
    bool open = true;
    bool is_ended = false; ///< Nothing comes any more; what came can be read.
    std::weak_ptr<LinkEnd> other;
    Time last_arrival{};            ///< Of what was sent from here.
    std::uint64_t sent_last = 0;    ///< Numbers of letters: of those that were sent from here,
    std::uint64_t arrived_last = 0; ///< and the greatest of those that came here.
    std::size_t queued = 0;
    std::size_t blocks_queued = 0; ///< Of these bytes.
    bool is_broken = false;        ///< What was sent from here vanished, and so does all after it.
    Traffic traffic;

    [[nodiscard]] Time
    arrival_at(const Host& from, const Host& there, Duration delay, World& world) const;
    void send(const Message& message, bool is_open);
    void deliver(const Letter& letter, Time when);
    void arrive(const Letter& letter, World& world);
    static void count(const Letter& letter, std::uint64_t arrived_last, World& world);
    /// What has come and can be taken.
    [[nodiscard]] std::optional<Message> take();
    void shut(bool tells);
    /// Both ends notice it some time.
    void cut(Trouble trouble);
    /// Only this end notices it; the message is on its way until this host greets again.
    void cut_late(const Letter& letter);
    void notice_cut(Duration latest, std::optional<Trouble> trouble);
    /// It is not known here, until the sender has waited in vain for long enough.
    void break_off(const Host& from, const Host& there, World& world);
    void check_flight(World& world) const;
    void check_queue(World& world) const;
    void wake_up(World& world);
};

// Channels are made by one function alone, which takes sockets: what the next one is made of.
std::shared_ptr<LinkEnd> next_end;

Time LinkEnd::arrival_at(const Host& from, const Host& there, Duration delay, World& world) const {
    Time when = world.now() + world.between(latency_min, latency_max) + delay;
    for (const Host* end : {&from, &there}) {
        if (end->cut_off_until > when) {
            when = end->cut_off_until;
            world.felt(end->id == tests::master_host ? Trouble::MasterCutOff
                                                     : Trouble::WorkerCutOff,
                       *end,
                       when);
        }
    }
    return std::max(when, last_arrival);
}

void LinkEnd::wake_up(World& world) {
    arrived.cancel();
    drained.cancel();
    if (Host* here = world.find_host(host)) {
        world.wake(*here);
    }
}

void LinkEnd::count(const Letter& letter, std::uint64_t arrived_last, World& world) {
    const bool is_first = letter.number > arrived_last;
    if (letter.trouble && (letter.trouble != Trouble::Overtaken || !is_first)) {
        world.troubles.add(*letter.trouble);
    }
}

void LinkEnd::arrive(const Letter& letter, World& world) {
    const Message& message = letter.message;
    if (!open || is_ended) {
        return;
    }
    count(letter, arrived_last, world);
    arrived_last = std::max(arrived_last, letter.number);
    inbox.push_back(message);
    arrived.cancel();
    if (Host* here = world.find_host(host)) {
        world.felt_stop(*here);
        world.wake(*here);
    }
    if (host != tests::master_host || !std::holds_alternative<Hello>(message)) {
        return;
    }
    if (Host* from = world.find_host(other_id)) {
        for (const auto& comes : std::exchange(from->at_greeting, {})) {
            comes();
        }
    }
}

std::optional<Message> LinkEnd::take() {
    std::optional<Message> message = std::exchange(incoming, std::nullopt);
    if (!message && open && !inbox.empty()) {
        message = std::move(inbox.front());
        inbox.pop_front();
    }
    if (!message) {
        return message;
    }
    is_awaited = false;
    CD_CHECK(payload_bytes_max_from(other_party, message_type(*message)) != 0);
    if (host == tests::master_host) {
        World::current()->log("heard: " + name_of(*message) + ", of " + other_host);
        World::current()->on_heard({other_id, host, connection}, *message);
    }
    return message;
}

void LinkEnd::deliver(const Letter& letter, Time when) {
    World& world = *World::current();
    world.at(when, [&world, self = weak_from_this(), to = other, letter] {
        const std::size_t bytes = letter.bytes;
        if (const auto sender = self.lock(); sender != nullptr && bytes != 0) {
            sender->queued -= bytes;
            sender->blocks_queued -= std::holds_alternative<Subtrees>(letter.message) ? bytes : 0;
            sender->drained.cancel();
            if (Host* here = world.find_host(sender->host)) {
                world.wake(*here);
            }
        }
        if (const auto there = to.lock()) {
            there->arrive(letter, world);
        }
    });
}

void LinkEnd::send(const Message& message, bool is_open) {
    World& world = *World::current();
    const bool is_sent = world.on_message({host, other_id, connection}, message);
    const auto to = other.lock();
    if (!is_open || !is_sent) {
        return;
    }
    Host* from = world.find_host(host);
    Host* there = to == nullptr ? nullptr : world.find_host(to->host);
    if (from == nullptr || there == nullptr) {
        return;
    }
    const std::string way = name_of(message) + ", " + from->name + " to " + there->name;
    const bool is_odd_host = from->is_odd && there->id == tests::master_host;
    const bool is_odd = is_odd_host && may_be_odd(message);
    const bool is_unwelcome = there->is_odd && std::holds_alternative<Welcome>(message) &&
                              world.happens(world.network.unwelcome);
    const std::size_t bytes = bytes_of(message);
    const std::size_t bytes_of_blocks = std::holds_alternative<Subtrees>(message) ? bytes : 0;
    if (bytes_of_blocks != 0) {
        check_flight(world);
    }
    queued += bytes;
    blocks_queued += bytes_of_blocks;
    check_queue(world);
    break_off(*from, *there, world);
    if (is_broken) {
        return world.log("vanished: " + way);
    }
    const Duration delay =
        world.happens(world.network.delayed) ? world.between(0s, 2s) : Duration{};
    const Time when = arrival_at(*from, *there, delay, world);
    Letter letter{message, ++sent_last, bytes, std::nullopt};
    if (is_odd && world.happens(world.network.overtaken)) {
        world.log("overtaken: " + way);
        letter.trouble = Trouble::Overtaken;
        return deliver(letter, when + world.between(0s, 200ms));
    }
    last_arrival = when;
    if (world.happens(world.network.lost) || is_unwelcome) {
        world.log("lost: " + way);
        queued -= bytes;
        blocks_queued -= bytes_of_blocks;
        return is_odd_host && world.happens(world.network.late)
                   ? cut_late(letter)
                   : cut(is_unwelcome ? Trouble::Unwelcomed : Trouble::Lost);
    }
    if (delay > latency_max) {
        letter.trouble = Trouble::Delayed;
    }
    deliver(letter, when);
    if (is_odd && world.happens(world.network.doubled)) {
        world.log("doubled: " + way);
        letter.bytes = 0;
        letter.trouble = Trouble::Doubled;
        deliver(letter, when);
    }
}

void LinkEnd::shut(bool tells) {
    World* world = World::current();
    if (!open || world == nullptr) {
        return;
    }
    // The one that has come to who awaits it is taken all the same.
    if (is_awaited && !inbox.empty()) {
        incoming = std::move(inbox.front());
    }
    open = false;
    wake_up(*world);
    const Host* from = world->find_host(host);
    const Host* into = world->find_host(other_id);
    if (from != nullptr && into != nullptr) {
        break_off(*from, *into, *world);
    }
    if (!tells || is_broken) {
        return;
    }
    const Time when = std::max(last_arrival, world->now() + latency_max);
    world->at(when, [world, to = other] {
        if (const auto there = to.lock()) {
            there->is_ended = true;
            there->wake_up(*world);
        }
    });
}

void LinkEnd::notice_cut(Duration latest, std::optional<Trouble> trouble) {
    World& world = *World::current();
    world.in(world.between(0s, latest), [&world, end = weak_from_this(), trouble] {
        if (const auto state = end.lock(); state != nullptr && state->open) {
            if (trouble && !state->is_ended) {
                world.troubles.add(*trouble);
            }
            state->inbox.clear();
            state->is_ended = true;
            state->wake_up(world);
        }
    });
}

void LinkEnd::break_off(const Host& from, const Host& there, World& world) {
    if (is_broken || !world.is_severed(from, there)) {
        return;
    }
    is_broken = true;
    world.in(limits::write_stall_max, [end = weak_from_this()] {
        if (const auto state = end.lock()) {
            state->notice_cut(1s, std::nullopt);
        }
    });
}

void LinkEnd::cut(Trouble trouble) {
    notice_cut(4s, trouble);
    if (const auto there = other.lock()) {
        there->notice_cut(4s, trouble);
    }
}

void LinkEnd::cut_late(const Letter& letter) {
    World& world = *World::current();
    world.log("late: " + name_of(letter.message) + ", of " + this_host);
    Letter late = letter;
    late.trouble = Trouble::Late;
    world.find_host(host)->at_greeting.push_back([&world, end = other, late] {
        if (const auto old = end.lock()) {
            old->arrive(late, world);
        }
    });
    notice_cut(1s, std::nullopt);
}

/// Who gives blocks waits until those before them are on their way.
void LinkEnd::check_flight(World& world) const {
    const std::size_t most =
        host == tests::master_host ? limits::subtrees_queue_bytes_max : limits::subtrees_bytes_min;
    if (blocks_queued >= most) {
        world.problem("blocks go to " + other_host + ", and " + std::to_string(blocks_queued) +
                      " bytes of them are under way");
    }
}

/// And of all else no more queues up than one connection may hold.
void LinkEnd::check_queue(World& world) const {
    if (queued - blocks_queued > limits::write_queue_bytes_max) {
        world.problem(std::to_string(queued - blocks_queued) + " bytes queue up towards " +
                      other_host);
    }
}

} // namespace

// ---- The channel ------------------------------------------------------------------------------

struct Channel::State {
    std::shared_ptr<LinkEnd> end;
};

Channel::Channel(std::shared_ptr<State> state) : state_(std::move(state)) {}

Channel::~Channel() {
    state_->end->shut(!*state_->end->is_silent);
}

std::shared_ptr<Channel> Channel::make(std::unique_ptr<Stream>, Duration) {
    return std::shared_ptr<Channel>(
        new Channel(std::make_shared<State>(State{std::exchange(next_end, nullptr)})));
}

asio::awaitable<Result<Message>> Channel::receive(std::chrono::steady_clock::duration timeout) {
    const std::shared_ptr<LinkEnd> end = state_->end;
    const Time deadline = std::chrono::steady_clock::now() + timeout;
    end->is_awaited = true;
    if (end->open && !end->inbox.empty()) {
        // Each message is read by itself, and what happens elsewhere comes between.
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
            co_return Error{ErrorCode::Timeout, "nothing came in time"};
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

// ---- How it begins ------------------------------------------------------------------------------

namespace {

struct Listening {
    asio::any_io_executor executor;
    std::uint16_t port = 0;
    Listener::OnSocket on_socket = nullptr;
};

std::map<std::uint16_t, std::weak_ptr<Listening>> listeners;
/// Connections that were made and not yet accepted, by the descriptor of the socket that stands for
/// one: who refuses a connection closes it.
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

asio::awaitable<Result<std::shared_ptr<Channel>>> connect(Target target, std::chrono::seconds) {
    World& world = *World::current();
    const asio::any_io_executor executor = co_await asio::this_coro::executor;
    Host& from = *world.host_of(executor);
    asio::steady_timer timer(executor, world.between(latency_min, latency_max));
    co_await timer.async_wait(asio::use_awaitable);
    const std::shared_ptr<Listening> listener = listeners[target.endpoint.port].lock();
    Host* there = listener == nullptr ? nullptr : world.host_of(listener->executor);
    const bool reaches = there != nullptr && listener->on_socket != nullptr &&
                         world.now() >= from.cut_off_until && world.now() >= there->cut_off_until &&
                         !world.is_severed(from, *there) && !world.is_severed(*there, from);
    if (!reaches) {
        co_return Error{ErrorCode::Disconnected, "nobody is there"};
    }
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
