#pragma once

#include "core/io/stroke/stroke_file.h"
#include "core/mesh/mesh_delta.h"

#include <QtGlobal>

#include <functional>
#include <memory>
#include <stop_token>

namespace core
{
class Sculptor;
}

namespace app
{
/// What the window says of the mesh.
struct MeshFacts
{
    quint64 vertices = 0;
    quint64 faces = 0;
    core::Box box;            ///< mm; right after a stroke it may still be larger than the mesh
    double area = 0;          ///< mm^2; of the mesh some time ago, as the box
    double uniformDetail = 0; ///< mm
    double minDetail = 0;     ///< mm; the finest d_detail that the lattice holds
};

/// A stroke that has ended, in the order of the strokes' beginnings.
struct StrokeReport
{
    std::shared_ptr<core::MeshDelta> delta;              ///< already applied; null if nothing changed
    std::shared_ptr<const core::FileEntry> recordedStep; ///< the core::Stroke that did it; null if nothing changed
    core::Tool tool = core::Tool::Pull;
    quint64 dabs = 0;
    quint64 fusions = 0;
    core::Shortfall shortfall = core::Shortfall::None; ///< the one of its dabs that is most worth telling
    bool added = false;                                ///< a sphere, or the brush's model
    bool hasModel = false;                             ///< the brush
    bool asymmetric = false; ///< mirrored where the model is not symmetric: some dabs were done as two
    /// Radial where the model is not its own image by the turn, or over the axis: some dabs were done one by one.
    bool sequential = false;
    bool isReplacement = false; ///< of SculptWorker::replaceLastStroke()
    MeshFacts facts;

    /// The stroke that was recorded; null if nothing changed.
    const core::Stroke* stroke() const { return std::get_if<core::Stroke>(recordedStep.get()); }
};

/// Another stroke in place of one that was undone.
struct StrokeReplacement
{
    StrokeReport before; ///< of the one that was undone
    /// Applies its change again; thread: mesh.
    std::function<std::shared_ptr<core::MeshDelta>(core::Sculptor&)> restoreReplaced;
    std::shared_ptr<const core::Stroke> stroke; ///< null: the one that was undone comes back, bit for bit
    std::stop_token stop;                       ///< before this is done, the one that was undone comes back as well
};
} // namespace app
