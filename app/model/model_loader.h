#pragma once

#include "core/io/document_metadata.h"
#include "core/primitives/starter_models.h"
#include "core/print/print_check.h"
#include "core/util/job_control.h"
#include "ui/model/repair_doubt.h"
#include "ui/settings/model_info.h"

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
struct ReadRemarks;
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
    std::shared_ptr<core::Sculptor> sculptor;    ///< null: refused or cancelled
    std::shared_ptr<const core::Snapshot> start; ///< snapshot of the sculptor's mesh; valid only with a sculptor
    QString problem;                             ///< if refused: one sentence with file, place or counts, and reason
    bool isRepairable = false;                   ///< if refused: loadRepaired() may help
    QStringList repairs;                         ///< sentences about repairs that were done; empty: none
    std::optional<ui::RepairDoubt> doubt; ///< set if repairing changed the model too much: the user must accept it
    bool isUnsaved = false;               ///< true if no file contains the model in this state
    QString notice;                       ///< if not refused: a remark for the user; may be empty
    core::UnitDoubt unitGuess = core::UnitDoubt::None; ///< the likelier unit of length, if the file states none
    ui::FileObjects objects; ///< objects of the file, if the user can choose whether they become parts
    QString name;
    QString path;                           ///< path of the file that contains the model; empty: none
    QString source;                         ///< file from which the model was read; empty: none
    core::DocumentMetadata metadata;        ///< metadata of the file
    core::PartList parts;                   ///< names and properties of the parts in the file
    std::shared_ptr<core::Journal> journal; ///< journal begun for the model; may be null
    /// History of a model that was recovered from a journal; its mesh has moved to the sculptor. Null for others.
    std::shared_ptr<core::RecoveredDocument> recovered;
    quint64 offer = 0; ///< id of the RecoveryOffer from which the model was recovered; 0: none
};

/// Reads models from files, checks them and writes them, with sentences for the user. Never throws. Thread: any. Cost:
/// a few passes over the model.
class ModelLoader
{
    Q_DECLARE_TR_FUNCTIONS(app::ModelLoader)

public:
    /// A callback that gets the name of each stage at its beginning.
    using OnStage = std::function<void(const QString& what)>;
    /// Ways of reading the objects of a file that is not a document of Fettle.
    enum class Objects { AsOnePart, AsParts };

    /// Reads, checks and builds a model for the window, with its centre at the origin; the mesh's frame keeps the place
    /// that the file gives it. If it is cancelled, returns neither a model nor a problem. Objects that are not sound as
    /// one part, because they overlap, become parts if each of them is sound.
    static LoadedModel load(const QString& path, const OnStage& onStage = {}, const core::JobControl& control = {},
                            Objects objects = Objects::AsOnePart);
    /// Loads like load(), but repairs a model that is not sound. A repaired model has no path.
    static LoadedModel loadRepaired(const QString& path, const core::RepairOptions& options,
                                    const OnStage& onStage = {}, const core::JobControl& control = {});
    /// Loads like load(), for scripts: keeps the model's coordinates unless it is far from the origin. A model too far
    /// away for 32-bit coordinates is refused (core::isTooFarForFloats), because its file could not be written again.
    static LoadedModel loadInPlace(const QString& path, Objects objects = Objects::AsOnePart);
    /// Returns the sphere of 2562 vertices that the sculpting paper starts with. `radius`: mm.
    static LoadedModel sphere(double radius);
    static LoadedModel starter(core::Starter starter);
    /// Writes a model to a file, at the position given by metadata.frame. Returns an empty string on success. Otherwise
    /// returns one sentence about the error, and no file has changed. `backupCount`: number of backups to keep
    /// (core/io/numbered_backup.h).
    static QString save(const QString& path, const core::TriangleMesh& mesh, const core::DocumentMetadata& metadata,
                        int backupCount = 0);

    /// Returns whether the format for this file name supports colours.
    static bool holdsColors(const QString& path);
    /// Returns the surface that save() writes: without hidden parts unless the format keeps them.
    static core::TriangleMesh writtenSurface(const QString& path, const core::TriangleMesh& mesh,
                                             const core::DocumentMetadata& metadata);
    /// Returns whether the format for this file name defines a unit of length.
    static bool holdsUnit(const QString& path);
    /// Returns a sentence about a model that was inserted in millimetres from a file without a unit, if it is so small
    /// that its unit may be larger; otherwise an empty string. `volume`: mm3.
    static QString insertedUnitNotice(const ui::InsertRequest& insertion, double volume);

private:
    static QString name(core::Starter starter);
    using Process = std::function<void(LoadedModel& loaded, core::TriangleMesh& mesh, const core::JobControl& control)>;
    struct Source
    {
        QString path;
        Objects objects = Objects::AsOnePart;
        bool isChoice = false; ///< the user can choose what becomes of objects
    };
    static LoadedModel read(const Source& source, const OnStage& onStage, const core::JobControl& control,
                            const Process& process);
    static void noteObjects(LoadedModel& loaded, const Source& source, core::ReadRemarks& remarks);
    struct Placing
    {
        bool isCentred = false;                 ///< whether the centre of the model is moved to the origin
        core::Vec3 origin = core::Vec3::Zero(); ///< position of the mesh's origin in the space of the file
    };
    /// Builds `loaded.sculptor` from the mesh, or sets `loaded.problem`; does neither if cancelled. Returns the check
    /// report of the unchanged input mesh.
    static core::MeshReport build(LoadedModel& loaded, const core::TriangleMesh& mesh, const Placing& placing,
                                  const core::JobControl& control);
};

/// Converts a Qt path to a std::filesystem path.
std::filesystem::path toPath(const QString& path);
} // namespace app
