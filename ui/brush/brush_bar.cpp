#include "ui/brush/brush_bar.h"

#include "ui/util/error_messages.h"
#include "ui/widgets/named.h"
#include "ui/widgets/spacing.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSpinBox>

#include <algorithm>
#include <cmath>

namespace ui
{
namespace
{
constexpr int sliderSteps = 1000;

/// Largest strength on the slider; the number box allows the whole range of the parameter table.
constexpr double strengthOnSlider = 2.0;

bool isLogarithmic(core::Parameter parameter)
{
    return core::info(parameter).min > 0;
}

double sliderMax(const BrushSettings& brush, core::Parameter parameter)
{
    return parameter == core::Parameter::Strength ? strengthOnSlider : brush.maxOf(parameter);
}

/// Returns the number of decimals; logarithmic parameters show three significant digits.
int decimalsFor(core::Parameter parameter, double value)
{
    if (parameter == core::Parameter::Falloff)
        return 0;
    if (!isLogarithmic(parameter))
        return 2;
    return std::clamp(2 - static_cast<int>(std::floor(std::log10(std::max(value, 1e-6)))), 0, 6);
}
} // namespace

QValidator::State NumberBox::validate(QString& text, int& cursor) const
{
    const QValidator::State state = NumberField::validate(text, cursor);
    return state == QValidator::Invalid && numberIn(text) ? QValidator::Intermediate : state;
}

/// Handles typed numbers that the box cannot show; Qt calls it when editing is finished.
void NumberBox::fixup(QString& text) const
{
    NumberField::fixup(text);
    if (const std::optional<double> number = numberIn(text)) {
        Q_EMIT asked(*number);
        text = textFromValue(std::clamp(*number, minimum(), maximum()));
    }
}

QSize NumberBox::sizeHint() const
{
    ensurePolished();
    const int cursorWidth = 2;
    const QString longest = QStringLiteral("8888.88") + suffix();
    const QSize text(fontMetrics().horizontalAdvance(longest) + cursorWidth, lineEdit()->sizeHint().height());
    QStyleOptionSpinBox option;
    initStyleOption(&option);
    return style()->sizeFromContents(QStyle::CT_SpinBox, &option, text, this);
}

std::optional<double> NumberBox::numberIn(const QString& text) const
{
    bool isNumber = false;
    const double number =
        locale().toDouble(text.chopped(text.endsWith(suffix()) ? suffix().size() : 0).trimmed(), &isNumber);
    return isNumber && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

ParameterControl::ParameterControl(BrushSettings* brush, core::Parameter parameter, Label label)
    : m_brush(brush)
    , m_parameter(parameter)
    , m_slider(new QSlider(Qt::Horizontal))
    , m_box(new NumberBox)
{
    const QString name = QLatin1StringView(core::info(parameter).key.data(), core::info(parameter).key.size());
    named(m_slider, name + QStringLiteral(".slider"), {}, ErrorMessages::name(parameter));
    m_slider->setRange(0, sliderSteps);
    m_slider->setMinimumWidth(80);
    named(m_box, name + QStringLiteral(".box"), {}, ErrorMessages::name(parameter));
    m_box->setKeyboardTracking(false);
    m_box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    if (core::info(parameter).unit == core::Unit::Millimetres)
        m_box->setSuffix(tr(" mm"));

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(gap);
    if (label == Label::Before) {
        auto* text = new QLabel(ErrorMessages::name(parameter));
        text->setBuddy(m_box);
        row->addWidget(text);
    }
    row->addWidget(m_slider, 1);
    row->addWidget(m_box);

    connect(m_slider, &QSlider::valueChanged, this, [this](int at) {
        if (!m_isShowing)
            m_brush->setValue(m_parameter, valueAt(at));
    });
    connect(m_box, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        if (!m_isShowing)
            m_brush->setValue(m_parameter, value);
    });
    connect(m_box, &NumberBox::asked, brush, [brush, parameter](double value) { brush->setValue(parameter, value); });
    connect(m_box, &QDoubleSpinBox::editingFinished, this, [this] {
        if (m_box->hasFocus()) // otherwise the user has left the box without Return
            Q_EMIT entered();
    });
    connect(brush, &BrushSettings::changed, this, &ParameterControl::showValue);
    showValue();
}

void ParameterControl::showValue()
{
    m_isShowing = true;
    const double value = m_brush->value(m_parameter);
    m_box->setDecimals(decimalsFor(m_parameter, value));
    m_box->setRange(m_brush->minOf(m_parameter), m_brush->maxOf(m_parameter));
    m_box->setValue(value);
    m_slider->setValue(position(value));
    m_isShowing = false;
}

int ParameterControl::position(double value) const
{
    const double min = m_brush->minOf(m_parameter), max = sliderMax(*m_brush, m_parameter);
    const double share =
        isLogarithmic(m_parameter) ? std::log(value / min) / std::log(max / min) : (value - min) / (max - min);
    return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * sliderSteps));
}

double ParameterControl::valueAt(int position) const
{
    const double min = m_brush->minOf(m_parameter), max = sliderMax(*m_brush, m_parameter);
    const double share = static_cast<double>(position) / sliderSteps;
    return std::clamp(isLogarithmic(m_parameter) ? min * std::pow(max / min, share) : min + share * (max - min), min,
                      max);
}

BrushBar::BrushBar(BrushSettings* brush, QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(gap, 0, gap, 0);
    row->setSpacing(2 * gap);
    for (const core::Parameter parameter : {core::Parameter::Radius, core::Parameter::Strength}) {
        auto* control = new ParameterControl(brush, parameter);
        connect(control, &ParameterControl::entered, this, &BrushBar::entered);
        row->addWidget(control);
    }
}
} // namespace ui
