#pragma once

#include "ui/settings/brush_settings.h"
#include "ui/widgets/message_bar.h"

#include "core/stroke/stroke_edit.h"

#include <QList>

class QAction;
class QComboBox;

namespace ui
{
/// A tool that the bar offers, with the action that shows its name and icon.
struct OfferedTool
{
    core::Tool tool;
    const QAction* action;
};

/// A bar that changes tool, radius and strength of the last stroke after the fact. Esc in it cancels. Gui thread.
class StrokeBar : public OfferBar
{
    Q_OBJECT

public:
    /// `facts`: of the model, for the radius's range. `tools`: in the order of the list; the stroke's own tool among
    /// them.
    StrokeBar(const core::BrushChange& brush, const ModelFacts& facts, const QList<OfferedTool>& tools,
              QMainWindow* window);

    /// What is to be said of the stroke as it is; empty: nothing.
    void setHint(const QString& sentence);

Q_SIGNALS:
    void changed(const core::BrushChange& brush);
    void kept();
    void cancelled();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void addTools(const QList<OfferedTool>& tools);
    void tell();

    BrushSettings m_brush; ///< as the controls show it
    core::BrushChange m_first, m_shownFirst, m_told;
    QComboBox* m_tools;
    QLabel* m_hint;
};
} // namespace ui
