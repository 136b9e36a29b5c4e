#include "client/base/interrupt.hpp"

#include "client/base/exit_code.hpp"

#include <unistd.h>

#include <string_view>

namespace cd {

namespace {

volatile std::sig_atomic_t received = 0;

void remember(int signal) {
    received = signal;
}

/// Ends the process with a message. Calls only async-signal-safe functions.
void end_process(int signal) {
    constexpr std::string_view line = "\ncdctl: interrupted\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, line.data(), line.size());
    ::_exit(exit_signal_base + signal);
}

void handle(void (*handler)(int),
            struct sigaction* old_interrupt,
            struct sigaction* old_terminate) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESETHAND | SA_RESTART;
    sigaction(SIGINT, &action, old_interrupt);
    sigaction(SIGTERM, &action, old_terminate);
}

} // namespace

InterruptGuard::InterruptGuard(First first) {
    received = 0;
    handle(first == First::SetsFlag ? remember : end_process, &old_interrupt_, &old_terminate_);
}

void InterruptGuard::begin_to_flag() {
    if (received == 0) {
        handle(remember, nullptr, nullptr);
    }
}

void InterruptGuard::begin_to_end() {
    handle(end_process, nullptr, nullptr);
    if (received != 0) {
        end_process(received);
    }
}

InterruptGuard::~InterruptGuard() {
    sigaction(SIGINT, &old_interrupt_, nullptr);
    sigaction(SIGTERM, &old_terminate_, nullptr);
}

int InterruptGuard::signal() {
    return received;
}

} // namespace cd
