#pragma once

#include "app/document/document.h"

#include "core/stroke/stroke_edit.h"
#include "ui/brush/stroke_edit_bar.h"

#include <QElapsedTimer>
#include <QPointer>

namespace ui
{
class MainWindow;
}

namespace app
{
/// Changes the brush of the last stroke after the fact: Edit > Edit Last Stroke. Each change replaces the stroke, as
/// one step; of the changes made meanwhile only the newest is applied. Any other change of the model ends the edit.
/// Thread: gui.
class StrokeEdit : public QObject
{
    Q_OBJECT

public:
    /// Both must outlive it but for the window: a child of the document.
    StrokeEdit(ui::MainWindow& window, Document& document);

private:
    void begin();
    QList<ui::ToolOption> offeredTools() const;
    void requestBrush(const core::BrushChange& brush);
    void accept();
    void cancel();
    void proceed();
    void replaceStroke(const core::BrushChange& brush);
    void finish();
    void onReplaced(const std::optional<StrokeReport>& report);
    void checkHistory();
    void end();

    QPointer<ui::MainWindow> m_window;
    QPointer<ui::StrokeEditBar> m_bar;
    Document* m_document;
    std::optional<LastStroke::Step> m_stroke;     ///< before the edit; none: no stroke is edited
    std::optional<core::BrushChange> m_requested; ///< not applied yet
    core::BrushChange m_present;                  ///< what the model shows, or will after the present replacement
    int m_index = 0;                              ///< of the undo stack, between replacements
    bool m_isReplacing = false, m_isClosing = false;
    std::stop_source m_stop; ///< of the present replacement
    QElapsedTimer m_sinceBegin;
};
} // namespace app
