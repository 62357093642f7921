#pragma once

#include "ui/settings/brush_settings.h"
#include "ui/widgets/message_bar.h"

#include "core/stroke/stroke_edit.h"

#include <QList>

class QAction;
class QComboBox;

namespace ui
{
/// A tool in the list of the bar, with the action that shows its name and icon.
struct ToolOption
{
    core::Tool tool;
    const QAction* action;
};

/// A bar that changes tool, radius and strength of the last stroke after the fact. Esc in it cancels. Thread: gui.
class StrokeEditBar : public MessageBar
{
    Q_OBJECT

public:
    /// `modelInfo`: of the model, for the radius's range. `tools`: in the order of the list; the stroke's own tool
    /// among them.
    StrokeEditBar(const core::BrushChange& brush, const ModelInfo& modelInfo, const QList<ToolOption>& tools,
                  QMainWindow* window);

    /// What is to be said of the stroke as it is; empty: nothing.
    void setHint(const QString& sentence);

Q_SIGNALS:
    void changed(const core::BrushChange& brush);
    void accepted();
    void cancelled();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void addTools(const QList<ToolOption>& tools);
    void emitChanged();

    BrushSettings m_brush; ///< as the controls show it
    core::BrushChange m_first, m_shownFirst, m_lastEmitted;
    QComboBox* m_tools;
    QLabel* m_hint;
};
} // namespace ui
