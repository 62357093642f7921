#pragma once

#include "core/analysis/mesh_check.h"
#include "core/parts/part_list.h"

#include <filesystem>

namespace core
{
/// The result of reading an exported file back and comparing it with the model.
struct ExportVerdict
{
    /// Every triangle has the same corner positions in the same order, bit for bit (-0 = 0), and no number in the file
    /// contradicts their number.
    bool sameCorners = false;
    bool sameColors = false; ///< every corner has the same colour; true also if the format or the model has no colours
    MeshReport report;       ///< checkMesh() of the mesh read back

    bool holds() const { return sameCorners && sameColors && report.printReady(); }
};

/// Reads the file back and compares it with the mesh that was written to it. Throws FileError, or ReadingCancelled if
/// it is cancelled while reading. After a later cancel the result is not usable. Cost: that of opening the file:
/// reading it, and about 1 s per million faces on two cores. `parts`: the list of the mesh's parts with which it was
/// written. Formats with objects are checked part by part.
ExportVerdict checkExport(const std::filesystem::path& path, const TriangleMesh& mesh, const JobControl& control = {},
                          const PartList& parts = {});
} // namespace core
