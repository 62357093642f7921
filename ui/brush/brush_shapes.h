#pragma once

#include "ui/brush/brush_files.h"
#include "ui/settings/settings.h"
#include "ui/util/background_thread.h"

#include <QHash>
#include <QObject>

namespace ui
{
/// Which alpha and which model the brush has: reads their files on a thread, and keeps what was chosen in the settings.
/// Thread: gui.
class BrushShapes : public QObject
{
    Q_OBJECT

public:
    /// Both must outlive this.
    BrushShapes(BrushSettings* brush, Settings* settings, QObject* parent = nullptr);
    ~BrushShapes() override;

    /// What the settings name. A file that is gone or broken gives none, which refused() says; it is named no more
    /// then.
    void restore();

    /// A name of core::builtInAlphas(), or a path, which takes effect when it was read; empty: none.
    void chooseAlpha(const QString& source);
    /// A path; empty: a ball.
    void chooseModel(const QString& path);
    /// The document's model as it is now: ownModelRequested().
    void chooseOwnModel() { Q_EMIT ownModelRequested(); }

    /// Whether other files may be chosen than those that were before, or the document's model; at first they may.
    bool mayLoad() const { return m_mayLoad; }
    void setMayLoad(bool mayLoad);
    /// Files that were chosen before, the latest first.
    const QStringList& alphas() const { return m_stored.alphas; }
    const QStringList& models() const { return m_stored.models; }
    /// Null if it has not been read yet.
    std::shared_ptr<const core::Alpha> alpha(const QString& source) const;

Q_SIGNALS:
    /// Another choice, or other files.
    void changed();
    void ownModelRequested();
    /// In one sentence why a file is not taken; the brush is what it was.
    void refused(const QString& sentence);

private:
    enum class Origin { User, Restore };
    /// Of one kind of shape: where it stands in the brush and in the settings.
    template <class What> struct ShapeSlot
    {
        std::shared_ptr<const What> core::StrokeSettings::*inBrush;
        QString StoredShapes::*chosen;
        QStringList StoredShapes::*files;
        BrushFile<What> (*read)(const QString& path);
        int request = 0;          ///< what was read for an earlier one is too late
        bool isRestoring = false; ///< the stored file is being read
    };
    template <class What> void choose(ShapeSlot<What>& slot, const QString& path, Origin origin);
    template <class What> void setShape(ShapeSlot<What>& slot, const std::shared_ptr<const What>& what);
    template <class What>
    void refuse(ShapeSlot<What>& slot, const QString& path, Origin origin, const QString& problem);
    template <class What> void store(ShapeSlot<What>& slot);
    QString missingFileMessage(const core::Alpha*) const;
    QString missingFileMessage(const core::BrushModel*) const;
    void remember(const QString& path, const std::shared_ptr<const core::Alpha>& alpha);
    void remember(const QString&, const std::shared_ptr<const core::BrushModel>&) {}
    void save();

    BrushSettings* m_brush;
    Settings* m_settings;
    StoredShapes m_stored;
    QHash<QString, std::shared_ptr<const core::Alpha>> m_read;
    ShapeSlot<core::Alpha> m_alpha{&core::StrokeSettings::alpha, &StoredShapes::alpha, &StoredShapes::alphas,
                                   readAlpha};
    ShapeSlot<core::BrushModel> m_model{&core::StrokeSettings::model, &StoredShapes::model, &StoredShapes::models,
                                        readBrushModel};
    bool m_mayLoad = true;
    BackgroundThread m_background; ///< last
};
} // namespace ui
