#include "core/drawing/projected_views.h"

#include <algorithm>
#include <cmath>
#include <future>

namespace core
{
namespace
{
constexpr float slack = 1.5F; ///< pixels; tolerance for rounding in the depth image
/// Largest slope of a face, mm per mm; steeper faces are treated as having this slope.
constexpr float steepest = 6;
constexpr int maxPieces = 1 << 14; ///< largest number of pieces that an edge is divided into
constexpr Slot noEnd = noSlot;

/// A visible piece of an edge. `a` and `b` are the vertices at its ends, or noEnd where the piece was cut.
struct Piece
{
    Vec2f from, to;
    Slot a, b;
};

/// Finds the parts of edges that are visible from one side.
class Sight
{
public:
    Sight(const DrawArrays& model, const DepthImage& depths, DrawnSide side, std::span<const std::uint8_t> facing)
        : m_model(model)
        , m_depths(depths)
        , m_side(side)
        , m_facing(facing)
    {}

    void addPieces(const FeatureEdge& edge, std::vector<Piece>& pieces) const
    {
        const Vec3f &start = m_model.vertices[edge.a].position, &end = m_model.vertices[edge.b].position;
        const Vec3f a = m_depths.toGrid(start), b = m_depths.toGrid(end);
        const Vec2f from = onPaper(m_side, start).head<2>(), to = onPaper(m_side, end).head<2>();
        const Vec2f slope = slopeOf(edge);
        const int count = std::clamp(static_cast<int>(std::ceil((b - a).head<2>().norm())), 1, maxPieces);
        const auto share = [count](int i) { return static_cast<float>(i) / static_cast<float>(count); };
        for (int i = 0; i < count; ++i) {
            const int first = i;
            while (i < count &&
                   isSeen(a + (b - a) * ((static_cast<float>(i) + 0.5F) / static_cast<float>(count)), slope))
                ++i;
            if (i > first)
                pieces.push_back({from + (to - from) * share(first),
                                  i == count ? to : Vec2f(from + (to - from) * share(i)), first == 0 ? edge.a : noEnd,
                                  i == count ? edge.b : noEnd});
        }
    }

private:
    /// Returns the slope of the edge's face that faces the eye: mm towards the eye for each pixel. Of two such faces
    /// the steeper counts.
    Vec2f slopeOf(const FeatureEdge& edge) const
    {
        const int bit = 1 << static_cast<int>(m_side);
        Vec2f steeper = Vec2f::Zero();
        for (const Slot f : edge.faces) {
            if ((m_facing[f] & bit) == 0)
                continue;
            const Vec3f n = onPaper(m_side, drawnNormal(m_model, f).normalized().cast<float>());
            const Vec2f slope = -n.head<2>() / std::max(n.z(), 1 / steepest);
            if (slope.squaredNorm() > steeper.squaredNorm())
                steeper = slope;
        }
        return steeper * m_depths.pixel();
    }

    /// Returns whether a point of an edge is visible. One of the 3 x 3 pixels around it must not be covered by anything
    /// nearer than the edge's own face extended to that pixel. At an outline this is a pixel beyond the outline.
    bool isSeen(const Vec3f& at, const Vec2f& slope) const
    {
        const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const Vec2f off(static_cast<float>(x + dx) + 0.5F - at.x(), static_cast<float>(y + dy) + 0.5F - at.y());
                const float ownFace = std::max(0.0F, slope.dot(off));
                if (m_depths.depth(x + dx, y + dy) <= at.z() + ownFace + slack * m_depths.pixel())
                    return true;
            }
        return false;
    }

    const DrawArrays& m_model;
    const DepthImage& m_depths;
    DrawnSide m_side;
    std::span<const std::uint8_t> m_facing;
};

/// Joins pieces end to end into few lines, greedily.
class Chainer
{
public:
    explicit Chainer(std::span<const Piece> pieces) : m_pieces(pieces), m_isUsed(pieces.size(), false)
    {
        for (std::size_t i = 0; i < pieces.size(); ++i)
            for (const Slot v : {pieces[i].a, pieces[i].b})
                if (v != noEnd)
                    m_ends.emplace_back(v, i);
        std::ranges::sort(m_ends);
    }

    std::vector<DrawnLine> run()
    {
        std::vector<DrawnLine> lines;
        for (std::size_t i = 0; i < m_pieces.size(); ++i) {
            if (m_isUsed[i])
                continue;
            m_isUsed[i] = true;
            const Piece& piece = m_pieces[i];
            DrawnLine line{piece.to, piece.from};
            extend(line, piece.a);
            std::ranges::reverse(line);
            extend(line, piece.b);
            lines.push_back(std::move(line));
        }
        return lines;
    }

private:
    void extend(DrawnLine& line, Slot end)
    {
        while (end != noEnd) {
            auto next = std::ranges::lower_bound(m_ends, std::pair(end, std::size_t(0)));
            while (next != m_ends.end() && next->first == end && m_isUsed[next->second])
                ++next;
            if (next == m_ends.end() || next->first != end)
                return;
            const Piece& piece = m_pieces[next->second];
            m_isUsed[next->second] = true;
            const bool isForward = piece.a == end;
            line.push_back(isForward ? piece.to : piece.from);
            end = isForward ? piece.b : piece.a;
        }
    }

    std::span<const Piece> m_pieces;
    std::vector<bool> m_isUsed;
    std::vector<std::pair<Slot, std::size_t>> m_ends; ///< vertex, and index of a piece that ends there
};

Eigen::AlignedBox2f boxOnPaper(DrawnSide side, const Box& box)
{
    const Vec3f one = onPaper(side, box.min().cast<float>()), other = onPaper(side, box.max().cast<float>());
    Eigen::AlignedBox2f result(Vec2f(one.head<2>()));
    result.extend(Vec2f(other.head<2>()));
    return result;
}

std::optional<DrawnView> viewOf(const DrawArrays& model, const FeatureScan& scan, DrawnSide side, DepthImage& depths,
                                bool isShaded, const std::stop_token& stop)
{
    if (!depths.draw(model, scan.facing(), scan.blocks(), stop))
        return std::nullopt;
    DrawnView view;
    view.box = boxOnPaper(side, scan.box());
    const Sight sight(model, depths, side, scan.facing());
    const int bit = 1 << static_cast<int>(side);
    std::vector<Piece> outlines, creases;
    for (const FeatureEdge& edge : scan.edges()) {
        if (stop.stop_requested())
            return std::nullopt;
        const bool isTowardsEye = ((scan.facing()[edge.faces[0]] | scan.facing()[edge.faces[1]]) & bit) != 0;
        if ((edge.outlineIn & bit) != 0)
            sight.addPieces(edge, outlines);
        else if (edge.isCrease && isTowardsEye)
            sight.addPieces(edge, creases);
    }
    view.outlines = Chainer(outlines).run();
    view.creases = Chainer(creases).run();
    if (isShaded)
        view.shaded = depths.shade(model);
    return view;
}
} // namespace

DepthImages depthImagesOf(const Box& box, float pixel)
{
    const auto image = [&](DrawnSide side) { return DepthImage(side, boxOnPaper(side, box), pixel); };
    return {image(DrawnSide::Front), image(DrawnSide::Right), image(DrawnSide::Top)};
}

std::optional<LineDrawing> drawingOf(const DrawArrays& model, const FeatureScan& scan, DepthImages& images, bool shaded,
                                     const std::stop_token& stop)
{
    LineDrawing drawing;
    drawing.box = scan.box();
    drawing.volume = scan.volume();
    drawing.hasCreases = scan.hasCreases();
    drawing.pixel = images[0].pixel();
    std::array<std::future<std::optional<DrawnView>>, drawnSides.size()> views;
    for (std::size_t i = 0; i < views.size(); ++i)
        views[i] = std::async(std::launch::async,
                              [&, i] { return viewOf(model, scan, drawnSides[i], images[i], shaded, stop); });
    bool isWhole = true;
    for (std::size_t i = 0; i < views.size(); ++i)
        if (auto view = views[i].get())
            drawing.views[i] = *std::move(view);
        else
            isWhole = false;
    if (!isWhole)
        return std::nullopt;
    return drawing;
}
} // namespace core
