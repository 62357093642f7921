#include "ui/scene/reference_image.h"

#include <QFileInfo>
#include <QImageReader>

#include <algorithm>

namespace ui
{
namespace
{
constexpr double cosineOfAside = 0.9962; ///< cosine of 5 degrees
constexpr double hundred = 100;          ///< edge of the cube that replaces an empty box, mm

/// Axes of the view from a side; `back` points from the eye into the view.
struct SideAxes
{
    core::Vec3 right, up, back;
};

SideAxes axesOf(OrbitCamera::Side side)
{
    OrbitCamera camera;
    camera.turnTo(side);
    return {camera.right(), camera.up(), camera.viewDirection()};
}

double cosineTo(OrbitCamera::Side side, const OrbitCamera& camera)
{
    return axesOf(side).back.dot(camera.viewDirection());
}

core::Box shownBox(const core::Box& box)
{
    return box.isEmpty() ? core::Box(core::Vec3::Constant(-hundred / 2), core::Vec3::Constant(hundred / 2)) : box;
}

/// Returns the box's length along an axis of the document.
double extent(const core::Box& box, const core::Vec3& axis)
{
    return box.sizes().dot(axis.cwiseAbs());
}

QImage decoded(const QString& path)
{
    QImageReader reader(path);
    reader.setAutoTransform(true);
    reader.setDecideFormatFromContent(true);
    const QSize size = reader.size();
    if (std::max(size.width(), size.height()) > maxReferencePixels)
        reader.setScaledSize(
            size.scaled(maxReferencePixels, maxReferencePixels, Qt::KeepAspectRatio).expandedTo({1, 1}));
    return reader.read();
}
} // namespace

SharedReferencePicture readReference(const QString& path)
{
    QImage level = decoded(path);
    if (level.isNull())
        return nullptr;
    // needed for formats whose size is unknown before decoding
    if (std::max(level.width(), level.height()) > maxReferencePixels)
        level = level.scaled(maxReferencePixels, maxReferencePixels, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    auto picture = std::make_shared<ReferencePicture>();
    picture->levels.push_back(level.convertToFormat(QImage::Format_RGBA8888_Premultiplied));
    while (picture->levels.back().size() != QSize(1, 1)) {
        const QImage& last = picture->levels.back();
        const QSize half = QSize(last.width() / 2, last.height() / 2).expandedTo({1, 1});
        picture->levels.push_back(last.scaled(half, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                                      .convertToFormat(QImage::Format_RGBA8888_Premultiplied));
    }
    return picture;
}

bool isNamedLikePicture(const QString& path)
{
    return QImageReader::supportedImageFormats().contains(QFileInfo(path).suffix().toLower().toLatin1());
}

OrbitCamera::Side nearestSide(const OrbitCamera& camera)
{
    return std::ranges::max(viewSides, {}, [&](const auto& side) { return cosineTo(side.value, camera); }).value;
}

bool looksFrom(const OrbitCamera& camera, OrbitCamera::Side side)
{
    return cosineTo(side, camera) > cosineOfAside;
}

ReferencePlacement fitted(QSize picture, OrbitCamera::Side side, const core::Box& box)
{
    const core::Box shown = shownBox(box);
    const SideAxes axes = axesOf(side);
    const double aspect = static_cast<double>(picture.width()) / picture.height();
    const double width = std::max(extent(shown, axes.right), extent(shown, axes.up) * aspect);
    ReferencePlacement placement;
    placement.width = std::clamp(width, minReferenceWidth, maxReferenceWidth);
    placement.x = std::clamp(shown.center().dot(axes.right), -maxReferenceOffset, maxReferenceOffset);
    placement.y = std::clamp(shown.center().dot(axes.up), -maxReferenceOffset, maxReferenceOffset);
    return placement;
}

PlacedReference seenReference(const References& references, const OrbitCamera& camera, const core::Box& box)
{
    const OrbitCamera::Side side = nearestSide(camera);
    const Reference& reference = references[static_cast<std::size_t>(side)];
    if (!reference.picture || !looksFrom(camera, side))
        return {};
    const core::Box shown = shownBox(box);
    const SideAxes axes = axesOf(side);
    const QSize size = reference.picture->size();
    const ReferencePlacement& at = reference.placement;
    const double depth = shown.center().dot(axes.back);
    const double halfWidth = 0.5 * at.width;
    return {reference.picture,
            at.x * axes.right + at.y * axes.up + depth * axes.back,
            halfWidth * axes.right,
            halfWidth * size.height() / size.width() * axes.up,
            at.opacity,
            at.inFront};
}
} // namespace ui
