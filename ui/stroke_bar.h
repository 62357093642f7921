#pragma once

#include "brush_settings.h"
#include "offer_bar.h"

#include "core/stroke_change.h"

class QComboBox;

namespace ui
{
class MainWindow;

/// Tool, radius and strength of the stroke that was done last, to be changed after the fact. Of the tools, those that the window's brush offers.
/// Esc in it cancels. Gui thread.
class StrokeBar : public OfferBar
{
    Q_OBJECT

public:
    /// `facts`: of the model, for the radius's range.
    StrokeBar(const core::BrushChange& brush, const ModelFacts& facts, MainWindow* window);

    /// What is to be said of the stroke as it is; empty: nothing.
    void setHint(const QString& sentence);

Q_SIGNALS:
    void changed(const core::BrushChange& brush);
    void kept();
    void cancelled();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void addTools(const MainWindow& window);
    void tell();

    BrushSettings m_brush; ///< as the controls show it
    core::BrushChange m_first, m_shownFirst, m_told;
    QComboBox* m_tools;
    QLabel* m_hint;
};
} // namespace ui
