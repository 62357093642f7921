#pragma once

#include "orbit_camera.h"
#include "view_look.h"

#include <QImage>
#include <QString>

#include <array>
#include <memory>
#include <vector>

namespace ui
{
inline constexpr double minReferenceWidth = 0.01, maxReferenceWidth = 100000, maxReferenceOffset = 100000;
inline constexpr double minReferenceOpacity = 0.05, defaultReferenceOpacity = 0.6;

inline constexpr std::array<Named<OrbitCamera::Side>, 6> viewSides{{{OrbitCamera::Side::Front, "front"},
                                                                {OrbitCamera::Side::Back, "back"},
                                                                {OrbitCamera::Side::Right, "right"},
                                                                {OrbitCamera::Side::Left, "left"},
                                                                {OrbitCamera::Side::Top, "top"},
                                                                {OrbitCamera::Side::Bottom, "bottom"}}};

/// How a reference image stands on its side: mm, as seen from there.
struct ReferencePlacement
{
    double width = 100;
    double x = 0, y = 0; ///< the image's middle from the origin, to the right and up
    double opacity = defaultReferenceOpacity;
    bool inFront = false; ///< over the model instead of behind it

    bool operator==(const ReferencePlacement&) const = default;
};

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

/// In the middle of the box, so large that all of the box lies before it. An empty box is taken as 100 mm about the origin.
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

/// What the camera sees of them: the one of the side that it looks from; its picture is null where there is none. In perspective it is
/// as large as if it stood in the middle of the box, where the model's outline is; it hides nothing that stands before or behind that.
PlacedReference seenReference(const References& references, const OrbitCamera& camera, const core::Box& box);
} // namespace ui
