#pragma once

#include "core/io/document_metadata.h"
#include "core/io/mesh_io.h"

#include <QCoreApplication>
#include <QString>

namespace app
{
/// What became of a model that was to have a file of its own.
struct SavedFile
{
    QString path;    ///< of that file
    QString problem; ///< one sentence: there is none
    QString notice;  ///< what the person should know all the same; may be empty
};

/// Writes models to files that are to be their own. Each is written whole or not at all. Any thread; never throws.
class ModelSaving
{
    Q_DECLARE_TR_FUNCTIONS(app::ModelSaving)

public:
    /// Replaces a file of that name, of which `backupCount` backups stay
    /// (core/util/numbered_backup.h).
    static SavedFile save(const QString& path, const core::TriangleMesh& mesh, const core::DocumentMetadata& metadata,
                          int backupCount = 0);
    /// A GLB and an STL, named as that path but for ending and number, which is the first after all that are there.
    static SavedFile saveNumbered(const QString& path, const core::TriangleMesh& mesh,
                                  const core::DocumentMetadata& metadata);
};
} // namespace app
