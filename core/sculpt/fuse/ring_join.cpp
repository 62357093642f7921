// Joins two stars (paper, section 3.4, Figure 13; the case of common ring vertices is not in the paper):
//   1. rings:      takes the ring of p counter-clockwise and that of q clockwise, seen from outside; the two then run
//                  in the same direction
//   2. arcs:       divides the rings at their common vertices; without any, starts both rings where they are nearest
//   3. strip:      connects each pair of arcs by triangles, evenly by Bresenham's error diffusion or by nearest
//                  vertices
//   4. umbrellas:  gives each umbrella its own copy of a vertex whose faces form several umbrellas (Brochu and Bridson
//                  2009)

#include "core/sculpt/fuse/ring_join.h"

#include <algorithm>
#include <limits>

namespace core
{
namespace
{
/// Share of the distance to the middle of its umbrella by which the copy of a vertex is moved.
constexpr double apart = 0.25;

Ring ringOf(const Mesh& mesh, Slot v)
{
    Ring ring;
    mesh.forEachOutgoing(v, [&](Slot h) { ring.push_back(mesh.to(h)); });
    return ring;
}

void addStar(const Mesh& mesh, Slot v, std::vector<Slot>& faces)
{
    mesh.forEachOutgoing(v, [&](Slot h) { faces.push_back(mesh.face(h)); });
}

bool has(const Ring& ring, Slot v)
{
    return std::ranges::find(ring, v) != ring.end();
}

/// Rotates b's starting point so that vertices of a and b at equal shares of the way round are as close as possible.
void alignEvenly(const Mesh& mesh, const Ring& a, Ring& b)
{
    const auto cost = [&](std::size_t start) {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            const Slot other = b[(start + i * b.size() / a.size()) % b.size()];
            sum += (mesh.point(a[i]).cast<double>() - mesh.point(other).cast<double>()).squaredNorm();
        }
        return sum;
    };
    std::size_t best = 0;
    double minCost = cost(0);
    for (std::size_t start = 1; start < b.size(); ++start) {
        const double here = cost(start);
        if (here < minCost) {
            minCost = here;
            best = start;
        }
    }
    std::ranges::rotate(b, b.begin() + static_cast<std::ptrdiff_t>(best));
}

/// Rotates the starting points of both rings to the pair of vertices that are nearest to each other.
void alignAtNearest(const Mesh& mesh, Ring& a, Ring& b)
{
    std::size_t bestA = 0, bestB = 0;
    double minCost = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            const double here = (mesh.point(a[i]).cast<double>() - mesh.point(b[j]).cast<double>()).squaredNorm();
            if (here < minCost) {
                minCost = here;
                bestA = i;
                bestB = j;
            }
        }
    }
    std::ranges::rotate(a, a.begin() + static_cast<std::ptrdiff_t>(bestA));
    std::ranges::rotate(b, b.begin() + static_cast<std::ptrdiff_t>(bestB));
}

RingStrip makeStrip(const Mesh& mesh, Stepping stepping, const Ring& a, const Ring& b, std::vector<Triangle>& faces)
{
    return stepping == Stepping::Nearest ? RingStrip(a, b, faces, mesh) : RingStrip(a, b, faces);
}

std::vector<std::size_t> commonPositions(const Ring& ring, const Ring& other)
{
    std::vector<std::size_t> positions;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (has(other, ring[i]))
            positions.push_back(i);
    }
    return positions;
}

/// Makes the strip between two rings with common vertices. Returns false if these are not in the same order on both
/// rings.
bool stripArcs(const Mesh& mesh, Stepping stepping, const Ring& a, Ring b, std::vector<Triangle>& faces)
{
    const std::vector<std::size_t> inA = commonPositions(a, b);
    std::ranges::rotate(b, std::ranges::find(b, a[inA[0]]));
    const std::vector<std::size_t> inB = commonPositions(b, a);
    for (std::size_t k = 0; k < inA.size(); ++k) {
        if (a[inA[k]] != b[inB[k]])
            return false;
    }
    for (std::size_t k = 0; k < inA.size(); ++k) {
        const std::size_t next = (k + 1) % inA.size();
        const Ring arcA = arc(a, inA[k], inA[next]), arcB = arc(b, inB[k], inB[next]);
        makeStrip(mesh, stepping, arcA, arcB, faces).betweenCommonEnds();
    }
    return true;
}

void stripWhole(const Mesh& mesh, Stepping stepping, Ring a, Ring b, std::vector<Triangle>& faces)
{
    if (stepping == Stepping::Nearest)
        alignAtNearest(mesh, a, b);
    else
        alignEvenly(mesh, a, b);
    a.push_back(a.front());
    b.push_back(b.front());
    makeStrip(mesh, stepping, a, b, faces).open();
}

std::optional<Surgery> ifOk(const Mesh& mesh, Surgery surgery)
{
    return isSurgeryOk(mesh, surgery) ? std::optional(std::move(surgery)) : std::nullopt;
}
} // namespace

std::optional<Surgery> joinStars(const Mesh& mesh, Slot p, Slot q, Stepping stepping)
{
    const Ring a = ringOf(mesh, p);
    Ring b = ringOf(mesh, q);
    if (p == q || has(a, q))
        return std::nullopt;
    std::ranges::reverse(b);
    Surgery surgery;
    surgery.nearby = p;
    addStar(mesh, p, surgery.removed);
    addStar(mesh, q, surgery.removed);
    if (commonPositions(a, b).empty())
        stripWhole(mesh, stepping, a, b, surgery.faces);
    else if (!stripArcs(mesh, stepping, a, b, surgery.faces))
        return std::nullopt;
    if (surgery.faces.empty())
        return std::nullopt; // the two stars are their whole component
    splitUmbrellas(mesh, surgery, apart);
    return ifOk(mesh, std::move(surgery));
}
} // namespace core
