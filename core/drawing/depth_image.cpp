#include "core/drawing/depth_image.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
constexpr int margin = 2;                         ///< pixels around the box on each side
constexpr Slot facesPerStep = facesPerBlock << 6; ///< faces drawn between two checks of `stop`
constexpr int tilePixels = 16;

float crossOf(const Vec2f& a, const Vec2f& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// Returns the first pixel whose centre is at or above a coordinate; lastCentre() returns the last one whose centre is
/// at or below it. Precondition: the coordinate is not negative. Avoids ceil() and floor() because it is called for
/// every face.
int firstCentre(float at)
{
    const int pixel = static_cast<int>(at);
    return at > static_cast<float>(pixel) + 0.5F ? pixel + 1 : pixel;
}
int lastCentre(float at)
{
    const int pixel = static_cast<int>(at);
    return at < static_cast<float>(pixel) + 0.5F ? pixel - 1 : pixel;
}

/// Returns the barycentric weights of the corners a, b, c at a point; their sum is 1.
Vec3f weightsAt(const Vec2f& at, const Vec2f& a, const Vec2f& b, const Vec2f& c)
{
    const float area = crossOf(b - a, c - a), toB = crossOf(c - b, at - b) / area, toC = crossOf(a - c, at - c) / area;
    return {toB, toC, 1 - toB - toC};
}
} // namespace

DepthImage::DepthImage(DrawnSide side, const Eigen::AlignedBox2f& box, float pixel)
    : m_side(side)
    , m_corner(box.min() - Vec2f::Constant(margin * pixel))
    , m_pixel(pixel)
    , m_pixelsPerMm(1 / pixel)
    , m_width(static_cast<int>(std::ceil(box.sizes().x() / pixel)) + 2 * margin + 1)
    , m_height(static_cast<int>(std::ceil(box.sizes().y() / pixel)) + 2 * margin + 1)
    , m_tilesAcross(m_width / tilePixels + 1)
    , m_depth(static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height))
    , m_face(m_depth.size())
    , m_stale(static_cast<std::size_t>(m_tilesAcross) * static_cast<std::size_t>(m_height / tilePixels + 1),
              Depths | Colors)
    , m_shaded{m_width, m_height, {m_corner.x(), m_corner.y() + static_cast<float>(m_height) * m_pixel}, m_pixel, {}}
{}

Vec3f DepthImage::toGrid(const Vec3f& point) const
{
    const Vec3f p = onPaper(m_side, point);
    return {(p.x() - m_corner.x()) * m_pixelsPerMm, (p.y() - m_corner.y()) * m_pixelsPerMm, p.z()};
}

/// Returns the tiles between two corners, limited to the grid.
DepthImage::Tiles DepthImage::tilesOf(const Vec2f& low, const Vec2f& high) const
{
    const auto tile = [](float at, int pixels) {
        return static_cast<int>(std::clamp(at, 0.0F, static_cast<float>(pixels - 1))) / tilePixels;
    };
    return {tile(low.x(), m_width), tile(low.y(), m_height), tile(high.x(), m_width), tile(high.y(), m_height)};
}

void DepthImage::expire(const DrawArrays& model, Slot face)
{
    const auto corner = [&](std::size_t i) { return toGrid(model.vertices[model.faces[face][i]].position); };
    const Vec3f a = corner(0), b = corner(1), c = corner(2);
    const Tiles tiles = tilesOf(a.cwiseMin(b).cwiseMin(c).head<2>(), a.cwiseMax(b).cwiseMax(c).head<2>());
    for (int y = tiles.bottom; y <= tiles.top; ++y)
        for (int x = tiles.left; x <= tiles.right; ++x)
            m_stale[tileIndex(x, y)] = Depths | Colors;
}

bool DepthImage::isStale(const Tiles& tiles) const
{
    for (int y = tiles.bottom; y <= tiles.top; ++y)
        for (int x = tiles.left; x <= tiles.right; ++x)
            if ((m_stale[tileIndex(x, y)] & Depths) != 0)
                return true;
    return false;
}

bool DepthImage::isStale(const Box& box) const
{
    if (box.isEmpty())
        return false;
    const Vec3f one = toGrid(box.min().cast<float>()), other = toGrid(box.max().cast<float>());
    return isStale(tilesOf(one.cwiseMin(other).head<2>(), one.cwiseMax(other).head<2>()));
}

template <class Work> void DepthImage::eachStalePixel(Stale what, Work work) const
{
    for (int y = 0; y < m_height; ++y)
        for (int tile = 0; tile < m_tilesAcross; ++tile)
            if ((m_stale[tileIndex(tile, y / tilePixels)] & what) != 0)
                for (int x = tile * tilePixels, end = std::min(m_width, x + tilePixels); x < end; ++x)
                    work(x, y);
}

void DepthImage::settle(Stale what)
{
    for (std::uint8_t& tile : m_stale)
        tile = static_cast<std::uint8_t>(tile & ~what);
}

/// Draws whole faces, also into tiles that have not expired. This is harmless: a face that is drawn again does not
/// change a pixel.
bool DepthImage::draw(const DrawArrays& model, std::span<const std::uint8_t> facing, std::span<const Box> blocks,
                      const std::stop_token& stop)
{
    eachStalePixel(Depths, [this](int x, int y) {
        m_depth[index(x, y)] = -std::numeric_limits<float>::infinity();
        m_face[index(x, y)] = noSlot;
    });
    const auto faces = static_cast<Slot>(facing.size());
    for (Slot first = 0; first < faces; first += facesPerBlock) {
        if (first % facesPerStep == 0 && stop.stop_requested())
            return false;
        if (blocks.empty() || isStale(blocks[first / facesPerBlock]))
            drawFaces(model, facing, first, std::min(faces, first + facesPerBlock));
    }
    settle(Depths);
    return true;
}

void DepthImage::drawFaces(const DrawArrays& model, std::span<const std::uint8_t> facing, Slot first, Slot end)
{
    const int bit = 1 << static_cast<int>(m_side);
    const auto at = [&](Slot v) { return toGrid(model.vertices[v].position); };
    for (Slot f = first; f < end; ++f)
        if ((facing[f] & bit) != 0)
            drawFace(f, at(model.faces[f][0]), at(model.faces[f][1]), at(model.faces[f][2]));
}

/// Draws the face at pixel centres, row by row between its edges. A sliver therefore costs its pixels and not those of
/// its box.
void DepthImage::drawFace(Slot f, const Vec3f& a, const Vec3f& b, const Vec3f& c)
{
    const auto inGrid = [](float at, int pixels) { return std::clamp(at, 0.0F, static_cast<float>(pixels)); };
    const float lowY = inGrid(std::min({a.y(), b.y(), c.y()}), m_height),
                highY = inGrid(std::max({a.y(), b.y(), c.y()}), m_height);
    const int bottom = firstCentre(lowY), top = lastCentre(highY);
    if (bottom > top)
        return;
    const float lowX = inGrid(std::min({a.x(), b.x(), c.x()}), m_width),
                highX = inGrid(std::max({a.x(), b.x(), c.x()}), m_width);
    const int left = firstCentre(lowX), right = lastCentre(highX);
    if (left > right || !isStale({left / tilePixels, bottom / tilePixels, right / tilePixels, top / tilePixels}))
        return;
    const Vec2f ab = (b - a).head<2>(), ac = (c - a).head<2>();
    const float area = crossOf(ab, ac);
    if (!(area > 0))
        return;
    const float slopeX = ((b.z() - a.z()) * ac.y() - (c.z() - a.z()) * ab.y()) / area;
    const float slopeY = ((c.z() - a.z()) * ab.x() - (b.z() - a.z()) * ac.x()) / area;
    const float highZ = std::max({a.z(), b.z(), c.z()});
    const std::array<const Vec3f*, 3> corners{&a, &b, &c};
    for (int y = bottom; y <= top; ++y) {
        const float row = static_cast<float>(y) + 0.5F;
        float from = std::numeric_limits<float>::infinity(), to = -from;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3f *lower = corners[i], *upper = corners[(i + 1) % 3];
            // Both faces at the edge compute the same x, so that no pixel is left between them.
            if (lower->y() > upper->y())
                std::swap(lower, upper);
            const Vec3f &p = *lower, &q = *upper;
            if ((p.y() <= row) == (q.y() <= row))
                continue;
            const float x = p.x() + (row - p.y()) / (q.y() - p.y()) * (q.x() - p.x());
            from = std::min(from, x);
            to = std::max(to, x);
        }
        const int first = std::max(left, firstCentre(std::clamp(from, lowX, highX))),
                  last = std::min(right, lastCentre(std::clamp(to, lowX, highX)));
        for (int x = first; x <= last; ++x) {
            const float z = a.z() + slopeX * (static_cast<float>(x) + 0.5F - a.x()) + slopeY * (row - a.y());
            const std::size_t i = index(x, y);
            if (z > m_depth[i]) {
                m_depth[i] = std::min(z, highZ);
                m_face[i] = f;
            }
        }
    }
}

const DrawnImage& DepthImage::shade(const DrawArrays& model)
{
    m_shaded.pixels.resize(m_depth.size());
    eachStalePixel(Colors, [&](int x, int y) {
        const Seen at = seen(model, x, y);
        m_shaded.pixels[index(x, m_height - 1 - y)] =
            at.face == noSlot ? std::array<std::uint8_t, 4>{} : colorAt(model, at);
    });
    settle(Colors);
    return m_shaded;
}

DepthImage::Seen DepthImage::seen(const DrawArrays& model, int x, int y) const
{
    const Slot f = m_face[index(x, y)];
    if (f == noSlot)
        return {noSlot, Vec3f::Zero()};
    const auto corner = [&](std::size_t i) {
        return Vec2f(toGrid(model.vertices[model.faces[f][i]].position).head<2>());
    };
    const Vec2f centre(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
    return {f, weightsAt(centre, corner(0), corner(1), corner(2)).cwiseMax(0).cwiseMin(1)};
}

/// Returns the colour under a lamp at the upper left in front of the model.
std::array<std::uint8_t, 4> DepthImage::colorAt(const DrawArrays& model, const Seen& seen) const
{
    Vec3f normal = Vec3f::Zero(), color = Vec3f::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        const DrawVertex& v = model.vertices[model.faces[seen.face][i]];
        const float weight = seen.weights[static_cast<Eigen::Index>(i)];
        normal += weight * Vec3f(v.normal[0], v.normal[1], v.normal[2]);
        color += weight * Vec3f(v.color[0], v.color[1], v.color[2]);
    }
    const Vec3f lamp(-0.4F, 0.5F, 0.7681F);
    const float length = normal.norm();
    const float light = length > 0 ? std::max(0.0F, onPaper(m_side, normal).dot(lamp) / length) : 1;
    const Vec3f lit = color * (0.4F + 0.6F * light);
    const auto byte = [](float x) { return static_cast<std::uint8_t>(std::clamp(x + 0.5F, 0.0F, 255.0F)); };
    return {byte(lit.x()), byte(lit.y()), byte(lit.z()), 255};
}
} // namespace core
