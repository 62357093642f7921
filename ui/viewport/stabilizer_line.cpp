#include "ui/viewport/stabilizer_line.h"

#include <QPainter>

namespace ui
{
namespace
{
constexpr int ringMargin = 4; ///< pixels
} // namespace

StabilizerLine::StabilizerLine(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("stringLine"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

void StabilizerLine::setLine(const QLineF& line)
{
    setVisible(!line.isNull());
    if (m_line == line || line.isNull())
        return;
    m_line = line;
    const QRectF around = QRectF(line.p1(), line.p2()).normalized();
    setGeometry(around.toAlignedRect().adjusted(-ringMargin, -ringMargin, ringMargin, ringMargin));
    update();
}

/// Draws a light line with dark edges, to be visible on every material.
void StabilizerLine::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(-pos());
    painter.setPen(QPen(QColor(0, 0, 0, 110), 3, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(m_line);
    painter.setPen(QPen(QColor(255, 246, 232), 1.2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(m_line);
}
} // namespace ui
