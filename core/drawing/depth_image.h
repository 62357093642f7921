#pragma once

#include "core/drawing/line_drawing.h"

#include <span>

namespace core
{
inline constexpr Slot facesPerBlock = 512;

/// A depth image of the model from one side: for each pixel the depth of the nearest face, and its slot. The grid is
/// divided into tiles of pixels. draw() updates only expired tiles; initially all are expired.
class DepthImage
{
public:
    /// Makes a grid that covers the box and two more pixels on each side. `pixel`: size of a pixel, mm.
    DepthImage(DrawnSide side, const Eigen::AlignedBox2f& box, float pixel);

    /// Marks the tiles under the face's box as expired, so that draw() updates them.
    void expire(const DrawArrays& model, Slot face);

    /// Draws the faces that face the eye into the expired tiles. Parts outside the grid are ignored. `facing`: see
    /// FeatureScan::facing(). `blocks`: bounding boxes of every `facesPerBlock` faces, used to skip blocks; may be
    /// empty. Returns false if it was stopped.
    bool draw(const DrawArrays& model, std::span<const std::uint8_t> facing, std::span<const Box> blocks,
              const std::stop_token& stop);

    /// Converts a point to grid coordinates: x and y in pixels from the bottom left corner of the grid, z in mm towards
    /// the eye.
    Vec3f toGrid(const Vec3f& point) const;
    /// Returns the depth of the nearest face at the pixel's centre, in mm towards the eye; minus infinity if there is
    /// no face.
    float depth(int x, int y) const { return m_depth[index(x, y)]; }
    float pixel() const { return m_pixel; }

    int width() const { return m_width; }
    int height() const { return m_height; }
    struct Seen
    {
        Slot face;     ///< the nearest face; noSlot: none
        Vec3f weights; ///< barycentric weights of its corners, 0 to 1; their sum is about 1
    };
    /// Returns the nearest face at the pixel's centre. Precondition: `model` is the model of the last draw().
    Seen seen(const DrawArrays& model, int x, int y) const;

    /// Shades the pixels that were drawn since the last call, and returns the image.
    const DrawnImage& shade(const DrawArrays& model);

private:
    enum Stale : std::uint8_t { Depths = 1, Colors = 2 };
    struct Tiles
    {
        int left, bottom, right, top; ///< tile indices, including right and top
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
    Vec2f m_corner; ///< bottom left corner of the grid, mm
    float m_pixel, m_pixelsPerMm;
    int m_width, m_height;
    int m_tilesAcross;
    std::vector<float> m_depth;        ///< mm towards the eye, rows from the bottom
    std::vector<Slot> m_face;          ///< slot of the nearest face; noSlot: background
    std::vector<std::uint8_t> m_stale; ///< Stale flags of each tile, rows from the bottom
    DrawnImage m_shaded;
};
} // namespace core
