// The unit and the up axis that a mesh file declares.
#pragma once

#include <string>

namespace cd {

/// Members are empty or 0 where neither the file nor its format declares them.
struct DeclaredFrame {
    std::string unit;  ///< The unit's name in the file: "inch".
    double metres = 0; ///< Length of one unit in metres.
    std::string up;    ///< "X", "Y" or "Z".

    friend bool operator==(const DeclaredFrame&, const DeclaredFrame&) = default;
};

} // namespace cd
