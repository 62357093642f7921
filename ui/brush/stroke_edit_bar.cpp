#include "ui/brush/stroke_edit_bar.h"

#include "ui/actions/actions.h"
#include "ui/brush/brush_bar.h"
#include "ui/widgets/named.h"

#include <QAction>
#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>

#include <utility>

namespace ui
{
StrokeEditBar::StrokeEditBar(const core::BrushChange& brush, const ModelInfo& modelInfo, const QList<ToolOption>& tools,
                             QMainWindow* window)
    : MessageBar("strokeBar", tr("Edit Last Stroke"), window)
    , m_first(brush)
    , m_lastEmitted(brush)
    , m_tools(new QComboBox)
    , m_hint(new QLabel)
{
    m_brush.fitTo(modelInfo, brush.radius / modelInfo.size.maxCoeff());
    m_brush.setTool(brush.tool);
    m_brush.setValue(core::Parameter::Strength, brush.strength);
    m_shownFirst = core::brushOf(m_brush.stroke());

    addControl(new QLabel(tr("Last stroke:")));
    addTools(tools);
    auto* numbers = new BrushBar(&m_brush);
    addControl(numbers);
    m_hint->setObjectName(QStringLiteral("strokeHint"));
    m_hint->setTextFormat(Qt::PlainText);
    m_hint->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addControl(m_hint);
    QPushButton* keepButton =
        addButton("keepStroke", tr("&Keep"), tr("Leaves the stroke as it is now, and hides this bar."));
    keepButton->setDefault(true);
    QPushButton* cancel =
        addButton("cancelStroke", tr("&Cancel"), tr("Restores the stroke as it was, and hides this bar."));
    const auto dismissWith = [this](void (StrokeEditBar::*what)()) {
        Q_EMIT(this->*what)();
        dismiss();
    };
    connect(keepButton, &QPushButton::clicked, this, [dismissWith] { dismissWith(&StrokeEditBar::accepted); });
    connect(cancel, &QPushButton::clicked, this, [dismissWith] { dismissWith(&StrokeEditBar::cancelled); });
    connect(numbers, &BrushBar::entered, keepButton, [keepButton] { keepButton->setFocus(); });
    connect(&m_brush, &BrushSettings::changed, this, &StrokeEditBar::emitChanged);
    m_tools->setFocus();
}

void StrokeEditBar::setHint(const QString& sentence)
{
    m_hint->setText(sentence);
}

void StrokeEditBar::keyPressEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_Escape)
        return MessageBar::keyPressEvent(event);
    Q_EMIT cancelled();
    dismiss();
}

void StrokeEditBar::addTools(const QList<ToolOption>& tools)
{
    named(m_tools, "strokeTool", tr("Changes the tool of the stroke."), tr("Tool of the last stroke"));
    for (const auto& [tool, action] : tools)
        m_tools->addItem(action->icon(), Actions::plain(action->text()), static_cast<int>(tool));
    m_tools->setCurrentIndex(m_tools->findData(static_cast<int>(m_first.tool)));
    // Keeps the stroke's strength instead of using the tool's own
    connect(m_tools, &QComboBox::activated, this, [this] {
        core::StrokeSettings stroke = m_brush.stroke();
        stroke.tool = static_cast<core::Tool>(m_tools->currentData().toInt());
        m_brush.apply(stroke);
    });
    addControl(m_tools);
}

/// Emits changed() with the edited brush. Values that the user has not edited are emitted unrounded, although the
/// controls may show them rounded or clamped.
void StrokeEditBar::emitChanged()
{
    core::BrushChange brush = core::brushOf(m_brush.stroke());
    if (brush.radius == m_shownFirst.radius)
        brush.radius = m_first.radius;
    if (brush.strength == m_shownFirst.strength)
        brush.strength = m_first.strength;
    if (std::exchange(m_lastEmitted, brush) != brush)
        Q_EMIT changed(brush);
}
} // namespace ui
