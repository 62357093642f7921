#include "core/boolean/solid_parts.h"

#include "core/analysis/shell_orientation.h"
#include "core/geometry/face_geometry.h"
#include "core/util/disjoint_sets.h"
#include "core/util/parallel.h"

#include <map>
#include <memory>

namespace core::boolean
{
namespace
{
/// Answers whether points are inside a solid. Precondition: they are not on its surface.
class PointInSolid
{
public:
    PointInSolid(const SolidSoup& soup, std::size_t solid)
        : m_soup(soup)
        , m_box(soup.boxes[solid])
        , m_first(soup.firstFaces[solid])
        , m_count(soup.firstFaces[solid + 1] - m_first)
    {}

    bool holds(const LatticePoint& p)
    {
        constexpr std::size_t fewQuestions = 8; // a tree costs about as much as this number of passes
        if (!m_box.meets({p, p}))
            return false;
        if (!m_tree && ++m_questions > fewQuestions) {
            const auto faces = std::span<const Triangle>(m_soup.surface.triangles).subspan(m_first, m_count);
            m_tree = std::make_unique<BoxTree>(faceBoxes(m_soup.surface.points, faces));
        }
        return m_tree ? byTree(p) : byPass(p);
    }

private:
    bool byPass(const LatticePoint& p) const
    {
        const LatticeBox column = ShellOrientation(p).column();
        const std::vector<bool> parities = joinChunks<std::vector<bool>>(
            m_count, facesPerChunk, [&](std::size_t begin, std::size_t end, std::vector<bool>& parity) {
                ShellOrientation probe(p);
                for (auto f = static_cast<Slot>(m_first + begin); f < m_first + end; ++f)
                    if (m_soup.boxOf(f).meets(column))
                        probe.castAt(m_soup.cornersOf(f));
                parity.push_back(probe.isInside());
            });
        return std::ranges::count(parities, true) % 2 == 1;
    }

    bool byTree(const LatticePoint& p) const
    {
        ShellOrientation probe(p);
        const LatticeBox column = probe.column();
        m_tree->forEachMeeting(floatBox(column),
                               [&](Slot position) { probe.castAt(m_soup.cornersOf(m_first + m_tree->at(position))); });
        return probe.isInside();
    }

    const SolidSoup& m_soup;
    LatticeBox m_box;
    Slot m_first, m_count; ///< range of its faces
    std::unique_ptr<BoxTree> m_tree;
    std::size_t m_questions = 0;
};
} // namespace

std::vector<Fate> fatesOf(const SolidSoup& soup, std::span<const Slot> crossing)
{
    std::vector<Fate> fates(soup.surface.triangles.size(), Fate::Dropped);
    for (const Slot f : crossing)
        fates[f] = Fate::Cut;
    DisjointSets parts(soup.surface.points.size());
    for (Slot f = 0; f < fates.size(); ++f) {
        if (fates[f] == Fate::Cut)
            continue;
        const auto& [a, b, c] = soup.surface.triangles[f];
        parts.unite(a, b);
        parts.unite(a, c);
    }
    std::vector<PointInSolid> solids;
    for (std::size_t s = 0; s < soup.solids(); ++s)
        solids.emplace_back(soup, s);
    std::map<Slot, Fate> ofPart; ///< for each part, by its first point
    for (std::size_t s = 0; s < soup.solids(); ++s)
        for (Slot f = soup.firstFaces[s]; f < soup.firstFaces[s + 1]; ++f) {
            if (fates[f] == Fate::Cut)
                continue;
            const auto [part, isNew] = ofPart.try_emplace(parts.root(soup.surface.triangles[f][0]), Fate::Dropped);
            if (isNew) {
                int before = std::min(0, soup.windingOf(s)); // winding number in front of the part
                for (std::size_t other = 0; other < soup.solids(); ++other)
                    if (other != s && solids[other].holds(soup.surface.points[part->first]))
                        before += soup.windingOf(other);
                if (before + 1 == soup.least)
                    part->second = Fate::Kept;
            }
            fates[f] = part->second;
        }
    return fates;
}
} // namespace core::boolean
