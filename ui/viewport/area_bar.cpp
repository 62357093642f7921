#include "ui/viewport/area_bar.h"

#include "ui/widgets/named.h"
#include "ui/widgets/themed_icon.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QToolButton>

namespace ui
{
AreaBar::AreaBar(QWidget* view) : QFrame(view), m_row(new QHBoxLayout(this))
{
    setObjectName(QStringLiteral("areaBar"));
    setAutoFillBackground(true);
    setFrameShape(QFrame::StyledPanel);
    setCursor(Qt::ArrowCursor);
    m_row->setContentsMargins(4, 4, 4, 4);
    auto* group = new QButtonGroup(this);
    const auto addShape = [&](const char* name, const QString& text, const QString& tip, const QString& icon) {
        QToolButton* button = addButton(name, text, tip, icon);
        button->setToolButtonStyle(Qt::ToolButtonIconOnly);
        group->addButton(button, static_cast<int>(m_shapes.size()));
        m_shapes << button;
    };
    addShape("areaLasso", tr("Lasso"), tr("Draw freely around the area (1)."), QStringLiteral("area-lasso"));
    addShape("areaBox", tr("Box"), tr("Drag a box over the area (2)."), QStringLiteral("area-box"));
    addShape("areaLine", tr("Line"), tr("Drag a line; the area is on its right (3)."), QStringLiteral("area-line"));
    addShape("areaPolygon", tr("Polygon"), tr("Click the corners of the area (4)."), QStringLiteral("area-polygon"));
    m_shapes.front()->setChecked(true);
    connect(group, &QButtonGroup::idClicked, this, [this](int id) { setShape(static_cast<CurveShape>(id)); });
    m_row->addSpacing(8);
    m_outside =
        addButton("areaOutside", tr("Outside"), tr("Takes what is beside the curve instead (O, or hold Shift)."), {});
    m_front = addButton("areaFront", tr("Only in Front"),
                        tr("Takes only what is seen first, not what is behind it (F)."), {});
    m_color = addButton("areaColor", tr("Coloured"), tr("Gives the faces of the cut the paint colour (P)."), {});
    connect(m_outside, &QToolButton::clicked, this, &AreaBar::extentChanged);
    connect(m_front, &QToolButton::clicked, this, &AreaBar::extentChanged);
    hide();
}

QToolButton* AreaBar::addButton(const char* name, const QString& text, const QString& tip, const QString& icon)
{
    auto* button = named(new QToolButton, name, tip, text);
    button->setText(text);
    button->setCheckable(true);
    button->setAutoRaise(!icon.isEmpty());
    button->setFocusPolicy(Qt::NoFocus);
    if (!icon.isEmpty())
        button->setIcon(themedIcon(icon));
    m_row->addWidget(button);
    return button;
}

bool AreaBar::isOutside() const
{
    return m_outside->isChecked();
}

bool AreaBar::isFrontOnly() const
{
    return m_front->isChecked();
}

bool AreaBar::isColored() const
{
    return m_color->isVisibleTo(this) && m_color->isChecked();
}

void AreaBar::setUse(AreaUse use)
{
    m_color->setVisible(use == AreaUse::Trim);
}

void AreaBar::setShape(CurveShape shape)
{
    m_shape = shape;
    m_shapes[static_cast<qsizetype>(shape)]->setChecked(true);
    Q_EMIT shapeChanged();
}

/// Returns the button of a key; null: none has it.
QToolButton* AreaBar::buttonFor(int key) const
{
    switch (key) {
    case Qt::Key_O:
        return m_outside;
    case Qt::Key_F:
        return m_front;
    case Qt::Key_P:
        return m_color;
    default:
        return m_shapes.value(key - Qt::Key_1);
    }
}

bool AreaBar::handleKey(const QKeyEvent& event)
{
    QToolButton* button = buttonFor(event.key());
    if (!button || !button->isVisibleTo(this) ||
        event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier))
        return false;
    if (event.type() == QEvent::KeyPress && !event.isAutoRepeat())
        button->click();
    return true;
}
} // namespace ui
