#include "common/scene/scene_head.hpp"

#include "common/core/check.hpp"
#include "common/core/files/bytes.hpp"
#include "common/core/files/disk_file.hpp"

#include <array>

namespace cd {

namespace {

constexpr std::uint64_t magic = 0x31'45'4e'45'43'53'44'43; // "CDSCENE1"

} // namespace

SceneHead scene_head(std::span<const Sha256> meshes,
                     const std::vector<bool>& are_fixed,
                     std::uint64_t steps,
                     const PairSet& ignored,
                     std::span<const IgnoredRange> ranges) {
    CD_CHECK(are_fixed.size() == meshes.size() && ignored.bodies() == meshes.size());
    ByteWriter out;
    out.put(magic);
    out.put(std::uint64_t{meshes.size()});
    for (std::size_t body = 0; body < meshes.size(); ++body) {
        put_hash(out, meshes[body]);
        out.put(are_fixed[body]);
    }
    out.put(steps);
    out.put_array(ignored.words());
    for (const IgnoredRange& range : ranges) {
        out.put_array(std::span<const std::uint32_t>(std::array{
            range.a_begin, range.a_end, range.b_begin, range.b_end, range.body_a, range.body_b}));
    }
    return {sha256(out.bytes())};
}

} // namespace cd
