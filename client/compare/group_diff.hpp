// Which groups of contacts are new, resolved, grown or shrunk in a later run.
#pragma once

#include "client/compare/paired_results.hpp"
#include "client/groups/group_sum.hpp"
#include "common/geometry/mesh.hpp"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// How a group, a pair of parts by their names, differs between two runs. Sums are over the
/// scenarios that both runs tested. If a run has sums only over all of its scenarios, and the other
/// run did not test all of these that are in contact, groups of both runs are not comparable.
enum class GroupState : std::uint8_t {
    New,           ///< In contact or near in no scenario of the earlier run.
    Grown,         ///< In more scenarios, or in as many with more pairs, or more near ones.
    Shrunk,        ///< In fewer scenarios, or in as many with fewer pairs, or fewer near ones.
    Resolved,      ///< In none, and all scenarios of the earlier run that had it were tested again.
    NotComparable, ///< Not in the later run, or in neither sum; some scenario was not tested again.
                   ///< Or sums cover other scenarios.
    Unchanged,     ///< Equal scenarios, pairs and near pairs.
};

inline constexpr std::size_t group_states = 6;
[[nodiscard]] std::string_view to_text(GroupState state);

/// Sums of a group in one run.
struct GroupCounts {
    std::uint64_t scenarios = 0;
    std::uint64_t pairs = 0;
    std::uint64_t near = 0; ///< Near pairs.

    friend auto operator<=>(const GroupCounts&, const GroupCounts&) = default;
};

struct ChangedGroup {
    GroupState state = GroupState::Unchanged;
    std::uint32_t body_a = 0; ///< Index of body A in the job's list of bodies.
    std::uint32_t body_b = 1;
    std::string part_a;
    std::string part_b;
    GroupCounts earlier; ///< For New and NotComparable over all scenarios, not only common ones.
    GroupCounts later;
    std::uint64_t worst = 0; ///< A worst scenario (`Group`): of the later run, or of the earlier
                             ///< one if the group is not in the later one.

    friend bool operator==(const ChangedGroup&, const ChangedGroup&) = default;
};

/// Sums the groups of two runs. Memory: four `GroupSum`.
class GroupDiff {
  public:
    using Meshes = std::vector<std::shared_ptr<const Mesh>>;

    /// The meshes of each run's bodies, by the index that results give the body.
    GroupDiff(const Meshes& earlier, const Meshes& later, PartKind kind = PartKind::Any);

    /// Adds a scenario. The bodies of its results must have meshes.
    void add(const PairedResult& pair);
    /// Adds the sums over a run that lists no pairs, after all scenarios; null for a run that lists
    /// them. Errors: as `GroupSum::add`.
    [[nodiscard]] Status add_sums(const PartContacts* earlier, const PartContacts* later);

    /// Returns all groups, by state in the order of `GroupState`, then those in most scenarios
    /// first.
    [[nodiscard]] std::vector<ChangedGroup> groups() const;
    /// False if a part is a connected piece of a mesh without parts, and its number may change with
    /// the mesh.
    [[nodiscard]] bool has_lasting_names();
    /// False if sums of a run cover scenarios in contact that the other run did not test.
    [[nodiscard]] bool are_sums_comparable() const;
    /// Number of pairs of triangles in no group, since there are too many groups.
    [[nodiscard]] std::uint64_t left_out() const;

  private:
    /// The groups of one run.
    struct Run {
        GroupSum tested;                 ///< Over the scenarios that both runs tested.
        GroupSum rest;                   ///< Over the other scenarios of the run.
        bool rest_is_in_contact = false; ///< A scenario of the rest has pairs.
        bool has_sums = false;           ///< The run lists no pairs.
    };
    [[nodiscard]] static Status add_sums(Run& run, const PartContacts* sums);

    std::size_t bodies_;
    Run earlier_;
    Run later_;
};

} // namespace cd
