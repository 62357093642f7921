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
constexpr double widest = 16, thinnest = 0.5; ///< pixels
constexpr qsizetype most = 4000;              ///< dots; then the oldest go
} // namespace

PenTest::PenTest(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("penTest"));
    setAccessibleName(tr("Pen test"));
    setToolTip(tr("Draw here: the line shows what your pen's pressure becomes."));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMinimumHeight(sizeHint().height());
    setCursor(Qt::CrossCursor);
    setTabletTracking(true);
    say(tr("Draw here with the pen or the mouse."));
}

void PenTest::say(const QString& words)
{
    m_words = words;
    setAccessibleDescription(words);
    update();
}

void PenTest::draw(const QPointF& at, double pressure, bool begins)
{
    if (m_dots.size() == most)
        m_dots.removeFirst();
    m_dots.append({at, pressure, begins});
}

void PenTest::mousePressEvent(QMouseEvent* event)
{
    draw(event->position(), 1, true);
    say(tr("Mouse: no pressure"));
}

void PenTest::mouseMoveEvent(QMouseEvent* event)
{
    draw(event->position(), 1, false);
    say(tr("Mouse: no pressure"));
}

/// Accepted, or Qt would send the same again as a mouse's.
void PenTest::tabletEvent(QTabletEvent* event)
{
    event->accept();
    const double pressure = penPressure(event->pressure(), m_exponent);
    if (event->type() != QEvent::TabletRelease && event->pressure() > 0)
        draw(event->position(), pressure, event->type() == QEvent::TabletPress);
    const QString number = locale().toString(pressure, 'f', 2);
    say(event->pointerType() == QPointingDevice::PointerType::Eraser ? tr("Eraser: %1").arg(number)
                                                                     : tr("Pen: %1").arg(number));
}

void PenTest::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    for (qsizetype i = 0; i < m_dots.size(); ++i) {
        const Dot &dot = m_dots[i], &before = i == 0 || dot.begins ? dot : m_dots[i - 1];
        painter.setPen(
            QPen(palette().highlight(), thinnest + dot.pressure * (widest - thinnest), Qt::SolidLine, Qt::RoundCap));
        before.at == dot.at ? painter.drawPoint(dot.at) : painter.drawLine(before.at, dot.at);
    }
    painter.setPen(palette().text().color());
    painter.drawText(rect().adjusted(margin, margin, -margin, -margin), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                     m_words);
    painter.setPen(palette().mid().color());
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}
} // namespace ui
