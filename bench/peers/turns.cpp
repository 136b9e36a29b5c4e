#include "bench/peers/turns.hpp"

#include "common/core/check.hpp"

#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>

namespace cd::bench {

namespace {

void stay_on(int cpu) {
    if (cpu < 0) {
        return;
    }
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(static_cast<std::size_t>(cpu), &set);
    CD_CHECK(::sched_setaffinity(0, sizeof set, &set) == 0);
}

[[noreturn]] void serve(int link, const std::function<void(std::uint32_t)>& work) {
    std::uint32_t number = 0;
    while (::recv(link, &number, sizeof number, MSG_WAITALL) == sizeof number) {
        work(number);
        std::fflush(nullptr);
        if (::send(link, &number, sizeof number, MSG_NOSIGNAL) != sizeof number) {
            break;
        }
    }
    ::_exit(0);
}

} // namespace

TurnTaker::TurnTaker(int cpu, const std::function<void(std::uint32_t)>& work) {
    std::array<int, 2> ends{};
    CD_CHECK(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0); // NOLINT
    std::fflush(nullptr);
    child_ = ::fork();
    CD_CHECK(child_ >= 0);
    if (child_ == 0) {
        ::close(ends[0]);
        const rlimit no_core{0, 0};
        static_cast<void>(::setrlimit(RLIMIT_CORE, &no_core));
        static_cast<void>(::prctl(PR_SET_PDEATHSIG, SIGKILL));
        stay_on(cpu);
        serve(ends[1], work);
    }
    ::close(ends[1]);
    link_ = ends[0];
}

TurnTaker::~TurnTaker() {
    end(ending_);
    ::close(link_);
}

void TurnTaker::end(Ending ending) {
    ending_ = ending;
    if (child_ > 0) {
        static_cast<void>(::kill(child_, SIGKILL));
        CD_CHECK(::waitpid(child_, nullptr, 0) == child_);
        child_ = -1;
    }
}

Ending TurnTaker::take_turn(std::uint32_t number, std::chrono::seconds limit) {
    if (ending_ != Ending::Done) {
        return ending_;
    }
    std::uint32_t echo = 0;
    pollfd wait{link_, POLLIN, 0};
    if (::send(link_, &number, sizeof number, MSG_NOSIGNAL) != sizeof number) {
        end(Ending::Crashed);
    } else if (::poll(&wait, 1, static_cast<int>(1000 * limit.count())) == 0) {
        end(Ending::TimedOut);
    } else if (::recv(link_, &echo, sizeof echo, MSG_WAITALL) != sizeof echo) {
        end(Ending::Crashed);
    }
    return ending_;
}

} // namespace cd::bench
