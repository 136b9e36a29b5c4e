#include "bench/peers/ours.hpp"

#include "common/core/check.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/geometry/simd_target.hpp"
#include "common/search/contact_search.hpp"
#include "common/tree/build/build.hpp"

#include <string>
#include <utility>

namespace cd::bench {

namespace {

/// Returns the bytes that a search descends through: the wide tree with its triangles and support
/// points if there is one, else the binary tree and the mesh's triangles.
std::uint64_t bytes_of(const TreeView& view) {
    const TriangleBlocks& blocks = view.wide.triangles;
    if (!view.wide.nodes.empty()) {
        return view.wide.nodes.size_bytes() + blocks.floats.size_bytes() +
               blocks.doubles.size_bytes() + blocks.vertex_begin.size_bytes() +
               blocks.corners.size_bytes() + blocks.ids.size_bytes() +
               view.wide.support.sets.size_bytes() + view.wide.support.columns.size_bytes();
    }
    return view.nodes.size_bytes() + view.vertices.size_bytes() + view.triangles.size_bytes() +
           view.triangle_ids.size_bytes();
}

/// The search for contacts without a job's extra steps: no sorting, no record, and no containment
/// test, which no peer does.
class OurMeshes final : public MeshEngine {
  public:
    OurMeshes() = default;
    OurMeshes(std::shared_ptr<const ObbTree> a, std::shared_ptr<const ObbTree> b)
        : a_(std::move(a)), b_(std::move(b)) {}

    void load(const std::shared_ptr<const Mesh>& a, const std::shared_ptr<const Mesh>& b) override {
        a_ = build_ours(a, 1);
        b_ = build_ours(b, 1);
        keeping_.reset();
        counting_.reset();
    }

    MeshAnswer ask(const PosePair& poses, Level level) override {
        const TreeView a = a_->view();
        const TreeView b = b_->view();
        std::unique_ptr<ContactSearch>& kept = level >= Level::Pairs ? keeping_ : counting_;
        if (kept) {
            kept->restart(poses);
        } else {
            kept = make_search(a, b, poses, {}, {.keep_pairs = level >= Level::Pairs});
        }
        ContactSearch& search = *kept;
        MeshAnswer answer;
        if (level == Level::Any) {
            answer.touches = search.any(a, b);
            answer.pair_count = answer.touches ? 1 : 0;
        } else {
            search.collect(a, b);
            answer.pair_count = search.contacts().count();
            answer.touches = answer.pair_count > 0;
            answer.pairs.reserve(search.contacts().pairs().size());
            for (const ContactPair& pair : search.contacts().pairs()) {
                answer.pairs.emplace_back(pair.a, pair.b);
            }
        }
        return answer;
    }

    [[nodiscard]] std::uint64_t resident_bytes() const override {
        return bytes_of(a_->view()) + bytes_of(b_->view());
    }

    [[nodiscard]] std::unique_ptr<MeshEngine> for_another_thread() const override {
        return std::make_unique<OurMeshes>(a_, b_);
    }

  private:
    std::shared_ptr<const ObbTree> a_;
    std::shared_ptr<const ObbTree> b_;
    // Reused from pose to pose, as a user does.
    std::unique_ptr<ContactSearch> keeping_;
    std::unique_ptr<ContactSearch> counting_;
};

} // namespace

std::vector<Engine> our_mesh_engines() {
    std::vector<Engine> engines;
    const auto add = [&](std::string name, SimdTarget target) {
        Engine engine;
        engine.name = std::move(name);
        engine.is_ours = true;
        engine.make_meshes = [target] {
            CD_CHECK(force_simd_target(to_text(target)).has_value());
            return std::make_unique<OurMeshes>();
        };
        engine.levels = {Level::Any, Level::Count, Level::Pairs};
        engines.push_back(std::move(engine));
    };
    add("cdcluster", simd_target());
    for (const SimdTarget target : available_simd_targets()) {
        if (target != simd_target() && target == SimdTarget::Avx2) {
            add("cdcluster (avx2)", target);
        }
    }
    return engines;
}

std::shared_ptr<const ObbTree> build_ours(const std::shared_ptr<const Mesh>& mesh,
                                          unsigned threads) {
    ThreadPool pool(threads);
    ObbTree tree = build_tree(mesh, {}, pool);
    tree.prepare_planes(&pool);
    return std::make_shared<const ObbTree>(std::move(tree));
}

} // namespace cd::bench
