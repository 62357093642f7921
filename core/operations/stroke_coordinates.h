#pragma once

#include "core/operations/model_command.h"
#include "core/stroke/stroke.h"

namespace core
{
/// Coordinates of the places, planes and axes in a stroke file: those of the document of the window that wrote it, or
/// those of the model's own file. They are fixed in space: after a command, a place refers to where the model is then.
/// A model far from its file's origin is sculpted near the document's origin (MeshFrame::place); this class converts
/// between the two.
class StrokeCoordinates
{
public:
    /// `origin`: origin of these coordinates in the space of the model's file: DocumentMetadata::place() of a document,
    /// else zero.
    explicit StrokeCoordinates(const Vec3& origin) : m_start(origin), m_origin(origin) {}

    /// Returns the origin of the mesh's document in these coordinates; zero if they are the document's own.
    Vec3 offset(const Mesh& mesh) const;

    /// Returns the stroke in the document's coordinates. Removes its symmetry, or its radial sectors, if the plane or
    /// axis is not the document's own; aligned() has made them equal where they are near the model.
    Stroke inDocument(const Stroke& stroke, const Mesh& mesh) const;

    /// Applies the command to a copy of the mesh, as applyToCopy() does, with planes, axes and places in these
    /// coordinates. A Symmetrize whose plane is not the document's is refused with EmptyHalf or TooFar. A part of
    /// several is moved, turned and mirrored in the document's coordinates.
    /// An area of the view loses a symmetry whose plane is not the document's.
    ModelChange apply(const Mesh& mesh, ModelCommand command, PartId part = 0);

    /// Returns the change that moves the model so that coordinate planes near it coincide with those of the document,
    /// which makes symmetry exact. Planes that cut the model, or are within its longest side of it, are near. Call it
    /// once at the beginning; apply() does it after each command. No change if offset() is zero.
    ModelChange aligned(const Mesh& mesh) const;

private:
    ModelChange symmetrizedBeside(const Mesh& mesh, const Symmetrize& command, const Vec3& offset) const;
    void alignAfter(const Mesh& mesh, ModelChange& change) const;
    void follow(const ModelCommand& command, const Vec3& offset, MeshFrame& frame);

    Vec3 m_start;  ///< origin before all commands
    Vec3 m_origin; ///< origin after the commands so far
};
} // namespace core
