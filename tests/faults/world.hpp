// A small universe for real programs: its time, its chance, its network, its disk. What in other
// programs waits for the world outside (threads, sockets, files, the clock) is replaced at link
// time by the simulated_*.cpp beside this; everything else is the code that is shipped.
#pragma once

#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"
#include "proto/codec/message.hpp"
#include "tests/faults/files.hpp"
#include "tests/faults/troubles.hpp"
#include "tests/faults/watcher.hpp"

#include <chrono>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace cd {
class ThreadPool;
} // namespace cd

namespace cd::tests {

using Time = std::chrono::steady_clock::time_point;
using Duration = std::chrono::steady_clock::duration;

/// The number of the master's host.
inline constexpr std::uint64_t master_host = 0;

/// A CD_CHECK that does not hold, anywhere.
struct BrokenInvariant : std::exception {};
/// The master ends in the middle of what it does to its disk.
struct PowerCut : std::exception {};

/// A process; its program is in who owns it, and gone before it.
struct Host {
    Host(std::uint64_t number, std::string called);
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;
    ~Host();

    std::uint64_t id;
    std::string name;
    asio::io_context context{1};
    /// Its peers do not hear of its end.
    std::shared_ptr<bool> is_silent = std::make_shared<bool>(false);
    bool is_odd = false;   ///< Messages from it may come twice, or in another order.
    bool is_dying = false; ///< Nothing more comes from it.
    std::vector<std::function<void()>> at_greeting; ///< What comes to the master with its next one.
    std::optional<unsigned> liar; ///< Its results are now and then wrong; which liar it is.
    double slowness = 1;          ///< Of its threads.
    Time slowed_at{};             ///< When they became so, if trouble made them.
    Time stopped_until{};         ///< It does nothing until then (SIGSTOP),
    Time cut_off_until{};         ///< and nothing comes to it, or from it, before.
    // Of a worker. What vanishes takes its connection with it, which nobody is told:
    Time mute_until{};  ///< What it says to the master vanishes,
    Time deaf_until{};  ///< what the master says to it,
    Time apart_until{}; ///< and all between it and other workers.
};

/// How often a message has which accident; of 1000.
struct NetworkFaults {
    unsigned lost = 0; ///< Its connection breaks soon after.
    /// Of those lost on their way to the master: only their sender takes the connection for broken,
    /// and they come at the very moment of its next greeting.
    unsigned late = 0;
    unsigned unwelcome = 0; ///< Of welcomes to workers: they are lost.
    unsigned doubled = 0;
    unsigned overtaken = 0;
    unsigned delayed = 0;
};

/// Everything that happens, happens in `step`, on one thread, as the seed says.
class World {
  public:
    World(std::uint64_t seed, bool logs);
    World(const World&) = delete;
    World& operator=(const World&) = delete;
    ~World();
    /// Null outside of a simulation.
    [[nodiscard]] static World* current();

    // ---- Time and chance --------------------------------------------------------------------
    [[nodiscard]] Time now() const;
    [[nodiscard]] std::uint64_t below(std::uint64_t bound) { return random_() % bound; }
    [[nodiscard]] bool happens(unsigned of_1000) { return below(1000) < of_1000; }
    [[nodiscard]] Duration between(Duration least, Duration most);
    [[nodiscard]] std::uint64_t new_number() { return ++number_last_; }
    void at(Time time, std::function<void()> event);
    void in(Duration delay, std::function<void()> event) { at(now() + delay, std::move(event)); }
    /// The next event. False when there is none.
    bool step();
    void log(const std::string& text) const;

    // ---- Hosts ------------------------------------------------------------------------------
    /// Pools that are made belong to this one. Null: to nobody, and run at once.
    void make_for(Host* host) { making_ = host; }
    /// What is ready there runs at the end of this step.
    void wake(Host& host) { awake_.insert(host.id); }
    void wake_all();
    /// In the last step something may have run there: it was awake, and not stopped.
    [[nodiscard]] bool has_run(std::uint64_t host) const { return have_run_.contains(host); }
    [[nodiscard]] Host* host_of(const asio::any_io_executor& executor);
    [[nodiscard]] Host* find_host(std::uint64_t id);
    [[nodiscard]] bool is_stopped(const Host& host) const { return now() < host.stopped_until; }
    /// What goes there vanishes now. Asked only where something goes: then that took effect.
    [[nodiscard]] bool is_severed(const Host& from, const Host& to);

    // ---- What the replaced parts call ---------------------------------------------------------
    void pool_made(const ThreadPool* pool, unsigned threads);
    void pool_gone(const ThreadPool* pool) { pools_.erase(pool); }
    void post(const ThreadPool* pool, std::function<void()> function);
    void check_failed(const std::string& what);
    /// Before every change of the disk of the master.
    void touch_disk();

    NetworkFaults network;
    Files disk; ///< Of the master.
    bool disk_is_full = false;
    bool disk_is_unreadable = false; ///< Where running jobs need it.
    /// What the disk had not synced may be gone.
    void lose_power();
    /// After so many changes of the disk the master ends; 0: it does not.
    std::uint64_t power_cut_after = 0;
    bool power_was_cut = false;
    Watcher watcher;
    /// Called with each message that a host sends to another, also in vain; false: it is not sent.
    std::function<bool(const Route& route, const Message& message)> on_message;
    /// And with each that the master takes up.
    std::function<void(const Route& route, const Message& message)> on_heard;

    /// Trouble took effect on the host: counts once for each `since`, which names the trouble
    /// there.
    void felt(Trouble trouble, const Host& host, Time since);
    /// The same, of a host to which something came while it was stopped.
    void felt_stop(const Host& host);
    Troubles troubles;

    /// The first one is what a failing seed is about.
    void problem(const std::string& text);
    [[nodiscard]] const std::vector<std::string>& problems() const { return problems_; }

  private:
    friend struct Host;
    struct Pool {
        std::uint64_t host = 0;
        std::uint64_t number = 0; ///< A pool may be made where another one stood.
        unsigned free = 0;
        std::deque<std::function<void()>> waiting;
        std::map<std::uint64_t, std::function<void()>> running; ///< By whatever number.
    };
    void start_next(const ThreadPool* pool);
    void run_on_pool(const ThreadPool* pool, std::uint64_t number, std::uint64_t job);
    void run_awake();

    std::mt19937_64 random_;
    bool logs_ = false;
    std::multimap<Time, std::function<void()>> events_;
    std::map<std::uint64_t, Host*> hosts_;
    std::set<std::uint64_t> awake_;
    std::set<std::uint64_t> have_run_; ///< In the last step.
    std::map<const ThreadPool*, Pool> pools_;
    std::uint64_t number_last_ = 0; ///< Of pools, what they run, and connections.
    Host* making_ = nullptr;
    std::map<std::pair<Trouble, std::uint64_t>, Time> felt_; ///< By kind and host, the last one.
    std::vector<std::string> problems_;
};

} // namespace cd::tests
