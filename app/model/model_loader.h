#pragma once

#include "core/analysis/print_check.h"
#include "core/io/document_metadata.h"
#include "core/operations/starter_models.h"
#include "core/util/job_control.h"
#include "ui/model/repair_doubt.h"

#include <QCoreApplication>
#include <QString>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

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
    std::shared_ptr<const core::Snapshot> start; ///< snapshot of its mesh; null: refused
    QString problem;                             ///< if refused: one sentence with file, place or counts, and reason
    bool isRepairable = false;                   ///< if refused: loadRepaired() may help
    QStringList repairs;                         ///< sentences about repairs that were done; empty: none
    std::optional<ui::RepairDoubt> doubt;        ///< the repairs did not keep the model: a person must accept it
    bool isUnsaved = false;                      ///< no file holds the model as it is
    QString notice;                              ///< if not refused: a remark for the user; may be empty
    core::UnitDoubt unitGuess = core::UnitDoubt::None; ///< the likelier unit, if the file has none
    QString name;
    QString path;                           ///< empty: no file holds the model
    QString source;                         ///< the file that it was read from; empty: none
    core::DocumentMetadata metadata;        ///< metadata of the file
    std::shared_ptr<core::Journal> journal; ///< journal begun for the model; may be null
    /// History of a model that was recovered from a journal; its mesh has moved to the sculptor. Null for others.
    std::shared_ptr<core::RecoveredDocument> recovered;
    quint64 offer = 0; ///< id of the RecoveryOffer that the model was; 0: none
};

/// Reads models from files, checks them and writes them, with sentences for the user. Never throws. Thread: any. Cost:
/// a few passes over the model.
class ModelLoader
{
    Q_DECLARE_TR_FUNCTIONS(app::ModelLoader)

public:
    /// A callback that gets the name of each stage at its beginning.
    using OnStage = std::function<void(const QString& what)>;

    /// Reads, checks and builds a model for the window, with its centre at the origin; the mesh's frame keeps the place
    /// that the file gives it. If it is cancelled, returns neither a model nor a problem.
    static LoadedModel load(const QString& path, const OnStage& onStage = {}, const core::JobControl& control = {});
    /// As load(), except that it repairs a model that is not sound. A repaired model has no path.
    static LoadedModel loadRepaired(const QString& path, const core::RepairOptions& options,
                                    const OnStage& onStage = {}, const core::JobControl& control = {});
    /// Does as load(), for scripts: the model stays where it is, unless it lies far from the origin. One that lies too
    /// far for 32-bit coordinates is refused (core::isTooFarForFloats), as its file could not be written again.
    static LoadedModel loadInPlace(const QString& path);
    /// Returns the paper's sphere of 2562 vertices. Units: mm.
    static LoadedModel sphere(double radius);
    /// Returns a starter model.
    static LoadedModel starter(core::Starter starter);
    /// Writes a model to a file, at the place of the metadata's frame. Returns an empty string, or a sentence that says
    /// what is wrong; no file has changed then. `backupCount`: number of backups to keep (core/util/numbered_backup.h).
    static QString save(const QString& path, const core::TriangleMesh& mesh, const core::DocumentMetadata& metadata,
                        int backupCount = 0);

    /// Whether the format of a file of this name has colours.
    static bool holdsColors(const QString& path);
    /// Whether the format of a file of this name has a unit of length.
    static bool holdsUnit(const QString& path);
    /// Returns a sentence about a model that was inserted, if it is so small that its unit may be larger than the
    /// millimetre; otherwise an empty string. `volume`: mm3.
    static QString insertedUnitNotice(const ui::InsertRequest& insertion, double volume);

private:
    static QString name(core::Starter starter);
    using Process = std::function<void(LoadedModel& loaded, core::TriangleMesh& mesh, const core::JobControl& control)>;
    static LoadedModel read(const QString& path, const OnStage& onStage, const core::JobControl& control,
                            const Process& process);
    struct Placing
    {
        bool isCentred = false;                 ///< the centre goes to the origin
        core::Vec3 origin = core::Vec3::Zero(); ///< the place of the mesh's origin in the file
    };
    /// Returns the report of the mesh as it came.
    static core::MeshReport build(LoadedModel& loaded, const core::TriangleMesh& mesh, const Placing& placing,
                                  const core::JobControl& control);
};

/// Converts a path from Qt.
std::filesystem::path toPath(const QString& path);
} // namespace app
