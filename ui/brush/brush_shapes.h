#pragma once

#include "ui/brush/brush_files.h"
#include "ui/brush/tool_alphas.h"
#include "ui/settings/settings.h"
#include "ui/util/background_thread.h"

#include <QHash>
#include <QObject>

namespace ui
{
/// Effect of choosing an alpha on the tool's spacing. Readable: the first alpha of a tool sets a spacing at which
/// prints do not overlap; removing the alpha restores the default spacing.
enum class AlphaSpacing { Readable, Kept };

/// The alpha of each tool and the model of Stamp: reads their files on a background thread and stores the choice in the
/// settings. Thread: gui.
class BrushShapes : public QObject
{
    Q_OBJECT

public:
    /// Precondition: `brush` and `settings` outlive this object.
    BrushShapes(BrushSettings* brush, Settings* settings, QObject* parent = nullptr);
    ~BrushShapes() override;

    /// Reads the files named in the settings. A missing or damaged file gives no shape, is reported by refused(), and
    /// is no longer the stored choice.
    void restore();

    /// Sets the alpha of the current tool. `source`: a name of core::builtInAlphas(), or a path, whose file is read
    /// first; empty: no alpha.
    void chooseAlpha(const QString& source, AlphaSpacing spacing = AlphaSpacing::Readable);
    /// Reads the model of Stamp from a path; empty: a ball.
    void chooseModel(const QString& path);
    /// Requests the document's current model as the brush's shape, by ownModelRequested().
    void chooseOwnModel() { Q_EMIT ownModelRequested(); }

    /// Returns true if the user may choose any file, not only recent ones and the document's model. Initially true.
    bool mayLoad() const { return m_mayLoad; }
    void setMayLoad(bool mayLoad);
    /// Recently chosen files, the latest first.
    const QStringList& alphas() const { return m_stored.alphas; }
    const QStringList& models() const { return m_stored.models; }
    /// Returns null if the alpha has not been read yet.
    std::shared_ptr<const core::Alpha> alpha(const QString& source) const;

Q_SIGNALS:
    /// The choice or the lists of files have changed.
    void changed();
    void ownModelRequested();
    /// A file was refused, and the brush is unchanged. `sentence`: the reason.
    void refused(const QString& sentence);

private:
    enum class Origin { User, Restore };
    void setAlpha(core::Tool tool, const std::shared_ptr<const core::Alpha>& alpha, AlphaSpacing spacing);
    void readModel(const QString& path, Origin origin);
    void setModel(const std::shared_ptr<const core::BrushModel>& model);
    void storeModel();
    /// Removes a file that the user chose from the list and reports the problem.
    void refuse(QStringList StoredShapes::*files, const QString& path, const QString& problem);
    void remember(const QString& path, const std::shared_ptr<const core::Alpha>& alpha);
    void save();

    BrushSettings* m_brush;
    Settings* m_settings;
    StoredShapes m_stored;
    QHash<QString, std::shared_ptr<const core::Alpha>> m_read;
    ToolAlphas m_alphas;
    /// Numbers of the latest requests; results of earlier requests are dropped.
    int m_alphaRequest = 0, m_modelRequest = 0;
    bool m_isRestoringModel = false; ///< the stored model file is being read
    bool m_mayLoad = true;
    BackgroundThread m_background; ///< last member: destroyed first, because its jobs use the other members
};
} // namespace ui
