#include "client/base/exit_code.hpp"

namespace cd {

int exit_code_of(const Error& error, int signal) {
    switch (error.code) {
    case ErrorCode::BadInput:
    case ErrorCode::NotFound:
    case ErrorCode::TooLarge:
    case ErrorCode::Io:
        return exit_usage;
    case ErrorCode::Timeout:
    case ErrorCode::Disconnected:
        return exit_unreachable;
    case ErrorCode::BadFrame:
    case ErrorCode::Refused:
        return exit_refused;
    case ErrorCode::Incomplete:
        return exit_incomplete;
    case ErrorCode::Interrupted:
        return exit_signal_base + signal;
    }
    return exit_usage;
}

} // namespace cd
