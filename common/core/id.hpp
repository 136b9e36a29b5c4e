// Numeric identifiers, with a type for each kind of object.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace cd {

/// Identifies one object of kind Tag.
template <class Tag>
struct Id {
    std::uint64_t value = 0;

    friend auto operator<=>(const Id&, const Id&) = default;
};

using JobId = Id<struct JobTag>;
using WorkerId = Id<struct WorkerTag>;
using TaskId = Id<struct TaskTag>; ///< Identifies a batch or a range sent to one worker.

} // namespace cd

template <class Tag>
struct std::hash<cd::Id<Tag>> {
    std::size_t operator()(const cd::Id<Tag>& id) const noexcept {
        return std::hash<std::uint64_t>{}(id.value);
    }
};
