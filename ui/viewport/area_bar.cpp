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

void AreaBar::setShape(CurveShape shape)
{
    m_shape = shape;
    m_shapes[static_cast<qsizetype>(shape)]->setChecked(true);
    Q_EMIT shapeChanged();
}

bool AreaBar::handleKey(const QKeyEvent& event)
{
    const int key = event.key();
    const bool isShape = key >= Qt::Key_1 && key < Qt::Key_1 + m_shapes.size();
    if ((!isShape && key != Qt::Key_O && key != Qt::Key_F) ||
        event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier))
        return false;
    if (event.type() == QEvent::KeyPress && !event.isAutoRepeat())
        (isShape ? m_shapes[key - Qt::Key_1] : key == Qt::Key_O ? m_outside : m_front)->click();
    return true;
}
} // namespace ui
