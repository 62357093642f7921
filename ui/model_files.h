#pragma once

#include "core/model_command.h"
#include "core/starter_models.h"

#include <QObject>
#include <QString>

#include <functional>

class QAction;
class QMenu;
class QMimeData;
class QWidget;

namespace ui
{
class Actions;
class Settings;

/// Where models come from and where they go: the dialogs, drag and drop onto the window, and the question about changes
/// that no file holds. Opens and writes nothing: it asks by signals. Gui thread.
class ModelFiles : public QObject
{
    Q_OBJECT

public:
    /// Neither is owned. In the settings the last folder and the last files are kept.
    ModelFiles(Settings* settings, QWidget* window);

    /// Into the File menu, which has its actions already: New and Open Recent.
    void addMenus(QMenu* fileMenu, const Actions& actions);
    void open();
    void insert();
    /// `name`: of the present model.
    void exportAs(const QString& name);
    /// True if the changes may be lost. If the person would rather export them, `goOn` is called when that is done.
    bool askToDiscard(const QString& name, const std::function<void()>& goOn);
    /// A model is open now; its path is empty if it comes from no file.
    void setOpened(const QString& path);
    /// An export was written.
    void finishExport();

    /// Nothing can be dropped meanwhile.
    void setBusy(bool isBusy);

    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    /// A local path; nothing about it is checked.
    void openRequested(const QString& path);
    void starterRequested(core::Starter starter);
    /// The dialog has asked about overwriting. The ending says the format.
    void exportRequested(const QString& path);
    void insertRequested(const QString& path, const core::Insert& how);

private:
    void showRecent();
    void enable();
    bool mayDrop(const QMimeData* data) const;
    void remember(const QString& path);

    Settings* m_settings;
    QWidget* m_window;
    QMenu* m_recent = nullptr;
    QAction* m_revert = nullptr;
    QString m_path;
    std::function<void()> m_afterExport; ///< of an export that was preferred to losing changes
    bool m_isBusy = false;
};
} // namespace ui
