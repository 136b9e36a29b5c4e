// Return types for errors that a caller is expected to handle.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace cd {

enum class ErrorCode {
    BadInput,     ///< A file, option or field is invalid. Exit code 2.
    BadFrame,     ///< The bytes are not a message of this protocol.
    TooLarge,     ///< A limit of `common/core/limits/` is exceeded.
    Timeout,      ///< The peer did not answer before the deadline.
    Disconnected, ///< The peer cannot be reached, or closed or reset the connection. Exit code 4.
    Refused,      ///< The peer rejected the request (version, authorisation). Exit code 5.
    NotFound,     ///< The named job, mesh or file does not exist.
    Io,           ///< The operating system failed a read or write.
    Incomplete,   ///< The job ended without an answer for some scenario. Exit code 3.
    Interrupted,  ///< The user or the operator ended the work.
};

struct Error {
    ErrorCode code;
    std::string detail; ///< One sentence for a person: cause, location and remedy. Never parsed.
};

/// Holds a value or an error.
template <class T>
class [[nodiscard]] Result {
  public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

    [[nodiscard]] bool has_value() const { return state_.index() == 0; }
    explicit operator bool() const { return has_value(); }

    [[nodiscard]] T& value() { return std::get<0>(state_); }
    [[nodiscard]] const T& value() const { return std::get<0>(state_); }
    [[nodiscard]] const Error& error() const { return std::get<1>(state_); }

  private:
    std::variant<T, Error> state_;
};

/// The value of a successful `Status`.
struct Done {};
using Status = Result<Done>;

} // namespace cd
