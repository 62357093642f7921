#pragma once

#include "core/util/job_control.h"

#include <QCoreApplication>
#include <QString>

#include <memory>

namespace core
{
class Mesh;
}

namespace app
{
/// Result of exporting the model as a brush.
struct ExportedBrush
{
    QString path;    ///< path of the brush file; empty if none was written
    QString problem; ///< reason why there is no file, one sentence; empty if the export succeeded or was cancelled
};

/// Writes the present model to a brush file. Stroke files refer to the file by path and by fingerprint. Thread: any.
/// Never throws.
class BrushExport
{
    Q_DECLARE_TR_FUNCTIONS(app::BrushExport)

public:
    /// Returns the folder of brush files in the user's data directory. Files in it are never deleted, because stroke
    /// files may refer to them.
    static QString folder();
    /// Writes `name`.glb to a subfolder named after the brush's fingerprint, so that a different model with the same
    /// name replaces no file. A model with more triangles than core::BrushModel::maxFaces is decimated first. Consumes
    /// the copy. A null `copy` is reported as out of memory.
    static ExportedBrush run(const std::shared_ptr<core::Mesh>& copy, const QString& name,
                             const core::JobControl& control);
};
} // namespace app
