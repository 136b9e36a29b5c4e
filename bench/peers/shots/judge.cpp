#include "bench/peers/shots/judge.hpp"

#include "tests/support/shot_oracle.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace cd::bench {

namespace {

/// A point at which a line meets triangles.
struct MetPoint {
    std::uint64_t crossings = 0; ///< Of ours.
    std::uint64_t hits = 0;      ///< Of theirs.
};

bool is_same_point(const ShotHit& left, const ShotHit& right) {
    return left.depth == right.depth && left.rank == right.rank;
}

bool is_crossing(const ShotHit& hit) {
    return (hit.flags & hit_flag::crosses) != 0;
}

} // namespace

HitsByLine::HitsByLine(std::vector<ShotHit> hits, std::uint32_t lines)
    : hits_(std::move(hits)), begins_(std::size_t{lines} + 1) {
    const auto key = [](const ShotHit& hit) {
        return std::tuple(hit.line, hit.depth, hit.rank, hit.triangle);
    };
    std::sort(hits_.begin(), hits_.end(), [&](const ShotHit& left, const ShotHit& right) {
        return key(left) < key(right);
    });
    for (const ShotHit& hit : hits_) {
        ++begins_[hit.line + 1];
    }
    for (std::size_t line = 0; line < lines; ++line) {
        begins_[line + 1] += begins_[line];
    }
}

HitErrors& HitErrors::operator+=(const HitErrors& other) {
    missing += other.missing;
    doubled += other.doubled;
    return *this;
}

HitErrors compare_hits(std::span<const ShotHit> ours, std::span<const ShotHit> theirs) {
    HitErrors errors;
    std::vector<MetPoint> points;
    std::vector<std::pair<std::uint32_t, std::size_t>> point_of; // By triangle.
    for (std::size_t i = 0; i < ours.size(); ++i) {
        if (i == 0 || !is_same_point(ours[i - 1], ours[i])) {
            points.emplace_back();
        }
        points.back().crossings += is_crossing(ours[i]) ? 1u : 0u;
        point_of.emplace_back(ours[i].triangle, points.size() - 1);
    }
    std::sort(point_of.begin(), point_of.end());
    for (const ShotHit& hit : theirs) {
        const auto found = std::lower_bound(
            point_of.begin(), point_of.end(), std::pair(hit.triangle, std::size_t{0}));
        if (found != point_of.end() && found->first == hit.triangle) {
            ++points[found->second].hits;
        } else {
            ++errors.doubled;
        }
    }
    for (const MetPoint& point : points) {
        errors.missing += point.crossings - std::min(point.crossings, point.hits);
        errors.doubled += point.hits - std::min(point.crossings, point.hits);
    }
    return errors;
}

bool is_right(const Mesh& mesh,
              const PosedLine& line,
              std::span<const ShotHit> ours,
              std::span<const ShotHit> theirs) {
    std::vector<std::uint32_t> triangles;
    for (const auto hits : {ours, theirs}) {
        for (const ShotHit& hit : hits) {
            triangles.push_back(hit.triangle);
        }
    }
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    std::vector<Corners> corners;
    for (const std::uint32_t triangle : triangles) {
        corners.push_back(mesh.corners(triangle));
    }
    std::vector<LineHit> truth = tests::rounded_hits(
        tests::oracle_hits(corners, line.segment, {Pose(), line.pose}), line.segment);
    std::vector<LineHit> told;
    for (const ShotHit& hit : ours) {
        const auto place = std::lower_bound(triangles.begin(), triangles.end(), hit.triangle);
        told.push_back({static_cast<std::uint32_t>(place - triangles.begin()),
                        hit.flags,
                        hit.rank,
                        hit.depth});
    }
    for (std::vector<LineHit>* const hits : {&truth, &told}) {
        std::ranges::sort(*hits, {}, &LineHit::triangle);
    }
    return truth == told;
}

} // namespace cd::bench
