#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/sculpt/sculptor.h"
#include "core/util/atomic_file.h"

#include <vector>

namespace app
{
/// What `replay --stats` tells of one dab.
struct ReplayedDab
{
    core::DabReport report;
    double cpuMs = 0; ///< CPU time of the mesh thread
    std::optional<core::SelectionQuality> quality;
};

/// Writes one JSON object; not committed. `mesh`: the sculptor's, as it is at the end. Throws core::FileError.
void writeReplayStats(core::AtomicFile& file, const std::vector<ReplayedDab>& dabs, const core::Sculptor& sculptor,
                      const core::TriangleMesh& mesh);
} // namespace app
