// Finds the pairs of triangles of two wide trees whose boxes may overlap.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/tree/neighbours/last_contacts.hpp"
#include "common/tree/planes/plane_stack.hpp"
#include "common/tree/wide/wide_kernel.hpp"
#include "common/tree/wide/wide_tree.hpp"

#include <cstdint>
#include <memory>
#include <span>

namespace cd {

/// Descends two wide trees simultaneously under one relative pose. Never skips a pair that touches,
/// in exact terms. Keeps scratch memory between calls; one thread at a time may use it.
///
/// Where both trees have support points, a descent that expects no contact goes depth first and
/// opens a pair of nodes only if no plane parts them. So bodies that nearly touch are parted by few
/// planes between large nodes, where boxes would have to be opened down to the leaves.
class WideDescent {
  public:
    /// `error_scale` multiplies both margins. Skipped pairs are proven to be apart only if the
    /// scale is at least 1; tests use less to show that the margins are needed.
    explicit WideDescent(const RelativePose& b_to_a, double error_scale = 1);

    /// Forgets all pairs and counters, and takes another pose. Keeps scratch memory. Then never
    /// skips a pair of triangles that is at most `reach` apart in A's coordinates and in B's.
    void restart(const RelativePose& b_to_a, double reach = 0);

    /// Selects the order of the descent.
    enum class Aim : std::uint8_t {
        All,         ///< Finds every candidate: many pairs of nodes are visited together.
        AllUnlikely, ///< Finds every candidate, of which there is likely none: begins with planes,
                     ///< and goes on like All after the first candidate.
        First,       ///< Finds a first contact that may not exist: like All, but yields candidates
                     ///< sooner, and goes on with planes.
        LikelyFirst, ///< Finds a likely first contact: looks near the last contacts, if the pose
                     ///< is near the last one; then visits the most promising pairs of nodes
                     ///< (`PairBuckets`) one by one, and goes on like First after `dive_visits`.
        Nearest,     ///< Finds all pairs within a reach that shrinks: nearest boxes first.
        Any,         ///< LikelyFirst if the answers noted before make a contact likely, else First.
    };

    /// Number of visits of most promising pairs in LikelyFirst. These visits find nearly all
    /// existing contacts; each costs more than a later visit.
    static constexpr std::uint32_t dive_visits = 16;
    /// The same before planes, which find a contact later than boxes would.
    static constexpr std::uint32_t dive_visits_before_planes = 24;
    /// The same near the last contacts.
    static constexpr std::uint32_t dive_visits_near_last = 8;

    /// Changes the reach; during a descent only to a smaller one.
    void set_reach(double reach);

    /// Takes a unit vector in A's coordinates for a descent with the aim Nearest. The better it
    /// parts the bodies where they are nearest, the more pairs are skipped.
    void set_direction(const Vec3& direction);

    /// Begins a descent at the roots. The trees have nodes and outlive the descent.
    void start(const WideView& a, const WideView& b, Aim aim = Aim::All);
    [[nodiscard]] bool is_done() const {
        return !dive_.is_near_last &&
               walk_.waiting_count + walk_.leaf_count + walk_.ranked.size() + planes_.size() == 0;
    }
    /// Returns more candidates, as slots of the triangle blocks: about `wanted`, or fewer (even
    /// none) after much work. The candidates are valid until the next call.
    [[nodiscard]] std::span<Candidate> next(std::size_t wanted);
    /// Notes that a candidate of the last call of `next` touches, for later descents. Takes the
    /// trees of the last call of `start`.
    void note_contact(const WideView& a, const WideView& b, const Candidate& candidate) {
        last_.add(a, b, candidate);
    }
    /// Notes whether the bodies touch under the present pose, for later descents.
    void note_answer(bool touches) { last_.note_answer(touches); }

    /// Returns the number of box tests since `restart` was called.
    [[nodiscard]] std::uint64_t box_tests() const { return walk_.box_tests; }
    /// Returns the number of pairs of nodes visited since `restart` was called.
    [[nodiscard]] std::uint64_t visits() const { return walk_.visits; }

  private:
    void set_margin();
    void visit_nearest();
    void begin_dive();
    void dive_at_roots();
    void dive();
    void end_dive();
    void part();
    void leave_planes();
    void grow();

    /// Visits of the most promising pairs.
    struct Dive {
        std::uint32_t visits_left = 0;
        bool is_near_last = false; ///< Visits pairs near the last contacts.
    };

    /// How a descent goes on, from its aim and the trees.
    struct Course {
        bool has_planes = false; ///< Both trees have support points.
        bool is_for_all = true;  ///< The aim is All.
        bool is_nearest = false; ///< The aim is Nearest.
    };

    struct Margins {
        double error_scale = 1;
        double reach = 0;
        double absolute = 0; ///< A length, without the reach.
    };

    Dive dive_;
    Course course_;
    RelativePose b_to_a_;
    Margins margins_;
    WidePose pose_;
    WideWalk walk_;
    PlaneStack planes_;
    LastContacts last_;
    // Arrays, because a vector would initialise elements that are written before they are read.
    std::unique_ptr<WidePair[]> waiting_;
    std::unique_ptr<Candidate[]> candidates_;
    std::size_t candidates_room_ = 0;
};

} // namespace cd
