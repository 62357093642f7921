#pragma once

#include "core/drawing/line_drawing.h"

#include <span>

namespace core
{
/// An edge that is drawn: an outline in at least one view, or a crease.
struct FeatureEdge
{
    Slot a, b; ///< indices of its vertices
    std::array<Slot, 2> faces;
    std::uint8_t outlineIn; ///< one bit for each DrawnSide: one of the faces faces the eye and the other does not
    bool isCrease;
};

struct HalfEdge
{
    Slot a, b, face; ///< vertices, a < b, and the face
    friend auto operator<=>(const HalfEdge&, const HalfEdge&) = default;
};

/// A change to the draw arrays. All slots are in ascending order.
struct DrawnChange
{
    /// Faces with other corners than before, or with a changed corner; includes new and removed faces.
    std::vector<Slot> faces;
    std::vector<Slot> vertices; ///< the corners of `faces`, both before and after the change
    std::vector<Slot> around;   ///< all existing faces at those vertices after the change
};

/// Finds the edges to draw, and the faces that face the eye in each view. Thread: one thread at a time.
class FeatureScan
{
public:
    /// Makes an empty scan. If more than `maxEdges` edges may be outlines or creases, creases are omitted.
    explicit FeatureScan(std::size_t maxEdges) : m_maxEdges(maxEdges) {}

    /// Scans every face, on two threads. Returns false if it was stopped; the scan is then not usable. The results of
    /// facing() are exact for vertices on the lattice.
    bool scan(const DrawArrays& model, const std::stop_token& stop);

    /// Updates the scan after a local change. Returns false if a full scan() is needed because there are too many
    /// creases. Cost: the changed faces, their blocks, and a pass over the candidate edges.
    bool rescan(const DrawArrays& model, const DrawnChange& change);

    /// Returns for each face slot one bit for each DrawnSide that is set if the face faces the eye; 0 for a free slot.
    std::span<const std::uint8_t> facing() const { return m_facing; }
    std::span<const FeatureEdge> edges() const { return m_edges; } ///< sorted by vertices
    std::span<const Box> blocks() const { return m_blocks; }       ///< bounding box of every `facesPerBlock` faces
    Box box() const;
    double volume() const;
    /// Returns the faces that have one of the vertices; both lists are ascending. Faces that changed since the last
    /// scan may be missing. Cost: the blocks whose range of vertices contains one of the vertices.
    std::vector<Slot> facesAt(std::span<const Slot> vertices, const DrawArrays& model) const;
    bool hasCreases() const { return m_hasCreases; } ///< false: omitted because there were too many

private:
    /// Flags for each vertex slot: the sides on which a face at the vertex faces the eye, the sides on which one faces
    /// away, and whether the vertex is sharp.
    using Marks = std::vector<std::uint8_t>;

    void measure(const DrawArrays& model, std::size_t block);
    void mark(const DrawArrays& model, Slot f, Marks& marks) const;
    bool collect(const DrawArrays& model, const std::stop_token& stop);
    void addHalfEdges(const Triangle& corners, Slot f, std::vector<HalfEdge>& to) const;
    bool mayBeLine(Slot a, Slot b) const;
    void pair(const DrawArrays& model);

    std::vector<std::uint8_t> m_facing;
    Marks m_marks;
    std::vector<Box> m_blocks;
    std::vector<std::pair<Slot, Slot>> m_corners; ///< lowest and highest vertex slot of each block
    std::vector<double> m_volumes;                ///< volume contribution of each block in mm^3, times 6
    std::vector<HalfEdge> m_halfEdges;            ///< candidates for lines, ascending
    std::vector<FeatureEdge> m_edges;
    std::size_t m_maxEdges;
    bool m_hasCreases = true;
};

Vec3 drawnNormal(const DrawArrays& model, Slot face); ///< normal of the face; its length is twice the face's area
} // namespace core
