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

/// A folder of models as pictures: to open, rename, duplicate, put into the trash, and show where they lie. Asks the
/// disk and draws in other threads, and only while it can be seen. Thread: gui.
class FileBrowser : public QWidget
{
    Q_OBJECT

public:
    /// Both must outlive the panel.
    FileBrowser(Settings* settings, const Actions& actions, QWidget* parent = nullptr);
    ~FileBrowser() override;

    void goTo(const QString& folder);
    const QString& folder() const { return m_options.folder; }
    /// Goes where the last model's file lies, if that is another place than at the last call and the panel is hidden.
    void followModel();
    /// The keyboard goes to the grid.
    void focusGrid();

Q_SIGNALS:
    void openRequested(const QString& path);
    void renamed(const QString& from, const QString& to);
    /// Files may be gone.
    void trashed();
    /// One sentence.
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
    /// `done`: after it, with what became of it.
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
    QString m_problem;                            ///< of the folder
    QString m_modelFolder;                        ///< at the last call of followModel()
    bool m_isListed = false, m_isStopped = false; ///< stopped: by hand, until another folder is looked at
    QStringList m_toSelect;                       ///< when they appear

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
    std::unique_ptr<ThumbnailMaker> m_maker; ///< from the first look on
    std::stop_source m_listing;
    BackgroundThread m_disk; ///< last
};

struct FileBrowserContext
{
    QMainWindow* window;
    QMenu* toggles;
    ModelFiles* opener; ///< of what is chosen
};

/// As a dock at the window's left, where it has the height, hidden at first, with its entry among the toggles.
void addFileBrowser(const FileBrowserContext& context, Settings* settings, const Actions& actions,
                    const std::function<void(const QString&)>& notice);
} // namespace ui
