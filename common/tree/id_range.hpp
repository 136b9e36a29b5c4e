// A run of a mesh's triangles.
#pragma once

#include <compare>
#include <cstdint>

namespace cd {

/// Triangles [begin, end), by their ids.
struct IdRange {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;

    friend auto operator<=>(const IdRange&, const IdRange&) = default;
};

} // namespace cd
