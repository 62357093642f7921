#pragma once

#include "ui/shapes/view_tool.h"

#include <QPointF>

namespace ui
{
class Actions;
class BrushSettings;
class SolidCard;

/// Lets the user place a solid with measures in the view: a press on the model, or on the ground beside it, puts its
/// base there, and the drag gives its size. Then all numbers can be typed. What the solid will be is shown translucent.
/// Return makes it. Switched by the action "model.placeSolid". Knows no document: it requests the insertion by a
/// signal. Thread: gui.
class SolidTool : public ViewTool
{
    Q_OBJECT

public:
    SolidTool(const Actions& actions, const BrushSettings* brush, Viewport* viewport);

protected:
    void clear() override;
    void refresh() override;
    bool handlePointer(const QSinglePointEvent& event) override;
    bool handleKey(const QKeyEvent& event) override;
    void place(const std::vector<core::Ray>& rays, const Hits& hits) override;
    bool isHeld() const override { return m_isPressed; }

private:
    core::SurfaceHit groundAt(const core::Ray& ray) const;
    core::Insert insertion() const;
    void resize();
    void apply();

    SolidCard* m_card;
    bool m_isPressed = false, m_isPlaced = false;
    QPointF m_from, m_pointer; ///< of the drag, logical pixels
};
} // namespace ui
