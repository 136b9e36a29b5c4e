#include "master/geometry/mesh_hold.hpp"

#include "common/core/check.hpp"

#include <utility>

namespace cd {

void MeshUses::add(std::span<const Sha256> meshes) {
    const std::lock_guard lock(mutex_);
    for (const Sha256& mesh : meshes) {
        ++counts_[mesh];
    }
}

void MeshUses::remove(std::span<const Sha256> meshes) {
    const std::lock_guard lock(mutex_);
    for (const Sha256& mesh : meshes) {
        const auto count = counts_.find(mesh);
        CD_CHECK(count != counts_.end());
        if (--count->second == 0) {
            counts_.erase(count);
        }
    }
}

bool MeshUses::contains(const Sha256& mesh) const {
    const std::lock_guard lock(mutex_);
    return counts_.contains(mesh);
}

MeshHold::MeshHold(std::shared_ptr<MeshUses> uses, std::vector<Sha256> meshes)
    : uses_(std::move(uses)), meshes_(std::move(meshes)) {
    uses_->add(meshes_);
}

MeshHold::~MeshHold() {
    uses_->remove(meshes_);
}

} // namespace cd
