// Reference counts that protect meshes in use from removal.
#pragma once

#include "common/core/files/hash.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace cd {

/// Counts the `MeshHold`s of each mesh. Any thread may call any member.
class MeshUses {
  public:
    void add(std::span<const Sha256> meshes);
    void remove(std::span<const Sha256> meshes);
    [[nodiscard]] bool contains(const Sha256& mesh) const;

  private:
    mutable std::mutex mutex_;
    std::map<Sha256, std::size_t> counts_;
};

/// Prevents the removal of its meshes while it exists.
class MeshHold {
  public:
    MeshHold(std::shared_ptr<MeshUses> uses, std::vector<Sha256> meshes);
    MeshHold(const MeshHold&) = delete;
    MeshHold& operator=(const MeshHold&) = delete;
    ~MeshHold();

  private:
    std::shared_ptr<MeshUses> uses_;
    std::vector<Sha256> meshes_;
};

} // namespace cd
