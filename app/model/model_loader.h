#pragma once

#include "core/analysis/print_check.h"
#include "core/io/document_metadata.h"
#include "core/operations/starter_models.h"
#include "core/util/job_control.h"

#include <QCoreApplication>
#include <QString>

#include <filesystem>
#include <functional>
#include <memory>

namespace core
{
class Journal;
class Mesh;
class Sculptor;
struct RepairOptions;
struct RecoveredDocument;
struct Snapshot;
} // namespace core
namespace ui
{
struct InsertRequest;
}

namespace app
{
/// A model that may be sculpted, or the reason why not.
struct LoadedModel
{
    std::shared_ptr<core::Sculptor> sculptor;    ///< null: refused
    std::shared_ptr<const core::Snapshot> start; ///< of its mesh; null: refused
    QString problem;                             ///< then: one sentence with file, place or counts, and reason
    bool isRepairable = false;                   ///< then: loadRepaired() may help
    QStringList repairs;                         ///< what was done to it; empty: nothing
    bool isUnsaved = false;                      ///< it is in no file as it is
    QString notice; ///< what the person should know of a model that was taken; may be empty
    core::UnitDoubt unitGuess = core::UnitDoubt::None; ///< of a model whose file has none
    QString name;
    QString path;                           ///< empty: from no file
    core::DocumentMetadata metadata;        ///< that the file keeps beside it
    std::shared_ptr<core::Journal> journal; ///< that was begun for it; may be null
    /// Of a model out of such a journal: its history; the mesh is the sculptor's.
    std::shared_ptr<core::RecoveredDocument> recovered;
    quint64 offer = 0; ///< that it was
};

/// Files to models and back, in words for people. Any thread; takes as long as the model is large. Never throws.
class ModelLoader
{
    Q_DECLARE_TR_FUNCTIONS(app::ModelLoader)

public:
    /// Called at the beginning of each stage with its name.
    using OnStage = std::function<void(const QString& what)>;

    /// Reads, checks and builds for the window: the model's centre is put at the origin.
    /// If it is cancelled, returns neither a model nor a problem.
    static LoadedModel load(const QString& path, const OnStage& onStage = {}, const core::JobControl& control = {});
    /// As load(), but repairs a model that is not sound; it has no path then.
    static LoadedModel loadRepaired(const QString& path, const core::RepairOptions& options,
                                    const OnStage& onStage = {}, const core::JobControl& control = {});
    /// The same for scripts: the model stays where it is, or is refused.
    static LoadedModel loadInPlace(const QString& path);
    /// The paper's sphere, 2562 vertices.
    static LoadedModel sphere(double radius);
    static LoadedModel starter(core::Starter starter);
    /// Empty, or what is wrong; then no file has changed. `backupCount`: that many backups stay
    /// (core/util/numbered_backup.h).
    static QString save(const QString& path, const core::TriangleMesh& mesh, const core::DocumentMetadata& metadata,
                        int backupCount = 0);

    /// Whether a file of that name would.
    static bool holdsColors(const QString& path);
    static bool holdsUnit(const QString& path);
    /// Of a model that was inserted: empty, or why it may have been meant larger.
    static QString insertedUnitNotice(const ui::InsertRequest& insertion, double volume);

private:
    static void setMesh(LoadedModel& loaded, std::unique_ptr<core::Mesh> mesh);
    static QString name(core::Starter starter);
    using Process = std::function<void(LoadedModel& loaded, core::TriangleMesh& mesh, const core::JobControl& control)>;
    static LoadedModel read(const QString& path, const OnStage& onStage, const core::JobControl& control,
                            const Process& process);
    static void build(LoadedModel& loaded, const core::TriangleMesh& mesh, bool inPlace,
                      const core::JobControl& control);
};

std::filesystem::path toPath(const QString& path);
} // namespace app
