#pragma once

#include <QLineF>
#include <QWidget>

namespace ui
{
/// The line of a steady stroke, from the pointer to the brush; over its parent, transparent for the mouse.
class StabilizerLine : public QWidget
{
    Q_OBJECT

public:
    explicit StabilizerLine(QWidget* parent);

    /// In the parent's pixels; a line without length is not shown.
    void setLine(const QLineF& line);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QLineF m_line;
};
} // namespace ui
