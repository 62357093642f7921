#pragma once

#include "core/operations/model_command.h"
#include "core/stroke/stroke.h"

namespace core
{
/// The coordinates of a stroke file's places, planes and axes: those of the document that a window wrote, or those that
/// the model's own file gives the model. They stay where they are in space: after a command a place is meant where the
/// model is then. A model that lies far from its file's origin is sculpted near the document's (MeshFrame::place);
/// this class knows what lies between the two.
class StrokeCoordinates
{
public:
    /// `origin`: of the coordinates, in the space of the model's file. DocumentMetadata::place() of a document, else
    /// zero.
    explicit StrokeCoordinates(const Vec3& origin) : m_start(origin), m_origin(origin) {}

    /// Returns the origin of the mesh's document in these coordinates; zero where both are the same.
    Vec3 offset(const Mesh& mesh) const;

    /// Returns the stroke in the document's coordinates. Without its symmetry, or its sectors, if their plane or axis
    /// passes the model by: nothing lies on their other side (see aligned()).
    Stroke inDocument(const Stroke& stroke, const Mesh& mesh) const;

    /// Applies the command to a copy of the mesh, as applyToCopy() does, by planes, axes and places of these
    /// coordinates. A Symmetrize by a plane that passes the model by is refused: EmptyHalf, or TooFar.
    ModelChange apply(const Mesh& mesh, ModelCommand command);

    /// Returns the change that lays coordinate planes that cut the model, or lie within its longest side of it, onto
    /// those of the document, so that symmetry is exact. For the beginning: apply() does it, too. Changes nothing where
    /// offset() is zero.
    ModelChange aligned(const Mesh& mesh) const;

private:
    ModelChange symmetrizedBeside(const Mesh& mesh, const Symmetrize& command, const Vec3& offset) const;
    void alignAfter(const Mesh& mesh, ModelChange& change) const;
    void follow(const ModelCommand& command, const Vec3& offset, MeshFrame& frame);

    Vec3 m_start;  ///< `origin` before all commands
    Vec3 m_origin; ///< after those so far
};
} // namespace core
