#include "core/io/mesh/ear_clipping.h"

#include "core/io/mesh/flat_polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>

namespace core::io
{
namespace
{
/// A grid of a polygon's corners in its projection, with about one corner a cell. A place is an index in the ring of
/// corners.
class RingGrid
{
public:
    RingGrid(const FlatPolygon& polygon, std::span<const Slot> ring) : m_polygon(polygon), m_ring(ring)
    {
        for (std::size_t k = 0; k < 2; ++k) {
            m_min[k] = std::numeric_limits<float>::max();
            float max = std::numeric_limits<float>::lowest();
            for (const Slot corner : ring) {
                m_min[k] = std::min(m_min[k], seen(corner, k));
                max = std::max(max, seen(corner, k));
            }
            m_size[k] = static_cast<double>(max) - static_cast<double>(m_min[k]);
        }
        m_side = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(ring.size()))));
        m_cells.resize(m_side * m_side);
        for (std::size_t i = 0; i < ring.size(); ++i)
            cellOf(i).push_back(static_cast<Slot>(i));
    }

    void remove(std::size_t place) { std::erase(cellOf(place), static_cast<Slot>(place)); }

    /// Returns whether `holds` is true for any place in the cells that overlap the box of these three corners.
    template <typename Holds> bool anyIn(const std::array<Slot, 3>& corners, Holds holds) const
    {
        std::array<std::size_t, 2> first, last;
        for (std::size_t k = 0; k < 2; ++k) {
            const auto [min, max] = std::minmax({seen(corners[0], k), seen(corners[1], k), seen(corners[2], k)});
            first[k] = step(min, k);
            last[k] = step(max, k);
        }
        for (std::size_t y = first[1]; y <= last[1]; ++y)
            for (std::size_t x = first[0]; x <= last[0]; ++x)
                if (std::ranges::any_of(m_cells[y * m_side + x], holds))
                    return true;
        return false;
    }

private:
    float seen(Slot corner, std::size_t k) const { return m_polygon.seen(corner, static_cast<int>(k)); }

    /// Returns the row or column of a coordinate. It never decreases as x grows, so that every corner in a box is in
    /// the box's cells.
    std::size_t step(float x, std::size_t k) const
    {
        const double part = m_size[k] > 0 ? (static_cast<double>(x) - static_cast<double>(m_min[k])) / m_size[k] : 0;
        return std::min(static_cast<std::size_t>(part * static_cast<double>(m_side)), m_side - 1);
    }

    std::vector<Slot>& cellOf(std::size_t place)
    {
        return m_cells[step(seen(m_ring[place], 1), 1) * m_side + step(seen(m_ring[place], 0), 0)];
    }

    const FlatPolygon& m_polygon;
    std::span<const Slot> m_ring;
    std::array<float, 2> m_min{};
    std::array<double, 2> m_size{};
    std::size_t m_side = 1;
    std::vector<std::vector<Slot>> m_cells;
};

class EarClipper
{
public:
    EarClipper(std::vector<Triangle>& triangles, const std::vector<Vec3f>& points, std::span<const Slot> ring)
        : m_triangles(triangles)
        , m_ring(ring)
        , m_polygon(points, ring)
        , m_grid(m_polygon, ring)
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

    /// Cuts ears until one triangle is left. A corner is tested again only after one of its neighbours was cut, or when
    /// no other corner is left to test. A simple polygon always has an ear. A polygon that crosses itself may have
    /// none; then any corner is cut.
    void clip(StopCheck& stopCheck)
    {
        enqueueAll();
        bool hasEars = true, hasCut = false;
        while (m_left > 3) {
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
            if (hasEars && !isEar(place))
                continue;
            cut(place);
            hasCut = true;
        }
        Slot place = m_next[m_last];
        std::array<Slot, 3> rest;
        for (Slot& corner : rest) {
            corner = m_ring[place];
            place = m_next[place];
        }
        m_triangles.push_back({rest[0], rest[1], rest[2]});
    }

private:
    static constexpr std::uint32_t gone = ~std::uint32_t(0);
    struct Waiting
    {
        Slot place;
        std::uint32_t turn; ///< m_turns[place] when it was enqueued; the entry is void if that has changed
    };

    void enqueue(Slot place) { m_waiting.push_back({place, ++m_turns[place]}); }
    void enqueueAll()
    {
        m_waiting.clear();
        Slot place = m_next[m_last];
        for (std::size_t i = 0; i < m_left; ++i, place = m_next[place])
            enqueue(place);
    }

    /// Returns whether the corner is convex and no other corner is in the triangle that it would cut off.
    bool isEar(Slot place) const
    {
        const Slot a = m_ring[m_previous[place]], b = m_ring[place], c = m_ring[m_next[place]];
        if (m_polygon.turn(a, b, c) <= 0)
            return false;
        return !m_grid.anyIn({a, b, c}, [&](Slot other) {
            const Slot p = m_ring[other];
            return p != a && p != b && p != c && m_polygon.turn(a, b, p) >= 0 && m_polygon.turn(b, c, p) >= 0 &&
                   m_polygon.turn(c, a, p) >= 0;
        });
    }

    /// Cuts the corner off and moves its neighbours to the end of the queue. Cutting them at once would make a fan of
    /// slivers.
    void cut(Slot place)
    {
        const Slot before = m_previous[place], behind = m_next[place];
        m_triangles.push_back({m_ring[before], m_ring[place], m_ring[behind]});
        m_grid.remove(place);
        m_turns[place] = gone;
        m_next[before] = behind;
        m_previous[behind] = before;
        m_last = behind;
        --m_left;
        enqueue(before);
        enqueue(behind);
    }

    std::vector<Triangle>& m_triangles;
    std::span<const Slot> m_ring;
    FlatPolygon m_polygon;
    RingGrid m_grid;
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
