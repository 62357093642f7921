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
/// Keeps the lesson in the making in a file, a few seconds behind, until it is saved or given up: what ends the program
/// leaves it there for the next one. Where nothing can be written nothing is kept. Gui thread; never throws.
class LessonKeeper : public QObject
{
public:
    /// What is not saved; null: nothing is.
    using Unsaved = std::function<const core::LessonDraft*()>;

    LessonKeeper(const std::filesystem::path& root, Unsaved unsaved);
    ~LessonKeeper() override;

    /// What programs before left, the latest first.
    QStringList left() const;
    /// One of those as it was: it had to be given words that it lacked.
    static core::Lesson withoutStandIns(core::Lesson lesson);
    /// That one is what is not saved from now on.
    void takeOver(const QString& file);

private:
    struct Place;

    void look();

    std::filesystem::path m_root;
    Unsaved m_unsaved;
    std::vector<std::unique_ptr<core::JournalFolder>> m_left;
    std::shared_ptr<Place> m_place; ///< of our own; null: nothing is kept
    std::uint64_t m_revision = 0;   ///< that is kept
    QTimer m_clock;
    ui::BackgroundThread m_aside; ///< last
};
} // namespace app
