#pragma once

#include "line_drawing.h"

#include <span>

namespace core
{
/// The model from one side on a grid of pixels: how near the nearest face is, and which it is.
class DepthImage
{
public:
    /// The grid covers the box and two pixels more around it. `pixel`: mm.
    DepthImage(DrawnSide side, const Eigen::AlignedBox2f& box, float pixel);

    /// Draws the faces that look to the eye; false if it was stopped. `facing`: as DrawingScan has it.
    bool draw(const DrawArrays& model, std::span<const std::uint8_t> facing, const std::stop_token& stop);

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

    DrawnImage shade(const DrawArrays& model) const;

private:
    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x); }
    void drawFace(Slot f, const Triangle& corners);
    std::array<std::uint8_t, 4> colorAt(const DrawArrays& model, const Seen& seen) const;

    DrawnSide m_side;
    Vec2f m_corner; ///< bottom left, mm
    float m_pixel, m_pixelsAMm;
    int m_width, m_height;
    std::vector<Vec3f> m_points; ///< by vertex slot, as toGrid() has them
    std::vector<float> m_depth; ///< rows from the bottom
    std::vector<Slot> m_face;   ///< noSlot: background
};
} // namespace core
