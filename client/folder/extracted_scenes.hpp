// Writes scenarios of a run as 3D scenes.
#pragma once

#include "client/folder/extracted_case.hpp"
#include "client/job/prepared_job.hpp"
#include "client/trees/tree_cache.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>

namespace cd {

enum class SceneFormat : std::uint8_t { Vtp, Glb };

/// Runs each scenario N again here, exactly and at `level contacts`, and writes it into a folder,
/// which is created if missing. Glb: N.glb. Vtp: contacts-N.vtp; a.vtp for a body A with the same
/// pose in all scenarios, else a-N.vtp, and B alike; and scenarios.pvd, a series with the numbers
/// of the scenarios as times. Errors: Io; Interrupted; BadInput if a contact differs from the
/// run's, or for a scene that a GLB file cannot hold.
[[nodiscard]] Status write_scenes(const PreparedJob& job,
                                  const CaseScenarios& scenarios,
                                  SceneFormat format,
                                  const std::filesystem::path& dir,
                                  TreeCache& cache,
                                  ThreadPool& pool,
                                  const StopCheck& stop);

} // namespace cd
