#pragma once

#include "brush_files.h"
#include "settings.h"
#include "side_thread.h"

#include <QHash>
#include <QObject>

namespace ui
{
/// Which alpha and which model the brush has: reads their files on a thread, and keeps what was chosen in the settings. Gui thread.
class BrushShapes : public QObject
{
    Q_OBJECT

public:
    /// Both must outlive this.
    BrushShapes(BrushSettings* brush, Settings* settings, QObject* parent = nullptr);
    ~BrushShapes() override;

    /// What the settings name; a file that is gone or broken gives none.
    void restore();

    /// A name of core::builtInAlphas(), or a path, which takes effect when it was read; empty: none.
    void chooseAlpha(const QString& source);
    /// A path; empty: a ball.
    void chooseModel(const QString& path);

    /// Whether other files may be chosen than those that were before; at first they may.
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
    /// In one sentence why a file is not taken; the brush is what it was.
    void refused(const QString& sentence);

private:
    enum class Asked { ByHand, ByRestoring };
    void readAlpha(const QString& path, Asked asked);
    void take(const std::shared_ptr<const core::Alpha>& alpha);
    void keep();

    BrushSettings* m_brush;
    Settings* m_settings;
    StoredShapes m_stored;
    QHash<QString, std::shared_ptr<const core::Alpha>> m_read;
    bool m_mayLoad = true;
    bool m_isRestoring = false;               ///< the stored alpha's file is being read
    int m_askedAlphas = 0, m_askedModels = 0; ///< what was read for an earlier question is too late
    SideThread m_aside;                       ///< last
};
} // namespace ui
