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
constexpr int lookMs = 2000;
constexpr char fileName[] = "lesson.zip";
/// In the place of words that a lesson must have and has not yet: a reader takes no lesson without.
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

/// From its beginning on the aside thread's alone.
struct LessonKeeper::Place
{
    std::unique_ptr<core::JournalFolder> folder;
};

LessonKeeper::LessonKeeper(const std::filesystem::path& root, Unsaved unsaved)
    : m_root(root)
    , m_unsaved(std::move(unsaved))
    , m_left(core::JournalFolder::abandoned(root))
{
    std::erase_if(m_left, [](const auto& folder) {
        std::error_code problem;
        if (std::filesystem::exists(folder->path() / fileName, problem))
            return false;
        folder->remove();
        return true;
    });
    std::ranges::sort(m_left, std::greater(), [](const auto& folder) {
        std::error_code problem;
        return std::filesystem::last_write_time(folder->path() / fileName, problem);
    });
    connect(&m_clock, &QTimer::timeout, this, &LessonKeeper::look);
    m_clock.start(lookMs);
}

/// In order: what is not saved was given up.
LessonKeeper::~LessonKeeper()
{
    m_aside.run([place = m_place] {
        if (place && place->folder)
            place->folder->remove();
    });
}

QStringList LessonKeeper::left() const
{
    QStringList files;
    for (const auto& folder : m_left)
        files << QString::fromStdU16String((folder->path() / fileName).u16string());
    return files;
}

core::Lesson LessonKeeper::withoutStandIns(core::Lesson lesson)
{
    dropStandIn(lesson.title);
    for (core::LessonStep& step : lesson.steps) {
        dropStandIn(step.title);
        dropStandIn(step.text);
    }
    return lesson;
}

void LessonKeeper::takeOver(const QString& file)
{
    const auto found = std::ranges::find_if(m_left, [&](const auto& folder) {
        return folder->path() / fileName == std::filesystem::path(file.toStdU16String());
    });
    if (found == m_left.end())
        return;
    m_place = std::make_shared<Place>(Place{std::move(*found)});
    m_left.erase(found);
    m_revision = 0;
}

void LessonKeeper::look()
{
    const core::LessonDraft* const draft = m_unsaved();
    if (!draft) {
        m_aside.run([place = std::exchange(m_place, nullptr)] {
            if (place && place->folder)
                place->folder->remove();
        });
        return;
    }
    if (m_place && draft->revision() == m_revision)
        return;
    if (!m_place)
        m_place = std::make_shared<Place>();
    m_revision = draft->revision();
    m_aside.run([place = m_place, root = m_root, draft = *draft] {
        try {
            if (!place->folder)
                place->folder = core::JournalFolder::make(root);
            core::writeLesson(place->folder->path() / fileName, filled(draft).complete({}));
        } catch (const core::FileError&) { // what was kept before stays
        } catch (const std::bad_alloc&) {
        }
    });
}
} // namespace app
