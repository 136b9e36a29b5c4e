// What a person can do about a state that is damaged.
#pragma once

#include "common/core/result.hpp"

namespace cd {

/// The master has stopped at it.
[[nodiscard]] inline Error with_way_out(const Error& damage) {
    return {damage.code,
            damage.detail +
                "; nothing was changed: restore the state directory from a copy, or move it away "
                "and start with an empty one (`cdmaster check` tells all that is wrong)"};
}

} // namespace cd
