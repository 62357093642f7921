#include "core/lesson/lesson_draft.h"

#include <algorithm>
#include <cassert>

namespace core
{
namespace
{
constexpr std::string_view spaces = " \t\r\n";

/// Returns the file name for the step's strokes or picture; numbers in names start at 1.
std::string nameOf(std::size_t step, const char* ending)
{
    return "step-" + std::to_string(step + 1) + ending;
}

/// Returns whether nameOf() could have made this picture name, for any step.
bool isMadeName(std::string_view name)
{
    if (!name.starts_with("step-") || !name.ends_with(".png") || name.size() < 10)
        return false;
    name = name.substr(5, name.size() - 9);
    return std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; });
}

bool asksNothing(const FactBounds& bounds)
{
    return bounds.min <= 0 && bounds.max == FactBounds::unbounded;
}
} // namespace

LessonStep& LessonDraft::change(std::size_t step)
{
    assert(step < steps());
    ++m_revision;
    return m_lesson.steps[step];
}

std::size_t LessonDraft::strokes() const
{
    std::size_t count = 0;
    for (const LessonStep& step : m_lesson.steps)
        count += step.strokes.size();
    return count;
}

void LessonDraft::setWords(LessonText& text, const std::string& language, std::string_view words)
{
    ++m_revision;
    if (words.find_first_not_of(spaces) == std::string_view::npos)
        text.words.erase(language);
    else
        text.words[language] = words;
}

void LessonDraft::setTitle(const std::string& language, std::string_view words)
{
    setWords(m_lesson.title, language, words);
}

void LessonDraft::setSummary(const std::string& language, std::string_view words)
{
    setWords(m_lesson.summary, language, words);
}

void LessonDraft::setStepTitle(std::size_t step, const std::string& language, std::string_view words)
{
    setWords(change(step).title, language, words);
}

void LessonDraft::setStepText(std::size_t step, const std::string& language, std::string_view words)
{
    setWords(change(step).text, language, words);
}

void LessonDraft::addStep()
{
    m_lesson.steps.emplace_back();
    ++m_revision;
}

void LessonDraft::removeStep(std::size_t step)
{
    change(step);
    m_lesson.steps.erase(m_lesson.steps.begin() + static_cast<std::ptrdiff_t>(step));
}

void LessonDraft::moveStep(std::size_t from, std::size_t to)
{
    assert(to < steps());
    LessonStep moved = std::move(change(from));
    m_lesson.steps.erase(m_lesson.steps.begin() + static_cast<std::ptrdiff_t>(from));
    m_lesson.steps.insert(m_lesson.steps.begin() + static_cast<std::ptrdiff_t>(to), std::move(moved));
}

void LessonDraft::setTools(std::size_t step, std::vector<Tool> tools)
{
    std::ranges::sort(tools);
    if (tools.size() == toolNames().size())
        tools.clear();
    change(step).tools = std::move(tools);
}

void LessonDraft::setFact(std::size_t step, const FactBounds& bounds)
{
    std::vector<FactBounds>& facts = change(step).checkpoint.facts;
    std::erase_if(facts, [&](const FactBounds& former) { return former.fact == bounds.fact; });
    if (!asksNothing(bounds))
        facts.insert(std::ranges::upper_bound(facts, bounds.fact, {}, &FactBounds::fact), bounds);
}

std::optional<FactBounds> LessonDraft::fact(std::size_t step, Fact fact) const
{
    const std::vector<FactBounds>& facts = this->step(step).checkpoint.facts;
    const auto found = std::ranges::find(facts, fact, &FactBounds::fact);
    return found == facts.end() ? std::nullopt : std::optional(*found);
}

void LessonDraft::setTolerance(std::size_t step, double tolerance)
{
    std::optional<CheckpointTarget>& target = change(step).checkpoint.target;
    if (tolerance <= 0)
        target.reset();
    else if (target)
        target->tolerance = tolerance;
    else
        target = CheckpointTarget{{}, tolerance};
}

void LessonDraft::addStroke(std::size_t step, FileEntry entry, const std::optional<LessonView>& view)
{
    LessonStep& changed = change(step);
    if (changed.strokes.empty() && view)
        changed.view = view;
    changed.strokes.push_back(std::move(entry));
}

FileEntry LessonDraft::takeLastStroke(std::size_t step)
{
    std::vector<FileEntry>& strokes = change(step).strokes;
    assert(!strokes.empty());
    FileEntry last = std::move(strokes.back());
    strokes.pop_back();
    return last;
}

void LessonDraft::cutStroke(std::size_t step, std::size_t stroke)
{
    std::vector<FileEntry>& strokes = change(step).strokes;
    assert(stroke < strokes.size());
    strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(stroke));
}

std::optional<LessonDraft::Missing> LessonDraft::missing() const
{
    if (m_lesson.title.words.empty())
        return Missing{Required::Title};
    if (m_lesson.steps.empty())
        return Missing{Required::Steps};
    for (std::size_t i = 0; i < steps(); ++i) {
        if (step(i).title.words.empty())
            return Missing{Required::StepTitle, i};
        if (step(i).text.words.empty())
            return Missing{Required::StepText, i};
    }
    return {};
}

bool LessonDraft::makesPicture(std::size_t step) const
{
    return this->step(step).picture.empty() || isMadeName(this->step(step).picture);
}

Lesson LessonDraft::complete(const std::vector<std::string>& pictures) const
{
    Lesson lesson = m_lesson;
    lesson.files.clear();
    const auto keep = [&](const std::string& name) {
        if (!name.empty())
            lesson.files[name] = m_lesson.files.at(name);
    };
    if (const auto* const file = std::get_if<std::string>(&lesson.start))
        keep(*file);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        LessonStep& step = lesson.steps[i];
        step.strokesFile = step.strokes.empty() ? std::string() : nameOf(i, ".json");
        if (step.checkpoint.target)
            keep(step.checkpoint.target->file);
        if (!makesPicture(i)) {
            keep(step.picture);
            continue;
        }
        step.picture = i < pictures.size() && !pictures[i].empty() ? nameOf(i, ".png") : std::string();
        if (!step.picture.empty())
            lesson.files[step.picture] = pictures[i];
    }
    return lesson;
}
} // namespace core
