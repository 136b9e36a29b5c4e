#include "common/core/files/hash.hpp"
#include "common/core/limits/master.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "common/search/contact_search.hpp"
#include "common/tree/tree_file.hpp"
#include "master/identity/token_book.hpp"
#include "master/submission/pose_spool.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/require.hpp"
#include "tests/fuzz/sample_mesh.hpp"
#include "tests/fuzz/targets.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

namespace cd::fuzz {

namespace {

/// Corrects the checksums of a spool file's runs (spool_file.cpp) that lie in the file, then its
/// counts and its index's checksum.
void sum_up_spool(Bytes& file, std::uint64_t scenarios) {
    const std::uint64_t runs =
        (scenarios + limits::pose_run_scenarios - 1) / limits::pose_run_scenarios;
    const std::size_t index = (2 * runs + 4) * word;
    if (file.size() < index) {
        return;
    }
    const std::size_t begin = file.size() - index;
    std::size_t from = 0;
    for (std::size_t run = 0; run < runs; ++run) {
        const std::uint64_t end = word_at(file, begin + run * word);
        if (end < from || end > begin) {
            break;
        }
        sum_up(file, from, end, begin + (runs + run) * word);
        from = end;
    }
    const std::array<std::uint64_t, 2> counts{scenarios, runs};
    std::memcpy(file.data() + file.size() - 3 * word, counts.data(), sizeof counts);
    sum_up(file, begin, file.size() - word, file.size() - word);
}

/// Corrects the checksums of a section file (section_file.hpp) that lie in the file.
void sum_up_sections(Bytes& file) {
    constexpr std::size_t table = 56; // After the key; the number of sections is at 12.
    constexpr std::size_t entry = 3 * word;
    if (file.size() < table) {
        return;
    }
    const std::size_t sections = word_at(file, 8) >> 32u;
    if (sections > (file.size() - table) / entry || file.size() < table + sections * entry + word) {
        return;
    }
    for (std::size_t i = 0; i < sections; ++i) {
        const std::size_t at = table + i * entry;
        const std::uint64_t offset = word_at(file, at);
        const std::uint64_t size = word_at(file, at + word);
        if (offset <= file.size() && size <= file.size() - offset) {
            sum_up(file, offset, offset + size, at + 2 * word);
        }
    }
    const std::size_t header = table + sections * entry;
    sum_up(file, 0, header, header);
}

} // namespace

void tokens(Input input) {
    (void)TokenBook::parse(text_of(input));
    const auto book = TokenBook::parse(text_of(input) + "sha256 " + to_hex(sha256(input)) + "\n");
    if (book) {
        const std::string text = book.value().to_text();
        const auto again = TokenBook::parse(text);
        require(again && again.value().to_text() == text, "a book's text is one of the same");
    }
}

void pose_spool(Input input) {
    if (input.size() < 2) {
        return;
    }
    const auto scenarios = std::to_integer<std::uint64_t>(input[1]);
    Bytes bytes(input.begin() + 2, input.end());
    if (is_odd(input)) {
        sum_up_spool(bytes, scenarios);
    }
    const MemoryFile file(bytes);
    auto opened = PoseSpool::open(file.path(), {scenarios, 2});
    if (!opened) {
        return;
    }
    PoseSpool& spool = *opened.value();
    require(spool.count() == scenarios && spool.is_complete(), "a sealed spool is complete");
    const bool is_verified = spool.verify().has_value();
    OrderedPoses poses((std::shared_ptr<const PoseRuns>(std::move(opened.value()))));
    const auto read = poses.read(0, scenarios);
    require(!is_verified || read, "what is verified can be read");
    require(!read || read.value().size() == scenarios, "all scenarios are read");
}

void tree_file(Input input) {
    static const std::shared_ptr<const Mesh> mesh = sample_mesh();
    const Input rest = rest_of(input);
    Bytes bytes(rest.begin(), rest.end());
    if (is_odd(input)) {
        sum_up_sections(bytes);
    }
    const MemoryFile file(bytes);
    const bool is_wide = !input.empty() && (input.front() & std::byte{2}) != std::byte{};
    const auto read = is_wide ? read_wide_tree_file(file.path(), mesh, {})
                              : read_tree_file(file.path(), mesh, {});
    if (!read) {
        return;
    }
    const ObbTree& tree = *read.value();
    const std::size_t triangles = mesh->triangles().size();
    for (const std::uint32_t triangle : tree.topology().component_triangles) {
        require(triangle < triangles, "a component's triangle is there");
    }
    PosePair poses;
    poses.b = Pose::from_matrix(Mat3::Identity(), {0.25, 0, 0});
    for (const ContactPair& pair : contact_pairs(tree, tree, poses)) {
        require(pair.a < triangles && pair.b < triangles, "triangles in contact are there");
    }
}

} // namespace cd::fuzz
