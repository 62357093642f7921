#pragma once

#include "core/sculpt/remesh/remesh_pass.h"

#include <functional>

namespace core
{
/// Returns how far a shape is to move the surface at a point, in mm, of either sign; 0 outside the shape.
using ShapeDepth = std::function<double(const Vec3&)>;

/// Makes the outline of a shape on the surface run along edges. Edges that cross it are split there; an end that lies
/// close to it moves onto it, along an edge and where the surface is not sharp. Where the shape is deep beside its
/// outline, the edges that lead inwards are split once more, close to it: the foot of the wall that is to stand there.
/// A mirror has the outlines of the shape and of its image cut, on both sides.
class OutlineCut
{
public:
    /// `ball`: around the shape. References are kept.
    OutlineCut(RemeshPass& pass, const ShapeDepth& depth, const Sphere& ball);

    /// Cuts the edges of the region's vertices inside the shape. Vertices on the outline, and the ends of the edges
    /// that crossed it, join the region. Returns the vertices on the shape's own outline, on both sides of a mirror.
    SlotSet cut();

private:
    /// An edge with just one end inside, and where between them the outline is.
    struct Crossing
    {
        Slot inside, outside; ///< vertices
        Vec3 point;
        double share; ///< of the edge, from the nearer end
        Slot nearer() const { return isNearInside ? inside : outside; }
        bool isNearInside;
    };

    void cut(const ShapeDepth& depth, SlotSet& outline);
    std::vector<Crossing> crossings(const ShapeDepth& depth, const SlotSet& outline);
    void moveNearest(std::vector<Crossing> crossings, SlotSet& outline);
    bool move(const Crossing& crossing);
    void splitCrossing(const std::vector<Crossing>& crossings, SlotSet& outline);
    void splitInwards(const ShapeDepth& depth, const SlotSet& outline);
    Slot split(Slot from, Slot to, const Vec3& point);
    void addToRegion(Slot v);

    RemeshPass& m_pass;
    const Mesh& m_mesh;
    const ShapeDepth& m_depth;
    Sphere m_ball;
    SlotSet m_cut; ///< vertices on an outline
};
} // namespace core
