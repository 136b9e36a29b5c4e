// Groups of contacts: pairs of parts that are in contact, or near, in at least one scenario.
#pragma once

#include "client/groups/body_parts.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/result/part_contacts.hpp"
#include "common/job/result/result.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace cd {

/// A run of consecutive scenarios in which a group is in contact or near.
struct Episode {
    std::uint64_t first = 0;
    std::uint64_t last = 0;

    friend bool operator==(const Episode&, const Episode&) = default;
};

/// The episodes of a group.
struct GroupEpisodes {
    std::uint64_t count = 0;      ///< 0 if unknown. Then `first` spans all scenarios of the group.
    std::uint64_t last = 0;       ///< The last scenario of the last episode.
    std::vector<Episode> first{}; ///< The first `limits::group_episodes_max` episodes.

    friend bool operator==(const GroupEpisodes&, const GroupEpisodes&) = default;
};

/// Numbers of a group's near pairs.
struct GroupNear {
    std::uint64_t pairs = 0;       ///< In all scenarios.
    std::uint64_t worst_pairs = 0; ///< In the group's worst scenario.

    friend bool operator==(const GroupNear&, const GroupNear&) = default;
};

/// A part of A and a part of B that are in contact or near, by the listed pairs of triangles or, at
/// `level count`, by sums over all pairs.
struct Group {
    std::uint32_t body_a = 0; ///< Index of body A in the job's list of bodies.
    std::uint32_t body_b = 1;
    std::string part_a; ///< Name of the part (`BodyParts`).
    std::string part_b;
    std::uint64_t scenarios = 0; ///< Number of scenarios with a contact or a near pair.
    std::uint64_t pairs = 0;     ///< Number of pairs in contact in all scenarios.
    /// The first scenario with most pairs in contact, and among such scenarios with most near
    /// pairs.
    std::uint64_t worst = 0;
    std::uint64_t worst_pairs = 0; ///< Number of its pairs in contact.
    /// Cross if a pair is proper, or if a scenario's class is Cross without any proper pair; else
    /// Touch; Near if no pair is in contact. In sums Contact in place of Touch, which leaves open
    /// what it is.
    ScenarioClass kind = ScenarioClass::Touch;
    /// On A's part and on B's part, the number of regions: connected sets of triangles in contact
    /// or near in any scenario. Zeros if they are too many to count, or unknown.
    std::array<std::uint64_t, 2> regions{};
    GroupEpisodes episodes;
    GroupNear near;

    friend bool operator==(const Group&, const Group&) = default;
};

/// True if the groups' bodies have the same positions in their jobs, and their parts the same
/// names.
[[nodiscard]] bool is_same(const Group& left, const Group& right);

/// A part and the number of scenarios in which it is in contact or near.
struct TouchedPart {
    std::string part;
    std::uint64_t scenarios = 0;
    std::uint32_t body = 0; ///< Index in the job's list of bodies.
};

/// Sums groups over the results of a run. Results below `level pairs` list no pairs and add
/// nothing. Memory: eight bytes per triangle, a few hundred bytes for each of at most
/// `limits::groups_max` groups, and at most `limits::group_triangles_max` triangle numbers.
class GroupSum {
  public:
    /// `meshes` holds the mesh of each body, by the index that results give the body.
    explicit GroupSum(std::vector<std::shared_ptr<const Mesh>> meshes,
                      PartKind kind = PartKind::Any);

    /// Adds a result, whose bodies must have meshes. Results come in ascending order.
    void add(const ScenarioResult& result);
    /// Adds the sums over all scenarios of a run that lists no pairs, once. The kind of parts must
    /// be Named. Errors: BadInput for a part that a body does not have.
    [[nodiscard]] Status add(const PartContacts& contacts);

    /// Returns the groups, those in most scenarios first. Takes near-linear time in the number of
    /// vertices and of triangles in contact.
    [[nodiscard]] std::vector<Group> groups() const;
    /// Number of scenarios inside, which are in no group, since no triangles meet.
    [[nodiscard]] std::uint64_t inside() const { return inside_; }
    /// Number of pairs of triangles in no group, since there are too many groups.
    [[nodiscard]] std::uint64_t left_out() const { return left_out_; }

    /// Returns the `count` parts in contact or near in most scenarios, most first. Leaves out parts
    /// that never are, bodies with a single part, and bodies whose parts are pieces.
    [[nodiscard]] std::vector<TouchedPart> most_touched(std::size_t count = 3) const;
    [[nodiscard]] const BodyParts& parts(std::size_t body);
    [[nodiscard]] std::size_t bodies() const { return meshes_.size(); }

  private:
    struct Body {
        std::shared_ptr<const BodyParts> parts;
        std::uint64_t first_part = 0;          ///< Number of parts of all bodies before.
        std::vector<std::uint64_t> scenarios;  ///< Number of scenarios, by part.
        std::vector<std::uint64_t> last_seen;  ///< `stamp_` of the last result counted, by part.
        std::vector<std::uint32_t> last_group; ///< The last group that noted each triangle.
    };
    /// A group and what is counted in the present result.
    struct Sum {
        std::array<std::uint32_t, 2> part{};
        Group group;
        std::uint64_t stamp = 0;      ///< `stamp_` of the last result with the group.
        std::uint64_t pairs_here = 0; ///< Number of pairs in contact in that result.
        std::uint64_t near_here = 0;  ///< Number of near pairs in that result.
        bool is_proper_here = false;  ///< A pair in that result is proper.
        /// Triangles of the pairs, of A and of B, with repetitions; the first `sorted` ascend.
        std::array<std::vector<std::uint32_t>, 2> touched;
        std::array<std::size_t, 2> sorted{};
    };

    void find_parts();
    void note_part(Body& body, std::uint32_t part) const;
    /// Returns the number of the group of a part of each body; nothing if there are too many.
    [[nodiscard]] std::optional<std::uint32_t> number_of(std::array<std::uint32_t, 2> bodies,
                                                         std::array<std::uint32_t, 2> part);
    [[nodiscard]] std::optional<std::uint32_t> group_of(const ScenarioResult& result,
                                                        const ContactPair& pair);
    void note_pair(const ScenarioResult& result, const ContactPair& pair, std::uint32_t number);
    void note_triangle(Sum& sum, std::size_t side, std::uint32_t triangle);
    void sort_touched(Sum& sum, std::size_t side);
    void limit_triangles();
    void count_regions(std::uint32_t body, std::vector<Group>& groups) const;

    std::vector<std::shared_ptr<const Mesh>> meshes_;
    PartKind kind_;
    std::vector<Body> bodies_; ///< Empty until parts are needed.
    std::vector<Sum> sums_;
    std::unordered_map<std::uint64_t, std::uint32_t> numbers_; ///< Number in `sums_`, by parts.
    std::vector<std::uint32_t> here_; ///< Numbers of the groups in the present result.
    std::uint64_t stamp_ = 0;         ///< Number of results added so far.
    std::uint64_t triangles_ = 0;     ///< Number of triangles in all `touched`.
    bool counts_regions_ = true;
    std::uint64_t inside_ = 0;
    std::uint64_t left_out_ = 0;
};

} // namespace cd
