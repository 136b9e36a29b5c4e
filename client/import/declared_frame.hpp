// What a mesh file says of its unit and its axes.
#pragma once

#include <string>

namespace cd {

/// Empty and 0 where the file, and its format, say nothing.
struct DeclaredFrame {
    std::string unit;  ///< As the file calls it: "inch".
    double metres = 0; ///< Of one unit.
    std::string up;    ///< "X", "Y" or "Z".

    friend bool operator==(const DeclaredFrame&, const DeclaredFrame&) = default;
};

} // namespace cd
