#pragma once

#include "core/util/job_control.h"

#include <QCoreApplication>
#include <QString>

#include <memory>

namespace core
{
class Mesh;
}

namespace app
{
/// The outcome of an export as a brush.
struct ExportedBrush
{
    QString path;    ///< of its file; empty: there is none
    QString problem; ///< then: one sentence, or nothing if it was stopped
};

/// Writes the document's present model to a file that brushes are read from: strokes name it, with its fingerprint.
/// Any thread; never throws.
class BrushExport
{
    Q_DECLARE_TR_FUNCTIONS(app::BrushExport)

public:
    /// In the user's data. Nothing is removed there: a stroke file may name it.
    static QString folder();
    /// A GLB of that name, in a folder that is called as its fingerprint: another model of that name takes no file's
    /// place. A model with more triangles than a brush may have has fewer there. Consumes the copy; null: there was not
    /// enough memory for one.
    static ExportedBrush run(const std::shared_ptr<core::Mesh>& copy, const QString& name,
                             const core::JobControl& control);
};
} // namespace app
