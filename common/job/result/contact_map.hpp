// Contact maps (heat maps): the number of scenarios in which each triangle is in contact. Workers
// sum these numbers where scenarios run, so that a job has maps without sending pairs.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/search/contact_pair.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cd {

/// A triangle's index in its mesh, with the number of scenarios in which it is in contact.
struct TriangleContacts {
    std::uint32_t triangle = 0;
    std::uint64_t scenarios = 0;

    friend bool operator==(const TriangleContacts&, const TriangleContacts&) = default;
};

/// The triangles of A ([0]) and of B ([1]) that are in contact in any scenario, ascending.
struct ContactMap {
    std::array<std::vector<TriangleContacts>, 2> bodies;

    [[nodiscard]] bool empty() const { return bodies[0].empty() && bodies[1].empty(); }
    friend bool operator==(const ContactMap&, const ContactMap&) = default;
};

/// Sums the contacts of a thread's or a task's scenarios. Memory: one number per touched triangle
/// of each scenario, or a few numbers per distinct touched triangle, whichever is less.
class ContactMapSum {
  public:
    ContactMapSum();
    ContactMapSum(ContactMapSum&&) noexcept;
    ContactMapSum& operator=(ContactMapSum&&) noexcept;
    ~ContactMapSum();

    /// Adds all pairs of one scenario, in any order. Each triangle in them counts once.
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
    std::unique_ptr<State> state_; ///< Null while the sum is empty.
};

/// Sums the maps of a whole job. Memory: eight bytes for each triangle up to the last one touched.
class ContactMapTotal {
  public:
    void add(const ContactMap& map);
    [[nodiscard]] ContactMap map() const;

  private:
    std::array<std::vector<std::uint64_t>, 2> scenarios_;
};

/// Returns SHA-256 over, for each body, the number of its touched triangles, and for each of them
/// its index and its number of scenarios; all u64, little-endian. The digest is equal on every
/// cluster that ran the job.
[[nodiscard]] Sha256 digest_of(const ContactMap& map);

} // namespace cd
