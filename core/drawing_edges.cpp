// Which edges are lines of a drawing. Nobody keeps the mesh's connectivity for this: an edge of an outline joins two vertices that have
// faces looking to the eye and others; a crease joins two whose normals lie far from a face's. Only faces at such edges are paired.
#include "drawing_edges.h"

#include <algorithm>

namespace core
{
namespace
{
constexpr Slot facesAStep = 1 << 15; ///< between two looks at `stop`
constexpr std::uint8_t sidesMask = 7, awayShift = 3, sharpBit = 1 << 6;
constexpr double sharpCosine = halfCreaseCosine + 0.012; ///< vertex normals are rounded to 1/127

bool isFree(const Triangle& t)
{
    return t[0] == t[1];
}

std::uint8_t facingOf(const Vec3& normal)
{
    return static_cast<std::uint8_t>((normal.z() > 0) | (normal.x() > 0) << 1 | (normal.y() > 0) << 2);
}

/// Whether the angle to the vertex's normal is beyond half a crease's.
bool isSharp(const DrawVertex& vertex, const Vec3f& normal, float length2)
{
    const Vec3f mean(vertex.normal[0], vertex.normal[1], vertex.normal[2]);
    const float along = mean.dot(normal);
    constexpr auto least = static_cast<float>(sharpCosine * sharpCosine);
    return along <= 0 || along * along < least * length2 * mean.squaredNorm();
}

struct HalfEdge
{
    Slot a, b, face; ///< a < b
    friend auto operator<=>(const HalfEdge&, const HalfEdge&) = default;
};

class Scanner
{
public:
    Scanner(const DrawArrays& model, const std::stop_token& stop) : m_model(model), m_stop(stop) {}

    std::optional<DrawingScan> run(std::size_t mostEdges)
    {
        m_scan.facing.assign(m_model.faces.size(), 0);
        m_marks.assign(m_model.vertices.size(), 0);
        if (!eachFace([this](Slot f) { measure(f); }) || !collect(mostEdges))
            return std::nullopt;
        m_scan.volume /= 6;
        std::ranges::sort(m_halfEdges);
        pair();
        return std::move(m_scan);
    }

private:
    template <class Work> bool eachFace(Work work)
    {
        const auto count = static_cast<Slot>(m_model.faces.size());
        for (Slot first = 0; first < count; first += facesAStep) {
            if (m_stop.stop_requested())
                return false;
            for (Slot f = first, end = std::min(count, first + facesAStep); f < end; ++f)
                work(f);
        }
        return true;
    }

    void measure(Slot f)
    {
        const Triangle& t = m_model.faces[f];
        if (isFree(t))
            return;
        const Vec3 normal = drawnNormal(m_model, f);
        const std::uint8_t facing = facingOf(normal);
        m_scan.facing[f] = facing;
        const auto mark = static_cast<std::uint8_t>(facing | (~facing & sidesMask) << awayShift);
        const Vec3f direction = normal.cast<float>();
        const float length2 = direction.squaredNorm();
        for (const Slot v : t) {
            const DrawVertex& vertex = m_model.vertices[v];
            m_marks[v] = static_cast<std::uint8_t>(m_marks[v] | mark | (isSharp(vertex, direction, length2) ? sharpBit : 0));
            m_scan.box.extend(vertex.position.cast<double>());
        }
        m_scan.volume += m_model.vertices[t[0]].position.cast<double>().dot(normal);
    }

    bool mayBeLine(Slot a, Slot b) const
    {
        const auto both = static_cast<std::uint8_t>(m_marks[a] & m_marks[b]);
        return (both & both >> awayShift & sidesMask) != 0 || (m_scan.hasCreases && (both & sharpBit) != 0);
    }

    /// Creases are left out where they would be too many.
    bool collect(std::size_t mostEdges)
    {
        bool isTooMuch = false;
        const auto add = [&](Slot f) {
            const Triangle& t = m_model.faces[f];
            if (isFree(t) || isTooMuch)
                return;
            for (std::size_t i = 0; i < 3; ++i)
                if (const Slot a = t[i], b = t[(i + 1) % 3]; mayBeLine(a, b))
                    m_halfEdges.push_back({std::min(a, b), std::max(a, b), f});
            isTooMuch = m_scan.hasCreases && m_halfEdges.size() / 2 > mostEdges;
        };
        if (!eachFace(add))
            return false;
        if (!isTooMuch)
            return true;
        m_scan.hasCreases = false;
        m_halfEdges.clear();
        return collect(mostEdges);
    }

    void pair()
    {
        for (std::size_t i = 0; i + 1 < m_halfEdges.size(); ++i) {
            const HalfEdge &one = m_halfEdges[i], &other = m_halfEdges[i + 1];
            if (one.a != other.a || one.b != other.b)
                continue;
            const auto outline = static_cast<std::uint8_t>(m_scan.facing[one.face] ^ m_scan.facing[other.face]);
            const bool isCrease = m_scan.hasCreases && bends(one.face, other.face);
            if (outline != 0 || isCrease)
                m_scan.edges.push_back({one.a, one.b, {one.face, other.face}, outline, isCrease});
            ++i;
        }
    }

    bool bends(Slot f, Slot g) const
    {
        const Vec3 m = drawnNormal(m_model, f), n = drawnNormal(m_model, g);
        const double along = m.dot(n);
        return along <= 0 || along * along < creaseCosine * creaseCosine * m.squaredNorm() * n.squaredNorm();
    }

    const DrawArrays& m_model;
    const std::stop_token& m_stop;
    DrawingScan m_scan;
    std::vector<std::uint8_t> m_marks; ///< by vertex slot: sides that see a face of it, sides that see one's back, sharp
    std::vector<HalfEdge> m_halfEdges;
};
} // namespace

Vec3 drawnNormal(const DrawArrays& model, Slot face)
{
    const Triangle& t = model.faces[face];
    const Vec3 a = model.vertices[t[0]].position.cast<double>();
    return (model.vertices[t[1]].position.cast<double>() - a).cross(model.vertices[t[2]].position.cast<double>() - a);
}

std::optional<DrawingScan> scanForDrawing(const DrawArrays& model, std::size_t mostEdges, const std::stop_token& stop)
{
    return Scanner(model, stop).run(mostEdges);
}
} // namespace core
