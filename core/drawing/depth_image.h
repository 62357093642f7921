#pragma once

#include "core/drawing/line_drawing.h"

#include <span>

namespace core
{
inline constexpr Slot facesPerBlock = 512;

/// The model from one side on a grid of pixels: how near the nearest face is, and which it is. Tiles of pixels can
/// expire; only those are drawn, at first all of them.
class DepthImage
{
public:
    /// The grid covers the box and two pixels more around it. `pixel`: mm.
    DepthImage(DrawnSide side, const Eigen::AlignedBox2f& box, float pixel);

    /// What stands where this face is, is to be drawn anew. Cost: the tiles under its box.
    void expire(const DrawArrays& model, Slot face);

    /// Draws the faces that look to the eye into the expired tiles, as far as they lie on the grid; false if it was
    /// stopped. `facing`: as FeatureScan has it. `blocks`: around each `facesPerBlock` faces, so that others need not
    /// be looked at; or none.
    bool draw(const DrawArrays& model, std::span<const std::uint8_t> facing, std::span<const Box> blocks,
              const std::stop_token& stop);

    /// In pixels from the grid's corner at the bottom left, and mm towards the eye.
    Vec3f toGrid(const Vec3f& point) const;
    /// Of the nearest face at a pixel's centre, mm towards the eye; minus infinity where there is none.
    float depth(int x, int y) const { return m_depth[index(x, y)]; }
    float pixel() const { return m_pixel; }

    int width() const { return m_width; }
    int height() const { return m_height; }
    struct Seen
    {
        Slot face;     ///< noSlot: nothing
        Vec3f weights; ///< of its corners, 0 to 1; about 1 together
    };
    /// The nearest face at a pixel's centre. The model is the one that was drawn.
    Seen seen(const DrawArrays& model, int x, int y) const;

    /// What was drawn since it was last asked for is shaded anew.
    const DrawnImage& shade(const DrawArrays& model);

private:
    enum Stale : std::uint8_t { Depths = 1, Colors = 2 };
    struct Tiles
    {
        int left, bottom, right, top; ///< the last ones belong to it
    };

    Tiles tilesOf(const Vec2f& low, const Vec2f& high) const;
    std::size_t tileIndex(int x, int y) const { return static_cast<std::size_t>(y * m_tilesAcross + x); }
    bool isStale(const Tiles& tiles) const;
    bool isStale(const Box& box) const;
    template <class Work> void eachStalePixel(Stale what, Work work) const;
    void settle(Stale what);
    void drawFaces(const DrawArrays& model, std::span<const std::uint8_t> facing, Slot first, Slot end);
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
    }
    void drawFace(Slot f, const Vec3f& a, const Vec3f& b, const Vec3f& c);
    std::array<std::uint8_t, 4> colorAt(const DrawArrays& model, const Seen& seen) const;

    DrawnSide m_side;
    Vec2f m_corner; ///< bottom left, mm
    float m_pixel, m_pixelsPerMm;
    int m_width, m_height;
    int m_tilesAcross;
    std::vector<float> m_depth;        ///< rows from the bottom
    std::vector<Slot> m_face;          ///< noSlot: background
    std::vector<std::uint8_t> m_stale; ///< by tile, rows from the bottom
    DrawnImage m_shaded;
};
} // namespace core
