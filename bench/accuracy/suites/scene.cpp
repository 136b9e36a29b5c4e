#include "bench/accuracy/suites/scene.hpp"

#include "common/core/host/thread_pool.hpp"
#include "tests/support/oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd::bench {

namespace {

struct WorldBox {
    Vec3 min;
    Vec3 max;
    std::uint32_t triangle = 0;

    [[nodiscard]] bool overlaps(const WorldBox& other) const {
        return (min.array() <= other.max.array()).all() && (other.min.array() <= max.array()).all();
    }
};

/// Returns world boxes of the triangles, each wider than any rounding error of a corner: by 32 ulps
/// of the largest number involved.
std::vector<WorldBox> world_boxes(const Mesh& mesh, const Pose& pose) {
    const WorldFrame to_world(pose);
    const double matrix_size = to_world.rotation.cwiseAbs().maxCoeff();
    std::vector<WorldBox> boxes;
    boxes.reserve(mesh.triangles().size());
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        const Corners own = mesh.corners(i);
        const Corners world = to_world(own);
        double size = to_world.translation.cwiseAbs().maxCoeff();
        for (const Vec3& corner : own) {
            size += 3 * matrix_size * corner.cwiseAbs().maxCoeff();
        }
        const double margin =
            32 * std::numeric_limits<double>::epsilon() * size + std::numeric_limits<double>::min();
        const Vec3 wide(margin, margin, margin);
        boxes.push_back({world[0].cwiseMin(world[1]).cwiseMin(world[2]) - wide,
                         world[0].cwiseMax(world[1]).cwiseMax(world[2]) + wide,
                         i});
    }
    return boxes;
}

/// Drops the boxes that touch none of `others`, and sorts the rest by least x.
void keep_near(std::vector<WorldBox>& boxes, const std::vector<WorldBox>& others) {
    WorldBox all = others.empty() ? WorldBox{} : others.front();
    for (const WorldBox& box : others) {
        all.min = all.min.cwiseMin(box.min);
        all.max = all.max.cwiseMax(box.max);
    }
    std::erase_if(boxes, [&](const WorldBox& box) { return others.empty() || !box.overlaps(all); });
    std::sort(boxes.begin(), boxes.end(), [](const WorldBox& left, const WorldBox& right) {
        return left.min.x() < right.min.x();
    });
}

std::vector<IdPair> near_pairs(const Mesh& a, const Mesh& b, const PosePair& poses) {
    std::vector<WorldBox> boxes_a = world_boxes(a, poses.a);
    std::vector<WorldBox> boxes_b = world_boxes(b, poses.b);
    keep_near(boxes_a, boxes_b);
    keep_near(boxes_b, boxes_a);
    std::vector<IdPair> pairs;
    const auto sweep = [&](const auto& from, const auto& to, const auto& add) {
        // Each overlapping pair is found from the box with the lower start in x; from A's on a tie.
        for (const WorldBox& box : from) {
            const auto first = std::partition_point(to.begin(), to.end(), [&](const WorldBox& o) {
                return &from == &boxes_a ? o.min.x() < box.min.x() : o.min.x() <= box.min.x();
            });
            for (auto other = first; other != to.end() && other->min.x() <= box.max.x(); ++other) {
                if (box.overlaps(*other)) {
                    add(box.triangle, other->triangle);
                }
            }
        }
    };
    sweep(boxes_a, boxes_b, [&](auto ia, auto ib) { pairs.emplace_back(ia, ib); });
    sweep(boxes_b, boxes_a, [&](auto ib, auto ia) { pairs.emplace_back(ia, ib); });
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

} // namespace

std::vector<TrueContacts> true_contacts(const Scene& scene, unsigned threads) {
    ThreadPool pool(threads);
    std::vector<TrueContacts> contacts(scene.poses.size());
    for (std::size_t s = 0; s < scene.poses.size(); ++s) {
        const std::vector<IdPair> near = near_pairs(*scene.a, *scene.b, scene.poses[s]);
        std::vector<PairClass> kinds(near.size());
        parallel_for(pool, near.size(), [&](std::size_t i) {
            kinds[i] = tests::oracle_class(
                scene.a->corners(near[i].first), scene.b->corners(near[i].second), scene.poses[s]);
        });
        for (std::size_t i = 0; i < near.size(); ++i) {
            if (kinds[i] != PairClass::Separate) {
                contacts[s].push_back({near[i], kinds[i]});
            }
        }
    }
    return contacts;
}

PairClass true_class(const TrueContacts& contacts, const IdPair& ids) {
    const auto found = std::lower_bound(
        contacts.begin(), contacts.end(), ids, [](const auto& pair, const auto& i) {
            return pair.ids < i;
        });
    return found != contacts.end() && found->ids == ids ? found->kind : PairClass::Separate;
}

} // namespace cd::bench
