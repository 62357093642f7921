#pragma once

#include "core/io/document_metadata.h"
#include "core/io/mesh_io.h"

#include <QCoreApplication>
#include <QString>

namespace app
{
/// Result of saving a model.
struct SavedFile
{
    QString path;    ///< path of the file that was or should have been written
    QString problem; ///< reason why no file was written, one sentence; empty if it was written
    QString notice;  ///< message for the user after saving; may be empty
};

/// Saves models to files and reports losses such as missing colours. Each file is written completely or not at all.
/// Thread: any. Never throws.
class ModelSaving
{
    Q_DECLARE_TR_FUNCTIONS(app::ModelSaving)

public:
    /// Saves to `path`, replacing an existing file. `backupCount`: number of backups to keep
    /// (core/io/numbered_backup.h).
    static SavedFile save(const QString& path, const core::TriangleMesh& mesh, const core::DocumentMetadata& metadata,
                          int backupCount = 0);
    /// Saves a GLB and an STL beside `path`, with the base name of `path` and the first number after all numbers in
    /// use.
    static SavedFile saveNumbered(const QString& path, const core::TriangleMesh& mesh,
                                  const core::DocumentMetadata& metadata);
};
} // namespace app
