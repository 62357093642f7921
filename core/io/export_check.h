#pragma once

#include "core/analysis/mesh_check.h"

#include <filesystem>

namespace core
{
/// What a file holds of a model that was written to it.
struct ExportVerdict
{
    bool sameCorners = false; ///< of every triangle, in their order, bit for bit (-0 = 0)
    bool sameColors = false;  ///< of every corner, if the format holds colours and the model has some
    MeshReport report;        ///< of what was read, in mm

    bool holds() const { return sameCorners && sameColors && report.printReady(); }
};

/// Reads the file back and checks it. Throws FileError; ReadingCancelled if it was asked to stop while reading. If it
/// is cancelled, the result is not usable. Costs what opening costs: reading, and about 1 s a million faces on two
/// cores.
ExportVerdict checkExport(const std::filesystem::path& path, const TriangleMesh& written,
                          const JobControl& control = {});
} // namespace core
