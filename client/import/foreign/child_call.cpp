#include "client/import/foreign/child_call.hpp"

#include "common/core/timing/engine.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>
#include <span>

namespace cd {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool memory_can_be_bounded = false; // Sanitizers map terabytes.
#else
constexpr bool memory_can_be_bounded = true;
#endif

constexpr int exit_out_of_memory = 3;

/// Owns a file descriptor.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close_now(); }

    [[nodiscard]] int number() const { return number_; }
    void close_now() {
        if (number_ >= 0) {
            close(number_);
        }
        number_ = -1;
    }

  private:
    int number_;
};

std::uint64_t mapped_bytes() {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void bound(decltype(RLIMIT_AS) resource, std::uint64_t value, std::uint64_t hard) {
    rlimit limit{};
    getrlimit(resource, &limit);
    limit.rlim_max = std::min<rlim_t>(limit.rlim_max, hard);
    limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, value);
    setrlimit(resource, &limit);
}

void take_default_signals() {
    for (int signal = 1; signal < NSIG; ++signal) {
        ::signal(signal, SIG_DFL); // Fails for SIGKILL and SIGSTOP, harmlessly.
    }
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
}

void leave_the_terminal() {
    const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        dup2(nothing, stream);
    }
}

void take_limits(const ChildLimits& limits, std::uint64_t mapped) {
    const auto seconds = static_cast<std::uint64_t>(limits.processor_time.count());
    bound(RLIMIT_CORE, 0, 0);
    bound(RLIMIT_CPU, seconds, seconds + 1);
    if (memory_can_be_bounded) {
        bound(RLIMIT_AS, mapped + limits.memory_bytes, mapped + limits.memory_bytes);
    }
}

bool write_all(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            return false;
        }
        bytes = bytes.subspan(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
    return true;
}

[[noreturn]] void answer(const std::function<Bytes()>& work, int descriptor) {
    try {
        _exit(write_all(descriptor, work()) ? 0 : 1);
    } catch (const std::bad_alloc&) {
        _exit(exit_out_of_memory);
    } catch (...) {
        _exit(1);
    }
}

/// Owns a child process: the destructor kills it and collects its status.
class Child {
  public:
    explicit Child(pid_t id) : id_(id) {}
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        if (id_ > 0) {
            kill();
            static_cast<void>(wait());
        }
    }

    void kill() const { ::kill(id_, SIGKILL); }

    int wait() {
        int status = 0;
        while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
        }
        id_ = 0;
        return status;
    }

  private:
    pid_t id_;
};

/// Appends to `bytes` until the writing end is closed. Returns Answered, OutOfTime or Stopped.
ChildEnd read_until_end(int descriptor,
                        std::chrono::seconds time,
                        const StopCheck& is_stopped,
                        Bytes& bytes) {
    const auto deadline = std::chrono::steady_clock::now() + time;
    std::array<std::byte, 1u << 16> piece{};
    for (;;) {
        if (is_stopped && is_stopped()) {
            return ChildEnd::Stopped;
        }
        if (std::chrono::steady_clock::now() > deadline) {
            return ChildEnd::OutOfTime;
        }
        pollfd wanted{descriptor, POLLIN, 0};
        if (poll(&wanted, 1, static_cast<int>(timing::stop_check_period.count())) <= 0) {
            continue;
        }
        const ssize_t got = read(descriptor, piece.data(), piece.size());
        if (got == 0) {
            return ChildEnd::Answered;
        }
        bytes.insert(bytes.end(), piece.begin(), piece.begin() + std::max<ssize_t>(got, 0));
    }
}

ChildEnd end_of(int status) {
    if (WIFEXITED(status)) {
        const int code = WEXITSTATUS(status);
        return code == 0                    ? ChildEnd::Answered
               : code == exit_out_of_memory ? ChildEnd::OutOfMemory
                                            : ChildEnd::Crashed;
    }
    switch (WTERMSIG(status)) {
    case SIGXCPU:
    case SIGKILL: // The kernel sends it when SIGXCPU did not end the child.
        return ChildEnd::OutOfTime;
    case SIGINT:
    case SIGTERM:
    case SIGHUP:
        return ChildEnd::Stopped;
    default:
        return ChildEnd::Crashed;
    }
}

} // namespace

Result<ChildAnswer> call_in_child(const std::function<Bytes()>& work,
                                  const ChildLimits& limits,
                                  const StopCheck& is_stopped) {
    const auto no_room = [] {
        return Error{ErrorCode::Io,
                     std::string("no process for the reader: ") + std::strerror(errno)};
    };
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
        return no_room();
    }
    const Descriptor from_child(ends[0]);
    Descriptor to_parent(ends[1]);
    const std::uint64_t mapped = mapped_bytes();
    const pid_t parent = getpid();
    const pid_t id = fork();
    if (id < 0) {
        return no_room();
    }
    if (id == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != parent) {
            _exit(1); // The parent died before prctl took effect.
        }
        take_default_signals();
        leave_the_terminal();
        take_limits(limits, mapped);
        answer(work, to_parent.number());
    }
    Child child(id);
    to_parent.close_now();
    ChildAnswer answer;
    answer.end = read_until_end(from_child.number(), limits.real_time, is_stopped, answer.bytes);
    if (answer.end == ChildEnd::Answered) {
        answer.end = end_of(child.wait());
    }
    return answer;
}

} // namespace cd
