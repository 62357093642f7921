#pragma once

#include "core/journal/journal_folder.h"
#include "core/lesson/lesson_draft.h"
#include "ui/util/background_thread.h"

#include <QObject>
#include <QStringList>
#include <QTimer>

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace app
{
/// Autosaves the edited lesson every two seconds until it is saved or discarded. After a crash, the file is there for
/// the next run. Does nothing if the disk cannot be written. Thread: gui. Never throws.
class LessonAutosave : public QObject
{
public:
    /// A callback that returns the draft with unsaved changes; null: there are none.
    using Unsaved = std::function<const core::LessonDraft*()>;

    LessonAutosave(const std::filesystem::path& root, Unsaved unsaved);
    ~LessonAutosave() override;

    /// Returns the files left by earlier runs, the latest first.
    QStringList abandoned() const;
    /// Removes the ellipsis that the file contains for each missing title and text.
    static core::Lesson withoutStandIns(core::Lesson lesson);
    /// Continues autosaving to `file`, which an earlier run left.
    void adopt(const QString& file);

private:
    struct Target;

    void saveIfChanged();

    std::filesystem::path m_root;
    Unsaved m_unsaved;
    std::vector<std::unique_ptr<core::JournalFolder>> m_abandoned;
    std::shared_ptr<Target> m_target; ///< folder of this run's file; null: there is no file
    std::uint64_t m_revision = 0;     ///< revision of the draft that was saved last
    QTimer m_timer;
    ui::BackgroundThread m_background; ///< last member: its destructor waits for jobs that use the other members
};
} // namespace app
