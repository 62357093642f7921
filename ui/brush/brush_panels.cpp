#include "ui/brush/brush_panels.h"

#include "ui/brush/brush_bar.h"
#include "ui/brush/falloff_curve.h"
#include "ui/brush/shape_choosers.h"
#include "ui/util/error_messages.h"
#include "ui/widgets/named.h"
#include "ui/widgets/side_column.h"
#include "ui/widgets/spacing.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace ui
{
namespace
{
struct BrushPanels
{
    Q_DECLARE_TR_FUNCTIONS(ui::BrushPanels)
};

template <class T> using Choices = std::vector<std::pair<QString, T>>;

/// A form with controls of some brush settings.
class Panel
{
public:
    explicit Panel(BrushSettings* brush) : content(new QWidget), m_brush(brush), m_form(new QFormLayout)
    {
        content->setLayout(m_form);
        content->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
        m_form->setContentsMargins(gap, gap, gap, gap);
        m_form->setSpacing(gap);
        m_form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    }

    QWidget* const content;

    void add(QWidget* row) const { m_form->addRow(row); }
    void add(QLayout* row) const { m_form->addRow(row); }
    void addRow(const QString& text, QWidget* row) const { m_form->addRow(text, row); }

    void addNumber(core::Parameter parameter, const std::function<void()>& entered) const
    {
        auto* control = new ParameterControl(m_brush, parameter, ParameterControl::Label::Without);
        QObject::connect(control, &ParameterControl::entered, content, entered);
        m_form->addRow(ErrorMessages::name(parameter), control);
    }

    template <class T>
    void addChoice(const QString& name, const QString& text, T core::StrokeSettings::*what,
                   const Choices<T>& choices) const
    {
        auto* box = named(new QComboBox, name, {}, text);
        for (const auto& [words, value] : choices)
            box->addItem(words, static_cast<int>(value));
        const auto show = [box, brush = m_brush, what] {
            box->setCurrentIndex(box->findData(static_cast<int>(brush->stroke().*what)));
        };
        QObject::connect(box, &QComboBox::activated, m_brush, [box, brush = m_brush, what] {
            brush->set(what, static_cast<T>(box->currentData().toInt()));
        });
        QObject::connect(m_brush, &BrushSettings::changed, box, show);
        show();
        m_form->addRow(text, box);
    }

    void addCheck(const QString& name, const QString& text, bool core::StrokeSettings::*what) const
    {
        m_form->addRow(makeCheck(name, text, what));
    }

    QCheckBox* makeCheck(const QString& name, const QString& text, bool core::StrokeSettings::*what) const
    {
        auto* box = named(new QCheckBox(text), name);
        const auto show = [box, brush = m_brush, what] { box->setChecked(brush->stroke().*what); };
        QObject::connect(box, &QCheckBox::clicked, m_brush,
                         [brush = m_brush, what](bool checked) { brush->set(what, checked); });
        QObject::connect(m_brush, &BrushSettings::changed, box, show);
        show();
        return box;
    }

    /// Gives all number boxes the same width, so that the sliders before them are aligned.
    void alignNumbers() const
    {
        const QList<QAbstractSpinBox*> boxes = content->findChildren<QAbstractSpinBox*>();
        int width = 0;
        for (const QAbstractSpinBox* box : boxes)
            width = std::max(width, box->sizeHint().width());
        for (QAbstractSpinBox* box : boxes)
            box->setMinimumWidth(width);
    }

    QCheckBox* makeAnchored() const
    {
        QCheckBox* check = makeCheck(QStringLiteral("anchored"), BrushPanels::tr("Drag out size and direction"),
                                     &core::StrokeSettings::anchored);
        check->setToolTip(
            BrushPanels::tr("Press where the alpha or the stamp should go, and drag: the distance sets its radius, and "
                            "it points up where you drag. A click makes it as large as the brush."));
        const auto show = [check, brush = m_brush] { check->setEnabled(core::canAnchor(brush->tool())); };
        QObject::connect(m_brush, &BrushSettings::changed, check, show);
        show();
        return check;
    }

    QCheckBox* makeAirbrush() const
    {
        auto* check = named(new QCheckBox(BrushPanels::tr("Airbrush")), "airbrush",
                            BrushPanels::tr("The tool continues for as long as you hold it in one place."));
        const auto show = [check, brush = m_brush] {
            check->setEnabled(core::canAirbrush(brush->tool()));
            check->setChecked(brush->tools()->isAirbrush(brush->tool()));
        };
        QObject::connect(check, &QCheckBox::clicked, m_brush,
                         [brush = m_brush](bool checked) { brush->tools()->setAirbrush(brush->tool(), checked); });
        QObject::connect(m_brush, &BrushSettings::changed, check, show);
        QObject::connect(m_brush, &BrushSettings::inputChanged, check, show);
        show();
        return check;
    }

    void addSharing() const
    {
        auto* check = named(new QCheckBox(BrushPanels::tr("Same radius for all tools")), "sharesRadius",
                            BrushPanels::tr("Keeps the radius when you change the tool. When off, each tool has its "
                                            "own radius, just as it has its own strength."));
        check->setChecked(m_brush->tools()->sharesRadius());
        QObject::connect(check, &QCheckBox::clicked, m_brush->tools(), &ToolMemory::setSharesRadius);
        QObject::connect(m_brush->tools(), &ToolMemory::sharesRadiusChanged, check, &QCheckBox::setChecked);
        m_form->addRow(check);
    }

    void addSteady(const std::function<void()>& entered) const
    {
        const QString tip =
            BrushPanels::tr("Length of the string between pointer and brush. A longer one makes smoother lines.");
        auto* check = named(new QCheckBox(BrushPanels::tr("Steady stroke")), "steady", tip);
        auto* length = named(new QSpinBox, "stringLength", tip, BrushPanels::tr("Length of the string"));
        length->setRange(static_cast<int>(minStabilizerLength), static_cast<int>(maxStabilizerLength));
        length->setSuffix(BrushPanels::tr(" px"));
        length->setKeyboardTracking(false);
        const auto show = [=, brush = m_brush] {
            check->setChecked(brush->isSteady());
            length->setEnabled(brush->isSteady());
            const QSignalBlocker quiet(length);
            length->setValue(static_cast<int>(std::lround(brush->stabilizerLength())));
        };
        QObject::connect(check, &QCheckBox::clicked, m_brush, &BrushSettings::setSteady);
        QObject::connect(length, &QSpinBox::valueChanged, m_brush, &BrushSettings::setStabilizerLength);
        QObject::connect(length, &QSpinBox::editingFinished, content, [=] {
            if (length->hasFocus())
                entered();
        });
        QObject::connect(m_brush, &BrushSettings::changed, check, show);
        show();
        auto* row = new QHBoxLayout;
        row->setSpacing(gap);
        row->addWidget(check, 1);
        row->addWidget(length);
        m_form->addRow(row);
    }

    void addSectors(const std::function<void()>& entered) const
    {
        auto* count = named(new QSpinBox, "radial",
                            BrushPanels::tr("Repeats your strokes in this number of sectors around the vertical axis "
                                            "(y), mirrored in each if Mirror is on."),
                            BrushPanels::tr("Sectors of the radial symmetry"));
        count->setRange(1, core::maxRadial);
        count->setSpecialValueText(BrushPanels::tr("Off"));
        count->setKeyboardTracking(false);
        auto* hint =
            new QLabel(BrushPanels::tr("With this count the sectors look alike; with 2 and 4 they are exactly alike."));
        hint->setObjectName(QStringLiteral("radialHint"));
        hint->setWordWrap(true);
        const auto show = [=, brush = m_brush] {
            const int radial = brush->stroke().radial;
            const QSignalBlocker quiet(count);
            count->setValue(radial);
            hint->setVisible(core::exactTurns(radial) != radial);
        };
        QObject::connect(count, &QSpinBox::valueChanged, m_brush,
                         [brush = m_brush](int radial) { brush->set(&core::StrokeSettings::radial, radial); });
        QObject::connect(count, &QSpinBox::editingFinished, content, [=] {
            if (count->hasFocus())
                entered();
        });
        QObject::connect(m_brush, &BrushSettings::changed, count, show);
        m_form->addRow(BrushPanels::tr("Radial"), count);
        m_form->addRow(hint);
        show();
    }

private:
    BrushSettings* m_brush;
    QFormLayout* m_form;
};

QWidget* brushForm(BrushSettings* brush, BrushShapes* shapes, const std::function<void()>& entered)
{
    const Panel panel(brush);
    panel.addChoice(QStringLiteral("reach"), BrushPanels::tr("Reach"), &core::StrokeSettings::brush,
                    Choices<core::BrushShape>{{BrushPanels::tr("Sphere"), core::BrushShape::Sphere},
                                              {BrushPanels::tr("Along the surface"), core::BrushShape::Ray}});
    panel.addNumber(core::Parameter::Falloff, entered);
    panel.add(new FalloffCurve(brush));
    panel.addNumber(core::Parameter::Spacing, entered);
    panel.addRow(BrushPanels::tr("Alpha"), alphaChooser(brush, shapes));
    auto* checks = new QHBoxLayout;
    checks->addWidget(panel.makeCheck(QStringLiteral("alphaFollows"), BrushPanels::tr("Follows the stroke"),
                                      &core::StrokeSettings::alphaFollows));
    checks->addWidget(panel.makeAirbrush());
    panel.add(checks);
    panel.add(panel.makeAnchored());
    panel.addRow(BrushPanels::tr("Stamp"), modelChooser(brush, shapes));
    panel.addSteady(entered);
    panel.addSharing();
    panel.alignNumbers();
    return panel.content;
}

QWidget* topologyForm(BrushSettings* brush, const std::function<void()>& entered)
{
    const Panel panel(brush);
    panel.addChoice(QStringLiteral("topology"), BrushPanels::tr("Edges"), &core::StrokeSettings::topology,
                    Choices<core::Topology>{{BrushPanels::tr("Refine"), core::Topology::Refine},
                                            {BrushPanels::tr("Adaptive"), core::Topology::Adaptive},
                                            {BrushPanels::tr("Keep"), core::Topology::Keep},
                                            {BrushPanels::tr("Uniform"), core::Topology::Uniform}});
    panel.addNumber(core::Parameter::Detail, entered);
    panel.addCheck(QStringLiteral("fusion"), BrushPanels::tr("Fuse touching surfaces"), &core::StrokeSettings::fusion);
    return panel.content;
}

QWidget* symmetryForm(BrushSettings* brush, const std::function<void()>& entered)
{
    const Panel panel(brush);
    panel.addChoice(QStringLiteral("symmetry"), BrushPanels::tr("Mirror"), &core::StrokeSettings::symmetry,
                    Choices<core::Symmetry>{{BrushPanels::tr("None"), core::Symmetry::None},
                                            {BrushPanels::tr("Left and right (x = 0)"), core::Symmetry::X},
                                            {BrushPanels::tr("Top and bottom (y = 0)"), core::Symmetry::Y},
                                            {BrushPanels::tr("Front and back (z = 0)"), core::Symmetry::Z}});
    panel.addSectors(entered);
    return panel.content;
}
} // namespace

void addBrushPanels(const BrushPanelContext& context, BrushSettings* brush, BrushShapes* shapes)
{
    const auto& [column, entered] = context;
    column->add(QStringLiteral("brushPanel"), BrushPanels::tr("Brush"), brushForm(brush, shapes, entered),
                SidePanel::State::Open);
    column->add(QStringLiteral("topologyPanel"), BrushPanels::tr("Topology"), topologyForm(brush, entered),
                SidePanel::State::Open);
    column->add(QStringLiteral("symmetryPanel"), BrushPanels::tr("Symmetry"), symmetryForm(brush, entered));
}
} // namespace ui
