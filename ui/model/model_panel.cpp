#include "ui/model/model_panel.h"

#include "ui/widgets/app_style.h"
#include "ui/widgets/side_column.h"
#include "ui/widgets/spacing.h"
#include "ui/widgets/themed_icon.h"

#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui
{
namespace
{
constexpr int iconSide = 20;

/// Returns a number with at least four significant digits, but at most six decimals.
QString figure(double value)
{
    const double size = std::max(std::abs(value), 1e-6);
    return QLocale().toString(value, 'f', std::clamp(3 - static_cast<int>(std::floor(std::log10(size))), 0, 6));
}

template <class Count> QString count(Count value)
{
    return QLocale().toString(static_cast<qlonglong>(value));
}
} // namespace

ModelPanel::ModelPanel(QWidget* parent)
    : QWidget(parent)
    , m_form(new QFormLayout(this))
    , m_icon(new QLabel)
    , m_word(new QLabel)
{
    m_form->setContentsMargins(gap, gap, gap, gap);
    m_form->setSpacing(gap);
    m_word->setObjectName(QStringLiteral("health"));
    m_word->setWordWrap(true);
    auto* badge = new QHBoxLayout;
    badge->setSpacing(gap);
    badge->addWidget(m_icon);
    badge->addWidget(m_word, 1);
    m_form->addRow(badge);
    addRow("part", tr("Part"), tr("The active part, whose values these are."));
    addRow("vertices", tr("Vertices"), tr("Corners of the triangles."));
    addRow("faces", tr("Faces"), tr("Triangles of the surface."));
    addRow("components", tr("Components"), tr("Parts of the surface that are not connected, including hollows."));
    addRow("genus", tr("Genus"), tr("The number of handles or through holes: 0 for a ball, 1 for a ring or a cup."));
    addRow("size", tr("Size"), tr("Width, height and depth of the box around the model."));
    addRow("volume", tr("Volume"), tr("Volume inside the surface."));
    addRow("area", tr("Area"), tr("Area of the whole surface."));
    addRow("edges", tr("Edges"), tr("The shortest and the longest edge of a triangle."));
    m_form->setRowVisible(m_values.value(QStringLiteral("part")), false);
    setStale();
}

void ModelPanel::addRow(const char* id, const QString& name, const QString& tip)
{
    auto* value = new QLabel(QStringLiteral("–"));
    value->setObjectName(QStringLiteral("model.") + QLatin1StringView(id));
    value->setTextFormat(Qt::PlainText);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    value->setAccessibleName(name);
    value->setToolTip(tip);
    m_values.insert(QLatin1StringView(id), value);
    m_form->addRow(name, value);
    m_form->labelForField(value)->setToolTip(tip);
}

void ModelPanel::setReport(const core::MeshReport& report, const QString& part)
{
    const auto set = [this](const char* id, const QString& text) {
        m_values.value(QLatin1StringView(id))->setText(text);
    };
    const QString none = QStringLiteral("–");
    set("part", part);
    m_form->setRowVisible(m_values.value(QStringLiteral("part")), !part.isEmpty());
    set("vertices", count(report.vertices));
    set("faces", count(report.faces));
    set("components", count(report.components));
    set("genus", report.genus ? count(*report.genus) : none);
    set("size", tr("%1 × %2 × %3 mm").arg(figure(report.size.x()), figure(report.size.y()), figure(report.size.z())));
    set("volume", report.volume ? tr("%1 cm³").arg(figure(*report.volume / 1000)) : none);
    set("area", tr("%1 cm²").arg(figure(report.area / 100)));
    set("edges", tr("%1 to %2 mm").arg(figure(report.minEdge), figure(report.maxEdge)));
    for (QLabel* value : std::as_const(m_values))
        value->setEnabled(true);
    if (report.printReady())
        showHealth(Health::Sound, tr("Watertight"), tr("Closed and free of self-intersections. Checked exactly."));
    else
        showHealth(Health::Unsound, tr("Needs repair"),
                   tr("The surface is open, intersects itself or encloses no space."));
}

void ModelPanel::setStale()
{
    for (QLabel* value : std::as_const(m_values))
        value->setEnabled(false);
    showHealth(Health::Unknown, tr("Not checked since the last change"),
               tr("These values are from before the last change. They are updated when the model is idle."));
}

/// Shows the state by icon and text; colour only repeats it.
void ModelPanel::showHealth(Health health, const QString& word, const QString& tip)
{
    m_health = health;
    showColors();
    m_word->setText(word);
    m_word->setToolTip(tip);
    m_word->setAccessibleDescription(tip);
}

/// Sets the colour of the text and draws the icon in the same colour.
void ModelPanel::showColors()
{
    // Contrast at least 4.5 to 1
    constexpr QRgb onLight[] = {0, 0xff1e7a3a, 0xffb3261e}, onDark[] = {0, 0xff66cc88, 0xfff28b82};
    const int kind = static_cast<int>(m_health);
    QPalette colors;
    if (m_health != Health::Unknown)
        colors.setColor(QPalette::WindowText, QColor(isDark(palette()) ? onDark[kind] : onLight[kind]));
    m_word->setPalette(colors);
    static const QString icons[] = {QStringLiteral("wait"), QStringLiteral("sound"), QStringLiteral("unsound")};
    m_icon->setPixmap(
        themedIcon(icons[static_cast<int>(m_health)]).pixmap(QSize(iconSide, iconSide), devicePixelRatioF()));
}

void ModelPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        showColors();
}

void ModelPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    Q_EMIT watched(true);
}

void ModelPanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    Q_EMIT watched(false);
}

ModelPanel* addModelPanel(SideColumn* column)
{
    auto* panel = new ModelPanel;
    column->add(QStringLiteral("modelPanel"), ModelPanel::tr("Model", "panel"), panel);
    return panel;
}
} // namespace ui
