#pragma once

#include "ui/scene/reference_image.h"
#include "ui/util/background_thread.h"

#include <QObject>

#include <array>

namespace ui
{
class Settings;

/// The reference images, one a side, read on a thread and kept in the settings. Thread: gui.
class ReferenceImages : public QObject
{
    Q_OBJECT

public:
    /// Nothing is read before restore(). The settings must outlive this.
    explicit ReferenceImages(Settings* settings, QObject* parent = nullptr);
    ~ReferenceImages() override;

    /// Reads what the settings name. What is gone or broken is refused, and keeps its place for when it comes back.
    void restore();

    /// When it was read it takes that side, fitted to the box, in place of what was there; until then nothing changes.
    void choose(OrbitCamera::Side side, const QString& path, const core::Box& box);
    void remove(OrbitCamera::Side side);
    void place(OrbitCamera::Side side, const ReferencePlacement& placement);
    void setShown(bool shown);

    /// Empty: none was chosen.
    QString path(OrbitCamera::Side side) const { return at(side).path; }
    /// Its picture is null while it is read, and where that failed.
    const Reference& reference(OrbitCamera::Side side) const { return at(side).reference; }
    bool isEmpty() const;
    bool isShown() const { return m_isShown; }
    /// What the view shows.
    References shown() const;

Q_SIGNALS:
    void changed();
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
    void save(OrbitCamera::Side side);

    Settings* m_settings;
    std::array<Slot, viewSides.size()> m_slots;
    bool m_isShown;
    BackgroundThread m_background; ///< last
};
} // namespace ui
