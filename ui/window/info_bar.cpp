#include "ui/window/info_bar.h"

#include "ui/util/number_format.h"

#include <QHBoxLayout>
#include <QLabel>

namespace ui
{
InfoBar::InfoBar(const BrushSettings* brush, QWidget* parent)
    : QWidget(parent)
    , m_brush(brush)
    , m_name(new QLabel)
    , m_vertices(new QLabel)
    , m_size(new QLabel)
    , m_radius(new QLabel)
{
    m_name->setObjectName(QStringLiteral("facts.name"));
    m_vertices->setObjectName(QStringLiteral("facts.vertices"));
    m_size->setObjectName(QStringLiteral("facts.size"));
    m_radius->setObjectName(QStringLiteral("facts.radius"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 0, 8, 0);
    row->setSpacing(24);
    for (QLabel* label : {m_name, m_vertices, m_size, m_radius}) {
        label->setTextFormat(Qt::PlainText);
        row->addWidget(label);
    }
    connect(brush, &BrushSettings::changed, this, &InfoBar::showRadius);
    showRadius();
}

void InfoBar::setModelInfo(const ModelInfo& modelInfo)
{
    m_name->setText(modelInfo.name);
    m_vertices->setText(tr("%Ln vertices", nullptr, static_cast<int>(modelInfo.vertices)));
    m_size->setText(
        tr("%1 × %2 × %3 mm")
            .arg(millimetres(modelInfo.size.x()), millimetres(modelInfo.size.y()), millimetres(modelInfo.size.z())));
}

void InfoBar::showRadius()
{
    m_radius->setText(tr("Radius %1 mm").arg(millimetres(m_brush->value(core::Parameter::Radius))));
}
} // namespace ui
