#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/sculpt/sculptor.h"
#include "core/util/atomic_file.h"

#include <vector>

namespace app
{
/// The statistics of one dab for `replay --stats`.
struct ReplayedDab
{
    core::DabReport report;
    double cpuMs = 0; ///< CPU time that the dab took on the sculpting thread, ms
    std::optional<core::SelectionQuality> quality;
};

/// Writes one JSON object without committing the file. `mesh`: the sculptor's final mesh. Throws core::FileError.
void writeReplayStats(core::AtomicFile& file, const std::vector<ReplayedDab>& dabs, const core::Sculptor& sculptor,
                      const core::TriangleMesh& mesh);
} // namespace app
