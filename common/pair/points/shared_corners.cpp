#include "common/pair/points/shared_corners.hpp"

#include "common/core/check.hpp"
#include "common/pair/poses/plain_poses.hpp"

namespace cd {

namespace {

using pair_decision::all_are;
using pair_decision::next;
using pair_decision::open_view;
using pair_decision::View;

using Kind = SharedCorner::Kind;

void add(SharedCorners& found, Kind kind, std::size_t first, std::size_t second = 0) {
    CD_CHECK(found.count < found.corner.size());
    found.corner[found.count++] = {
        kind, static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second)};
}

/// Locates a point in a triangle's plane by the point's turns against the three edges. Inside the
/// triangle all have one sign; on an edge one turn is 0, at a corner two are.
struct Site {
    bool is_within = false;
    int zeros = 0;

    explicit Site(const std::array<int, 3>& turns) {
        bool left = false;
        bool right = false;
        for (const int turn : turns) {
            left = left || turn > 0;
            right = right || turn < 0;
            zeros += turn == 0 ? 1 : 0;
        }
        is_within = !(left && right);
    }
};

/// Finds the shared corners of coplanar triangles, projected along `axis`, where both have area.
/// The shared corners are exactly the corners of one triangle in the other, and the proper
/// crossings of two edges.
template <CornerSigns Signs>
SharedCorners find_in_plane(Signs& signs, std::size_t axis) {
    std::array<std::array<int, 3>, 3> of_a{}; // [i][j]: turn of A's corner i against B's edge j.
    std::array<std::array<int, 3>, 3> of_b{}; // [j][i]: turn of B's corner j against A's edge i.
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            of_a[i][j] = signs.turn(3 + j, 3 + next(j), i, axis);
            of_b[j][i] = signs.turn(i, next(i), 3 + j, axis);
        }
    }
    SharedCorners found;
    for (std::size_t i = 0; i < 3; ++i) {
        if (Site(of_a[i]).is_within) {
            add(found, Kind::Corner, i);
        }
        const Site site(of_b[i]);
        if (site.is_within && site.zeros < 2) { // Otherwise A has the same corner.
            add(found, Kind::Corner, 3 + i);
        }
        for (std::size_t j = 0; j < 3; ++j) {
            if (of_a[i][j] * of_a[next(i)][j] < 0 && of_b[j][i] * of_b[next(j)][i] < 0) {
                add(found, Kind::Crossing, i, 3 + j);
            }
        }
    }
    return found;
}

/// Finds the shared corners of triangles with area in different planes. All shared points lie on
/// the line of both planes.
template <CornerSigns Signs>
class LineSearch {
  public:
    LineSearch(Signs& signs, const PlaneSides& of_a, const PlaneSides& of_b)
        : signs_(signs), of_a_(of_a), of_b_(of_b) {}

    [[nodiscard]] SharedCorners find() {
        add_corners(0, of_a_, 3);
        add_corners(3, of_b_, 0);
        add_piercings_of_a();
        add_piercings_of_b();
        return found_;
    }

  private:
    /// Adds the corners of the triangle from corner `own` on that lie in the other triangle. A
    /// corner that both triangles have is added only as A's.
    void add_corners(std::size_t own, const PlaneSides& sides, std::size_t other) {
        std::optional<View> view;
        for (std::size_t i = 0; i < 3; ++i) {
            if (sides[i] != 0) {
                continue;
            }
            if (!view) {
                view = open_view(signs_, other);
            }
            std::array<int, 3> turns{};
            for (std::size_t j = 0; j < 3; ++j) {
                turns[j] = signs_.turn(other + j, other + next(j), own + i, view->axis);
            }
            const Site site(turns);
            if (site.is_within && (own == 0 || site.zeros < 2)) {
                add(found_, Kind::Corner, own + i);
            }
        }
    }

    void add_piercings_of_a() {
        for (std::size_t i = 0; i < 3; ++i) {
            if (of_a_[i] * of_a_[next(i)] >= 0) {
                continue;
            }
            const Site site({side(i, 0), side(i, 1), side(i, 2)});
            // `add_corners` adds a corner of B at this point.
            if (site.is_within && site.zeros < 2) {
                add(found_, Kind::Piercing, i);
            }
        }
    }

    void add_piercings_of_b() {
        for (std::size_t j = 0; j < 3; ++j) {
            if (of_b_[j] * of_b_[next(j)] >= 0) {
                continue;
            }
            const Site site({side(0, j), side(1, j), side(2, j)});
            if (!site.is_within || site.zeros == 2) {
                continue;
            }
            // Skips a point on an edge of A that pierces B's plane: `add_piercings_of_a` has found
            // the point.
            std::size_t met = 0;
            while (met < 3 && side(met, j) != 0) {
                ++met;
            }
            if (met == 3 || of_a_[met] * of_a_[next(met)] == 0) {
                add(found_, Kind::Piercing, 3 + j);
            }
        }
    }

    /// Returns the side on which B's edge j passes A's edge i.
    int side(std::size_t i, std::size_t j) {
        int& known = sides_[i][j];
        if (known == unknown_sign) {
            known = signs_.edge_side(i, next(i), 3 + j, 3 + next(j));
        }
        return known;
    }

    Signs& signs_;
    const PlaneSides& of_a_;
    const PlaneSides& of_b_;
    std::array<PlaneSides, 3> sides_{unknown_sides, unknown_sides, unknown_sides};
    SharedCorners found_;
};

template <CornerSigns Signs>
std::optional<SharedCorners> find_corners(Signs& signs) {
    const PlaneSides of_a = signs.sides_of_a();
    const PlaneSides of_b = signs.sides_of_b();
    const bool a_flat = all_are(of_a, 0);
    const bool b_flat = all_are(of_b, 0);
    if (a_flat && b_flat) {
        const View view = open_view(signs, 0);
        if (view.turn == 0 || signs.turn(3, 4, 5, view.axis) == 0) {
            return std::nullopt;
        }
        return find_in_plane(signs, view.axis);
    }
    if (a_flat || b_flat) {
        return std::nullopt; // One triangle is degenerate: see `decide_pair`.
    }
    return LineSearch<Signs>(signs, of_a, of_b).find();
}

struct Task {
    const Corners& a;
    const Corners& b;
    const PlaneSides& of_a;
    const PlaneSides& of_b;
};

template <std::size_t n>
std::optional<SharedCorners> find_on(const LatticeCorners<n>& corners, const Task& task) {
    IntegerSigns<n> signs(corners, task.of_a, task.of_b);
    return find_corners(signs);
}

/// Finds the shared corners with the smallest number of words that holds the corners; nothing if no
/// number does.
template <std::size_t n, std::size_t... more>
std::optional<SharedCorners>
find_on(const PoseLattice& lattice, const PoseLattice::Extent& extent, const Task& task) {
    if (extent.bits <= wide_int::bits_max(n)) {
        return find_on(lattice.corners<n>(task.a, task.b, extent), task);
    }
    if constexpr (sizeof...(more) > 0) {
        return find_on<more...>(lattice, extent, task);
    }
    return std::nullopt;
}

} // namespace

SharedCornerFinder::SharedCornerFinder(const PosePair& poses) : poses_(plain_poses(poses)) {
    if (permutes_axes(poses_.a) && permutes_axes(poses_.b)) {
        short_lattice_.emplace(poses_);
    }
}

std::optional<SharedCorners> SharedCornerFinder::find(const Corners& a,
                                                      const Corners& b,
                                                      const PlaneSides& of_a,
                                                      const PlaneSides& of_b) {
    const Task task{a, b, of_a, of_b};
    if (short_lattice_) {
        if (const auto corners = short_lattice_->corners<1>(a, b)) {
            return find_on(*corners, task);
        }
        if (const auto corners = short_lattice_->corners<2>(a, b)) {
            return find_on(*corners, task);
        }
    }
    if (!lattice_) {
        lattice_ = std::make_unique<PoseLattice>(poses_);
    }
    if (!lattice_->fits()) {
        return std::nullopt;
    }
    return find_on<1, 2, 3, 4, 5, 6, 8>(*lattice_, lattice_->extent_of(a, b), task);
}

} // namespace cd
