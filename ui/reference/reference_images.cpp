#include "ui/reference/reference_images.h"

#include "ui/settings/settings.h"
#include "ui/util/error_messages.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace ui
{
namespace
{
ReferencePlacement placementOf(const core::SavedReference& saved)
{
    return {std::clamp(saved.width, minReferenceWidth, maxReferenceWidth),
            std::clamp(saved.x, -maxReferenceOffset, maxReferenceOffset),
            std::clamp(saved.y, -maxReferenceOffset, maxReferenceOffset),
            std::clamp(saved.opacity, minReferenceOpacity, 1.0), saved.inFront};
}
} // namespace

ReferenceImages::ReferenceImages(Settings* settings, QObject* parent)
    : QObject(parent)
    , m_settings(settings)
    , m_isShown(settings->get(&Setting::showsReferences))
{
    settings->onReset([this] { setShown(m_settings->get(&Setting::showsReferences)); });
}

ReferenceImages::~ReferenceImages()
{
    m_background.drop();
}

void ReferenceImages::setSaved(const std::vector<core::SavedReference>& references)
{
    for (Slot& slot : m_slots)
        slot = {{}, {}, slot.asked + 1};
    for (const core::SavedReference& saved : references) {
        const auto side = std::ranges::find(viewSides, saved.side, &Named<ViewSide>::key);
        if (side == viewSides.end())
            continue;
        Slot& slot = at(side->value);
        slot.path = QString::fromStdU16String(saved.path.generic_u16string());
        slot.reference.placement = placementOf(saved);
        read(side->value, slot.path, [this, side = side->value](const SharedReferencePicture& picture) {
            at(side).reference.picture = picture;
            Q_EMIT changed();
        });
    }
    Q_EMIT changed();
}

std::vector<core::SavedReference> ReferenceImages::saved() const
{
    std::vector<core::SavedReference> references;
    for (const auto& side : viewSides)
        if (const Slot& slot = at(side.value); !slot.path.isEmpty()) {
            const ReferencePlacement& place = slot.reference.placement;
            references.push_back({std::string(side.key), slot.path.toStdU16String(), place.width, place.x, place.y,
                                  place.opacity, place.inFront});
        }
    return references;
}

/// Reads an image on the background thread, then calls `onRead` on this thread, or emits refused() if reading fails.
/// Neither happens if the side got another image meanwhile.
template <class OnRead> void ReferenceImages::read(OrbitCamera::Side side, const QString& path, OnRead onRead)
{
    const int asked = ++at(side).asked;
    m_background.run(
        [path] {
            return QFileInfo(path).isFile() ? std::pair(readReference(path), true)
                                            : std::pair(SharedReferencePicture(), false);
        },
        [=, this](const std::pair<SharedReferencePicture, bool>& read) {
            const auto& [picture, isThere] = read;
            if (asked != at(side).asked)
                return;
            if (picture)
                onRead(picture);
            else
                Q_EMIT refused(isThere ? ErrorMessages::notAPicture(path) : ErrorMessages::missingReference(path));
        });
}

void ReferenceImages::choose(OrbitCamera::Side side, const QString& path, const core::Box& box)
{
    read(side, path, [=, this](const SharedReferencePicture& picture) {
        at(side).path = path;
        at(side).reference = {picture, fitted(picture->size(), side, box)};
        setShown(true);
        Q_EMIT edited();
        Q_EMIT changed();
        Q_EMIT chosen(side);
    });
}

void ReferenceImages::remove(OrbitCamera::Side side)
{
    at(side) = {{}, {}, at(side).asked + 1};
    Q_EMIT edited();
    Q_EMIT changed();
}

void ReferenceImages::place(OrbitCamera::Side side, const ReferencePlacement& placement)
{
    if (at(side).reference.placement == placement)
        return;
    at(side).reference.placement = placement;
    Q_EMIT edited();
    Q_EMIT changed();
}

void ReferenceImages::setShown(bool shown)
{
    if (m_isShown == shown)
        return;
    m_isShown = shown;
    m_settings->set(&Setting::showsReferences, shown);
    Q_EMIT changed();
}

References ReferenceImages::shown() const
{
    References references;
    if (m_isShown)
        std::ranges::transform(m_slots, references.begin(), &Slot::reference);
    return references;
}
} // namespace ui
