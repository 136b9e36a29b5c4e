#include "common/solid/penetration.hpp"

#include "common/solid/triangle_in_solid.hpp"

#include <algorithm>
#include <unordered_map>
#include <vector>

namespace cd {

namespace {

constexpr std::uint64_t steps_between_stop_checks = 64;

/// Calls the stop check once in `steps_between_stop_checks` steps.
class StopChecks {
  public:
    explicit StopChecks(const StopCheck& stop) : stop_(stop) {}

    [[nodiscard]] bool must_stop() {
        return stop_ && ++steps_ % steps_between_stop_checks == 0 && stop_();
    }

  private:
    const StopCheck& stop_;
    std::uint64_t steps_ = 0;
};

/// Caches `SolidTest::solid_side` of each tested triangle.
class SolidSides {
  public:
    explicit SolidSides(const ObbTree& body) : solid_(body) {}

    [[nodiscard]] int of(std::uint32_t triangle) {
        const auto [entry, is_new] = sides_.try_emplace(triangle, 0);
        if (is_new) {
            entry->second = solid_.solid_side(triangle);
        }
        return entry->second;
    }

    [[nodiscard]] const SettleStatistics& statistics() const { return solid_.statistics(); }

  private:
    SolidTest solid_;
    std::unordered_map<std::uint32_t, int> sides_;
};

bool any_faces_the_same_way(const ObbTree& a,
                            const ObbTree& b,
                            const PosePair& poses,
                            std::span<const ContactPair> contacts,
                            SettleStatistics& statistics,
                            StopChecks& stop) {
    const ExactFrame frame(poses.b, poses.a);
    if (frame.orientation() == 0) {
        return false;
    }
    const RelativePose a_to_b = relative_pose({poses.b, poses.a});
    SolidSides sides_a(a);
    SolidSides sides_b(b);
    const bool found =
        std::any_of(contacts.begin(), contacts.end(), [&](const ContactPair& contact) {
            if (contact.kind != PairClass::Coplanar) {
                return false;
            }
            if (stop.must_stop()) {
                return true;
            }
            const PosedTriangle posed(frame, a_to_b, a.mesh().corners(contact.a));
            const int winding = posed.winding(b.mesh().corners(contact.b));
            // The contacts may name triangles without area, which have no sides.
            if (posed.is_flat() || winding == 0) {
                return false;
            }
            // A pose that mirrors a body swaps the side of a triangle on which the solid lies.
            return frame.orientation() * winding * sides_a.of(contact.a) * sides_b.of(contact.b) >
                   0;
        });
    statistics += sides_a.statistics();
    statistics += sides_b.statistics();
    return found;
}

/// A contact, sorted under its inner triangle.
struct InnerContact {
    std::uint32_t inner = 0;
    OuterContact outer;
};

bool is_named(std::span<const IgnoredRange> ignored, std::uint32_t triangle, bool is_of_a) {
    return std::any_of(ignored.begin(), ignored.end(), [&](const IgnoredRange& range) {
        return is_of_a ? range.a_begin <= triangle && triangle < range.a_end
                       : range.b_begin <= triangle && triangle < range.b_end;
    });
}

std::vector<InnerContact> contacts_of(std::span<const ContactPair> contacts,
                                      std::span<const IgnoredRange> ignored,
                                      bool is_of_a) {
    std::vector<InnerContact> result;
    result.reserve(contacts.size());
    for (const ContactPair& contact : contacts) {
        const std::uint32_t inner = is_of_a ? contact.a : contact.b;
        const std::uint32_t outer = is_of_a ? contact.b : contact.a;
        if (!is_named(ignored, inner, is_of_a)) {
            result.push_back({inner, {outer, contact.kind}});
        }
    }
    std::sort(result.begin(), result.end(), [](const InnerContact& l, const InnerContact& r) {
        return l.inner != r.inner ? l.inner < r.inner : l.outer.triangle < r.outer.triangle;
    });
    return result;
}

bool any_reaches_inside(const ObbTree& outer,
                        const Pose& outer_pose,
                        const ObbTree& inner,
                        const Pose& inner_pose,
                        std::span<const InnerContact> contacts,
                        SettleStatistics& statistics,
                        StopChecks& stop) {
    TriangleInSolid test(outer, outer_pose, inner, inner_pose);
    std::vector<OuterContact> of_one;
    bool found = false;
    for (std::size_t i = 0; i < contacts.size() && !found;) {
        const std::uint32_t triangle = contacts[i].inner;
        of_one.clear();
        for (; i < contacts.size() && contacts[i].inner == triangle; ++i) {
            of_one.push_back(contacts[i].outer);
        }
        found = stop.must_stop() || test.reaches_inside(triangle, of_one);
    }
    statistics += test.statistics();
    return found;
}

} // namespace

bool penetrates(const ObbTree& a,
                const ObbTree& b,
                const PosePair& poses,
                std::span<const ContactPair> contacts,
                std::span<const IgnoredRange> ignored,
                SettleStatistics& statistics,
                const StopCheck& stop) {
    StopChecks checks(stop);
    return any_faces_the_same_way(a, b, poses, contacts, statistics, checks) ||
           any_reaches_inside(
               b, poses.b, a, poses.a, contacts_of(contacts, ignored, true), statistics, checks) ||
           any_reaches_inside(
               a, poses.a, b, poses.b, contacts_of(contacts, ignored, false), statistics, checks);
}

} // namespace cd
