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
/// Changes the brush of the last stroke after the fact: Edit > Edit Last Stroke. Each change takes the stroke back and
/// does it again, as one step; of those that come while one is under way only the newest is done. Whatever else is done
/// to the model ends it. Gui thread.
class StrokeEdit : public QObject
{
    Q_OBJECT

public:
    /// Both must outlive it but for the window: a child of the document.
    StrokeEdit(ui::MainWindow& window, Document& document);

private:
    void begin();
    QList<ui::ToolOption> offeredTools() const;
    void want(const core::BrushChange& brush);
    void keep();
    void cancel();
    void goOn();
    void redo(const core::BrushChange& brush);
    void finish();
    void take(const std::optional<StrokeReport>& report);
    void watch();
    void end();

    QPointer<ui::MainWindow> m_window;
    QPointer<ui::StrokeEditBar> m_bar;
    Document* m_document;
    std::optional<Document::LastStroke> m_stroke; ///< as it was; nothing: none is edited
    std::optional<core::BrushChange> m_wanted;    ///< still to be done
    core::BrushChange m_present;                  ///< what the model shows, or will when what is under way is done
    int m_index = 0;                              ///< of the undo stack, while nothing is under way
    bool m_isUnderWay = false, m_isClosing = false;
    std::stop_source m_stop; ///< of what is under way
    QElapsedTimer m_sinceBegin;
};
} // namespace app
