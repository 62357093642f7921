#pragma once

#include "core/sculptor.h"
#include "core/triangle_mesh.h"

#include <filesystem>
#include <vector>

namespace app
{
/// What `replay --stats` tells of one dab.
struct ReplayedDab
{
    core::DabReport report;
    double cpuMs = 0; ///< CPU time of the mesh thread; dabs of one sample share it evenly
};

/// Writes the object of DESIGN section 4, atomically. `mesh`: the sculptor's, as it is at the end. Throws core::FileError.
void writeReplayStats(const std::filesystem::path& path, const std::vector<ReplayedDab>& dabs,
                      const core::Sculptor& sculptor, const core::TriangleMesh& mesh);
} // namespace app
