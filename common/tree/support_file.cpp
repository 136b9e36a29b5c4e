#include "common/tree/support_file.hpp"

#include "common/core/errors.hpp"
#include "common/core/files/section_file.hpp"
#include "common/tree/wide/wide_tree.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace cd {

namespace {

/// The version must increase whenever other points are made of an unchanged tree.
constexpr FileKind support_kind{0x31'54'4e'49'4f'50'44'43, 1}; // "CDPOINT1"

enum SupportSection : std::size_t {
    lengths, ///< Four doubles: `SupportView::center` and `radius`.
    sets,
    columns,
    sections
};

/// Keeps the arrays of a tree and the file of its points.
struct Owner {
    std::shared_ptr<const WideTree> wide;
    std::shared_ptr<const SectionFile> file;
};

bool is_in_bounds(const SupportSet& set, const SupportView& support, const WideView& tree) {
    const std::uint64_t end =
        std::uint64_t{set.first} + (set.is_chosen ? padded(set.count) : set.count);
    return set.is_chosen ? set.count > 0 && 3 * end <= support.columns.size()
                         : end <= tree.triangles.vertex_begin.back();
}

Result<SupportView> support_of(const SectionFile& file, const WideView& tree) {
    const auto numbers = file.array<double>(lengths);
    const auto all_sets = file.array<SupportSet>(sets);
    const auto all_columns = file.array<float>(columns);
    if (!numbers || numbers.value().size() != 4 || !all_sets || !all_columns) {
        return Error{ErrorCode::Io, "its arrays have wrong sizes"};
    }
    const std::span<const double> n = numbers.value();
    const SupportView support{
        all_sets.value(),
        all_columns.value(),
        {static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])},
        n[3],
        next_support_id()};
    const bool fits = support.sets.size() == tree.nodes.size() &&
                      std::ranges::all_of(support.sets, [&](const SupportSet& set) {
                          return is_in_bounds(set, support, tree);
                      });
    return fits ? Result(support) : Error{ErrorCode::Io, "its points are not those of the tree"};
}

} // namespace

Status write_support_file(const std::filesystem::path& path,
                          const ObbTree& tree,
                          const Sha256& key,
                          Durability durability) {
    const SupportView support = tree.view().wide.support;
    const std::array<double, 4> numbers{static_cast<double>(support.center[0]),
                                        static_cast<double>(support.center[1]),
                                        static_cast<double>(support.center[2]),
                                        support.radius};
    const std::array<Section, sections> all{std::as_bytes(std::span(numbers)),
                                            std::as_bytes(support.sets),
                                            std::as_bytes(support.columns)};
    return write_section_file(path, {support_kind, key}, all, durability);
}

Result<std::shared_ptr<const ObbTree>>
read_support_file(const std::filesystem::path& path, const ObbTree& tree, const Sha256& key) {
    auto file = CD_TRY(SectionFile::open(path, {support_kind, key}, sections));
    WideView view = tree.view().wide;
    const auto support = support_of(*file, view);
    if (!support) {
        return Error{ErrorCode::Io, path.string() + " is damaged: " + support.error().detail};
    }
    view.support = support.value();
    auto wide = std::make_shared<const WideTree>(
        view, std::make_shared<const Owner>(tree.wide(), std::move(file)));
    return std::make_shared<const ObbTree>(
        tree.mesh_pointer(), tree.binary(), std::move(wide), tree.topology());
}

} // namespace cd
