// Sums of contacts by part: in how many scenarios each part, and each pair of parts, is in contact
// or, under a clearance, near. Workers sum them with contact maps, so that a job has groups of
// contacts without sending pairs.
#pragma once

#include "common/geometry/part_runs.hpp"
#include "common/job/result/result.hpp"
#include "common/search/contact_pair.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

namespace cd {

/// A part's number (`named_parts`), with the number of scenarios in which the part is in contact or
/// near.
struct PartScenarios {
    std::uint32_t part = 0;
    std::uint64_t scenarios = 0;

    friend bool operator==(const PartScenarios&, const PartScenarios&) = default;
};

/// The contacts and near pairs of a part of A with a part of B, over at least one scenario.
struct PartPairContacts {
    std::uint32_t a = 0; ///< Number of the part of A.
    std::uint32_t b = 0;
    std::uint64_t scenarios = 0; ///< Number of scenarios with a contact or a near pair.
    std::uint64_t pairs = 0;     ///< Number of pairs of triangles in contact in all scenarios.
    /// The first scenario with most pairs in contact, and among such scenarios with most near
    /// pairs.
    std::uint64_t worst = 0;
    std::uint64_t worst_pairs = 0; ///< Number of its pairs in contact.
    std::uint64_t first = 0;       ///< The first scenario with a contact or a near pair.
    std::uint64_t last = 0;
    bool has_proper = false;      ///< Triangles go through each other.
    std::uint64_t near = 0;       ///< Number of pairs of class Near in all scenarios.
    std::uint64_t worst_near = 0; ///< Number of near pairs in `worst`.

    friend bool operator==(const PartPairContacts&, const PartPairContacts&) = default;
};

/// Returns the class of a pair of parts: Cross if triangles go through each other, Near if none are
/// in contact, else Contact, which leaves open whether they cross.
[[nodiscard]] ScenarioClass class_of(const PartPairContacts& pair);

struct PartContacts {
    /// The parts of A ([0]) and of B ([1]) that are in contact or near in any scenario, ascending.
    std::array<std::vector<PartScenarios>, 2> parts = {};
    std::vector<PartPairContacts> pairs = {}; ///< Ascending by the part of A, then that of B.
    /// Number of pairs of triangles, in contact or near, in all scenarios if these are of more than
    /// `limits::groups_max` pairs of parts. `pairs` is empty then. Else 0.
    std::uint64_t left_out = 0;

    [[nodiscard]] bool empty() const { return parts[0].empty() && parts[1].empty(); }
    friend bool operator==(const PartContacts&, const PartContacts&) = default;
};

/// Sums contacts by part. The sum depends neither on the order nor on the grouping of what is
/// added. Memory: some hundred bytes for each of at most `limits::groups_max` pairs of parts, and
/// for each part in contact.
class PartContactSum {
  public:
    /// `parts` are those of the bodies; null if only sums are added.
    explicit PartContactSum(std::shared_ptr<const BodyPartRuns> parts = nullptr)
        : parts_(std::move(parts)) {}

    /// Adds all pairs of one scenario, in any order.
    void add(std::uint64_t scenario, std::span<const ContactPair> pairs);
    void add(const PartContacts& contacts);

    /// Bytes of memory in use.
    [[nodiscard]] std::uint64_t bytes() const;
    [[nodiscard]] PartContacts sums() const;

  private:
    struct PartSum {
        std::uint64_t scenarios = 0;
        std::uint64_t stamp = 0; ///< `stamp_` of the last scenario counted.
    };
    /// A sum, and what is counted in the present scenario.
    struct PairSum {
        PartPairContacts sum;
        std::uint64_t stamp = 0;
        std::uint64_t pairs_here = 0; ///< Pairs in contact.
        std::uint64_t near_here = 0;
        bool has_proper_here = false;

        void count(PairClass kind);
    };

    /// Returns the index in `pairs_`, or `no_pair` if there are too many.
    [[nodiscard]] std::uint32_t find(std::uint32_t a, std::uint32_t b);
    void note_part(std::size_t side, std::uint32_t part);
    void begin_in_scenario(std::uint32_t number);
    void end_scenario(std::uint64_t scenario);
    /// Gives up the sums by pair of parts.
    void leave_out();

    std::shared_ptr<const BodyPartRuns> parts_;
    std::array<std::unordered_map<std::uint32_t, PartSum>, 2> of_parts_;
    std::vector<PairSum> pairs_;
    std::unordered_map<std::uint64_t, std::uint32_t> numbers_; ///< Index in `pairs_`, by parts.
    std::vector<std::uint32_t> here_; ///< Indices in `pairs_` of the present scenario.
    std::uint64_t stamp_ = 0;         ///< Number of scenarios added.
    bool are_too_many_ = false;
    std::uint64_t left_out_ = 0;
};

} // namespace cd
