#include "tests/faults/world.hpp"

#include "common/core/check.hpp"
#include "common/core/host/log.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace cd::tests {

namespace {

World* the_world = nullptr;

/// Value of `steady_clock`.
Time clock_time{std::chrono::seconds(1000)};
/// Each read of the clock advances it by this much, so work on a slow host takes long.
Duration look_takes{0};

/// Bound on turns of a host without outside events; a sound host needs a few.
constexpr std::size_t turns_max = 100'000;

} // namespace

} // namespace cd::tests

// Replaces the C++ library's clock in this program.
std::chrono::steady_clock::time_point std::chrono::steady_clock::now() noexcept {
    cd::tests::clock_time += cd::tests::look_takes;
    return cd::tests::clock_time;
}

// Makes Asio's timers follow the simulated clock, not the system's.
extern "C" int timerfd_create(int, int) noexcept {
    return -1;
}

// Makes a failed CD_CHECK a problem of the simulation.
void cd::check_failed(const char* condition, const char* file, int line) {
    const std::string what = std::string(condition) + " at " + file + ":" + std::to_string(line);
    if (tests::World* world = tests::World::current()) {
        world->check_failed(what);
    }
    std::fprintf(stderr, "broken invariant: %s\n", what.c_str());
    std::abort();
}

namespace cd::tests {

Host::Host(std::uint64_t number, std::string called) : id(number), name(std::move(called)) {
    World::current()->hosts_.emplace(id, this);
}

Host::~Host() {
    World::current()->hosts_.erase(id);
}

World::World(std::uint64_t seed, bool logs) : random_(seed), logs_(logs) {
    the_world = this;
    clock_time = Time(std::chrono::seconds(1000));
}

World::~World() {
    events_.clear();
    the_world = nullptr;
}

World* World::current() {
    return the_world;
}

Time World::now() const {
    return clock_time;
}

Duration World::between(Duration least, Duration most) {
    return least + Duration(static_cast<std::int64_t>(
                       below(static_cast<std::uint64_t>((most - least).count()) + 1)));
}

void World::at(Time time, std::function<void()> event) {
    events_.emplace(time, std::move(event));
}

bool World::step() {
    if (events_.empty()) {
        return false;
    }
    const auto event = events_.extract(events_.begin());
    clock_time = std::max(clock_time, event.key());
    have_run_.clear();
    try {
        event.mapped()();
        run_awake();
    } catch (const BrokenInvariant&) {
        // The power cut is already recorded.
    } catch (const PowerCut&) {
        // The problem is already recorded.
    } catch (const std::exception& error) {
        problem(std::string("an exception: ") + error.what());
    }
    look_takes = Duration(0);
    return true;
}

void World::wake_all() {
    for (const auto& [id, host] : hosts_) {
        awake_.insert(id);
    }
}

void World::run_awake() {
    for (const std::uint64_t id : std::exchange(awake_, {})) {
        Host* host = find_host(id);
        if (host == nullptr) {
            continue;
        }
        if (is_stopped(*host)) {
            at(host->stopped_until, [this, id] { awake_.insert(id); });
            continue;
        }
        have_run_.insert(id);
        host->context.restart();
        std::size_t turns = 0;
        while (host->context.poll_one() != 0) {
            if (++turns == turns_max) {
                return problem(host->name + " never comes to rest");
            }
        }
    }
}

void World::log(const std::string& text) const {
    if (logs_) {
        const double seconds =
            std::chrono::duration<double>(now().time_since_epoch()).count() - 1000;
        log_info("t={:.6f} {}", seconds, text);
    }
}

Host* World::host_of(const asio::any_io_executor& executor) {
    const asio::execution_context& context = asio::query(executor, asio::execution::context);
    for (const auto& [id, host] : hosts_) {
        if (&host->context == &context) {
            return host;
        }
    }
    return nullptr;
}

bool World::is_severed(const Host& from, const Host& to) {
    const auto is_so = [&](Trouble trouble, const Host& worker, Time until) {
        if (now() >= until) {
            return false;
        }
        felt(trouble, worker, until);
        return true;
    };
    if (to.id == master_host) {
        return is_so(Trouble::WorkerMute, from, from.mute_until);
    }
    if (from.id == master_host) {
        return is_so(Trouble::WorkerDeaf, to, to.deaf_until);
    }
    return is_so(Trouble::WorkerApart, from, from.apart_until) ||
           is_so(Trouble::WorkerApart, to, to.apart_until);
}

Host* World::find_host(std::uint64_t id) {
    const auto found = hosts_.find(id);
    return found == hosts_.end() ? nullptr : found->second;
}

void World::work_slowly(Duration look, const std::function<void()>& function) {
    look_takes = look;
    function();
    look_takes = Duration(0);
}

// ---- Faults -----------------------------------------------------------------------------------

void World::problem(const std::string& text) {
    log("PROBLEM " + text);
    problems_.push_back(text);
}

void World::check_failed(const std::string& what) {
    problem("broken invariant: " + what);
    throw BrokenInvariant();
}

void World::felt(Trouble trouble, const Host& host, Time since) {
    if (std::exchange(felt_[{trouble, host.id}], since) != since) {
        troubles.add(trouble);
    }
}

void World::felt_stop(const Host& host) {
    if (is_stopped(host)) {
        felt(host.id == master_host ? Trouble::MasterStopped : Trouble::WorkerStopped,
             host,
             host.stopped_until);
    }
}

void World::lose_power() {
    if (disk.lose_power(random_)) {
        troubles.add(Trouble::UnsyncedLost);
    }
}

void World::touch_disk() {
    if (power_cut_after != 0 && --power_cut_after == 0) {
        power_was_cut = true;
        throw PowerCut();
    }
}

bool Files::lose_power(std::mt19937_64& random) {
    bool is_any_gone = false;
    for (auto file = by_path.begin(); file != by_path.end();) {
        SimulatedFile& content = *file->second;
        if (!content.is_named_for_ever && random() % 2 == 0) {
            file = by_path.erase(file);
            is_any_gone = true;
            continue;
        }
        Bytes left = content.durable;
        for (const SimulatedFile::Write& write : content.pending) {
            if (random() % 2 == 0) {
                left.resize(std::max(left.size(), write.offset + write.bytes.size()));
                std::copy(write.bytes.begin(),
                          write.bytes.end(),
                          left.begin() + static_cast<std::ptrdiff_t>(write.offset));
            }
        }
        content.pending.clear();
        is_any_gone |= content.content != left;
        content.content = left;
        content.durable = std::move(left);
        ++file;
    }
    return is_any_gone;
}

Files& safe_files() {
    static Files files;
    return files;
}

} // namespace cd::tests
