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
/// What is to be written.
struct ExportRequest
{
    QString path;                          ///< the ending says the format
    quint64 maxTriangles = 0;              ///< 0: all
    bool slices = false;                   ///< an installed slicer tries the file then
    core::DocumentMetadata metadata = {};  ///< of the mesh; a file with fewer triangles has none
    std::shared_ptr<core::Mesh> mesh = {}; ///< a copy; null: there was not enough memory
};

/// What became of it.
struct ExportOutcome
{
    QString problem; ///< one sentence: there is no file, or it is not what it should be
    QString verdict; ///< one line, of the file; empty: it was stopped before there was one
};

/// Writes a model that stays what it is, with fewer triangles if asked to, and checks what the file holds. Thread: any;
/// never throws.
class ModelExport
{
    Q_DECLARE_TR_FUNCTIONS(app::ModelExport)

public:
    /// Called at the beginning of each stage with its name.
    using OnStage = std::function<void(const QString& what)>;

    /// Consumes the copy. If it is cancelled in time, there is no file.
    static ExportOutcome run(ExportRequest request, const OnStage& onStage, const core::JobControl& control);

private:
    static ExportOutcome write(const ExportRequest& request, const core::TriangleMesh& mesh, const OnStage& onStage,
                               const core::JobControl& control);
    static ExportOutcome readBack(const ExportRequest& request, const core::TriangleMesh& mesh,
                                  const core::JobControl& control);
    static QString verdictText(const ExportRequest& request, const core::MeshReport& report, bool losesColors);
};
} // namespace app
