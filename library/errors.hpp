// Turns errors of the engine into exceptions of the library.
#pragma once

#include "common/core/result.hpp"

#include <utility>

namespace cdcluster {

[[noreturn]] void throw_error(const cd::Error& error);

/// Returns the value of a result. Throws its error.
template <class T>
[[nodiscard]] T value_of(cd::Result<T> result) {
    if (!result) {
        throw_error(result.error());
    }
    return std::move(result.value());
}

inline void check(const cd::Status& status) {
    if (!status) {
        throw_error(status.error());
    }
}

} // namespace cdcluster
