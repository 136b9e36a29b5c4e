// Pairs of triangles in blocks of either precision, for tests.
#pragma once

#include "common/geometry/triangle_blocks.hpp"
#include "common/pair/triangle_pair.hpp"
#include "tests/support/hard_pairs.hpp"

#include <algorithm>
#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace cd::tests {

/// Rounds to about the nearest finite floats.
[[nodiscard]] inline Vec3 in_floats(const Vec3& corner) {
    constexpr double most = 0x1p127;
    return corner.cwiseMin(most).cwiseMax(-most).cast<float>().cast<double>();
}

/// Triangles in blocks of 1 to 16, of doubles or rounded to floats, with each one's location.
class Blocks {
  public:
    explicit Blocks(Precision precision) : precision_(precision), arrays_(precision) {}

    void add(std::mt19937_64& random, std::span<const Corners> triangles) {
        while (!triangles.empty()) {
            const std::size_t size = std::min<std::size_t>(1 + random() % 16, triangles.size());
            add_block(triangles.first(size));
            triangles = triangles.subspan(size);
        }
    }
    [[nodiscard]] TriangleBlocks view() const { return arrays_.view(); }
    [[nodiscard]] std::uint32_t place(std::size_t triangle) const { return places_[triangle]; }

  private:
    void add_block(std::span<const Corners> some) {
        std::vector<Vec3> vertices;
        std::vector<Triangle> triangles;
        for (const Corners& corners : some) {
            const auto first = static_cast<std::uint32_t>(vertices.size());
            triangles.push_back({first, first + 1, first + 2});
            for (const Vec3& corner : corners) {
                vertices.push_back(precision_ == Precision::Double ? corner : in_floats(corner));
            }
        }
        const std::vector<std::uint32_t> ids(some.size());
        const std::uint32_t block = arrays_.add(triangles, ids, vertices);
        for (std::uint32_t i = 0; i < some.size(); ++i) {
            places_.push_back(block * block_size + i);
        }
    }

    Precision precision_;
    TriangleBlockArrays arrays_;
    std::vector<std::uint32_t> places_;
};

/// The precisions of A's and B's coordinates.
struct Kinds {
    Precision a;
    Precision b;
};

[[nodiscard]] inline std::string to_text(Precision precision) {
    return precision == Precision::Float ? "Float" : "Double";
}

/// One pose, and candidates under it.
struct BlockPairs {
    Blocks a;
    Blocks b;
    std::vector<Candidate> candidates;

    BlockPairs(std::mt19937_64& random, const Kinds& kinds, const std::vector<PosedPair>& pairs)
        : a(kinds.a), b(kinds.b) {
        std::vector<Corners> of_a;
        std::vector<Corners> of_b;
        for (const PosedPair& pair : pairs) {
            of_a.push_back(pair.a);
            of_b.push_back(pair.b);
        }
        a.add(random, of_a);
        b.add(random, of_b);
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            candidates.push_back({a.place(i), b.place(i)});
        }
    }
    [[nodiscard]] Corners corners_a(std::size_t i) const {
        return a.view().corners_at(candidates[i].a);
    }
    [[nodiscard]] Corners corners_b(std::size_t i) const {
        return b.view().corners_at(candidates[i].b);
    }
};

} // namespace cd::tests
