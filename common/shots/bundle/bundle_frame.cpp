// Bounds, with u = 2^-53, X for the reach and L for the stretch, which bounds the length of a row.
//
// Vertices: the relative pose errs by r in each entry and by t_e in each component of t, so exact
// values of row . x + t err by 3 r X + t_e. Three products and three sums of magnitudes that add up
// to at most 1.74 * 1.74 L X + |t| err by 4 u of these; 5 u (3.1 L X + |t|) has room.
//
// Boxes of children, with v = 2^-24 and e = axes_error_max = 2 v: S bounds the sum of 255 steps,
// times L. A point of a child is at the origin o plus F^-1 k for numbers k in its box, and
// |F^-1 - F'| is below 3.01 e in the spectral norm, so that row . F' k errs by 6.1 v S. The
// products row . F' are formed in doubles, and their products with the steps rounded to floats: v
// S. The products with bytes, which are whole, and three sums err by 4 v (S + |base|), the base's
// rounding by v |base|, and the sum with the margin by v (S + |base|): below 13 v (S + |base|). 16
// v (S + |base|) has room. The base itself errs as a vertex does, as X bounds origins as well.
#include "common/shots/bundle/bundle_frame.hpp"

#include "common/shots/rigid_pose.hpp"

#include <algorithm>
#include <cmath>

namespace cd {

namespace {

constexpr double u = 0x1p-53;

/// Returns the bound for a point whose coordinates are at most `reach`.
double error_of(const RelativePose& a_to_b, double stretch, double reach) {
    const double far = a_to_b.translation.cwiseAbs().maxCoeff();
    return 1.01 * (3 * a_to_b.rotation_error * reach + a_to_b.translation_error +
                   5 * u * (3.1 * stretch * reach + far)) +
           0x1p-1000;
}

} // namespace

bool BundleFrame::suits(const PosePair& poses) {
    return is_rigid(poses.b);
}

BundleFrame::BundleFrame(const PosePair& poses, std::size_t axis, double reach) {
    const RelativePose a_to_b = relative_pose({poses.b, poses.a});
    for (std::size_t i = 0; i < 3; ++i) {
        const auto row = static_cast<Eigen::Index>((axis + i) % 3);
        rows_[i] = {a_to_b.rotation(row, 0), a_to_b.rotation(row, 1), a_to_b.rotation(row, 2)};
        translation_[i] = a_to_b.translation[row];
    }
    stretch_ = std::max(1.0, 1.001 * a_to_b.rotation.rowwise().norm().maxCoeff());
    error_ = error_of(a_to_b, stretch_, reach);
}

NodeAcross
node_across(const WideNode& node, const BundleFrame& frame, const std::array<double, 2>& middle) {
    constexpr double v = 0x1p-24;
    const double steps = double{node.steps[0]} + double{node.steps[1]} + double{node.steps[2]};
    const double size = 255 * steps * frame.stretch();
    NodeAcross across;
    for (std::size_t which = 0; which < 2; ++which) {
        const std::array<double, 3>& row = frame.rows()[1 + which];
        NodeAcross::Axis& axis = across.axes[which];
        const double base = row[0] * node.origin[0] + row[1] * node.origin[1] +
                            row[2] * node.origin[2] + frame.translation()[1 + which] -
                            middle[which];
        axis.base = static_cast<float>(base);
        for (std::size_t k = 0; k < 3; ++k) {
            double along = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                along += row[c] * double{node.columns[c][k]};
            }
            axis.steps[k] = static_cast<float>(along * double{node.steps[k]});
        }
        axis.margin =
            static_cast<float>(1.01 * (16 * v * (size + std::abs(base)) + 2 * frame.error()));
    }
    return across;
}

} // namespace cd
