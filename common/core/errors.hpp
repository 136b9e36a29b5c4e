// Making errors, and passing them on to the caller.
#pragma once

#include "common/core/result.hpp"

#include <filesystem>
#include <string>
#include <utility>

/// Moves the value out of a `Result`: `auto mesh = CD_TRY(read_mesh(path));`. If the result holds
/// an error, the enclosing function returns that error. For a `Status`, the macro is a statement.
/// It cannot be used in constructors or coroutines, nor as a part of a larger expression. It uses
/// the statement expressions of GCC and Clang.
#define CD_TRY(...) CD_TRY_EXPANDED(__COUNTER__, __VA_ARGS__)
#define CD_TRY_EXPANDED(number, ...) CD_TRY_NAMED(tried_##number, __VA_ARGS__)
#define CD_TRY_NAMED(tried, ...)                                                                   \
    __extension__({                                                                                \
        auto&& tried = __VA_ARGS__;                                                                \
        if (!tried) {                                                                              \
            return tried.error();                                                                  \
        }                                                                                          \
        std::move(tried.value());                                                                  \
    })

namespace cd {

[[nodiscard]] inline Error bad_input(std::string detail) {
    return {ErrorCode::BadInput, std::move(detail)};
}
/// Returns the error BadInput "PATH: DETAIL".
[[nodiscard]] inline Error bad_input(const std::filesystem::path& path, const std::string& detail) {
    return bad_input(path.string() + ": " + detail);
}

/// An exception that ends the reading of a document. The readers of the document's parts throw it;
/// the function that began the reading catches it.
struct Refusal {
    Error error;
};

/// Returns `result`; if it holds an error, puts `place` before the error's detail.
template <class T>
[[nodiscard]] Result<T> within(const std::string& place, Result<T> result) {
    return result ? std::move(result) : Error{result.error().code, place + result.error().detail};
}

} // namespace cd
