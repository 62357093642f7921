#pragma once

#include "core/io/document_metadata.h"
#include "core/io/export_check.h"
#include "core/mesh/mesh.h"

#include <QCoreApplication>
#include <QString>

#include <functional>
#include <memory>

namespace app
{
/// What is to be written.
struct ExportOrder
{
    QString path;                          ///< the ending says the format
    quint64 mostTriangles = 0;             ///< 0: all
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

/// Writes a model that stays what it is, with fewer triangles if asked to, and judges what the file holds. Any thread;
/// never throws.
class ModelExport
{
    Q_DECLARE_TR_FUNCTIONS(app::ModelExport)

public:
    /// What is going on, while it does.
    using Tell = std::function<void(const QString& what)>;

    /// Uses the copy up. Who stops it in time has no file.
    static ExportOutcome run(ExportOrder order, const Tell& tell, const core::JobControl& control);

private:
    static ExportOutcome write(const ExportOrder& order, const core::TriangleMesh& mesh, const Tell& tell,
                               const core::JobControl& control);
    static ExportOutcome judge(const ExportOrder& order, const core::TriangleMesh& mesh,
                               const core::JobControl& control);
    static QString word(const ExportOrder& order, const core::MeshReport& report, bool losesColors);
};
} // namespace app
