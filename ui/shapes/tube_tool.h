#pragma once

#include "ui/shapes/tube_handles.h"
#include "ui/shapes/view_tool.h"

#include <QPolygonF>

namespace ui
{
class Actions;
class BrushSettings;
class TubeCard;

/// Lets the user draw a tube: a curve over the view, which lies on the model where it meets it, and beside it as deep
/// as there. Then each point of the curve can be moved, and its radius changed; a double click on the line adds a
/// point, Delete removes the chosen one. What the tube will be is shown translucent. Return makes it. Switched by the
/// action "model.tube". Thread: gui.
class TubeTool : public ViewTool
{
    Q_OBJECT

public:
    /// `brush`: a new tube is as thick as its radius says.
    TubeTool(const Actions& actions, const BrushSettings* brush, Viewport* viewport);

protected:
    void clear() override;
    void refresh() override;
    bool handlePointer(const QSinglePointEvent& event) override;
    bool handleKey(const QKeyEvent& event) override;
    void place(const std::vector<core::Ray>& rays, const Hits& hits) override;
    bool isHeld() const override { return m_isDrawing || m_dragged; }
    void paintEvent(QPaintEvent* event) override;

private:
    bool press(const QSinglePointEvent& event);
    bool moveTo(const QSinglePointEvent& event);
    bool release();
    void drag(const QSinglePointEvent& event);
    void endCurve();
    void apply();
    core::Primitive primitive() const;

    TubeCard* m_card;
    QPolygonF m_curve;                   ///< being drawn, logical pixels
    std::vector<core::TubePoint> m_path; ///< empty: no curve has been drawn yet
    std::size_t m_chosen = 0;            ///< index of the point whose radius the card shows
    std::optional<TubeHandle> m_hot, m_dragged;
    bool m_isDrawing = false;
};
} // namespace ui
