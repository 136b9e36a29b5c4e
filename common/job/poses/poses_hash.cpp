#include "common/job/poses/poses_hash.hpp"

#include "common/core/check.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/job/packed_scenarios.hpp"

#include <algorithm>

namespace cd {

namespace {

constexpr std::uint64_t scenarios_at_once = 4096;
/// Offset of the forms in the packed bytes of one scenario with index 0 and bodies 0 and 1.
constexpr std::size_t forms_offset = 2;
constexpr std::size_t numbers_offset = 11; ///< Offset of the doubles in the packed bytes.

/// Replaces -0 by 0 in a pose. Adding 0 leaves every other number unchanged.
Pose without_minus_zero(const Pose& pose) {
    const Vec3 translation = pose.translation() + Vec3::Zero();
    if (pose.kind() == Pose::Kind::Matrix) {
        return Pose::from_matrix(pose.matrix() + Mat3::Zero(), translation);
    }
    const Quaternion& q = pose.quaternion();
    return Pose::from_quaternion({q.w + 0.0, q.x + 0.0, q.y + 0.0, q.z + 0.0}, translation);
}

/// Writes the form of A's pose, the form of B's pose, then the doubles of both; of a motion the
/// same of the poses at its end. In a scene the step and the bodies come first.
void put_numbers(ByteWriter& out, const Scenario& scenario) {
    const PosePair& poses = scenario.poses;
    if (scenario.step) {
        out.put(*scenario.step);
        out.put(scenario.body_a);
        out.put(scenario.body_b);
    }
    Scenario alone;
    alone.poses = {without_minus_zero(poses.a), without_minus_zero(poses.b)};
    const Bytes packed = pack_scenarios({&alone, 1});
    CD_CHECK(packed.size() >= numbers_offset);
    const auto forms = std::to_integer<std::uint8_t>(packed[forms_offset]);
    out.put(static_cast<std::uint8_t>(forms & 3u));
    out.put(static_cast<std::uint8_t>(forms >> 2u));
    put_bytes(out, std::span(packed).subspan(numbers_offset));
    if (scenario.to) {
        Scenario end;
        end.poses = *scenario.to;
        put_numbers(out, end);
    }
}

} // namespace

void PosesHash::add(std::span<const Scenario> scenarios) {
    ByteWriter out;
    for (const Scenario& scenario : scenarios) {
        put_numbers(out, scenario);
    }
    stream_.update(out.bytes());
}

Sha256 PosesHash::finish() {
    return stream_.finish();
}

Sha256 hash_of(const Grid& grid) {
    return sha256(encode_grid(grid));
}

Result<Sha256> hash_of(PoseSource& poses, const StopCheck& stop) {
    if (const Grid* grid = poses.grid()) {
        return hash_of(*grid);
    }
    PosesHash hash;
    for (std::uint64_t first = 0; first < poses.count(); first += scenarios_at_once) {
        if (stop && stop()) {
            return interrupted();
        }
        const auto scenarios =
            poses.read(first, std::min(scenarios_at_once, poses.count() - first));
        if (!scenarios) {
            return scenarios.error();
        }
        hash.add(scenarios.value());
    }
    return hash.finish();
}

} // namespace cd
