#pragma once

#include "ui/files/file_entry.h"
#include "ui/model/insert_request.h"
#include "ui/settings/export_settings.h"

#include "core/primitives/starter_models.h"

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
struct ModelInfo;

/// File dialogs of models, drag and drop onto the window, and the question about unsaved changes. Opens and writes
/// nothing itself, but requests it by signals. Thread: gui.
class ModelFiles : public QObject
{
    Q_OBJECT

public:
    /// `settings` and `window` are not owned. Settings store the last folder and the recent files.
    ModelFiles(Settings* settings, QWidget* window);

    /// Adds New and Open Recent to the File menu, which already contains the actions, and connects the actions.
    void addMenus(QMenu* fileMenu, const Actions& actions);
    /// Disables drops on the window for good.
    void refuseDrops();
    /// Asks whether unsaved changes may be discarded and returns true if so. If the user prefers to save, `proceed` is
    /// called after saving.
    bool askToDiscard(const std::function<void()>& proceed);
    void setOpened(const ModelInfo& model);
    /// Asks for purpose and file of an export.
    void exportFor(const ModelInfo& model);
    /// Asks for another file, because the model could not be written to `path`.
    void saveElsewhere(const QString& path);
    void exportElsewhere(const QString& path);
    /// The model was saved to its file, which may be new.
    void setSaved(const ModelInfo& model);
    /// A file was exported; it may be the model's own file.
    void setExported(const QString& path);
    /// A file was renamed on disk; updates the model's path and the recent files.
    void setRenamed(const QString& from, const QString& to);
    /// Checks whether the model's file still exists. Also called when the window is activated.
    void checkFile();

    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    /// The user has answered the question about unsaved changes with Cancel.
    void discardDeclined();
    /// `path`: local path, unchecked.
    void openRequested(const QString& path);
    void starterRequested(core::Starter starter);
    /// The path is the model's own file, or the user has agreed to overwriting. Its suffix is the format.
    void saveRequested(const QString& path);
    void exportRequested(const QString& path, const ui::ExportSettings& options = {});
    /// `answer` is to be called with whether visible parts of the model overlap.
    void overlapAsked(const std::function<void(bool doOverlap)>& answer);
    /// A report on the models in `folder` is to be written to `path`.
    void reportRequested(const QString& folder, const QString& path);
    /// A file with the suffix of an image was dropped. `path`: local path.
    void pictureDropped(const QString& path);
    void insertRequested(const ui::InsertRequest& insertion);
    /// The model's own file was renamed to `path`.
    void renamed(const QString& path);
    /// The model's own file no longer exists.
    void fileDeleted();
    /// There is a message for the user.
    void noticed(const QString& sentence);

private:
    void open();
    void insert();
    void save();
    void askToOverwrite();
    void saveAs(const QString& folder, const QString& name);
    void saveCopy();
    void exportAs(const QString& folder, const QString& name);
    void report();
    void showRecent();
    void openDropped(const QString& path);
    void remember(const QString& path);

    Settings* m_settings;
    QWidget* m_window;
    QMenu* m_recent = nullptr;
    QAction* m_revert = nullptr;
    QString m_name, m_path; ///< name and path of the model; empty path: not read from a file
    FileEntry m_file;       ///< state of the file when the model was read or written
    bool m_isFileDeleted = false;
    bool m_refusesDrops = false;
    bool m_formatNoticeShown = false;  ///< the user was told that the file's format does not store the whole document
    std::function<void()> m_afterSave; ///< continuation after saving, set by askToDiscard()
};
} // namespace ui
