// The version of the three programs. It equals the version of the CMake project.
#pragma once

#include <string_view>

namespace cd {

inline constexpr std::string_view version = "0.1.0";

} // namespace cd
