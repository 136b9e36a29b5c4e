#include "common/tree/node_check.hpp"

#include "common/tree/build_fit.hpp"

#include <cmath>
#include <limits>

namespace cd {

bool is_valid_box(const ObbNode& node) {
    // Comparisons are written so that NaN fails them.
    for (std::size_t i = 0; i < 3; ++i) {
        if (!std::isfinite(node.center[i]) ||
            !(node.half[i] >= std::numeric_limits<float>::min())) {
            return false;
        }
        for (std::size_t j = i; j < 3; ++j) {
            double dot = i == j ? -1.0 : 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                dot += static_cast<double>(node.axes[3 * i + k]) *
                       static_cast<double>(node.axes[3 * j + k]);
            }
            if (!(std::abs(dot) <= axes_error_max)) {
                return false;
            }
        }
    }
    return true;
}

} // namespace cd
