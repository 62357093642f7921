#pragma once

#include "ui/brush/brush_files.h"
#include "ui/brush/tool_alphas.h"
#include "ui/settings/settings.h"
#include "ui/util/background_thread.h"

#include <QHash>
#include <QObject>

namespace ui
{
/// The effect that choosing an alpha has on the tool's spacing. Readable: with the tool's first alpha prints stand side
/// by side, and without one dabs are dense again.
enum class AlphaSpacing { Readable, Kept };

/// Which alpha each tool and which model the brush has: reads their files on a thread, and keeps what was chosen in the
/// settings. Thread: gui.
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

    /// Gives the tool that is in the hand a name of core::builtInAlphas(), or a path, which takes effect when it was
    /// read; empty: none.
    void chooseAlpha(const QString& source, AlphaSpacing spacing = AlphaSpacing::Readable);
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
    void setAlpha(core::Tool tool, const std::shared_ptr<const core::Alpha>& alpha, AlphaSpacing spacing);
    void readModel(const QString& path, Origin origin);
    void setModel(const std::shared_ptr<const core::BrushModel>& model);
    void storeModel();
    /// Refuses a file that the user chose.
    void refuse(QStringList StoredShapes::*files, const QString& path, const QString& problem);
    void remember(const QString& path, const std::shared_ptr<const core::Alpha>& alpha);
    void save();

    BrushSettings* m_brush;
    Settings* m_settings;
    StoredShapes m_stored;
    QHash<QString, std::shared_ptr<const core::Alpha>> m_read;
    ToolAlphas m_alphas;
    int m_alphaRequest = 0, m_modelRequest = 0; ///< what was read for an earlier one is too late
    bool m_isRestoringModel = false;            ///< the stored file is being read
    bool m_mayLoad = true;
    BackgroundThread m_background; ///< last
};
} // namespace ui
