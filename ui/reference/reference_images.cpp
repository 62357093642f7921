#include "ui/reference/reference_images.h"

#include "ui/settings/settings.h"
#include "ui/util/error_messages.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace ui
{
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

void ReferenceImages::restore()
{
    for (const auto& side : viewSides) {
        const StoredReference stored = m_settings->reference(side.value);
        at(side.value).path = stored.path;
        at(side.value).reference.placement = stored.placement;
        if (!stored.path.isEmpty())
            read(side.value, stored.path, [this, side = side.value](const SharedReferencePicture& picture) {
                at(side).reference.picture = picture;
                Q_EMIT changed();
            });
    }
    Q_EMIT changed();
}

/// Calls `take` on this thread with the picture, unless the side was given another meanwhile.
template <class OnRead> void ReferenceImages::read(OrbitCamera::Side side, const QString& path, OnRead onRead)
{
    const int asked = ++at(side).asked;
    m_background.run([path] { return std::pair(readReference(path), QFileInfo::exists(path)); },
                     [=, this](const std::pair<SharedReferencePicture, bool>& read) {
                         const auto& [picture, isThere] = read;
                         if (asked != at(side).asked)
                             return;
                         if (picture)
                             onRead(picture);
                         else
                             Q_EMIT refused(isThere ? ErrorMessages::notAPicture(path)
                                                    : ErrorMessages::missingReference(path));
                     });
}

void ReferenceImages::choose(OrbitCamera::Side side, const QString& path, const core::Box& box)
{
    read(side, path, [=, this](const SharedReferencePicture& picture) {
        at(side).path = path;
        at(side).reference = {picture, fitted(picture->size(), side, box)};
        save(side);
        setShown(true);
        Q_EMIT changed();
        Q_EMIT chosen(side);
    });
}

void ReferenceImages::remove(OrbitCamera::Side side)
{
    at(side) = {{}, {}, at(side).asked + 1};
    save(side);
    Q_EMIT changed();
}

void ReferenceImages::place(OrbitCamera::Side side, const ReferencePlacement& placement)
{
    if (at(side).reference.placement == placement)
        return;
    at(side).reference.placement = placement;
    save(side);
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

bool ReferenceImages::isEmpty() const
{
    return std::ranges::all_of(m_slots, [](const Slot& slot) { return slot.path.isEmpty(); });
}

References ReferenceImages::shown() const
{
    References references;
    if (m_isShown)
        std::ranges::transform(m_slots, references.begin(), &Slot::reference);
    return references;
}

void ReferenceImages::save(OrbitCamera::Side side)
{
    m_settings->setReference(side, {at(side).path, at(side).reference.placement});
}
} // namespace ui
