// Advice for a person whose state directory is damaged.
#pragma once

#include "common/core/result.hpp"

namespace cd {

/// Adds the advice to the error that stopped the master.
[[nodiscard]] inline Error with_remedy(const Error& damage) {
    return {damage.code,
            damage.detail +
                "; nothing was changed: restore the state directory from a copy, or move it away "
                "and start with an empty one (`cdmaster check` lists all damage)"};
}

} // namespace cd
