#pragma once

#include <QLineF>
#include <QWidget>

namespace ui
{
/// The string of a steady stroke, from the hand to the brush that it draws; over its parent, and the mouse goes through
/// it.
class StringLine : public QWidget
{
    Q_OBJECT

public:
    explicit StringLine(QWidget* parent);

    /// In the parent's pixels; a line without length is not shown.
    void span(const QLineF& line);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QLineF m_line;
};
} // namespace ui
