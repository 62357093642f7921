#pragma once

#include "ui/settings/brush_settings.h"
#include "ui/widgets/message_bar.h"

#include "core/stroke/stroke_edit.h"

#include <QList>

class QAction;
class QComboBox;

namespace ui
{
/// A tool in the list of the bar, with the action that has its name and icon.
struct ToolOption
{
    core::Tool tool;
    const QAction* action;
};

/// A bar that edits the last stroke's tool, radius and strength afterwards. Esc cancels. Thread: gui.
class StrokeEditBar : public MessageBar
{
    Q_OBJECT

public:
    /// `modelInfo`: data of the model, which limit the radius. `tools`: in list order, including the stroke's own tool.
    StrokeEditBar(const core::BrushChange& brush, const ModelInfo& modelInfo, const QList<ToolOption>& tools,
                  QMainWindow* window);

    /// Shows a remark on the edited stroke; empty: hides it.
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

    BrushSettings m_brush; ///< values shown by the controls
    core::BrushChange m_first, m_shownFirst, m_lastEmitted;
    QComboBox* m_tools;
    QLabel* m_hint;
};
} // namespace ui
