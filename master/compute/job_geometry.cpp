#include "master/compute/job_geometry.hpp"

#include "common/job/settle.hpp"
#include "master/geometry/depth_choice.hpp"
#include "master/journal/job_map.hpp"
#include "master/submission/pose_spool.hpp"

namespace cd {

namespace {

std::shared_ptr<const TreeTop> top_of(const std::shared_ptr<const CutGeometry>& cut) {
    return {cut, &cut->top()};
}

} // namespace

StoreResult<JobGeometry> StoredGeometry::prepare(const Submit& submit) {
    const auto tree_a = store_.tree(submit.bodies[0].mesh);
    const auto tree_b = store_.tree(submit.bodies[1].mesh);
    for (const auto* tree : {&tree_a, &tree_b}) {
        if (!*tree) {
            return tree->error();
        }
    }
    const bool is_wide =
        suits_wide_tree(tree_a.value()->view()) && suits_wide_tree(tree_b.value()->view());
    const SubtreeForm form = is_wide ? SubtreeForm::Wide : SubtreeForm::Binary;
    const auto depth_of = [&](const ObbTree& tree, const std::optional<std::uint32_t>& given) {
        return given ? *given : choose_depth(tree, form);
    };
    const std::uint32_t depth_a = depth_of(*tree_a.value(), submit.cluster.depth(0));
    const std::uint32_t depth_b = depth_of(*tree_b.value(), submit.cluster.depth(1));
    const auto cut_a = store_.cut(submit.bodies[0].mesh, depth_a, form);
    const auto cut_b = store_.cut(submit.bodies[1].mesh, depth_b, form);
    for (const auto* cut : {&cut_a, &cut_b}) {
        if (!*cut) {
            return cut->is_unwritten() ? StoreResult<JobGeometry>::unwritten(cut->error())
                                       : StoreResult<JobGeometry>(cut->error());
        }
    }
    const std::shared_ptr<const ObbTree> a = tree_a.value();
    const std::shared_ptr<const ObbTree> b = tree_b.value();
    const auto settler = std::make_shared<const Settler>(*a, *b, submit.query.ignored);
    return JobGeometry{
        cut_a.value(),
        cut_b.value(),
        {a, b, top_of(cut_a.value()), top_of(cut_b.value()), submit.query, settler, nullptr},
        std::make_shared<const JobMaterial>(JobMaterial{
            a,
            b,
            submit.query,
            settler,
            sums_contacts(submit.query) ? body_part_runs(a->mesh(), b->mesh()) : nullptr})};
}

DispatchTree dispatch_tree(TreeId id, const Cut& cut) {
    DispatchTree tree{id, {}, {}};
    for (RootIndex root = 0; root < cut.root_count(); ++root) {
        tree.root_triangles.push_back(cut.triangles_under(root));
        tree.root_bytes.push_back(cut.compressed_bytes(root));
    }
    return tree;
}

Result<std::shared_ptr<OrderedPoses>>
open_poses(const Submit& submit, const std::filesystem::path& path, PoseCheck check) {
    if (submit.grid) {
        Result<Grid> grid = decode_grid(*submit.grid);
        if (!grid) {
            return grid.error();
        }
        return std::make_shared<OrderedPoses>(grid.value());
    }
    Result<std::unique_ptr<PoseSpool>> spool = PoseSpool::open(path, submit.scenarios);
    if (!spool) {
        return spool.error();
    }
    const Status checked = check == PoseCheck::Whole ? spool.value()->verify() : Status(Done{});
    if (!checked) {
        return checked.error();
    }
    return std::make_shared<OrderedPoses>(
        std::shared_ptr<const PoseRuns>(std::move(spool.value())));
}

} // namespace cd
