#include "client/interrupt.hpp"

namespace cd {

namespace {

volatile std::sig_atomic_t received = 0;

void remember(int signal) {
    received = signal;
}

} // namespace

InterruptGuard::InterruptGuard() {
    received = 0;
    struct sigaction action {};
    action.sa_handler = remember;
    action.sa_flags = SA_RESETHAND | SA_RESTART;
    sigaction(SIGINT, &action, &old_interrupt_);
    sigaction(SIGTERM, &action, &old_terminate_);
}

InterruptGuard::~InterruptGuard() {
    sigaction(SIGINT, &old_interrupt_, nullptr);
    sigaction(SIGTERM, &old_terminate_, nullptr);
}

int InterruptGuard::signal() {
    return received;
}

} // namespace cd
