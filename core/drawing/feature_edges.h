#pragma once

#include "core/drawing/line_drawing.h"

#include <span>

namespace core
{
/// An edge that may be a line of a drawing.
struct FeatureEdge
{
    Slot a, b; ///< vertices
    std::array<Slot, 2> faces;
    std::uint8_t outlineIn; ///< bit by DrawnSide: one face looks to the eye, the other does not
    bool isCrease;
};

struct HalfEdge
{
    Slot a, b, face; ///< a < b
    friend auto operator<=>(const HalfEdge&, const HalfEdge&) = default;
};

/// What changed in draw arrays; slots in ascending order.
struct DrawnChange
{
    std::vector<Slot> faces;    ///< other corners than before, or a corner that changed; new and free ones, too
    std::vector<Slot> vertices; ///< their corners, as they were and as they are
    std::vector<Slot> around;   ///< the faces at those vertices
};

/// The model as drawings see it. One thread.
class FeatureScan
{
public:
    /// Beyond `maxEdges` edges in question creases are left out.
    explicit FeatureScan(std::size_t maxEdges) : m_maxEdges(maxEdges) {}

    /// Looks at every face, on two threads. False if it was stopped; then it counts for nothing.
    /// The signs of facing() are exact for vertices on the lattice.
    bool scan(const DrawArrays& model, const std::stop_token& stop);

    /// The same for a model that has changed here and there since the last scan. False if only scan() can tell: creases
    /// have become too many. Cost: the change's faces, their blocks, and a pass over the edges in question.
    bool rescan(const DrawArrays& model, const DrawnChange& change);

    /// By face slot; bit by DrawnSide: it looks to the eye. 0 of a free face.
    std::span<const std::uint8_t> facing() const { return m_facing; }
    std::span<const FeatureEdge> edges() const { return m_edges; } ///< by their vertices
    std::span<const Box> blocks() const { return m_blocks; }       ///< around each `facesPerBlock` faces
    Box box() const;
    double volume() const;
    /// The faces that have had one of the vertices since the last scan; both ascend. Cost: the blocks that may have
    /// some.
    std::vector<Slot> facesAt(std::span<const Slot> vertices, const DrawArrays& model) const;
    bool hasCreases() const { return m_hasCreases; } ///< false: there were too many

private:
    /// By vertex slot: sides that see a face of it, sides that see one's back, sharp.
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
    std::vector<std::pair<Slot, Slot>> m_corners; ///< of the blocks: the first and the last
    std::vector<double> m_volumes;                ///< of the blocks, times 6
    std::vector<HalfEdge> m_halfEdges;            ///< that may be of lines, ascending
    std::vector<FeatureEdge> m_edges;
    std::size_t m_maxEdges;
    bool m_hasCreases = true;
};

Vec3 drawnNormal(const DrawArrays& model, Slot face); ///< twice the face's area long
} // namespace core
