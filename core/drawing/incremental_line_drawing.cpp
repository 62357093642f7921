#include "core/drawing/incremental_line_drawing.h"

#include <algorithm>
#include <iterator>

namespace core
{
namespace
{
/// Fraction of the model's longest side that the grid adds on each side, so that strokes may extend the model.
constexpr double boxMargin = 0.125;
/// Smallest fraction of the grid that the model must fill; below it a smaller grid is made.
constexpr double minRoomShare = 0.5;
constexpr std::size_t maxChanged = 4; ///< a full scan is faster if more than 1 / maxChanged of the faces change

std::vector<Slot> slotsOf(const std::vector<SlotSpan>& spans)
{
    std::vector<Slot> slots;
    for (const SlotSpan& span : spans)
        for (Slot i = 0; i < span.count; ++i)
            slots.push_back(span.first + i);
    return slots;
}

std::vector<Slot> united(const std::vector<Slot>& one, const std::vector<Slot>& other)
{
    std::vector<Slot> both;
    std::ranges::set_union(one, other, std::back_inserter(both));
    return both;
}

/// Returns the corners of those faces that exist, ascending.
std::vector<Slot> cornersOf(std::span<const Slot> faces, const DrawArrays& model)
{
    std::vector<Slot> corners;
    for (const Slot f : faces)
        if (f < model.faces.size() && !model.isFree(f))
            corners.insert(corners.end(), model.faces[f].begin(), model.faces[f].end());
    std::ranges::sort(corners);
    const auto rest = std::ranges::unique(corners);
    corners.erase(rest.begin(), rest.end());
    return corners;
}
} // namespace

void IncrementalLineDrawing::apply(const MeshPatch& patch)
{
    m_isNew =
        m_isNew || patch.whole || patch.faceSlots < m_model.faces.size() || patch.vertexSlots < m_model.vertices.size();
    DrawnChange change;
    if (!m_isNew)
        change.faces = united(slotsOf(patch.faceSpans), m_scan.facesAt(slotsOf(patch.vertexSpans), m_model));
    m_isNew = m_isNew || change.faces.size() > patch.faceSlots / maxChanged;
    if (m_isNew)
        return m_model.apply(patch);
    const std::vector<Slot> before = cornersOf(change.faces, m_model);
    expire(change.faces);
    m_model.apply(patch);
    change.vertices = united(before, cornersOf(change.faces, m_model));
    change.around = united(change.faces, m_scan.facesAt(change.vertices, m_model));
    std::erase_if(change.around, [this](Slot f) { return m_model.isFree(f); });
    m_isNew = !m_scan.rescan(m_model, change);
    expire(change.faces);
}

/// Marks the tiles under the faces as expired in the views in which they face the eye.
void IncrementalLineDrawing::expire(std::span<const Slot> faces)
{
    for (const Slot f : faces)
        if (const std::uint8_t facing = m_images && f < m_model.faces.size() ? m_scan.facing()[f] : 0; facing != 0)
            for (const DrawnSide side : drawnSides)
                if ((facing & 1 << static_cast<int>(side)) != 0)
                    (*m_images)[static_cast<std::size_t>(side)].expire(m_model, f);
}

std::optional<LineDrawing> IncrementalLineDrawing::draw(bool shaded, const std::stop_token& stop)
{
    if (m_isNew) {
        if (!m_scan.scan(m_model, stop))
            return std::nullopt;
        m_images.reset();
        m_isNew = false;
    }
    const Box box = m_scan.box();
    if (box.isEmpty())
        return LineDrawing();
    if (!m_room.contains(box) || box.sizes().maxCoeff() < minRoomShare * m_room.sizes().maxCoeff()) {
        const Vec3 around = Vec3::Constant(boxMargin * box.sizes().maxCoeff());
        m_room = Box(box.min() - around, box.max() + around);
        m_images.reset();
    }
    if (!m_images)
        m_images = depthImagesOf(m_room, static_cast<float>(m_room.sizes().maxCoeff() / m_pixels));
    return drawingOf(m_model, m_scan, *m_images, shaded, stop);
}
} // namespace core
