#pragma once

#include "core/mesh/mesh.h"
#include "core/util/job_control.h"

#include <QCoreApplication>
#include <QString>

#include <memory>

namespace app
{
/// What became of a model that was to be a brush's, too.
struct KeptBrush
{
    QString path;    ///< of its file; empty: there is none
    QString problem; ///< then: one sentence, or nothing if it was stopped
};

/// Keeps the document's model as it is now in a file that brushes are read from: strokes name it, with its fingerprint.
/// Any thread; never throws.
class BrushKeeper
{
    Q_DECLARE_TR_FUNCTIONS(app::BrushKeeper)

public:
    /// In the user's data. Nothing is removed there: a stroke file may name it.
    static QString folder();
    /// A GLB of that name, in a folder that is called as its fingerprint: another model of that name takes no file's
    /// place. A model with more triangles than a brush may have has fewer there. Uses the copy up; null: there was not
    /// enough memory for one.
    static KeptBrush keep(const std::shared_ptr<core::Mesh>& copy, const QString& name,
                          const core::JobControl& control);
};
} // namespace app
