#pragma once

#include "core/model_command.h"

#include <QObject>
#include <QString>

#include <functional>

class QMimeData;
class QWidget;

namespace ui
{
class Settings;

/// Where models come from and where they go: the dialogs, drag and drop onto the window, and the question about changes
/// that no file holds. Opens and writes nothing: it asks by signals. Gui thread.
class ModelFiles : public QObject
{
    Q_OBJECT

public:
    /// Neither is owned. In the settings the last folder is kept.
    ModelFiles(Settings* settings, QWidget* window);

    void open();
    void insert();
    /// `name`: of the present model.
    void exportAs(const QString& name);
    /// True if the changes may be lost. If the person would rather export them, `goOn` is called when that is done.
    bool askToDiscard(const QString& name, const std::function<void()>& goOn);
    /// An export was written.
    void finishExport();

    /// Nothing can be dropped meanwhile.
    void setBusy(bool isBusy) { m_isBusy = isBusy; }

    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    /// A local path; nothing about it is checked.
    void openRequested(const QString& path);
    /// The dialog has asked about overwriting. The ending says the format.
    void exportRequested(const QString& path);
    void insertRequested(const QString& path, const core::Insert& how);

private:
    bool mayDrop(const QMimeData* data) const;
    void remember(const QString& path);

    Settings* m_settings;
    QWidget* m_window;
    std::function<void()> m_afterExport; ///< of an export that was preferred to losing changes
    bool m_isBusy = false;
};
} // namespace ui
