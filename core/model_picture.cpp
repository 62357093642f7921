// place (turn, fit) -> face the eye -> depth image, finer than the picture -> light -> mean of the samples.
// Normals: the mean of the faces around a vertex, or the face's own where that turns away from it (a crease).

#include "model_picture.h"

#include "depth_image.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
constexpr int samples = 3; ///< a pixel's, each way
constexpr int border = 2;  ///< samples left free at each side, beside those of the depth image itself
constexpr std::size_t elementsAStep = 1 << 13;

constexpr Rgb clay{194, 150, 126}; ///< as the window shows it
constexpr float ambient = 0.36F, keyLight = 0.60F, fillLight = 0.16F;
const Vec3f keyLamp = Vec3f(-0.45F, 0.62F, 0.64F), fillLamp = Vec3f(0.80F, 0.05F, 0.60F); ///< to the right, up, to the eye

/// Rows: to the right, up, to the eye. The model is turned by 35 degrees to the left and tilted by 25 to the eye.
Eigen::Matrix3d turn()
{
    const Vec3 toEye(0.5198368, 0.4226183, 0.7424039);
    const Vec3 right = Vec3::UnitY().cross(toEye).normalized();
    Eigen::Matrix3d rows;
    rows << right.transpose(), toEye.cross(right).transpose(), toEye.transpose();
    return rows;
}

class PicturePainter
{
public:
    PicturePainter(const TriangleMesh& mesh, const std::stop_token& stop) : m_mesh(mesh), m_stop(stop) {}

    std::optional<ModelPicture> paint(int pixels)
    {
        ModelPicture picture{pixels, {}};
        picture.rgba.resize(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(pixels));
        if (!place() || !faceTheEye())
            return std::nullopt;
        const float extent = m_box.isEmpty() ? 0 : m_box.sizes().maxCoeff();
        if (!(extent > 0))
            return picture;
        const int room = samples * pixels - 2 * border - 5; // what the depth image puts around the box
        DepthImage image(DrawnSide::Front, m_box, extent / static_cast<float>(room));
        if (!image.draw(m_model, std::vector<std::uint8_t>(m_model.faces.size(), 1), {}, m_stop))
            return std::nullopt;
        if (!light(image, picture))
            return std::nullopt;
        return picture;
    }

private:
    using Sum = std::array<std::uint16_t, 4>;

    bool stopsAt(std::size_t i) const { return i % elementsAStep == 0 && m_stop.stop_requested(); }

    /// Turned, and so large that float32 holds it well: the box of what faces use becomes about 1.
    bool place()
    {
        Box box;
        for (std::size_t f = 0; f < m_mesh.triangles.size(); ++f) {
            if (stopsAt(f))
                return false;
            for (const Slot corner : m_mesh.triangles[f])
                box.extend(m_mesh.points[corner].cast<double>());
        }
        const double size = box.isEmpty() ? 0 : box.sizes().maxCoeff();
        const Eigen::Matrix3d toPicture = turn() / (size > 0 ? size : 1);
        const Vec3 centre = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.center());
        m_model.vertices.reserve(m_mesh.points.size());
        for (std::size_t i = 0; i < m_mesh.points.size(); ++i) {
            if (stopsAt(i))
                return false;
            const Rgb color = m_mesh.colors.empty() ? clay : m_mesh.colors[i];
            const Vec3 placed = toPicture * (m_mesh.points[i].cast<double>() - centre);
            m_model.vertices.push_back({placed.cast<float>(), {}, {color.r, color.g, color.b, 255}});
        }
        return true;
    }

    /// Faces that look away are turned round, normals and all: a picture has no inside.
    bool faceTheEye()
    {
        m_normals.assign(m_model.vertices.size(), Vec3f::Zero());
        m_model.faces.reserve(m_mesh.triangles.size());
        for (std::size_t f = 0; f < m_mesh.triangles.size(); ++f) {
            if (stopsAt(f))
                return false;
            Triangle t = m_mesh.triangles[f];
            for (const Slot corner : t) {
                m_normals[corner] += areaOf(t);
                m_box.extend(Vec2f(at(corner).head<2>()));
            }
            if (areaOf(t).z() < 0)
                std::swap(t[1], t[2]);
            m_model.faces.push_back(t);
        }
        return true;
    }

    const Vec3f& at(Slot corner) const { return m_model.vertices[corner].position; }
    Vec3f areaOf(const Triangle& t) const { return (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])); }

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
        const float light = ambient + keyLight * std::max(0.0F, normal.dot(keyLamp)) + fillLight * std::max(0.0F, normal.dot(fillLamp));
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

    /// The image stands in the picture's middle; its rows go up, the picture's down.
    bool light(const DepthImage& image, ModelPicture& picture) const
    {
        std::vector<Sum> sums(picture.rgba.size());
        const int left = (samples * picture.pixels - image.width()) / 2, bottom = (samples * picture.pixels - image.height()) / 2;
        for (int y = 0; y < image.height(); ++y) {
            if (m_stop.stop_requested())
                return false;
            const int row = picture.pixels - 1 - (bottom + y) / samples;
            for (int x = 0; x < image.width(); ++x)
                if (const DepthImage::Seen seen = image.seen(m_model, x, y); seen.face != noSlot)
                    add(sums[static_cast<std::size_t>(row * picture.pixels + (left + x) / samples)], lit(seen));
        }
        std::transform(sums.begin(), sums.end(), picture.rgba.begin(), mean);
        return true;
    }

    static void add(Sum& sum, const Sum& sample)
    {
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] = static_cast<std::uint16_t>(sum[i] + sample[i]);
    }

    static std::array<std::uint8_t, 4> mean(const Sum& sum)
    {
        std::array<std::uint8_t, 4> result{};
        for (std::size_t i = 0; i < sum.size(); ++i)
            result[i] = static_cast<std::uint8_t>(sum[i] / (samples * samples));
        return result;
    }

    const TriangleMesh& m_mesh;
    const std::stop_token& m_stop;
    DrawArrays m_model; ///< in the picture: to the right, up, to the eye
    std::vector<Vec3f> m_normals;
    Eigen::AlignedBox2f m_box; ///< of the faces
};
} // namespace

std::optional<ModelPicture> drawPicture(const TriangleMesh& mesh, int pixels, const std::stop_token& stop)
{
    return PicturePainter(mesh, stop).paint(pixels);
}
} // namespace core
