#pragma once

#include "ui/scene/orbit_camera.h"
#include "ui/settings/reference_placement.h"

#include <QImage>
#include <QString>

#include <array>
#include <memory>
#include <vector>

namespace ui
{
/// An image to draw, with its mipmaps: RGBA8888 premultiplied, each level half as large as the level before, down to 1
/// x 1 pixel.
struct ReferencePicture
{
    std::vector<QImage> levels;

    QSize size() const { return levels.front().size(); }
};
using SharedReferencePicture = std::shared_ptr<const ReferencePicture>;

/// largest length of the longer side, pixels; larger images are scaled down
inline constexpr int maxReferencePixels = 4096;

/// Reads an image file. Returns null if Qt cannot read it. Thread: any. Cost: up to seconds, and 85 MB for the largest
/// image.
SharedReferencePicture readReference(const QString& path);

/// Returns true if the file's extension is that of an image format that Qt reads.
bool isNamedLikePicture(const QString& path);

/// Returns the side that is nearest to the camera's direction.
OrbitCamera::Side nearestSide(const OrbitCamera& camera);
/// Returns true if the camera looks from this side, within 5 degrees.
bool looksFrom(const OrbitCamera& camera, OrbitCamera::Side side);

/// Returns the placement of a picture of this size in the middle of the box, just large enough to cover it. An empty
/// box counts as a cube of 100 mm around the origin.
ReferencePlacement fitted(QSize picture, OrbitCamera::Side side, const core::Box& box);

/// The reference image of a side.
struct Reference
{
    SharedReferencePicture picture; ///< null: the side has none
    ReferencePlacement placement;
};
using References = std::array<Reference, viewSides.size()>; ///< indexed by Side

/// A reference image as a rectangle in the scene.
struct PlacedReference
{
    SharedReferencePicture picture;
    core::Vec3 center, halfRight, halfUp; ///< mm
    double opacity = 1;
    bool inFront = false;
};

/// Returns the reference image of the side that the camera looks from; its picture is null if there is none. The image
/// is in the middle of the box, so in perspective its scale matches the model's outline. It does not hide anything in
/// front of or behind it.
PlacedReference seenReference(const References& references, const OrbitCamera& camera, const core::Box& box);
} // namespace ui
