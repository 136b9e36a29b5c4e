// Points that nearly span the contents of the nodes of a wide tree.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace cd {

/// The points of a node: every vertex below the node is within `eps` of their convex hull.
struct SupportSet {
    std::uint32_t first = 0; ///< Index of the first point; see `is_chosen`.
    std::uint16_t count = 0; ///< Number of points; 0 if the node has none.
    /// True: points of `SupportView::columns`. False: vertices of the tree's triangle blocks; these
    /// are all vertices below the node.
    bool is_chosen = false;
    std::uint8_t unused = 0; ///< Padding; defines every byte of a set in a file.
    float eps = 0;           ///< A length; 0 unless `is_chosen`.
};
static_assert(sizeof(SupportSet) == 12);

/// Chosen points are padded to a multiple of this number by copies of the last one.
inline constexpr std::uint32_t support_padding = 16;

/// Returns the padded number of chosen points.
[[nodiscard]] constexpr std::uint32_t padded(std::uint32_t count) {
    return (count + support_padding - 1) / support_padding * support_padding;
}

/// A view of the points of a wide tree. Empty where they have not been made.
struct SupportView {
    std::span<const SupportSet> sets; ///< A set for each node of the tree.
    /// Chosen points less `center`, rounded to floats. A set of n points, with n padded, has its n
    /// first coordinates from `3 * first` on, then the second and the third ones.
    std::span<const float> columns;
    std::array<float, 3> center{}; ///< The origin of points; a point of the body's coordinates.
    double radius = 0;             ///< Bounds the distance of each vertex from `center`.
    /// Names the points: no other points that this process makes or reads have the same number.
    std::uint64_t id = 0;
};

/// Returns the next `SupportView::id`.
[[nodiscard]] std::uint64_t next_support_id();

} // namespace cd
