#include "bench/accuracy/suites/point_suite.hpp"

#include "tests/support/clipping_oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace cd::bench {

namespace {

using tests::Rational;
using tests::RationalPoint;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A pair in contact, with the exact corners of its intersection.
struct Contact {
    PairGroup group;
    Candidate candidate;
    RationalPoint origin;               ///< A's first corner in the world.
    std::vector<RationalPoint> corners; ///< In world coordinates.
    double edge = 0;                    ///< Longest edge of the two triangles.
};

/// A child's results for one pair.
struct Given {
    std::array<double, 3> origin;
    std::array<std::array<double, 3>, 16> points;
    std::size_t count;
};

struct Errors {
    std::uint64_t points = 0;
    std::uint64_t rounded = 0; ///< Correctly rounded points.
    std::vector<double> end;   ///< Distance of each exact corner from the nearest point.
    double end_units = 0;      ///< Largest of these distances, in model units.
};

double longest_edge(const Corners& a, const Corners& b) {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        longest = std::max(
            {longest, (a[(i + 1) % 3] - a[i]).stableNorm(), (b[(i + 1) % 3] - b[i]).stableNorm()});
    }
    return longest > 0 ? longest : 1;
}

std::vector<Contact> contacts_of(const PairBatch& batch, std::size_t pairs_max) {
    std::vector<Contact> contacts;
    for (const PairGroup& group : batch.groups()) {
        for (const Candidate& c : group.candidates) {
            if (contacts.size() == pairs_max) {
                return contacts;
            }
            const Corners a = group.a.corners_at(c.a);
            const Corners b = group.b.corners_at(c.b);
            std::vector<RationalPoint> corners = tests::clipping_oracle_points(a, b, group.poses);
            if (!corners.empty()) {
                contacts.push_back({group,
                                    c,
                                    tests::clipping_oracle_world(group.poses.a, a[0]),
                                    std::move(corners),
                                    longest_edge(a, b)});
            }
        }
    }
    return contacts;
}

/// Returns the point relative to the pair's origin, in longest edges.
Vec3 relative(const RationalPoint& world, const Contact& contact) {
    Vec3 result;
    for (std::size_t k = 0; k < 3; ++k) {
        const Rational share = (world[k] - contact.origin[k]) / Rational(contact.edge);
        result[static_cast<Eigen::Index>(k)] = share.convert_to<double>();
    }
    return result;
}

bool is_finite(const Given& given, std::size_t i) {
    return std::all_of(
        given.points[i].begin(), given.points[i].end(), [](double x) { return std::isfinite(x); });
}

/// Returns whether the point equals some exact corner minus the origin, rounded once, and the
/// origin equals A's exact corner, rounded once.
bool is_rounded(const Given& given, std::size_t i, const Contact& contact) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (!tests::is_nearest_double(given.origin[k], contact.origin[k])) {
            return false;
        }
    }
    return std::any_of(contact.corners.begin(), contact.corners.end(), [&](const auto& corner) {
        bool all = true;
        for (std::size_t k = 0; k < 3 && all; ++k) {
            all =
                tests::is_nearest_double(given.points[i][k], corner[k] - Rational(given.origin[k]));
        }
        return all;
    });
}

void judge(const Given& given, const Contact& contact, Errors& errors) {
    std::vector<Vec3> exact;
    for (const RationalPoint& corner : contact.corners) {
        exact.push_back(relative(corner, contact));
    }
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < given.count; ++i) {
        ++errors.points;
        if (!is_finite(given, i)) {
            continue;
        }
        errors.rounded += is_rounded(given, i, contact) ? 1u : 0u;
        RationalPoint world;
        for (std::size_t k = 0; k < 3; ++k) {
            world[k] = Rational(given.origin[k]) + Rational(given.points[i][k]);
        }
        points.push_back(relative(world, contact));
    }
    // If the engine sees no contact there is nothing to measure; the wrong answer is counted
    // elsewhere.
    for (const Vec3& corner : exact) {
        double nearest = infinity;
        for (const Vec3& point : points) {
            nearest = std::min(nearest, (corner - point).norm());
        }
        if (!points.empty()) {
            errors.end.push_back(nearest);
            errors.end_units = std::max(errors.end_units, nearest * contact.edge);
        }
    }
}

double largest(const std::vector<double>& values) {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

Ending ask(const Engine& engine,
           std::span<const Contact> contacts,
           std::chrono::seconds limit,
           const SharedArray<Given>& given) {
    return run_isolated(limit, [&] {
        const auto pairs = engine.make_pairs();
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const SharedPoints shared =
                pairs->shared_points(contacts[i].group, contacts[i].candidate);
            Given& to = given[i];
            for (std::size_t k = 0; k < 3; ++k) {
                to.origin[k] = shared.origin[static_cast<Eigen::Index>(k)];
            }
            to.count = std::min(shared.points.size(), to.points.size());
            for (std::size_t p = 0; p < to.count; ++p) {
                const Vec3& point = shared.points[p];
                to.points[p] = {point.x(), point.y(), point.z()};
            }
        }
    });
}

} // namespace

void run_points(const std::string& category,
                const PairBatch& batch,
                std::size_t pairs_max,
                std::span<const Engine> engines,
                std::chrono::seconds limit,
                CsvFile& csv) {
    const std::vector<Contact> contacts = contacts_of(batch, pairs_max);
    for (const Engine& engine : engines) {
        if (contacts.empty() || !engine.make_pairs()->gives_points()) {
            continue;
        }
        const SharedArray<Given> given(contacts.size());
        const Ending ending = ask(engine, contacts, limit, given);
        Errors errors;
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            judge(given[i], contacts[i], errors);
        }
        csv.row({category,
                 engine.name,
                 cell(std::uint64_t{contacts.size()}),
                 cell(errors.points),
                 cell(errors.rounded),
                 cell(largest(errors.end)),
                 cell(errors.end_units),
                 std::string(to_text(ending))});
    }
}

CsvFile open_points_csv(const std::filesystem::path& folder) {
    return {
        folder / "points.csv",
        {"category", "engine", "pairs", "points", "rounded", "end_max", "end_max_units", "ending"}};
}

} // namespace cd::bench
