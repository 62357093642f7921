#include "ui/brush/color_swatches.h"

#include "ui/util/color_convert.h"
#include "ui/widgets/themed_icon.h"

#include <QAction>
#include <QEvent>
#include <QGridLayout>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>

#include <utility>

namespace ui
{
namespace
{
constexpr int side = 20, perRow = 9, between = 4;

/// Draws a frame in the text colour, so that a swatch of the window's colour is visible.
QIcon patch(const core::Rgb& color, const QPalette& palette)
{
    QPixmap image(side, side);
    image.fill(toQt(color));
    QPainter painter(&image);
    QColor line = palette.color(QPalette::WindowText);
    line.setAlphaF(0.5);
    painter.setPen(line);
    painter.drawRect(image.rect().adjusted(0, 0, -1, -1));
    return QIcon(image);
}
} // namespace

ColorSwatches::ColorSwatches(QWidget* parent) : QWidget(parent), m_grid(new QGridLayout(this))
{
    setObjectName(QStringLiteral("swatches"));
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setSpacing(between);
    m_grid->setColumnStretch(perRow, 1);
    setMinimumHeight(2 * side + between);
    build();
}

void ColorSwatches::setColors(QList<core::Rgb> colors)
{
    m_colors = std::move(colors);
    m_colors.resize(std::min<qsizetype>(m_colors.size(), maxSwatches));
    build();
}

void ColorSwatches::add(const core::Rgb& color)
{
    if (m_colors.contains(color))
        return;
    if (m_colors.size() == maxSwatches)
        m_colors.removeFirst();
    m_colors << color;
    build();
    Q_EMIT changed();
}

void ColorSwatches::remove(const core::Rgb& color)
{
    if (m_colors.removeAll(color) == 0)
        return;
    build();
    Q_EMIT changed();
}

/// Redraws the frames, which have the text colour.
void ColorSwatches::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        build();
}

/// Rebuilds all buttons. deleteLater(), because an old button may be handling an event.
void ColorSwatches::build()
{
    while (QLayoutItem* item = m_grid->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
    int at = 0;
    const auto place = [&](QWidget* widget) {
        m_grid->addWidget(widget, at / perRow, at % perRow, Qt::AlignTop | Qt::AlignLeft);
        ++at;
    };
    for (const core::Rgb& color : std::as_const(m_colors))
        place(button(color));
    auto* plus = new QToolButton;
    plus->setObjectName(QStringLiteral("addSwatch"));
    plus->setIcon(themedIcon(QStringLiteral("plus")));
    plus->setIconSize(QSize(side - 4, side - 4));
    plus->setFixedSize(side, side);
    plus->setAutoRaise(true);
    plus->setFocusPolicy(Qt::StrongFocus);
    plus->setAccessibleName(tr("Keep this colour"));
    plus->setToolTip(tr("Keeps the paint colour among the swatches."));
    connect(plus, &QToolButton::clicked, this, &ColorSwatches::addRequested);
    place(plus);
}

QWidget* ColorSwatches::button(const core::Rgb& color)
{
    auto* made = new QPushButton;
    const QString name = toQt(color).name();
    made->setObjectName(QStringLiteral("swatch"));
    made->setIcon(patch(color, palette()));
    made->setIconSize(QSize(side, side));
    made->setFixedSize(side, side);
    made->setStyleSheet(
        QStringLiteral("QPushButton{border:0;padding:0} QPushButton:focus{border:2px solid palette(highlight)}"));
    made->setFocusPolicy(Qt::StrongFocus);
    made->setAccessibleName(name);
    made->setToolTip(tr("%1: click to use it, press Delete to remove it.").arg(name));
    auto* removing = new QAction(tr("Remove"), made);
    removing->setShortcut(Qt::Key_Delete);
    removing->setShortcutContext(Qt::WidgetShortcut);
    made->addAction(removing);
    made->setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(made, &QPushButton::clicked, this, [this, color] { Q_EMIT chosen(color); });
    connect(removing, &QAction::triggered, this, [this, color] { remove(color); });
    return made;
}
} // namespace ui
