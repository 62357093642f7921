// Steps: place the vertices -> turn faces towards the eye -> draw a depth image finer than the picture -> light each
// sample -> average the samples of a pixel. A vertex normal is the mean of its faces' normals; a face whose
// normal differs from the mean by more than the crease angle uses its own.

#include "core/drawing/model_thumbnail.h"

#include "core/drawing/depth_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core
{
namespace
{
constexpr int samples = 3;     ///< samples of a pixel in each direction
constexpr int viewSamples = 2; ///< samples of a pixel in each direction, for pictures that may be large
constexpr double marginFactor = 1.05;
constexpr int border = 2; ///< samples left free on each side, in addition to the margin of the depth image
constexpr std::size_t elementsPerStep = 1 << 13;

constexpr Rgb clay{194, 150, 126}; ///< the colour of uncoloured models in the window
constexpr float ambient = 0.36F, keyLight = 0.60F, fillLight = 0.16F;
/// Directions to the lamps: to the right, up, and towards the eye.
const Vec3f keyLamp = Vec3f(-0.45F, 0.62F, 0.64F), fillLamp = Vec3f(0.80F, 0.05F, 0.60F);

/// Returns unit rows: right, up, and towards the eye. The eye is 35 degrees to the right of the front and 25 degrees
/// above it.
Eigen::Matrix3d turn()
{
    const Vec3 toEye(0.5198368, 0.4226183, 0.7424039);
    const Vec3 right = Vec3::UnitY().cross(toEye).normalized();
    Eigen::Matrix3d rows;
    rows << right.transpose(), toEye.cross(right).transpose(), toEye.transpose();
    return rows;
}

/// A transform from the document to the picture. It scales lengths to about 1, where float32 is precise.
struct ThumbnailPoint
{
    Eigen::Matrix3d turn; ///< rotation and scale
    Vec3 target;          ///< the point in the middle of the picture
    double distance;      ///< scaled distance from the eye to the target; 0: parallel projection
};

/// Smallest visible distance from the eye, as a fraction of the distance from the eye to the target.
constexpr double nearest = 0.01;

class ThumbnailRenderer
{
public:
    ThumbnailRenderer(const TriangleMesh& mesh, int fineness, const std::stop_token& stop)
        : m_mesh(mesh)
        , m_samples(fineness)
        , m_stop(stop)
    {}

    std::optional<ModelThumbnail> paint(int pixels)
    {
        const Box box = boxOfFaces();
        const double size = box.isEmpty() ? 0 : box.sizes().maxCoeff();
        if (!place({turn() / (size > 0 ? size : 1), box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.center()), 0}) ||
            !faceTheEye())
            return std::nullopt;
        const float extent = m_box.isEmpty() ? 0 : m_box.sizes().maxCoeff();
        if (!(extent > 0))
            return emptyThumbnail(pixels, pixels);
        const int room = m_samples * pixels - 2 * border - 5; // the depth image adds 5 pixels to the box
        return draw(m_box, extent / static_cast<float>(room), emptyThumbnail(pixels, pixels));
    }

    /// Draws the view. Lengths are scaled so that the picture's height is 1.
    std::optional<ModelThumbnail> paint(const ThumbnailView& view)
    {
        if (!place({view.axes / view.extent, view.target, view.distance / view.extent}) || !faceTheEye())
            return std::nullopt;
        const Vec2f corner(0.5F * static_cast<float>(view.width) / static_cast<float>(view.height), 0.5F);
        return draw({-corner, corner}, 1 / static_cast<float>(m_samples * view.height),
                    emptyThumbnail(view.width, view.height));
    }

private:
    using Sum = std::array<std::uint16_t, 4>;

    static ModelThumbnail emptyThumbnail(int width, int height)
    {
        ModelThumbnail picture{width, height, {}};
        picture.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        return picture;
    }

    bool stopsAt(std::size_t i) const { return i % elementsPerStep == 0 && m_stop.stop_requested(); }

    Box boxOfFaces() const
    {
        Box box;
        for (std::size_t f = 0; f < m_mesh.triangles.size() && !stopsAt(f); ++f)
            for (const Slot corner : m_mesh.triangles[f])
                box.extend(m_mesh.points[corner].cast<double>());
        return box;
    }

    std::optional<ModelThumbnail> draw(const Eigen::AlignedBox2f& box, float pixel, ModelThumbnail picture) const
    {
        DepthImage image(DrawnSide::Front, box, pixel);
        if (!image.draw(m_model, std::vector<std::uint8_t>(m_model.faces.size(), 1), {}, m_stop) ||
            !light(image, picture))
            return std::nullopt;
        return picture;
    }

    bool place(const ThumbnailPoint& where)
    {
        m_model.vertices.reserve(m_mesh.points.size());
        m_shape.reserve(m_mesh.points.size());
        for (std::size_t i = 0; i < m_mesh.points.size(); ++i) {
            if (stopsAt(i))
                return false;
            const Rgb color = m_mesh.colors.empty() ? clay : m_mesh.colors[i];
            const Vec3 placed = where.turn * (m_mesh.points[i].cast<double>() - where.target);
            m_shape.push_back(placed.cast<float>());
            m_model.vertices.push_back(
                {seenFrom(where.distance, placed).cast<float>(), {}, {color.r, color.g, color.b, 255}});
        }
        return true;
    }

    /// Projects a placed point. The third coordinate grows with nearness, and planes remain planes. Points behind or
    /// too near the eye become NaN.
    static Vec3 seenFrom(double distance, const Vec3& placed)
    {
        if (distance == 0)
            return placed;
        const double away = distance - placed.z();
        if (away < nearest * distance)
            return Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
        const double larger = distance / away;
        return {larger * placed.x(), larger * placed.y(), distance * larger};
    }

    /// Reverses faces that face away from the eye, so that each face is drawn from either side. Omits faces that have a
    /// NaN corner. Returns false if it was stopped.
    bool faceTheEye()
    {
        m_normals.assign(m_model.vertices.size(), Vec3f::Zero());
        m_model.faces.reserve(m_mesh.triangles.size());
        for (std::size_t f = 0; f < m_mesh.triangles.size(); ++f) {
            if (stopsAt(f))
                return false;
            Triangle t = m_mesh.triangles[f];
            for (const Slot corner : t)
                m_normals[corner] += areaOf(t);
            const Vec2f a = at(t[0]), ab = at(t[1]) - a, ac = at(t[2]) - a;
            const float area = ab.x() * ac.y() - ab.y() * ac.x();
            if (std::isnan(area))
                continue;
            for (const Slot corner : t)
                m_box.extend(at(corner));
            if (area < 0)
                std::swap(t[1], t[2]);
            m_model.faces.push_back(t);
        }
        return true;
    }

    Vec2f at(Slot corner) const { return m_model.vertices[corner].position.head<2>(); }
    Vec3f areaOf(const Triangle& t) const
    {
        return (m_shape[t[1]] - m_shape[t[0]]).cross(m_shape[t[2]] - m_shape[t[0]]);
    }

    Sum lit(const DepthImage::Seen& seen) const
    {
        const Triangle& t = m_model.faces[seen.face];
        const Vec3f own = areaOf(t).normalized();
        Vec3f normal = Vec3f::Zero(), color = Vec3f::Zero();
        for (std::size_t i = 0; i < 3; ++i) {
            const float weight = seen.weights[static_cast<Eigen::Index>(i)];
            const std::array<std::uint8_t, 4>& c = m_model.vertices[t[i]].color;
            normal += weight * normalAt(t[i], own);
            color += weight * Vec3f(c[0], c[1], c[2]);
        }
        normal.normalize();
        const float light =
            ambient + keyLight * std::max(0.0F, normal.dot(keyLamp)) + fillLight * std::max(0.0F, normal.dot(fillLamp));
        const Vec3f shade = color * light;
        const auto byte = [](float x) { return static_cast<std::uint16_t>(std::clamp(x + 0.5F, 0.0F, 255.0F)); };
        return {byte(shade.x()), byte(shade.y()), byte(shade.z()), 255};
    }

    Vec3f normalAt(Slot corner, const Vec3f& own) const
    {
        const Vec3f mean = m_normals[corner].normalized();
        const float turned = mean.dot(own);
        if (std::abs(turned) < static_cast<float>(creaseCosine))
            return own;
        return turned < 0 ? Vec3f(-mean) : mean;
    }

    /// Averages lit samples to pixels. The depth image is centred on the picture and may be slightly larger. Its rows
    /// are from the bottom, the picture's from the top. Returns false if it was stopped.
    bool light(const DepthImage& image, ModelThumbnail& picture) const
    {
        std::vector<Sum> sums(picture.rgba.size());
        const int width = m_samples * picture.width, height = m_samples * picture.height;
        const int left = (width - image.width()) / 2, bottom = (height - image.height()) / 2;
        for (int y = std::max(0, -bottom); y < std::min(image.height(), height - bottom); ++y) {
            if (m_stop.stop_requested())
                return false;
            const int row = picture.height - 1 - (bottom + y) / m_samples;
            for (int x = std::max(0, -left); x < std::min(image.width(), width - left); ++x)
                if (const DepthImage::Seen seen = image.seen(m_model, x, y); seen.face != noSlot)
                    add(sums[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                             static_cast<std::size_t>((left + x) / m_samples)],
                        lit(seen));
        }
        std::transform(sums.begin(), sums.end(), picture.rgba.begin(), [this](const Sum& sum) { return mean(sum); });
        return true;
    }

    static void add(Sum& sum, const Sum& sample)
    {
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] = static_cast<std::uint16_t>(sum[i] + sample[i]);
    }

    std::array<std::uint8_t, 4> mean(const Sum& sum) const
    {
        std::array<std::uint8_t, 4> result{};
        for (std::size_t i = 0; i < sum.size(); ++i)
            result[i] = static_cast<std::uint8_t>(sum[i] / (m_samples * m_samples));
        return result;
    }

    const TriangleMesh& m_mesh;
    int m_samples; ///< samples of a pixel in each direction
    const std::stop_token& m_stop;
    DrawArrays m_model;         ///< projected vertices: to the right, up, and nearness
    std::vector<Vec3f> m_shape; ///< vertices before the perspective projection: to the right, up, and towards the eye
    std::vector<Vec3f> m_normals;
    Eigen::AlignedBox2f m_box; ///< box of the projected faces
};
} // namespace

std::optional<ModelThumbnail> drawThumbnail(const TriangleMesh& mesh, int pixels, const std::stop_token& stop)
{
    return ThumbnailRenderer(mesh, samples, stop).paint(pixels);
}

std::optional<ModelThumbnail> drawThumbnail(const TriangleMesh& mesh, const ThumbnailView& view,
                                            const std::stop_token& stop)
{
    return ThumbnailRenderer(mesh, viewSamples, stop).paint(view);
}

ThumbnailView viewOf(const Box& box, int width, int height)
{
    ThumbnailView view{turn(), box.center(), 0, 0, width, height};
    Box seen;
    for (int corner = 0; corner < 8; ++corner)
        seen.extend(Vec3(view.axes * (box.corner(static_cast<Box::CornerType>(corner)) - view.target)));
    const double aspect = static_cast<double>(width) / height;
    view.extent = std::max(seen.sizes().y(), seen.sizes().x() / aspect) * marginFactor;
    return view;
}
} // namespace core
