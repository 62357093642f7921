#pragma once

#include "core/sculpt/remesh/remesh_pass.h"

#include <functional>

namespace core
{
/// The depth function of a shape. Returns the distance, in mm, by which the shape is to move the surface at a point;
/// positive or negative, 0 outside the shape.
using ShapeDepth = std::function<double(const Vec3&)>;

/// Makes the outline of a shape on the surface run along edges. Edges that cross the outline are split there. If an end
/// of such an edge is close to the outline, it is moved onto it along the edge instead, unless the surface is sharp
/// there. Where the shape is deep beside its outline, the edges leading inwards are split once more, close to the
/// outline, as the foot of the steep wall to come. With a mirror, the outlines of both the shape and its image are cut,
/// on both sides.
class OutlineCut
{
public:
    /// `ball`: contains the shape. Keeps references to the pass and to `depth`.
    OutlineCut(RemeshPass& pass, const ShapeDepth& depth, const Sphere& ball);

    /// Cuts the edges of the region's vertices inside the shape. The vertices on the outline, and the ends of the edges
    /// that crossed it, are added to the region. Returns the vertices on the shape's own outline, on both sides of a
    /// mirror.
    SlotSet cut();

private:
    /// An edge with exactly one end inside the shape, and the point where it crosses the outline.
    struct Crossing
    {
        Slot inside, outside; ///< vertices inside and outside the shape
        Vec3 point;
        double share; ///< position of the crossing along the edge: distance from the nearer end, 0 to 0.5 of its length
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
    SlotSet m_cut; ///< vertices on the outline of the shape or of its image
};
} // namespace core
