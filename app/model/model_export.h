#pragma once

#include "core/io/document_metadata.h"
#include "core/io/export_check.h"
#include "core/util/job_control.h"

#include <QCoreApplication>
#include <QString>

#include <functional>
#include <memory>

namespace core
{
class Mesh;
struct TriangleMesh;
} // namespace core

namespace app
{
/// A request to export the model.
struct ExportRequest
{
    QString path;                         ///< file to write; its extension determines the format
    quint64 maxTriangles = 0;             ///< a model with more triangles is decimated to this number; 0: no limit
    bool slices = false;                  ///< whether to test the file with an installed slicer
    core::DocumentMetadata metadata = {}; ///< metadata of the mesh; not written if the model is decimated
    /// a copy of the model, which is consumed; null: there was not enough memory for a copy
    std::shared_ptr<core::Mesh> mesh = {};
    bool joinsParts = true; ///< unites parts that overlap, unless the format is for other programs than slicers
};

/// Result of an export.
struct ExportOutcome
{
    QString problem; ///< one sentence: the file was not written, or its content is wrong; empty: neither
    QString verdict; ///< one line about the written file; empty if there is a problem or no file was written
};

/// Writes a copy of the model to a file, decimated if requested, and reads the file back to verify it. Hidden parts are
/// written only to GLB. Visible parts that overlap are united, unless the request keeps them: slicers would otherwise
/// find surfaces that intersect. The document's model does not change. Thread: any. Never throws.
class ModelExport
{
    Q_DECLARE_TR_FUNCTIONS(app::ModelExport)

public:
    /// A callback that gets the name of each stage at its beginning.
    using OnStage = std::function<void(const QString& what)>;

    /// Exports the copy, which is consumed. Cancelling while parts are united or triangles are
    /// reduced leaves no file.
    static ExportOutcome run(ExportRequest request, const OnStage& onStage, const core::JobControl& control);
    /// Returns whether overlapping parts are united in a file of this name: true for STL, PLY and OFF, which have one
    /// surface, and for 3MF, which is for print.
    static bool joinsPartsByDefault(const QString& path);

private:
    static QString join(ExportRequest& request, core::TriangleMesh& mesh, const OnStage& onStage,
                        const core::JobControl& control);
    static void decimate(ExportRequest& request, core::TriangleMesh& mesh, const core::JobControl& control);
    static ExportOutcome write(const ExportRequest& request, const core::TriangleMesh& mesh, const OnStage& onStage,
                               const core::JobControl& control);
    static ExportOutcome readBack(const ExportRequest& request, const core::TriangleMesh& mesh,
                                  const core::JobControl& control);
    static QString apartText(const QString& path);
    static QString verdictText(const ExportRequest& request, const core::MeshReport& report, bool losesColors);
};
} // namespace app
