#include "master/compute/job_geometry.hpp"

#include "common/job/run_motion.hpp"
#include "common/job/settle.hpp"
#include "master/geometry/depth_choice.hpp"
#include "master/journal/job_map.hpp"
#include "master/submission/pose_spool.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace cd {

namespace {

using Cuts = std::vector<std::shared_ptr<const CutGeometry>>;

/// Returns the tree of each body; bodies of one mesh share it.
Result<BodyTrees> load_trees(GeometryStore& store, const Submit& submit) {
    std::map<Sha256, std::shared_ptr<const ObbTree>> of_meshes;
    BodyTrees trees;
    for (const JobBody& body : submit.bodies) {
        std::shared_ptr<const ObbTree>& tree = of_meshes[body.mesh];
        if (tree == nullptr) {
            const auto loaded = store.tree(body.mesh);
            if (!loaded) {
                return loaded.error();
            }
            tree = loaded.value();
        }
        trees.push_back(tree);
    }
    return trees;
}

/// Returns the cut of each body; bodies of one mesh and depth share it.
StoreResult<Cuts>
load_cuts(GeometryStore& store, const Submit& submit, const BodyTrees& trees, SubtreeForm form) {
    std::map<std::pair<Sha256, std::optional<std::uint32_t>>, Cuts::value_type> known;
    Cuts cuts;
    for (std::size_t body = 0; body < trees.size(); ++body) {
        const Sha256& mesh = submit.bodies[body].mesh;
        const std::optional<std::uint32_t> depth = submit.cluster.depth(body);
        Cuts::value_type& cut = known[{mesh, depth}];
        if (cut == nullptr) {
            const auto made =
                store.cut(mesh, depth ? *depth : choose_depth(*trees[body], form), form);
            if (!made) {
                return made.is_unwritten() ? StoreResult<Cuts>::unwritten(made.error())
                                           : StoreResult<Cuts>(made.error());
            }
            cut = made.value();
        }
        cuts.push_back(cut);
    }
    return cuts;
}

} // namespace

StoreResult<JobGeometry> StoredGeometry::prepare(const Submit& submit) {
    const Result<BodyTrees> trees = load_trees(store_, submit);
    if (!trees) {
        return trees.error();
    }
    const bool is_wide = std::ranges::all_of(
        trees.value(), [](const auto& tree) { return suits_wide_tree(tree->view()); });
    const SubtreeForm form = is_wide ? SubtreeForm::Wide : SubtreeForm::Binary;
    const StoreResult<Cuts> cuts = load_cuts(store_, submit, trees.value(), form);
    if (!cuts) {
        return cuts.is_unwritten() ? StoreResult<JobGeometry>::unwritten(cuts.error())
                                   : StoreResult<JobGeometry>(cuts.error());
    }
    JobGeometry made;
    JobMaterial material;
    material.trees = trees.value();
    material.query = submit.query;
    material.radii = radii_for(TreesByBody(material.trees), submit.query);
    material.settler =
        std::make_shared<const Settler>(TreesByBody(material.trees), submit.query.ignored);
    if (sums_contacts(submit)) {
        material.parts = body_part_runs(material.trees[0]->mesh(), material.trees[1]->mesh());
    }
    made.analysis.trees = material.trees;
    made.analysis.query = submit.query;
    made.analysis.radii = material.radii;
    made.analysis.settler = material.settler;
    for (const auto& cut : cuts.value()) {
        made.cuts.push_back(cut);
        made.analysis.tops.emplace_back(cut, &cut->top());
    }
    made.material = std::make_shared<const JobMaterial>(std::move(material));
    return made;
}

DispatchTrees dispatch_trees(std::span<const TreeId> ids,
                             std::span<const std::shared_ptr<const Cut>> cuts) {
    std::map<TreeId, std::shared_ptr<const DispatchTree>> known;
    std::vector<DispatchTrees::Tree> by_body;
    for (std::size_t body = 0; body < ids.size(); ++body) {
        DispatchTrees::Tree& shared = known[ids[body]];
        if (shared == nullptr) {
            const Cut& cut = *cuts[body];
            DispatchTree tree{ids[body], {}, {}};
            for (RootIndex root = 0; root < cut.root_count(); ++root) {
                tree.root_triangles.push_back(cut.triangles_under(root));
                tree.root_bytes.push_back(cut.compressed_bytes(root));
            }
            shared = std::make_shared<const DispatchTree>(std::move(tree));
        }
        by_body.push_back(shared);
    }
    return DispatchTrees(std::move(by_body));
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
    Result<std::unique_ptr<PoseSpool>> spool = PoseSpool::open(path, announced_by(submit));
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
