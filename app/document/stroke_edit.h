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
/// Changes the brush of the last stroke afterwards (Edit > Edit Last Stroke). Each change replaces the stroke, still as
/// one step. If several changes are made during a replacement, only the newest is applied. Any other change of the
/// model ends the edit. Thread: gui.
class StrokeEdit : public QObject
{
    Q_OBJECT

public:
    /// A child of the document. The document must outlive it; the window need not.
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
    std::optional<LastStroke::Step> m_stroke;     ///< the stroke before the edit; none: no edit in progress
    std::optional<core::BrushChange> m_requested; ///< requested brush that is not applied yet
    core::BrushChange m_present;                  ///< brush of the model, or of the replacement in progress
    int m_index = 0;                              ///< undo index between replacements
    bool m_isReplacing = false, m_isClosing = false;
    std::stop_source m_stop; ///< cancels the replacement in progress
    QElapsedTimer m_sinceBegin;
};
} // namespace app
