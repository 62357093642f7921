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
/// An image as it is drawn: RGBA8888 premultiplied, each level half as large as the one before, down to one pixel.
struct ReferencePicture
{
    std::vector<QImage> levels;

    QSize size() const { return levels.front().size(); }
};
using SharedReferencePicture = std::shared_ptr<const ReferencePicture>;

inline constexpr int maxReferencePixels = 4096; ///< of the longer side; larger images are made smaller

/// Null where the file is no image that Qt reads. Takes up to seconds, and 85 MB for the largest; any thread.
SharedReferencePicture readReference(const QString& path);

/// Whether the file's name ends like that of an image.
bool isNamedLikePicture(const QString& path);

/// The side that the camera is nearest to, and whether it looks from there but for a few degrees.
OrbitCamera::Side nearestSide(const OrbitCamera& camera);
bool looksFrom(const OrbitCamera& camera, OrbitCamera::Side side);

/// In the middle of the box, so large that all of the box lies before it. An empty box is taken as 100 mm about the
/// origin.
ReferencePlacement fitted(QSize picture, OrbitCamera::Side side, const core::Box& box);

struct Reference
{
    SharedReferencePicture picture; ///< null: none is shown
    ReferencePlacement placement;
};
using References = std::array<Reference, viewSides.size()>; ///< by Side

/// A rectangle in the scene.
struct PlacedReference
{
    SharedReferencePicture picture;
    core::Vec3 center, halfRight, halfUp; ///< mm
    double opacity = 1;
    bool inFront = false;
};

/// What the camera sees of them: the one of the side that it looks from; its picture is null where there is none. In
/// perspective it is as large as if it stood in the middle of the box, where the model's outline is; it hides nothing
/// that stands before or behind that.
PlacedReference seenReference(const References& references, const OrbitCamera& camera, const core::Box& box);
} // namespace ui
