#pragma once

#include "core/io/stroke/stroke_file.h"
#include "core/mesh/mesh_delta.h"

#include <QtGlobal>

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

namespace core
{
class Sculptor;
}

namespace app
{
/// Facts about the mesh that the window shows.
struct MeshFacts
{
    quint64 vertices = 0;
    quint64 faces = 0;
    core::Box box;            ///< mm; may be larger than the mesh until the scan after the stroke has finished
    double area = 0;          ///< mm^2; may be out of date until the scan after the stroke has finished
    double uniformDetail = 0; ///< edge length above which Topology::Uniform splits (d_detail), mm
    double minDetail = 0;     ///< smallest d_detail that the mesh's lattice allows, mm
};

/// The result of a finished stroke. Reports come in the order in which the strokes began.
struct StrokeReport
{
    std::shared_ptr<core::MeshDelta> delta; ///< change of the mesh, already applied; null if nothing changed
    /// the core::Stroke that made the change; null if nothing changed
    std::shared_ptr<const core::FileEntry> recordedStep;
    std::optional<core::Part> part; ///< the part that the stroke changed, if the document has several
    core::Tool tool = core::Tool::Pull;
    quint64 dabs = 0;
    quint64 fusions = 0;
    core::Shortfall shortfall = core::Shortfall::None; ///< the most important shortfall of the stroke's dabs
    bool added = false;                                ///< whether the stroke added a sphere or the brush's model
    bool hasModel = false;                             ///< whether the brush is a model
    /// whether some mirrored dabs were done one after the other, because the model is not symmetric
    bool asymmetric = false;
    /// whether some dabs of a radial stroke were done one after the other: the model is not radially symmetric, or the
    /// brush reached over the axis
    bool sequential = false;
    bool isReplacement = false; ///< whether the stroke was made by SculptWorker::replaceLastStroke()
    MeshFacts facts;

    /// Returns the recorded stroke; null if nothing changed.
    const core::Stroke* stroke() const { return std::get_if<core::Stroke>(recordedStep.get()); }
};

/// A request to replace an undone stroke by another one.
struct StrokeReplacement
{
    StrokeReport before; ///< report of the undone stroke
    /// Applies the change of the undone stroke again. Thread: mesh.
    std::function<std::shared_ptr<core::MeshDelta>(core::Sculptor&)> restoreReplaced;
    std::shared_ptr<const core::Stroke> stroke; ///< the new stroke; null: the undone stroke is restored, bit for bit
    std::stop_token stop; ///< if it is requested before the new stroke is done, the undone stroke is restored
};
} // namespace app
