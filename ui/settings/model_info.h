#pragma once

#include "core/io/document_metadata.h"
#include "core/print/print_check.h"

#include <QString>

namespace ui
{
/// The objects of a file whose format has objects, as they were opened. A document of Fettle counts as one object.
struct FileObjects
{
    std::size_t count = 1;
    bool areParts = false; ///< each became a part of the model; false: they became one part
};

/// Data about the open model that the window shows.
struct ModelInfo
{
    QString name; ///< file name, or the name of a starter model; shown in the title
    quint64 vertices = 0;
    quint64 faces = 0;
    core::Vec3 size = core::Vec3::Zero(); ///< mm
    core::Box box;                        ///< mm
    double area = 0;                      ///< mm^2
    double uniformDetail = 0;             ///< edge length above which Topology::Uniform splits (d_detail), mm
    double minDetail = 0;                 ///< finest d_detail that the model's lattice can represent, mm
    QString path = {};                    ///< path of the model's file; empty: not saved in a file
    QString source = {};                  ///< file that was opened, even if the model had to be repaired; empty: none
    /// metadata of the model's file as read at opening, but palette and work are kept current
    core::DocumentMetadata metadata = {};
    core::UnitDoubt unitGuess = core::UnitDoubt::None; ///< probable unit of a file that has none; None: not in doubt
    FileObjects objects = {};                          ///< objects of the file that was opened
};
} // namespace ui
