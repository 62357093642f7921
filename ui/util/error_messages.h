#pragma once

#include "core/stroke/stroke.h"
#include "core/stroke/tool.h"
#include "core/util/file_error.h"

#include <QCoreApplication>
#include <QString>

namespace core
{
struct MeshReport;
struct ReadRemarks;
} // namespace core

namespace ui
{
/// Turns error kinds of core into plain translated sentences, for dialogs and the command line. Thread: any.
class ErrorMessages
{
    Q_DECLARE_TR_FUNCTIONS(ui::ErrorMessages)

public:
    /// Returns a sentence with file, place and reason.
    static QString sentence(const core::FileError& error);
    /// Returns why the model cannot be sculpted, with counts. Precondition: `report` is not print-ready.
    static QString refusal(const QString& file, const core::MeshReport& report);
    /// Returns why the model cannot be a brush's shape, with counts. Precondition: `report` is not print-ready.
    static QString brushRefusal(const QString& file, const core::MeshReport& report);
    /// Returns the message for a sound model of which this many faces would intersect after snapping to the lattice.
    static QString tooFine(const QString& file, quint64 faces);
    /// Returns the message for a model that is too large in the requested unit or size.
    static QString tooLarge(const QString& file);
    /// Returns the faults of a model that is not print-ready, as a list with counts rather than a sentence.
    static QString faults(const core::MeshReport& report);
    /// Returns how a slicer may misread the unit of a model of this volume, mm^3. Empty if its size is usual.
    static QString unitDoubt(double volume);
    /// Returns which data of a file are not in the model; empty if none.
    static QString remarks(const QString& file, const core::ReadRemarks& remarks);
    /// Returns what the brush did not do, and why. Empty if it did everything.
    static QString shortfall(core::Shortfall shortfall);
    /// Returns the message for a mirrored stroke on a model that is not symmetric.
    static QString asymmetric();
    static QString sequentialSectors();

    /// Returns the message for a file name without an extension of drawings.
    static QString notADrawing(const QString& path);
    /// Messages for a file name without an extension of class reports, or of sheets for several models.
    static QString notAReport(const QString& path);
    static QString notABook(const QString& path);
    /// Messages for a reference image's file that contains no readable image, or no longer exists.
    static QString notAPicture(const QString& path);
    static QString missingReference(const QString& path);
    static QString name(core::Parameter parameter);
    /// Returns the parameter's range, for a user whose value was out of range.
    static QString range(core::Parameter parameter, double min, double max);

private:
    static QString reading(const core::FileError& error);
    static QString content(const core::FileError& error);
    static QString writing(const core::FileError& error);
    static QString at(const core::FileError& error);
};
} // namespace ui
