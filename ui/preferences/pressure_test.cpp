#include "ui/preferences/pressure_test.h"

#include "ui/settings/preferences.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QTabletEvent>

namespace ui
{
namespace
{
constexpr int margin = 8;
constexpr double maxWidth = 16, minWidth = 0.5; ///< pixels; line width at full and at no pressure
constexpr qsizetype maxDots = 4000;             ///< older dots are removed
} // namespace

PressureTest::PressureTest(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("penTest"));
    setAccessibleName(tr("Pen test"));
    setToolTip(tr("Draw here: the line shows the effect of your pen's pressure."));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMinimumHeight(sizeHint().height());
    setCursor(Qt::CrossCursor);
    setTabletTracking(true);
    showMessage(tr("Draw here with the pen or the mouse."));
}

void PressureTest::showMessage(const QString& words)
{
    m_words = words;
    setAccessibleDescription(words);
    update();
}

void PressureTest::draw(const QPointF& at, double pressure, bool begins)
{
    if (m_dots.size() == maxDots)
        m_dots.removeFirst();
    m_dots.append({at, pressure, begins});
}

void PressureTest::mousePressEvent(QMouseEvent* event)
{
    draw(event->position(), 1, true);
    showMessage(tr("Mouse: no pressure"));
}

void PressureTest::mouseMoveEvent(QMouseEvent* event)
{
    draw(event->position(), 1, false);
    showMessage(tr("Mouse: no pressure"));
}

/// Accepts the event, because Qt would otherwise repeat it as a mouse event.
void PressureTest::tabletEvent(QTabletEvent* event)
{
    event->accept();
    const double pressure = penPressure(event->pressure(), m_exponent);
    if (event->type() != QEvent::TabletRelease && event->pressure() > 0)
        draw(event->position(), pressure, event->type() == QEvent::TabletPress);
    const QString number = locale().toString(pressure, 'f', 2);
    showMessage(event->pointerType() == QPointingDevice::PointerType::Eraser ? tr("Eraser: %1").arg(number)
                                                                             : tr("Pen: %1").arg(number));
}

void PressureTest::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    for (qsizetype i = 0; i < m_dots.size(); ++i) {
        const Dot &dot = m_dots[i], &before = i == 0 || dot.begins ? dot : m_dots[i - 1];
        painter.setPen(
            QPen(palette().highlight(), minWidth + dot.pressure * (maxWidth - minWidth), Qt::SolidLine, Qt::RoundCap));
        before.at == dot.at ? painter.drawPoint(dot.at) : painter.drawLine(before.at, dot.at);
    }
    painter.setPen(palette().text().color());
    painter.drawText(rect().adjusted(margin, margin, -margin, -margin), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                     m_words);
    painter.setPen(palette().mid().color());
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}
} // namespace ui
