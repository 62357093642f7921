#include "ui/brush/color_panel.h"

#include "ui/actions/actions.h"
#include "ui/brush/color_swatches.h"
#include "ui/brush/color_wheel.h"
#include "ui/settings/brush_settings.h"
#include "ui/settings/settings.h"
#include "ui/util/color_convert.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/named.h"
#include "ui/widgets/panel_layout.h"
#include "ui/widgets/side_column.h"
#include "ui/widgets/spacing.h"

#include <QAction>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>

#include <utility>

namespace ui
{
namespace
{
constexpr QSize pairSize{44, 24};
constexpr int otherWidth = 16;
} // namespace

ColorPanel::ColorPanel(BrushSettings* brush, Settings* settings, const Actions& actions, QWidget* parent)
    : QWidget(parent)
    , m_brush(brush)
    , m_settings(settings)
    , m_wheel(new ColorWheel)
    , m_pair(new QToolButton)
    , m_name(new QLineEdit)
    , m_swatches(new ColorSwatches)
{
    QVBoxLayout* column = panelLayout(this);
    column->addWidget(m_wheel);
    column->addLayout(buildButtons(actions));
    column->addLayout(buildChannels());
    column->addWidget(m_swatches);
    buildSwatches();
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    connect(m_wheel, &ColorWheel::colorChanged, this, &ColorPanel::set);
    connect(actions.get(QStringLiteral("color.swap")), &QAction::triggered, this, &ColorPanel::swap);
    connect(brush, &BrushSettings::changed, this, &ColorPanel::showColor);
    showColor();
}

/// Builds the row with the swap button, the buttons for picking and filling, and the field for the colour's name.
QLayout* ColorPanel::buildButtons(const Actions& actions)
{
    const QAction* swapping = actions.get(QStringLiteral("color.swap"));
    m_pair->setObjectName(QStringLiteral("colorPair"));
    const auto showTip = [this, swapping] { m_pair->setToolTip(swapping->toolTip()); };
    showTip();
    connect(swapping, &QAction::changed, this, showTip);
    m_pair->setIconSize(pairSize);
    m_pair->setAutoRaise(true);
    connect(m_pair, &QToolButton::clicked, swapping, &QAction::trigger);

    named(m_name, "colorName",
          tr("The paint colour as in web pages: # and two digits, 0 to f, for each of red, green and blue."),
          tr("Colour as #rrggbb"));
    m_name->setMaxLength(7);
    connect(m_name, &QLineEdit::editingFinished, this, &ColorPanel::setFromText);
    connect(m_name, &QLineEdit::returnPressed, this, &ColorPanel::entered);

    auto* row = new QHBoxLayout;
    row->setSpacing(gap / 2);
    row->addWidget(m_pair);
    for (const char* id : {"color.pick", "model.fill"}) {
        auto* button = new QToolButton;
        button->setDefaultAction(actions.get(QLatin1StringView(id)));
        button->setIconSize(QSize(20, 20));
        button->setAutoRaise(true);
        row->addWidget(button);
    }
    row->addWidget(m_name, 1);
    return row;
}

QLayout* ColorPanel::buildChannels()
{
    const std::array<Channel, 3> made = {channel(tr("Red"), "red", &core::Rgb::r),
                                         channel(tr("Green"), "green", &core::Rgb::g),
                                         channel(tr("Blue"), "blue", &core::Rgb::b)};
    m_channels = made;
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(gap);
    grid->setVerticalSpacing(gap / 2);
    for (int row = 0; row < 3; ++row) {
        const Channel& one = made[static_cast<std::size_t>(row)];
        auto* label = new QLabel(one.box->accessibleName());
        label->setBuddy(one.box);
        grid->addWidget(label, row, 0);
        grid->addWidget(one.slider, row, 1);
        grid->addWidget(one.box, row, 2);
    }
    return grid;
}

ColorPanel::Channel ColorPanel::channel(const QString& name, const char* id, std::uint8_t core::Rgb::*what)
{
    const Channel made{new QSlider(Qt::Horizontal), new QSpinBox};
    const auto change = [this, what](int value) {
        core::Rgb color = m_brush->stroke().color;
        color.*what = static_cast<std::uint8_t>(value);
        set(color);
    };
    made.slider->setObjectName(QLatin1StringView(id) + QStringLiteral(".slider"));
    made.box->setObjectName(QLatin1StringView(id) + QStringLiteral(".box"));
    made.slider->setRange(0, 255);
    made.box->setRange(0, 255);
    made.box->setKeyboardTracking(false);
    for (QWidget* widget : {static_cast<QWidget*>(made.slider), static_cast<QWidget*>(made.box)}) {
        widget->setAccessibleName(name);
        widget->setToolTip(tr("%1 of the paint colour, 0 to 255.").arg(name));
    }
    connect(made.slider, &QSlider::valueChanged, this, change);
    connect(made.box, &QSpinBox::valueChanged, this, change);
    connect(made.box, &QSpinBox::editingFinished, this, [this, box = made.box] {
        if (box->hasFocus()) // otherwise the user has left the box without Return
            Q_EMIT entered();
    });
    return made;
}

void ColorPanel::setSwatches(const QList<core::Rgb>& swatches)
{
    m_swatches->setColors(swatches);
    Q_EMIT swatchesChanged();
}

const QList<core::Rgb>& ColorPanel::swatches() const
{
    return m_swatches->colors();
}

void ColorPanel::reset(const QList<core::Rgb>& swatches)
{
    m_other = {255, 255, 255};
    m_settings->set(&Setting::swatches, swatches);
    setSwatches(swatches);
    showColor();
}

void ColorPanel::buildSwatches()
{
    m_swatches->setColors(m_settings->get(&Setting::swatches));
    connect(m_swatches, &ColorSwatches::chosen, this, &ColorPanel::set);
    connect(m_swatches, &ColorSwatches::addRequested, this, [this] { m_swatches->add(m_brush->stroke().color); });
    connect(m_swatches, &ColorSwatches::changed, this, [this] {
        m_settings->set(&Setting::swatches, m_swatches->colors());
        Q_EMIT swatchesChanged();
    });
}

void ColorPanel::swap()
{
    const core::Rgb present = m_brush->stroke().color;
    set(std::exchange(m_other, present));
    showColor();
}

void ColorPanel::set(const core::Rgb& color)
{
    m_brush->set(&core::StrokeSettings::color, color);
}

/// Accepts the colour's name with or without the leading #.
void ColorPanel::setFromText()
{
    const QString text = m_name->text().trimmed();
    const QColor color(text.startsWith(u'#') ? text : u'#' + text);
    if (color.isValid())
        set(toRgb(color));
    else if (!text.isEmpty())
        Q_EMIT refused(tr("%1 is not a colour: write # and six digits from 0 to f.").arg(text));
    showColor();
}

void ColorPanel::showColor()
{
    const core::Rgb color = m_brush->stroke().color;
    m_wheel->setColor(color);
    if (!m_name->hasFocus() || !m_name->isModified())
        m_name->setText(toQt(color).name());
    const int values[] = {color.r, color.g, color.b};
    for (std::size_t i = 0; i < 3; ++i) {
        const QSignalBlocker quietSlider(m_channels[i].slider), quietBox(m_channels[i].box);
        m_channels[i].slider->setValue(values[i]);
        m_channels[i].box->setValue(values[i]);
    }
    m_pair->setIcon(QIcon(pairPicture()));
    m_pair->setAccessibleName(tr("Paint colour %1, the other %2").arg(toQt(color).name(), toQt(m_other).name()));
}

QPixmap ColorPanel::pairPicture() const
{
    QPixmap picture(pairSize);
    picture.fill(toQt(m_brush->stroke().color));
    QPainter painter(&picture);
    const QRect all = picture.rect().adjusted(0, 0, -1, -1);
    painter.fillRect(all.adjusted(all.width() - otherWidth, 0, 0, 0), toQt(m_other));
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(all);
    painter.drawRect(all.adjusted(all.width() - otherWidth, 0, 0, 0));
    return picture;
}

void addColorPanel(const ColorPanelContext& context, BrushSettings* brush, Settings* settings, const Actions& actions,
                   const std::function<void(const QString&)>& notice)
{
    auto* panel = new ColorPanel(brush, settings, actions);
    SidePanel* section = context.column->add(QStringLiteral("colorPanel"), ColorPanel::tr("Colour"), panel);

    Viewport* viewport = context.viewport;
    QAction* picking = actions.get(QStringLiteral("color.pick"));
    QObject::connect(panel, &ColorPanel::entered, viewport, qOverload<>(&QWidget::setFocus));
    QObject::connect(panel, &ColorPanel::refused, section, notice);
    QObject::connect(actions.get(QStringLiteral("brush.color")), &QAction::triggered, section, [section, panel] {
        section->bringForward();
        panel->wheel()->setFocus();
    });
    PointerInput* input = viewport->input();
    QObject::connect(picking, &QAction::triggered, input, [input](bool on) { input->setMode(PointerMode::Pick, on); });
    QObject::connect(input, &PointerInput::modeChanged, picking,
                     [picking](PointerMode mode) { picking->setChecked(mode == PointerMode::Pick); });
    QObject::connect(input, &PointerInput::picked, section,
                     [brush, notice](const std::optional<core::SurfaceHit>& hit) {
                         if (hit)
                             brush->set(&core::StrokeSettings::color, hit->color);
                         else
                             notice(ColorPanel::tr("No colour was picked: you did not click on the model."));
                     });
}
} // namespace ui
