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
/// core's kinds in words: one sentence each, plain text, for dialogs and for the command line alike. Any thread.
class ErrorMessages
{
    Q_DECLARE_TR_FUNCTIONS(ui::ErrorMessages)

public:
    /// File, place and reason.
    static QString sentence(const core::FileError& error);
    /// Why a model of that file name is not sculpted, with counts; `report` is not print-ready.
    static QString refusal(const QString& file, const core::MeshReport& report);
    /// The same of a model that was to be a brush's shape.
    static QString brushRefusal(const QString& file, const core::MeshReport& report);
    /// Nothing is wrong with the model, but that many of its faces would meet where the lattice puts them.
    static QString tooFine(const QString& file, quint64 faces);
    /// In the unit or of the size that was asked for.
    static QString tooLarge(const QString& file);
    /// What is wrong with a model that is not print-ready: a list with counts, no sentence.
    static QString faults(const core::MeshReport& report);
    /// What a slicer may take a model of that volume (mm^3) for. Empty if it has a size that is usual.
    static QString unitDoubt(double volume);
    /// What of a file is not in its model; empty if all is.
    static QString remarks(const QString& file, const core::ReadRemarks& remarks);
    /// What the brush did not do, and why. Empty if it did all.
    static QString shortfall(core::Shortfall shortfall);
    /// Of a mirrored stroke on a model that is not its own mirror image.
    static QString asymmetric();
    static QString sequentialSectors();

    /// The ending is none that drawings have.
    static QString notADrawing(const QString& path);
    /// The same of class reports, and of sheets for several models.
    static QString notAReport(const QString& path);
    static QString notABook(const QString& path);
    /// A reference image's file holds no image that can be read, or is gone.
    static QString notAPicture(const QString& path);
    static QString missingReference(const QString& path);
    static QString name(core::Parameter parameter);
    /// What it can be, if somebody asked for more or less.
    static QString range(core::Parameter parameter, double min, double max);

private:
    static QString reading(const core::FileError& error);
    static QString content(const core::FileError& error);
    static QString writing(const core::FileError& error);
    static QString at(const core::FileError& error);
};
} // namespace ui
