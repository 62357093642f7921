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

/// The document's reference images, at most one for each side of the model. Files are read on a background thread.
/// Thread: gui.
class ReferenceImages : public QObject
{
    Q_OBJECT

public:
    /// Begins without images. The settings store only whether images are shown. Precondition: the settings outlive this
    /// object.
    explicit ReferenceImages(Settings* settings, QObject* parent = nullptr);
    ~ReferenceImages() override;

    /// Replaces all images by those of another document. A missing or damaged file is reported by refused(); its path
    /// and placement are kept in case the file comes back.
    void setSaved(const std::vector<core::SavedReference>& references);
    std::vector<core::SavedReference> saved() const;

    /// Reads an image and then places it on the side, fitted to the box, replacing the side's image. Nothing changes
    /// until it has been read.
    void choose(OrbitCamera::Side side, const QString& path, const core::Box& box);
    void remove(OrbitCamera::Side side);
    void place(OrbitCamera::Side side, const ReferencePlacement& placement);
    void setShown(bool shown);

    /// Returns the path of the side's image; empty if none was chosen.
    QString path(OrbitCamera::Side side) const { return at(side).path; }
    /// Returns the side's image. Its picture is null until it has been read, or if reading failed.
    const Reference& reference(OrbitCamera::Side side) const { return at(side).reference; }
    bool isShown() const { return m_isShown; }
    /// Returns the images to draw.
    References shown() const;

Q_SIGNALS:
    void changed();
    /// An image was chosen, removed or moved by the user; changed() follows.
    void edited();
    void chosen(OrbitCamera::Side side);
    /// An image could not be read. `sentence`: the reason.
    void refused(const QString& sentence);

private:
    struct Slot
    {
        QString path;
        Reference reference;
        int asked = 0; ///< number of the latest request; results of earlier requests are dropped
    };

    Slot& at(OrbitCamera::Side side) { return m_slots[static_cast<std::size_t>(side)]; }
    const Slot& at(OrbitCamera::Side side) const { return m_slots[static_cast<std::size_t>(side)]; }
    template <class OnRead> void read(OrbitCamera::Side side, const QString& path, OnRead onRead);

    Settings* m_settings;
    std::array<Slot, viewSides.size()> m_slots;
    bool m_isShown;
    BackgroundThread m_background; ///< last member: destroyed first, because its jobs use the other members
};
} // namespace ui
