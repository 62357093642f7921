#pragma once

#include "core/analysis/print_check.h"
#include "core/io/document_metadata.h"

#include <QString>

namespace ui
{
/// What the window shows about the open model.
struct ModelInfo
{
    QString name; ///< file name, or the name of a starter model; shown in the title
    quint64 vertices = 0;
    quint64 faces = 0;
    core::Vec3 size = core::Vec3::Zero(); ///< mm
    core::Box box;                        ///< mm
    double area = 0;                      ///< mm^2
    double uniformDetail = 0;             ///< mm; d_detail of the uniform topology
    double minDetail = 0;                 ///< mm; the finest d_detail that the model's lattice holds
    QString path = {};                    ///< empty: no file holds it
    QString source = {};                  ///< the file that was opened, also where it had to be mended; empty: none
    /// That its file keeps; when it was opened, but for the palette and the work.
    core::DocumentMetadata metadata = {};
    core::UnitDoubt unitGuess = core::UnitDoubt::None; ///< when it was opened, where its file has no unit
};
} // namespace ui
