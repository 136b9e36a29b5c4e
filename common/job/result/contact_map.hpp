// Heat maps: in how many scenarios each triangle was in contact. Sums of integers, made where the
// scenarios run, so that a job has them without sending a pair.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/search/contact_pair.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cd {

/// How many scenarios a triangle was in contact in, by its place in its mesh.
struct TriangleContacts {
    std::uint32_t triangle = 0;
    std::uint64_t scenarios = 0;

    friend bool operator==(const TriangleContacts&, const TriangleContacts&) = default;
};

/// Of A and of B: ascending triangles, each with at least one scenario.
struct ContactMap {
    std::array<std::vector<TriangleContacts>, 2> bodies;

    [[nodiscard]] bool empty() const { return bodies[0].empty() && bodies[1].empty(); }
    friend bool operator==(const ContactMap&, const ContactMap&) = default;
};

/// Sums the scenarios of a thread or a task. Memory: a number for each triangle of each scenario,
/// or, where that is more, a few for each triangle.
class ContactMapSum {
  public:
    ContactMapSum();
    ContactMapSum(ContactMapSum&&) noexcept;
    ContactMapSum& operator=(ContactMapSum&&) noexcept;
    ~ContactMapSum();

    /// All pairs of one scenario, in any order: each of their triangles counts once.
    void add(std::span<const ContactPair> pairs);
    void add(const ContactMap& map);

    [[nodiscard]] bool empty() const;
    /// Held in memory.
    [[nodiscard]] std::uint64_t bytes() const;
    /// The sum so far; then there is none any more.
    [[nodiscard]] ContactMap take();

  private:
    struct Body;
    struct State;
    [[nodiscard]] State& state();
    std::unique_ptr<State> state_; ///< Null while there is nothing in it.
};

/// Sums a whole job. Memory: eight bytes for each triangle up to the last.
class ContactMapTotal {
  public:
    void add(const ContactMap& map);
    [[nodiscard]] ContactMap map() const;

  private:
    std::array<std::vector<std::uint64_t>, 2> scenarios_;
};

/// SHA-256 over, of each body, the number of its triangles, and of each the triangle and its
/// scenarios; all u64, little-endian. The same for every cluster that ran the job.
[[nodiscard]] Sha256 digest_of(const ContactMap& map);

} // namespace cd
