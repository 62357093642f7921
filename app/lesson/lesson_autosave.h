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
/// Autosaves the edited lesson every few seconds until it is saved or discarded; if the program ends otherwise, the
/// file is there for the next run. Does nothing where nothing can be written. Thread: gui; never throws.
class LessonAutosave : public QObject
{
public:
    /// Returns the draft with unsaved changes; null: there are none.
    using Unsaved = std::function<const core::LessonDraft*()>;

    LessonAutosave(const std::filesystem::path& root, Unsaved unsaved);
    ~LessonAutosave() override;

    /// The files that earlier runs left, the latest first.
    QStringList abandoned() const;
    /// Removes the ellipsis that stands in the file for each title and text not yet written.
    static core::Lesson withoutStandIns(core::Lesson lesson);
    /// Continues that file: from now on it holds the unsaved lesson.
    void adopt(const QString& file);

private:
    struct Target;

    void saveIfChanged();

    std::filesystem::path m_root;
    Unsaved m_unsaved;
    std::vector<std::unique_ptr<core::JournalFolder>> m_abandoned;
    std::shared_ptr<Target> m_target; ///< of this run; null: there is no file
    std::uint64_t m_revision = 0;     ///< that is kept
    QTimer m_timer;
    ui::BackgroundThread m_background; ///< last
};
} // namespace app
