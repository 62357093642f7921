#pragma once

#include "ui/files/file_jobs.h"
#include "ui/settings/file_browser_settings.h"
#include "ui/util/background_thread.h"

#include <QFileSystemWatcher>
#include <QTimer>
#include <QWidget>

#include <functional>
#include <memory>

class QAction;
class QComboBox;
class QLabel;
class QLayout;
class QLineEdit;
class QMainWindow;
class QMenu;
class QSlider;
class QToolButton;

namespace ui
{
class Actions;
class FileGrid;
class FileListModel;
class FileSorter;
class ModelFiles;
class Settings;
class ThumbnailMaker;
struct Thumbnail;

/// A panel that shows the models of a folder as pictures. Commands open, rename, duplicate, trash and reveal a file.
/// Reads the disk and draws on other threads, and only while visible. Thread: gui.
class FileBrowser : public QWidget
{
    Q_OBJECT

public:
    /// Precondition: `settings` and `actions` outlive the panel.
    FileBrowser(Settings* settings, const Actions& actions, QWidget* parent = nullptr);
    ~FileBrowser() override;

    void goTo(const QString& folder);
    const QString& folder() const { return m_options.folder; }
    /// Goes to the folder of the file opened or exported last, if it is another folder than in the previous call and
    /// the panel is hidden.
    void followModel();
    /// Gives the keyboard focus to the grid.
    void focusGrid();

Q_SIGNALS:
    void openRequested(const QString& path);
    void renamed(const QString& from, const QString& to);
    /// Files were moved to the trash.
    void trashed();
    /// There is a message for the user.
    void noticed(const QString& sentence);

protected:
    bool event(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    using FileJob = std::function<FileOutcome()>;

    QLayout* buildFolderLine();
    QLayout* buildChoices();
    QLayout* buildFoot();
    void buildGrid();
    void buildActions();
    QAction* on(const char* id, const std::function<void()>& what);
    void showMenu(QPoint at);
    void renameTo(const QString& path, const QString& name);

    void setControls(const FileBrowserSettings& options);
    void choose();
    void list();
    void setFolderContent(const FolderContent& content);
    void select(const QStringList& paths);
    /// Runs a job on the disk thread, then lists the folder again. `done`: called with the outcome.
    void change(const FileJob& job, const std::function<void(const FileOutcome&)>& done = {});
    void requestThumbnails();
    void setThumbnail(const FileEntry& file, const Thumbnail& thumbnail);
    void showState();
    void enable();
    void activate(const QModelIndex& index);
    QStringList chosenFiles() const;

    Settings* m_settings;
    const Actions& m_actions;
    FileBrowserSettings m_options;
    QString m_problem;     ///< why the folder cannot be listed; empty: none
    QString m_modelFolder; ///< Settings::lastFolder() at the previous call of followModel()
    /// m_isStopped: the user has stopped the thumbnails, until another folder is shown or the panel is shown again.
    bool m_isListed = false, m_isStopped = false;
    QStringList m_toSelect; ///< paths to select once they are listed

    FileListModel* m_files;
    FileSorter* m_sorter;
    FileGrid* m_grid;
    QLineEdit *m_place, *m_filter;
    QComboBox* m_order;
    QToolButton *m_direction, *m_stop;
    QSlider* m_size;
    QLabel *m_state, *m_empty;
    QAction *m_open = nullptr, *m_rename = nullptr, *m_duplicate = nullptr, *m_trash = nullptr, *m_reveal = nullptr,
            *m_up = nullptr, *m_chooseFolder = nullptr;

    QFileSystemWatcher m_watcher;
    QTimer m_listTimer, m_thumbnailTimer;
    std::unique_ptr<ThumbnailMaker> m_maker; ///< created at first use
    std::stop_source m_listing;
    BackgroundThread m_disk; ///< last member: destroyed first, because its jobs use the other members
};

struct FileBrowserContext
{
    QMainWindow* window;
    QMenu* toggles;
    ModelFiles* opener; ///< opens the chosen files
};

/// Adds the panel as a dock at the left of the window, hidden at first, with its toggle in the menu. `notice` shows a
/// short message.
void addFileBrowser(const FileBrowserContext& context, Settings* settings, const Actions& actions,
                    const std::function<void(const QString&)>& notice);
} // namespace ui
