#include "core/io/mesh/ear_clipping.h"

#include "core/io/mesh/flat_polygon.h"

#include <algorithm>
#include <array>
#include <deque>
#include <numeric>

namespace core::io
{
namespace
{
/// A tree over the corners of a polygon in its projection. Each node has the corners in a box; its children halve them
/// along one axis, then the other. A place is an index in the ring of corners.
class RingTree
{
public:
    RingTree(const FlatPolygon& polygon, std::span<const Slot> ring)
        : m_polygon(polygon)
        , m_ring(ring)
        , m_order(ring.size())
        , m_leafOf(ring.size())
    {
        std::iota(m_order.begin(), m_order.end(), Slot(0));
        m_nodes.resize(1);
        build(0, 0, static_cast<Slot>(ring.size()), 0);
    }

    void remove(Slot place)
    {
        const auto [first, last] = m_nodes[m_leafOf[place]].places;
        const auto at = std::find(m_order.begin() + first, m_order.begin() + last, place);
        std::iter_swap(at, m_order.begin() + --m_nodes[m_leafOf[place]].places.second);
        for (Slot node = m_leafOf[place]; node != noSlot; node = m_nodes[node].parent)
            --m_nodes[node].count;
    }

    /// Returns whether `holds` is true for any place in the anticlockwise triangle of these corners, or near it.
    template <typename Holds> bool anyIn(const std::array<Slot, 3>& corners, Holds holds, Slot node = 0) const
    {
        const Node& n = m_nodes[node];
        if (n.child == noSlot)
            return std::any_of(m_order.begin() + n.places.first, m_order.begin() + n.places.second, holds);
        if (n.count == 0 || isApart(n, corners))
            return false;
        return anyIn(corners, holds, n.child) || anyIn(corners, holds, n.child + 1);
    }

private:
    static constexpr Slot leafSize = 8;
    struct Node
    {
        std::array<float, 2> min{}, max{};
        Slot parent = noSlot, child = noSlot; ///< the second child follows the first; noSlot: a leaf
        Slot count = 0;                       ///< number of places that are left
        std::pair<Slot, Slot> places{};       ///< range of a leaf in m_order
    };

    auto isLess(int axis) const
    {
        return [this, axis](Slot a, Slot b) { return seen(a, axis) < seen(b, axis); };
    }

    void build(Slot node, Slot first, Slot last, int axis)
    {
        const auto begin = m_order.begin() + first, end = m_order.begin() + last;
        m_nodes[node].count = last - first;
        for (const int k : {0, 1}) {
            const auto [min, max] = std::minmax_element(begin, end, isLess(k));
            m_nodes[node].min[static_cast<std::size_t>(k)] = seen(*min, k);
            m_nodes[node].max[static_cast<std::size_t>(k)] = seen(*max, k);
        }
        if (last - first <= leafSize) {
            m_nodes[node].places = {first, last};
            std::for_each(begin, end, [&](Slot place) { m_leafOf[place] = node; });
            return;
        }
        const Slot middle = first + (last - first) / 2, child = static_cast<Slot>(m_nodes.size());
        std::nth_element(begin, m_order.begin() + middle, end, isLess(axis));
        m_nodes[node].child = child;
        m_nodes.resize(m_nodes.size() + 2);
        m_nodes[child].parent = m_nodes[child + 1].parent = node;
        build(child, first, middle, 1 - axis);
        build(child + 1, middle, last, 1 - axis);
    }

    float seen(Slot place, int axis) const { return m_polygon.seen(m_ring[place], axis); }

    /// Returns whether the whole box is strictly outside the triangle. Exact, so no corner is missed.
    bool isApart(const Node& n, const std::array<Slot, 3>& corners) const
    {
        for (std::size_t i = 0; i < 3; ++i)
            if (m_polygon.isRightOf(corners[i], corners[(i + 1) % 3], n.min, n.max))
                return true;
        for (std::size_t k = 0; k < 2; ++k) {
            const auto at = [&](std::size_t i) { return m_polygon.seen(corners[i], static_cast<int>(k)); };
            if (std::max({at(0), at(1), at(2)}) < n.min[k] || std::min({at(0), at(1), at(2)}) > n.max[k])
                return true;
        }
        return false;
    }

    const FlatPolygon& m_polygon;
    std::span<const Slot> m_ring;
    std::vector<Slot> m_order;  ///< all places; those of a node follow each other
    std::vector<Slot> m_leafOf; ///< the leaf of each place
    std::vector<Node> m_nodes;
};

class EarClipper
{
public:
    EarClipper(std::vector<Triangle>& triangles, const std::vector<Vec3f>& points, std::span<const Slot> ring)
        : m_triangles(triangles)
        , m_ring(ring)
        , m_polygon(points, ring)
        , m_tree(m_polygon, ring)
        , m_next(ring.size())
        , m_previous(ring.size())
        , m_turns(ring.size(), 0)
        , m_left(ring.size())
    {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            m_next[i] = static_cast<Slot>((i + 1) % ring.size());
            m_previous[i] = static_cast<Slot>((i + ring.size() - 1) % ring.size());
        }
    }

    /// Cuts ears until nothing is left. A corner is tested again only after one of its neighbours was cut, or when no
    /// other corner is left to test. A polygon that touches itself only at corners and along edges always has an ear. A
    /// polygon that crosses itself may have none; then any corner is cut.
    void clip(StopCheck& stopCheck)
    {
        enqueueAll();
        bool hasEars = true, hasCut = false;
        while (m_left >= 3) {
            if (m_waiting.empty()) {
                hasEars = hasCut;
                hasCut = false;
                enqueueAll();
            }
            const auto [place, turn] = m_waiting.front();
            m_waiting.pop_front();
            if (turn != m_turns[place])
                continue;
            stopCheck(16);
            if (hasEars && !isTip(place) && !isEar(place))
                continue;
            cut(place);
            hasCut = true;
        }
    }

private:
    static constexpr std::uint32_t gone = ~std::uint32_t(0);
    struct Waiting
    {
        Slot place;
        std::uint32_t turn; ///< m_turns[place] when it was enqueued; the entry is void if that has changed
    };

    /// Puts tips to the front, because the sides of a slit look like the inside of the polygon to other corners.
    void enqueue(Slot place)
    {
        const Waiting waiting{place, ++m_turns[place]};
        if (isTip(place))
            m_waiting.push_front(waiting);
        else
            m_waiting.push_back(waiting);
    }
    void enqueueAll()
    {
        m_waiting.clear();
        Slot place = m_next[m_last];
        for (std::size_t i = 0; i < m_left; ++i, place = m_next[place])
            enqueue(place);
    }

    Slot before(Slot place) const { return m_ring[m_previous[place]]; }
    Slot behind(Slot place) const { return m_ring[m_next[place]]; }

    /// Returns whether the corner is the tip of a slit: the ring goes straight back from it.
    bool isTip(Slot place) const
    {
        const Slot a = before(place), b = m_ring[place], c = behind(place);
        return m_polygon.turn(a, b, c) == 0 && !m_polygon.isBetween(a, b, c);
    }

    /// Returns whether the corner is convex and nothing is in the triangle that it would cut off.
    bool isEar(Slot place) const
    {
        const Slot a = before(place), b = m_ring[place], c = behind(place);
        return m_polygon.turn(a, b, c) > 0 &&
               !m_tree.anyIn({a, b, c}, [&](Slot other) { return isIn(other, a, b, c); });
    }

    /// Returns whether a corner, or a side of the polygon at the corner, is in the triangle abc. A polygon whose holes
    /// are joined to its outline has several corners at one point; these are in the triangle's corner, but their sides
    /// may lead through the triangle.
    bool isIn(Slot place, Slot a, Slot b, Slot c) const
    {
        const Slot p = m_ring[place];
        const int ab = m_polygon.turn(a, b, p);
        const int bc = ab < 0 ? ab : m_polygon.turn(b, c, p), ca = bc < 0 ? bc : m_polygon.turn(c, a, p);
        if (ca < 0)
            return false;
        const auto leadsInto = [&](Slot q) {
            return (ab > 0 || m_polygon.turn(a, b, q) > 0) && (bc > 0 || m_polygon.turn(b, c, q) > 0) &&
                   (ca > 0 || m_polygon.turn(c, a, q) > 0);
        };
        const bool isOnCut = ca == 0 && ab > 0 && bc > 0;
        return isOnCut || leadsInto(before(place)) || leadsInto(behind(place));
    }

    /// Cuts the corner off and moves its neighbours to the end of the queue. Cutting them at once would make a fan of
    /// slivers. The tip of a slit gives no triangle, unless the slit's sides are divided differently.
    void cut(Slot place)
    {
        Slot previous = m_previous[place], next = m_next[place];
        if (m_polygon.areSame(m_ring[previous], m_ring[next]))
            next = remove(next);
        else
            m_triangles.push_back({m_ring[previous], m_ring[place], m_ring[next]});
        remove(place);
        m_last = next;
        enqueue(previous);
        enqueue(next);
    }

    /// Removes the place from the ring. Returns the next one.
    Slot remove(Slot place)
    {
        const Slot previous = m_previous[place], next = m_next[place];
        m_tree.remove(place);
        m_turns[place] = gone;
        m_next[previous] = next;
        m_previous[next] = previous;
        --m_left;
        return next;
    }

    std::vector<Triangle>& m_triangles;
    std::span<const Slot> m_ring;
    FlatPolygon m_polygon;
    RingTree m_tree;
    std::vector<Slot> m_next, m_previous; ///< neighbours of each place among the remaining places
    std::vector<std::uint32_t> m_turns;   ///< number of times that each place was enqueued; `gone` if it was cut
    std::deque<Waiting> m_waiting;
    std::size_t m_left;
    Slot m_last = 0; ///< any remaining place
};
} // namespace

void clipEars(std::vector<Triangle>& triangles, const std::vector<Vec3f>& points, std::span<const Slot> corners,
              StopCheck& stopCheck)
{
    EarClipper(triangles, points, corners).clip(stopCheck);
}
} // namespace core::io
