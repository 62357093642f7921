#include "app/lesson/lesson_recorder.h"

#include "app/document/document.h"

#include "core/sculpt/deform/alpha.h"
#include "core/sculpt/deform/brush_model.h"

namespace app
{
namespace
{
/// Returns whether the step needs a file besides the lesson, which pupils do not have.
bool needsFile(const core::FileEntry& entry)
{
    if (const auto* const command = std::get_if<core::FileCommand>(&entry)) {
        const auto* const insertion = std::get_if<core::Insert>(&command->command);
        return insertion && !insertion->primitive;
    }
    const core::Stroke& stroke = std::get<core::Stroke>(entry);
    const core::StrokeSettings& settings = stroke.settings;
    return settings.model || (settings.alpha && !settings.alpha->isBuiltIn()) || !stroke.model.file.empty() ||
           !stroke.alpha.file.empty();
}
} // namespace

LessonRecorder::LessonRecorder(Document& document) : m_document(&document)
{
    connect(&document, &Document::stepped, this, &LessonRecorder::add);
    connect(&document.history().stack(), &QUndoStack::indexChanged, this, &LessonRecorder::onIndexChanged);
}

void LessonRecorder::begin(core::LessonDraft* draft, std::function<std::optional<core::LessonView>()> view)
{
    m_draft = draft;
    m_view = std::move(view);
    m_steps.clear();
    m_undone.clear();
}

void LessonRecorder::end()
{
    m_draft = nullptr;
}

/// Adds a new stroke. The undo stack has already reported the new length, which onIndexChanged() may have taken for a
/// redo.
void LessonRecorder::add(const core::FileEntry& entry)
{
    if (!isOn())
        return;
    while (static_cast<int>(m_steps.size()) >= m_document->history().stack().index())
        removeLast();
    m_undone.clear();
    m_steps.push_back(m_draft->steps() - 1);
    m_draft->addStroke(m_steps.back(), entry, m_view());
    refuseUnfit();
    Q_EMIT recorded();
}

void LessonRecorder::onIndexChanged(int index)
{
    if (!isOn())
        return;
    if (m_document->history().stack().count() == 0) { // the history was cleared; the recorded strokes stay
        end();
        return Q_EMIT ended();
    }
    while (static_cast<int>(m_steps.size()) > index)
        removeLast();
    while (static_cast<int>(m_steps.size()) < index && !m_undone.empty()) {
        m_steps.push_back(m_undone.back().step);
        m_draft->addStroke(m_steps.back(), std::move(m_undone.back().entry));
        m_undone.pop_back();
    }
    refuseUnfit();
    Q_EMIT recorded();
}

void LessonRecorder::removeLast()
{
    m_undone.push_back({m_draft->takeLastStroke(m_steps.back()), m_steps.back()});
    m_steps.pop_back();
}

void LessonRecorder::refuseUnfit()
{
    if (m_steps.empty() || !needsFile(m_draft->step(m_steps.back()).strokes.back()))
        return;
    QMetaObject::invokeMethod(&m_document->history(), &DocumentHistory::undo, Qt::QueuedConnection);
    Q_EMIT refused();
}
} // namespace app
