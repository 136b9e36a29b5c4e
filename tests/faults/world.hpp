// A simulated environment for the real programs: time, randomness, network, disk. Journal, thread
// pools and connections implement the programs' interfaces (simulated_*.hpp). Only the system below
// the programs is replaced at link time: files (simulated_files.cpp), and the C++ library's clock
// (world.cpp), which Asio's timers follow. All else is the shipped code.
#pragma once

#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"
#include "proto/codec/message.hpp"
#include "tests/faults/files.hpp"
#include "tests/faults/troubles.hpp"
#include "tests/faults/watcher.hpp"

#include <chrono>
#include <cstdint>
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

namespace cd::tests {

using Time = std::chrono::steady_clock::time_point;
using Duration = std::chrono::steady_clock::duration;

inline constexpr std::uint64_t master_host = 0;

/// Thrown when a CD_CHECK fails anywhere.
struct BrokenInvariant : std::exception {};
/// Thrown to end the master in the middle of a disk operation.
struct PowerCut : std::exception {};

/// A process. Its owner keeps the program, which is destroyed before the host.
struct Host {
    Host(std::uint64_t number, std::string called);
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;
    ~Host();

    std::uint64_t id;
    std::string name;
    asio::io_context context{1};
    /// True if peers are not notified of its end.
    std::shared_ptr<bool> is_silent = std::make_shared<bool>(false);
    bool is_odd = false;                            ///< Its messages may be repeated or reordered.
    bool is_dying = false;                          ///< It sends nothing more.
    std::vector<std::function<void()>> at_greeting; ///< Arrives at the master with its next
                                                    ///< greeting.
    std::optional<unsigned> liar; ///< Number of the liar, if its results are now and then wrong.
    double slowness = 1;          ///< Factor on its threads' time.
    Time slowed_at{};             ///< When a fault slowed the threads.
    Time stopped_until{};         ///< The process does nothing until then (SIGSTOP).
    Time cut_off_until{};         ///< No message reaches or leaves it before.
    // For workers. A vanished message breaks its connection unnoticed.
    Time mute_until{};  ///< Messages to the master vanish.
    Time deaf_until{};  ///< Messages from the master vanish.
    Time apart_until{}; ///< Messages between it and other workers vanish.
};

/// Rate of each fault, per mille of messages.
struct NetworkFaults {
    unsigned lost = 0; ///< The connection breaks soon after.
    /// Share of lost messages to the master whose loss only the sender notices; they arrive just at
    /// its next greeting.
    unsigned late = 0;
    unsigned unwelcome = 0; ///< Share of welcomes to workers that are lost.
    unsigned doubled = 0;
    unsigned overtaken = 0;
    unsigned delayed = 0;
};

/// Runs all events in `step`, on one thread, in the order that the seed determines.
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
    /// Runs the next event. Returns false if there is none.
    bool step();
    void log(const std::string& text) const;

    // ---- Hosts ------------------------------------------------------------------------------
    /// Runs the host's ready handlers at the end of this step.
    void wake(Host& host) { awake_.insert(host.id); }
    void wake_all();
    /// True if the host may have run in the last step: it was awake, and not stopped.
    [[nodiscard]] bool has_run(std::uint64_t host) const { return have_run_.contains(host); }
    [[nodiscard]] Host* host_of(const asio::any_io_executor& executor);
    [[nodiscard]] Host* find_host(std::uint64_t id);
    [[nodiscard]] bool is_stopped(const Host& host) const { return now() < host.stopped_until; }
    /// True if a message to `to` vanishes now. Counts the fault, so call it only for a real
    /// message.
    [[nodiscard]] bool is_severed(const Host& from, const Host& to);

    // ---- Called by the simulated parts --------------------------------------------------------
    /// Runs the function, with a clock that each read advances by `look`.
    static void work_slowly(Duration look, const std::function<void()>& function);
    void check_failed(const std::string& what);
    /// Must be called before every change of the master's disk.
    void touch_disk();

    NetworkFaults network;
    Files disk; ///< The master's disk.
    bool disk_is_full = false;
    bool disk_is_unreadable = false; ///< Reads that running jobs need fail.
    /// Loses unsynced data at random.
    void lose_power();
    /// Number of disk changes after which the master ends; 0: never.
    std::uint64_t power_cut_after = 0;
    bool power_was_cut = false;
    Watcher watcher;
    /// Called with each message a host sends, delivered or not. Returns false to drop the message.
    std::function<bool(const Route& route, const Message& message)> on_message;
    /// Called with each message that the master reads.
    std::function<void(const Route& route, const Message& message)> on_heard;

    /// Counts a fault that took effect on the host, once for each `since`, which identifies it.
    void felt(Trouble trouble, const Host& host, Time since);
    /// Counts a stop of the host if something reached the host while it was stopped.
    void felt_stop(const Host& host);
    Troubles troubles;

    /// Records a problem; a failing seed reports the first one.
    void problem(const std::string& text);
    [[nodiscard]] const std::vector<std::string>& problems() const { return problems_; }

  private:
    friend struct Host;
    void run_awake();

    std::mt19937_64 random_;
    bool logs_ = false;
    std::multimap<Time, std::function<void()>> events_;
    std::map<std::uint64_t, Host*> hosts_;
    std::set<std::uint64_t> awake_;
    std::set<std::uint64_t> have_run_; ///< In the last step.
    std::uint64_t number_last_ = 0;    ///< Last number of a function or connection.
    std::map<std::pair<Trouble, std::uint64_t>, Time> felt_; ///< Last fault by kind and host.
    std::vector<std::string> problems_;
};

} // namespace cd::tests
