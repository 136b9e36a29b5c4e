#include "common/job/result/nearest_witness.hpp"

#include "common/core/errors.hpp"
#include "common/distance/nearest_points.hpp"
#include "common/job/result/canonical_numbers.hpp"

#include <array>
#include <string>
#include <vector>

namespace cd {

namespace {

/// A distance, two triangles, a feature, an origin and two points.
constexpr std::size_t witness_bytes = 8 + 2 * 4 + 1 + 9 * 8;

Error bad(const char* what) {
    return {ErrorCode::BadFrame, std::string("result record: ") + what};
}

} // namespace

void put_witness(ByteWriter& out, const std::optional<NearestWitness>& nearest) {
    out.put(std::uint8_t{nearest ? std::uint8_t{1} : std::uint8_t{0}});
    if (nearest) {
        out.put(canonical(nearest->distance));
        out.put(nearest->a);
        out.put(nearest->b);
        out.put(nearest->feature);
        put_points(out, std::array{nearest->origin, nearest->point_a, nearest->point_b});
    }
}

Status get_witness(ByteReader& in, std::optional<NearestWitness>& nearest) {
    const auto has_distance = in.get<std::uint8_t>();
    if (in.failed() || has_distance > 1) {
        return bad("unknown flag of a distance");
    }
    if (has_distance == 0) {
        return Done{};
    }
    NearestWitness witness;
    witness.distance = in.get<double>();
    witness.a = in.get<std::uint32_t>();
    witness.b = in.get<std::uint32_t>();
    witness.feature = in.get<std::uint8_t>();
    std::vector<Vec3> points;
    CD_TRY(get_points(in, 3, points));
    if (!is_distance(witness.distance) || witness.feature >= feature::count) {
        return bad("a distance that is none");
    }
    witness.origin = points[0];
    witness.point_a = points[1];
    witness.point_b = points[2];
    nearest = witness;
    return Done{};
}

std::size_t bytes_of_witness(const std::optional<NearestWitness>& nearest) {
    return 1 + (nearest ? witness_bytes : 0);
}

} // namespace cd
