// Which edges are lines of a drawing. Nobody keeps the mesh's connectivity for this: an edge of an outline joins two vertices that have
// faces looking to the eye and others; a crease joins two whose normals lie far from a face's. Only faces at such edges are paired.
#include "drawing_edges.h"

#include <algorithm>
#include <array>
#include <future>

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

/// What the faces from `first` on say; each part has a thread of its own.
struct Part
{
    Slot first = 0, end = 0;
    std::vector<std::uint8_t> marks; ///< by vertex slot: sides that see a face of it, sides that see one's back, sharp
    Box box;
    double volume = 0; ///< times 6
    std::vector<HalfEdge> halfEdges;
    bool isTooMuch = false;
};

class Scanner
{
public:
    Scanner(const DrawArrays& model, const std::stop_token& stop) : m_model(model), m_stop(stop)
    {
        const auto faces = static_cast<Slot>(model.faces.size()), share = faces / static_cast<Slot>(m_parts.size());
        for (Slot i = 0; i < m_parts.size(); ++i) {
            m_parts[i].first = i * share;
            m_parts[i].end = i + 1 == m_parts.size() ? faces : (i + 1) * share;
        }
    }

    std::optional<DrawingScan> run(std::size_t mostEdges)
    {
        m_scan.facing.assign(m_model.faces.size(), 0);
        if (!eachPart([this](Part& part) { return measure(part); }))
            return std::nullopt;
        joinMeasures();
        if (!collect(mostEdges))
            return std::nullopt;
        pair();
        return std::move(m_scan);
    }

private:
    /// False if one of them was stopped.
    template <class Work> bool eachPart(Work work)
    {
        auto aside = std::async(std::launch::async, [&] { return work(m_parts[1]); });
        const bool isDone = work(m_parts[0]);
        return aside.get() && isDone;
    }

    template <class Work> bool eachFace(const Part& part, Work work) const
    {
        for (Slot first = part.first; first < part.end; first += facesAStep) {
            if (m_stop.stop_requested())
                return false;
            for (Slot f = first, end = std::min(part.end, first + facesAStep); f < end; ++f)
                if (!isFree(m_model.faces[f]))
                    work(f);
        }
        return true;
    }

    bool measure(Part& part)
    {
        part.marks.assign(m_model.vertices.size(), 0);
        return eachFace(part, [&](Slot f) { measure(part, f); });
    }

    void measure(Part& part, Slot f)
    {
        const Triangle& t = m_model.faces[f];
        const Vec3 normal = drawnNormal(m_model, f);
        const std::uint8_t facing = facingOf(normal);
        m_scan.facing[f] = facing;
        const auto mark = static_cast<std::uint8_t>(facing | (~facing & sidesMask) << awayShift);
        const Vec3f direction = normal.cast<float>();
        const float length2 = direction.squaredNorm();
        for (const Slot v : t) {
            const DrawVertex& vertex = m_model.vertices[v];
            part.marks[v] = static_cast<std::uint8_t>(part.marks[v] | mark | (isSharp(vertex, direction, length2) ? sharpBit : 0));
            part.box.extend(vertex.position.cast<double>());
        }
        part.volume += m_model.vertices[t[0]].position.cast<double>().dot(normal);
    }

    void joinMeasures()
    {
        m_marks = std::move(m_parts[0].marks);
        std::ranges::transform(m_marks, m_parts[1].marks, m_marks.begin(), [](std::uint8_t one, std::uint8_t other) { return static_cast<std::uint8_t>(one | other); });
        m_scan.box = m_parts[0].box.merged(m_parts[1].box);
        m_scan.volume = (m_parts[0].volume + m_parts[1].volume) / 6;
    }

    bool mayBeLine(Slot a, Slot b) const
    {
        const auto both = static_cast<std::uint8_t>(m_marks[a] & m_marks[b]);
        return (both & both >> awayShift & sidesMask) != 0 || (m_scan.hasCreases && (both & sharpBit) != 0);
    }

    /// Creases are left out where they would be too many.
    bool collect(std::size_t mostEdges)
    {
        if (!eachPart([&](Part& part) { return collect(part, mostEdges); }))
            return false;
        auto& [one, other] = m_parts;
        m_halfEdges = std::move(one.halfEdges);
        m_halfEdges.insert(m_halfEdges.end(), other.halfEdges.begin(), other.halfEdges.end());
        if (m_scan.hasCreases && (one.isTooMuch || other.isTooMuch || m_halfEdges.size() / 2 > mostEdges)) {
            m_scan.hasCreases = false;
            return collect(mostEdges);
        }
        std::ranges::sort(m_halfEdges);
        return true;
    }

    bool collect(Part& part, std::size_t mostEdges)
    {
        part.halfEdges.clear();
        part.isTooMuch = false;
        return eachFace(part, [&](Slot f) {
            if (part.isTooMuch)
                return;
            const Triangle& t = m_model.faces[f];
            for (std::size_t i = 0; i < 3; ++i)
                if (const Slot a = t[i], b = t[(i + 1) % 3]; mayBeLine(a, b))
                    part.halfEdges.push_back({std::min(a, b), std::max(a, b), f});
            part.isTooMuch = m_scan.hasCreases && part.halfEdges.size() / 2 > mostEdges;
        });
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
    std::array<Part, 2> m_parts;
    std::vector<std::uint8_t> m_marks; ///< of all parts
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
