#include "app/lesson/lesson_autosave.h"

#include "core/lesson/lesson_file.h"
#include "core/util/file_error.h"

#include <algorithm>
#include <new>
#include <utility>

namespace app
{
namespace
{
constexpr int saveIntervalMs = 2000;
constexpr char fileName[] = "lesson.zip";
/// Is written for a required text that the author has not given yet: a lesson without it could not be read.
constexpr char standIn[] = "\u2026", standInLanguage[] = "en";

core::LessonDraft filled(core::LessonDraft draft)
{
    using Required = core::LessonDraft::Required;
    while (const auto missing = draft.missing()) {
        switch (missing->what) {
        case Required::Title:
            draft.setTitle(standInLanguage, standIn);
            break;
        case Required::Steps:
            draft.addStep();
            break;
        case Required::StepTitle:
            draft.setStepTitle(missing->step, standInLanguage, standIn);
            break;
        case Required::StepText:
            draft.setStepText(missing->step, standInLanguage, standIn);
            break;
        }
    }
    return draft;
}

void dropStandIn(core::LessonText& text)
{
    if (const auto found = text.words.find(standInLanguage); found != text.words.end() && found->second == standIn)
        text.words.erase(found);
}
} // namespace

/// Used only by the background thread after construction.
struct LessonAutosave::Target
{
    std::unique_ptr<core::JournalFolder> folder;
};

LessonAutosave::LessonAutosave(const std::filesystem::path& root, Unsaved unsaved)
    : m_root(root)
    , m_unsaved(std::move(unsaved))
    , m_abandoned(core::JournalFolder::abandoned(root))
{
    std::erase_if(m_abandoned, [](const auto& folder) {
        std::error_code problem;
        if (std::filesystem::exists(folder->path() / fileName, problem))
            return false;
        folder->remove();
        return true;
    });
    std::ranges::sort(m_abandoned, std::greater(), [](const auto& folder) {
        std::error_code problem;
        return std::filesystem::last_write_time(folder->path() / fileName, problem);
    });
    connect(&m_timer, &QTimer::timeout, this, &LessonAutosave::saveIfChanged);
    m_timer.start(saveIntervalMs);
}

/// Removes the file. After a regular end, unsaved changes have been discarded.
LessonAutosave::~LessonAutosave()
{
    m_background.run([target = m_target] {
        if (target && target->folder)
            target->folder->remove();
    });
}

QStringList LessonAutosave::abandoned() const
{
    QStringList files;
    for (const auto& folder : m_abandoned)
        files << QString::fromStdU16String((folder->path() / fileName).u16string());
    return files;
}

core::Lesson LessonAutosave::withoutStandIns(core::Lesson lesson)
{
    dropStandIn(lesson.title);
    for (core::LessonStep& step : lesson.steps) {
        dropStandIn(step.title);
        dropStandIn(step.text);
    }
    return lesson;
}

void LessonAutosave::adopt(const QString& file)
{
    const auto found = std::ranges::find_if(m_abandoned, [&](const auto& folder) {
        return folder->path() / fileName == std::filesystem::path(file.toStdU16String());
    });
    if (found == m_abandoned.end())
        return;
    m_target = std::make_shared<Target>(Target{std::move(*found)});
    m_abandoned.erase(found);
    m_revision = 0;
}

void LessonAutosave::saveIfChanged()
{
    const core::LessonDraft* const draft = m_unsaved();
    if (!draft) {
        m_background.run([target = std::exchange(m_target, nullptr)] {
            if (target && target->folder)
                target->folder->remove();
        });
        return;
    }
    if (m_target && draft->revision() == m_revision)
        return;
    if (!m_target)
        m_target = std::make_shared<Target>();
    m_revision = draft->revision();
    m_background.run([target = m_target, root = m_root, draft = *draft] {
        try {
            if (!target->folder)
                target->folder = core::JournalFolder::make(root);
            core::writeLesson(target->folder->path() / fileName, filled(draft).complete({}));
        } catch (const core::FileError&) { // the earlier file remains
        } catch (const std::bad_alloc&) {
        }
    });
}
} // namespace app
