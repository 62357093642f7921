#pragma once

#include <QLineF>
#include <QWidget>

namespace ui
{
/// The line of a steady stroke from pointer to brush; drawn over its parent and transparent for the mouse.
class StabilizerLine : public QWidget
{
    Q_OBJECT

public:
    explicit StabilizerLine(QWidget* parent);

    /// Sets the line in the parent's pixels. A line of length 0 is hidden.
    void setLine(const QLineF& line);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QLineF m_line;
};
} // namespace ui
