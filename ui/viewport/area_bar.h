#pragma once

#include "ui/viewport/drawn_curve.h"

#include <QFrame>

class QBoxLayout;
class QKeyEvent;
class QToolButton;

namespace ui
{
/// Buttons over the view for the area that is about to be drawn: its shape, which side of the curve counts, whether
/// only what is in front does, and whether a cut gets the paint colour. Remembers the choices. Takes no keyboard focus.
/// Thread: gui.
class AreaBar : public QFrame
{
    Q_OBJECT

public:
    explicit AreaBar(QWidget* view);

    CurveShape shape() const { return m_shape; }
    bool isOutside() const;
    bool isFrontOnly() const;
    bool isColored() const;

    /// Offers what this use has choices for.
    void setUse(AreaUse use);
    void setShape(CurveShape shape);
    /// Handles the keys of the visible buttons, without modifiers: 1 to 4, O, F and P. Returns false for other keys.
    bool handleKey(const QKeyEvent& event);

Q_SIGNALS:
    void shapeChanged();
    /// Another side, or another depth, counts.
    void extentChanged();

private:
    QToolButton* addButton(const char* name, const QString& text, const QString& tip, const QString& icon);
    QToolButton* buttonFor(int key) const;

    CurveShape m_shape = CurveShape::Lasso;
    QBoxLayout* m_row;
    QList<QToolButton*> m_shapes;
    QToolButton *m_outside, *m_front, *m_color;
};
} // namespace ui
