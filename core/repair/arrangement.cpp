// 1. cut    each face that meets others, on all cores
// 2. join   the points of all faces: they are exact, so equal points have equal numbers in every face

#include "core/repair/arrangement.h"

#include "core/repair/face_cutter.h"

#include "core/util/parallel_progress.h"

#include <algorithm>

namespace core::repair
{
namespace
{
/// Returns for each face the faces that it meets, ascending; empty for most.
std::vector<std::vector<Slot>> partners(std::size_t faces, std::span<const FacePair> pairs)
{
    std::vector<std::vector<Slot>> result(faces);
    for (const auto& [first, second] : pairs) {
        result[first].push_back(second);
        result[second].push_back(first);
    }
    for (std::vector<Slot>& others : result)
        std::ranges::sort(others);
    return result;
}

/// Collects the pieces of all faces, and gives each exact point one index in the arrangement.
class Joiner
{
public:
    explicit Joiner(const TriangleSoup& surface) : m_surface(surface)
    {
        m_result.points = surface.places();
        m_result.colors = surface.colors;
        m_result.upon.resize(surface.triangles.size());
    }

    void addOwnPoints(Slot face)
    {
        for (const Slot v : m_surface.triangles[face]) {
            const Slot exact = m_points.add(ExactPoint(m_surface.points[v]));
            m_slots.resize(m_points.size(), noSlot);
            m_slots[exact] = v;
        }
    }
    void addFace(Slot face) { m_result.faces.push_back({m_surface.triangles[face], face, 1}); }
    void addPieces(Slot face, const FacePieces& cut)
    {
        std::vector<Slot> slots;
        for (Slot i = 0; i < cut.points.size(); ++i)
            slots.push_back(slotOf(cut.points[i], face));
        for (const auto& [corners, jump] : cut.pieces)
            m_result.faces.push_back({{slots[corners[0]], slots[corners[1]], slots[corners[2]]}, face, jump});
        m_result.upon[face] = cut.upon;
    }

    Arrangement take() { return std::move(m_result); }

private:
    Slot slotOf(const ExactPoint& point, Slot face)
    {
        const Slot exact = m_points.add(point);
        m_slots.resize(m_points.size(), noSlot);
        Slot& slot = m_slots[exact];
        if (slot == noSlot) {
            slot = static_cast<Slot>(m_result.points.size());
            m_result.points.push_back(point.approx);
            if (!m_result.colors.empty())
                m_result.colors.push_back(colorIn(face, point.approx));
        }
        return slot;
    }

    Rgb colorIn(Slot face, const Vec3& p) const
    {
        const Triangle& t = m_surface.triangles[face];
        std::array<Vec3, 3> toCorner;
        for (std::size_t i = 0; i < 3; ++i)
            toCorner[i] = m_surface.points[t[i]].cast<double>() - p;
        Vec3 sum = Vec3::Zero();
        double total = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double weight = toCorner[(i + 1) % 3].cross(toCorner[(i + 2) % 3]).norm();
            const Rgb c = m_surface.colors[t[i]];
            sum += weight * Vec3(c.r, c.g, c.b);
            total += weight;
        }
        const auto channel = [&](int i) { return static_cast<std::uint8_t>(sum[i] / total + 0.5); };
        return {channel(0), channel(1), channel(2)};
    }

    const TriangleSoup& m_surface;
    ExactPoints m_points;
    std::vector<Slot> m_slots; ///< index in the arrangement of each point of m_points
    Arrangement m_result;
};
} // namespace

Arrangement arrange(const TriangleSoup& surface, std::span<const FacePair> pairs, const JobControl& control)
{
    const std::vector<std::vector<Slot>> others = partners(surface.triangles.size(), pairs);
    std::vector<Slot> met;
    for (Slot f = 0; f < others.size(); ++f)
        if (!others[f].empty())
            met.push_back(f);

    constexpr std::size_t facesPerChunk = 16;
    std::vector<FacePieces> cut(met.size());
    forEachChunkWithProgress(met.size(), facesPerChunk, control, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && !control.isCancelled(); ++i)
            cut[i] = cutFace(surface, met[i], others[met[i]]);
    });
    Joiner joiner(surface);
    for (const Slot f : met)
        joiner.addOwnPoints(f);
    for (Slot f = 0; f < others.size(); ++f)
        if (others[f].empty())
            joiner.addFace(f);
    for (std::size_t i = 0; i < met.size(); ++i)
        joiner.addPieces(met[i], cut[i]);
    return joiner.take();
}
} // namespace core::repair
