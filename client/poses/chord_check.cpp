#include "client/poses/chord_check.hpp"

#include "client/curves/pose_curve.hpp"
#include "common/core/words.hpp"

namespace cd {

Status check_chord(const JobSpec& spec, double moved) {
    if (!spec.chord || moved <= grid_share * *spec.chord) {
        return Done{};
    }
    return error_at_key(spec,
                        "chord",
                        "[motion]: chord = " + exact_text(*spec.chord) +
                            " is too small, since rounding of the keys moves two bodies by up to " +
                            exact_text(moved) + "; make it at least " +
                            exact_text(moved / grid_share));
}

} // namespace cd
