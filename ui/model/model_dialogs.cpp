#include "ui/model/model_dialogs.h"

#include "ui/model/command_dialog.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QRadioButton>

#include <algorithm>
#include <cmath>

namespace ui
{
namespace
{
QString formatted(double n)
{
    const double digit = std::pow(10, std::max(0.0, std::floor(std::log10(std::max(n, 1.0))) - 1));
    return QLocale().toString(static_cast<qulonglong>(std::round(n / digit) * digit));
}

QString length(double mm)
{
    const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(std::max(mm, 1e-6)))), 0, 6);
    return QLocale().toString(mm, 'f', decimals);
}
} // namespace

/// Asks for a scale by longest side or by factor; editing one updates the other.
void askForScale(QWidget* parent, const ModelInfo& modelInfo, const CommandCallback& callback)
{
    const double size = modelInfo.size.maxCoeff();
    auto* dialog = new CommandDialog(parent, "scaleDialog", ModelDialogs::tr("Scale the Model"),
                                     ModelDialogs::tr("New size of the model:"));
    auto* longest = dialog->addNumber("longest", ModelDialogs::tr("Longest side"), millimetreField(size, 0.001));
    auto* factor = dialog->addNumber("factor", ModelDialogs::tr("Factor"), {1, 1e-6, 1e6, 6, {}});
    const auto* units = dialog->addChoice(ModelDialogs::tr("Original unit"),
                                          {ModelDialogs::tr("Millimetres"), ModelDialogs::tr("Centimetres"),
                                           ModelDialogs::tr("Inches"), ModelDialogs::tr("Metres")});
    QObject::connect(units, &QButtonGroup::idClicked, factor, [factor](int unit) {
        constexpr double millimetresPerUnit[] = {1, 10, 25.4, 1000};
        factor->setValue(millimetresPerUnit[unit]);
    });
    const auto last = std::make_shared<double>(1); // exact factor, whichever box it was typed into
    QObject::connect(longest, &QDoubleSpinBox::valueChanged, factor, [=](double mm) {
        *last = mm / size;
        const QSignalBlocker quiet(factor);
        factor->setValue(*last);
    });
    QObject::connect(factor, &QDoubleSpinBox::valueChanged, longest, [=](double times) {
        *last = times;
        const QSignalBlocker quiet(longest);
        longest->setValue(times * size);
    });
    dialog->openFor(ModelDialogs::tr("Scale"), callback, [last] { return core::Scale{*last}; });
}

void askForMirror(QWidget* parent, const CommandCallback& callback)
{
    auto* dialog = new CommandDialog(parent, "mirrorDialog", ModelDialogs::tr("Mirror the Model"),
                                     ModelDialogs::tr("Mirror across a plane through the origin:"));
    const auto* sides =
        dialog->addChoice({}, {ModelDialogs::tr("Left and right (X)"), ModelDialogs::tr("Top and bottom (Y)"),
                               ModelDialogs::tr("Front and back (Z)")});
    dialog->openFor(ModelDialogs::tr("Mirror"), callback, [sides] { return core::Mirror{sides->checkedId()}; });
}

void askForSymmetry(QWidget* parent, const CommandCallback& callback)
{
    auto* dialog = new CommandDialog(parent, "symmetryDialog", ModelDialogs::tr("Symmetrize the Model"),
                                     ModelDialogs::tr("Mirror across a plane through the origin. Which half is kept?"));
    const auto* halves =
        dialog->addChoice({}, {ModelDialogs::tr("Right (X above 0)"), ModelDialogs::tr("Left (X below 0)"),
                               ModelDialogs::tr("Top (Y above 0)"), ModelDialogs::tr("Bottom (Y below 0)"),
                               ModelDialogs::tr("Front (Z above 0)"), ModelDialogs::tr("Back (Z below 0)")});
    dialog->openFor(ModelDialogs::tr("Symmetrize"), callback, [halves] {
        constexpr core::Symmetry planes[] = {core::Symmetry::X, core::Symmetry::Y, core::Symmetry::Z};
        const int choice = halves->checkedId();
        return core::Symmetrize{planes[choice / 2], choice % 2 == 0 ? core::Half::Positive : core::Half::Negative};
    });
}

void askForRemesh(QWidget* parent, const ModelInfo& modelInfo, const CommandCallback& callback)
{
    auto* dialog = new CommandDialog(
        parent, "remeshDialog", ModelDialogs::tr("Remesh Uniformly"),
        ModelDialogs::tr("Rebuild the mesh with triangles of about the same size. Maximum edge length:"));
    const double min = std::max(modelInfo.size.maxCoeff() * 1e-4, 0.001);
    auto* longest =
        dialog->addNumber("longest", ModelDialogs::tr("Longest edge"),
                          millimetreField(modelInfo.uniformDetail, min, std::max(modelInfo.size.maxCoeff(), min)));
    auto* outcome = dialog->addText({});
    outcome->setObjectName(QStringLiteral("outcome"));
    const auto show = [outcome, modelInfo](double mm) {
        outcome->setText(ModelDialogs::tr("Edges from %1 to %2 mm; about %3 triangles, currently %4.")
                             .arg(length(mm / 2), length(mm), formatted(core::uniformFaces(modelInfo.area, mm)),
                                  QLocale().toString(static_cast<qulonglong>(modelInfo.faces))));
    };
    QObject::connect(longest, &QDoubleSpinBox::valueChanged, outcome, show);
    show(longest->value());
    // An unedited box means the exact default (0), not the rounded number that the box shows.
    dialog->openFor(ModelDialogs::tr("Remesh"), callback, [longest, shown = longest->value()] {
        return core::RemeshUniformly{longest->value() == shown ? 0 : longest->value()};
    });
}

void askForBase(QWidget* parent, const ModelInfo& modelInfo, const CommandCallback& callback)
{
    constexpr double defaultShare = 0.02; ///< fraction of the model's height
    const double height = modelInfo.size.y(), min = std::min(0.001, height / 2);
    auto* dialog = new CommandDialog(parent, "baseDialog", ModelDialogs::tr("Flatten the Base"),
                                     ModelDialogs::tr("Cuts the bottom off level, so that the model stands. "
                                                      "Height of the cut above the lowest point:"));
    const auto* cut = dialog->addNumber("height", ModelDialogs::tr("Height"),
                                        millimetreField(defaultShare * height, min, std::max(height - min, min)));
    dialog->openFor(ModelDialogs::tr("Flatten"), callback, [cut] { return core::FlattenBase{cut->value()}; });
}

void askForPlace(QWidget* parent, const QString& path,
                 const std::function<void(const InsertRequest& insertion)>& callback)
{
    auto* dialog =
        new CommandDialog(parent, "insertDialog", ModelDialogs::tr("Insert a Model"),
                          ModelDialogs::tr("%1: where does it go, and how is it combined with the present model?")
                              .arg(QFileInfo(path).fileName()));
    const auto* places =
        dialog->addChoice({}, {ModelDialogs::tr("Beside the present model"), ModelDialogs::tr("Where its file has it"),
                               ModelDialogs::tr("With its middle at")});
    const Coordinates centre = addCoordinates(dialog);
    centre.setEnabled(false);
    QObject::connect(places, &QButtonGroup::idToggled, dialog,
                     [centre, places] { centre.setEnabled(places->checkedId() == 2); });
    const auto* combinations = addCombinations(dialog);
    const auto leaveSide = [places, combinations] {
        if (needsOverlap(combinations) && places->checkedId() == 0)
            places->button(1)->setChecked(true); // beside the model there is nothing to combine
    };
    QObject::connect(combinations, &QComboBox::currentIndexChanged, places, leaveSide);
    leaveSide();
    const auto* units =
        dialog->addList("unit", ModelDialogs::tr("Its unit"),
                        {ModelDialogs::tr("As stated in the file, otherwise mm"), ModelDialogs::tr("Centimetres"),
                         ModelDialogs::tr("Metres"), ModelDialogs::tr("Inches")});
    dialog->openFor(ModelDialogs::tr("Insert"), callback, [=] {
        constexpr core::Insert::Place all[] = {core::Insert::Place::Beside, core::Insert::Place::AsItIs,
                                               core::Insert::Place::Centre};
        constexpr double millimetresOf[] = {1, 10, 1000, 25.4};
        InsertRequest insertion{
            path, all[places->checkedId()], centre.value(), millimetresOf[units->currentIndex()], {}};
        insertion.combination = combinationOf(combinations);
        return insertion;
    });
}
} // namespace ui
