#pragma once

#include "ui/files/file_entry.h"
#include "ui/model/insert_request.h"

#include "core/operations/starter_models.h"

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

/// Where models come from and where they go: the dialogs, drag and drop onto the window, and the question about changes
/// that no file holds. Opens and writes nothing: it asks by signals. Thread: gui.
class ModelFiles : public QObject
{
    Q_OBJECT

public:
    /// Neither is owned. In the settings the last folder and the last files are kept.
    ModelFiles(Settings* settings, QWidget* window);

    /// Into the File menu, which has its actions already: New and Open Recent. What the actions do is connected, too.
    void addMenus(QMenu* fileMenu, const Actions& actions);
    /// From now on nothing can be dropped on the window.
    void refuseDrops();
    /// True if the changes may be lost. If the person would rather save them, `proceed` is called when that is done.
    bool askToDiscard(const std::function<void()>& proceed);
    void setOpened(const ModelInfo& model);
    /// Asks what for, and where to.
    void exportFor(const ModelInfo& model);
    /// Asks for another place, as the model could not be written to that path.
    void saveElsewhere(const QString& path);
    void exportElsewhere(const QString& path);
    /// The present model has a file of its own now.
    void setSaved(const ModelInfo& model);
    /// Perhaps to the model's own file.
    void setExported(const QString& path);
    /// A file of the disk has another name now: perhaps the model's, perhaps one among the last.
    void setRenamed(const QString& from, const QString& to);
    /// Whether the model's file is still there; it is looked at by itself when the window comes to the front.
    void checkFile();

    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    /// The person does not want to lose changes, and saves nothing either.
    void discardDeclined();
    /// A local path; nothing about it is checked.
    void openRequested(const QString& path);
    void starterRequested(core::Starter starter);
    /// The file is the model's own, or a dialog has asked about overwriting. The ending says the format.
    void saveRequested(const QString& path);
    /// With at most so many triangles; 0: all. Perhaps a slicer tries it.
    void exportRequested(const QString& path, quint64 maxTriangles = 0, bool slices = false);
    /// A class report of the models in a folder.
    void reportRequested(const QString& folder, const QString& path);
    /// By drag and drop: a local path that is named like an image.
    void pictureDropped(const QString& path);
    void insertRequested(const ui::InsertRequest& insertion);
    /// The model's own file is called so now.
    void renamed(const QString& path);
    /// The model's own file is not there any more.
    void fileDeleted();
    /// One sentence.
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
    QString m_name, m_path; ///< of the model; no path: it comes from no file
    FileEntry m_file;       ///< at the path, when the model was read or written
    bool m_isFileDeleted = false;
    bool m_refusesDrops = false;
    bool m_formatNoticeShown = false;  ///< that the file does not hold all of the document
    std::function<void()> m_afterSave; ///< which was preferred to losing changes
};
} // namespace ui
