// Contact maps (heat maps): the number of scenarios in which each triangle, and each part, is in
// contact or, under a clearance, near. Workers sum these numbers where scenarios run, so that a job
// has maps and groups of contacts without sending pairs.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/job/result/part_contacts.hpp"
#include "common/job/result/result.hpp"
#include "common/search/contact_pair.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cd {

/// A triangle's index in its mesh, with the number of scenarios in which it is in contact or near.
struct TriangleContacts {
    std::uint32_t triangle = 0;
    std::uint64_t scenarios = 0;

    friend bool operator==(const TriangleContacts&, const TriangleContacts&) = default;
};

struct ContactMap {
    /// The triangles of A ([0]) and of B ([1]) that are in contact or near in any scenario,
    /// ascending.
    std::array<std::vector<TriangleContacts>, 2> bodies;
    PartContacts parts = {}; ///< Empty if they were not summed.

    [[nodiscard]] bool empty() const {
        return bodies[0].empty() && bodies[1].empty() && parts.empty();
    }
    friend bool operator==(const ContactMap&, const ContactMap&) = default;
};

/// Returns the listed pairs of a result of Question::Shots whose hits cross.
[[nodiscard]] std::vector<ContactPair> crossings_of(const ScenarioResult& result);

/// Sums the contacts and near pairs of a thread's or a task's scenarios. Memory: one number per
/// touched triangle of each scenario, or a few numbers per distinct touched triangle, whichever is
/// less; and `PartContactSum`.
class ContactMapSum {
  public:
    /// Sums contacts by part if `parts` is not null.
    explicit ContactMapSum(std::shared_ptr<const BodyPartRuns> parts = nullptr);
    ContactMapSum(ContactMapSum&&) noexcept;
    ContactMapSum& operator=(ContactMapSum&&) noexcept;
    ~ContactMapSum();

    /// Adds a result of a job with maps; `found` has all pairs of its scenario, in any order. Each
    /// triangle in them counts once. With Question::Shots `found` has the crossings, and each of
    /// them counts. From `level pairs` on, the sums by part count the pairs that the result lists,
    /// of hits of lines those that cross.
    void add(const ScenarioResult& result, std::span<const ContactPair> found);
    /// Adds all pairs of one scenario, in any order, without sums by part.
    void add(std::span<const ContactPair> pairs);
    void add(const ContactMap& map);

    [[nodiscard]] bool empty() const;
    /// Bytes of memory in use.
    [[nodiscard]] std::uint64_t bytes() const;
    /// Returns the sum so far and resets it to empty.
    [[nodiscard]] ContactMap take();

  private:
    struct Body;
    struct State;
    [[nodiscard]] State& state();
    /// How often a triangle counts that several pairs of a scenario have.
    enum class Count : std::uint8_t { Once, EachTime };
    void add(std::span<const ContactPair> pairs, Count count);
    std::shared_ptr<const BodyPartRuns> parts_;
    std::unique_ptr<State> state_; ///< Null while the sum is empty.
};

/// Sums the maps of a whole job. Memory: eight bytes for each triangle up to the last one touched,
/// and `PartContactSum`.
class ContactMapTotal {
  public:
    void add(const ContactMap& map);
    [[nodiscard]] ContactMap map() const;
    [[nodiscard]] PartContacts parts() const { return parts_.sums(); }

  private:
    std::array<std::vector<std::uint64_t>, 2> scenarios_;
    PartContactSum parts_;
};

/// Returns SHA-256 over, for each body, the number of its touched triangles, and for each of them
/// its index and its number of scenarios; all u64, little-endian. The digest is equal on every
/// cluster that ran the job. Sums by part are not in it.
[[nodiscard]] Sha256 digest_of(const ContactMap& map);

} // namespace cd
