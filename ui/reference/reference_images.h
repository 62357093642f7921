#pragma once

#include "ui/scene/reference_image.h"
#include "ui/util/background_thread.h"

#include "core/io/document_metadata.h"

#include <QObject>

#include <array>
#include <vector>

namespace ui
{
class Settings;

/// The reference images of the document, one a side, read on a thread. Thread: gui.
class ReferenceImages : public QObject
{
    Q_OBJECT

public:
    /// Begins without images. The settings, which have only whether they are shown, must outlive this.
    explicit ReferenceImages(Settings* settings, QObject* parent = nullptr);
    ~ReferenceImages() override;

    /// Takes the images of another document. One that is gone or broken is refused, and keeps its place for when it
    /// comes back.
    void setSaved(const std::vector<core::SavedReference>& references);
    std::vector<core::SavedReference> saved() const;

    /// When it was read it takes that side, fitted to the box, in place of what was there; until then nothing changes.
    void choose(OrbitCamera::Side side, const QString& path, const core::Box& box);
    void remove(OrbitCamera::Side side);
    void place(OrbitCamera::Side side, const ReferencePlacement& placement);
    void setShown(bool shown);

    /// Empty: none was chosen.
    QString path(OrbitCamera::Side side) const { return at(side).path; }
    /// Its picture is null while it is read, and where that failed.
    const Reference& reference(OrbitCamera::Side side) const { return at(side).reference; }
    bool isShown() const { return m_isShown; }
    /// What the view shows.
    References shown() const;

Q_SIGNALS:
    void changed();
    /// Somebody chose, removed or moved one; changed() follows.
    void edited();
    void chosen(OrbitCamera::Side side);
    /// In one sentence why an image is not there.
    void refused(const QString& sentence);

private:
    struct Slot
    {
        QString path;
        Reference reference;
        int asked = 0; ///< what was read for an earlier question is too late
    };

    Slot& at(OrbitCamera::Side side) { return m_slots[static_cast<std::size_t>(side)]; }
    const Slot& at(OrbitCamera::Side side) const { return m_slots[static_cast<std::size_t>(side)]; }
    template <class OnRead> void read(OrbitCamera::Side side, const QString& path, OnRead onRead);

    Settings* m_settings;
    std::array<Slot, viewSides.size()> m_slots;
    bool m_isShown;
    BackgroundThread m_background; ///< last
};
} // namespace ui
