// A range of a mesh's triangle ids.
#pragma once

#include <compare>
#include <cstdint>

namespace cd {

/// The triangles with ids [begin, end).
struct IdRange {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;

    friend auto operator<=>(const IdRange&, const IdRange&) = default;
};

} // namespace cd
