#include "ui/model/model_dialogs.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>

#include <optional>

using namespace core;

namespace
{
/// A parent window and the command that a dialog returned.
struct Asking
{
    QWidget window;
    std::optional<ModelCommand> command;
    ui::CommandCallback answer = [this](const ModelCommand& given) { command = given; };

    QDialog* dialog(const char* name) { return window.findChild<QDialog*>(QLatin1StringView(name)); }
    template <class Widget> Widget* in(const char* name, const char* child)
    {
        return dialog(name)->findChild<Widget*>(QLatin1StringView(child));
    }
    void type(const char* name, const char* box, double value) { in<QDoubleSpinBox>(name, box)->setValue(value); }
};

ui::ModelInfo ball()
{
    return {QStringLiteral("Ball"), 2562, 5120, {100, 50, 20}, Box(Vec3(-50, -25, -10), Vec3(50, 25, 10)), 31400, 5};
}
} // namespace

class TestModelDialogs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void scale_boxesFollowEachOther();
    void scale_knowsUnits();
    void mirror_givesTheSide();
    void symmetry_givesPlaneAndHalf();
    void remesh_saysWhatWillBe();
    void remesh_untouchedIsTheDefault();
    void insert_givesThePlace();
    void insert_givesTheCombination();
    void verb_isTheDefaultButton();
    void cancelled_isNoAnswer();
};

void TestModelDialogs::scale_knowsUnits()
{
    const double factors[] = {1, 10, 25.4, 1000};
    for (int i = 3; i >= 0; --i) {
        Asking asking;
        ui::askForScale(&asking.window, ball(), asking.answer);
        asking.in<QRadioButton>("scaleDialog", qPrintable(QStringLiteral("choice%1").arg(i)))->click();
        QCOMPARE(asking.in<QDoubleSpinBox>("scaleDialog", "longest")->value(), factors[i] * ball().size.maxCoeff());
        asking.dialog("scaleDialog")->accept();
        QCOMPARE(std::get<core::Scale>(asking.command.value()).factor, factors[i]);
    }
}

void TestModelDialogs::scale_boxesFollowEachOther()
{
    Asking asking;
    ui::askForScale(&asking.window, ball(), asking.answer);
    asking.type("scaleDialog", "longest", 40);
    QCOMPARE(asking.in<QDoubleSpinBox>("scaleDialog", "factor")->value(), 0.4);
    asking.type("scaleDialog", "factor", 2.54);
    QCOMPARE(asking.in<QDoubleSpinBox>("scaleDialog", "longest")->value(), 254.0);
    asking.type("scaleDialog", "longest", 33.333);
    asking.dialog("scaleDialog")->accept();
    QCOMPARE(std::get<Scale>(asking.command.value()).factor, 0.33333);
}

void TestModelDialogs::mirror_givesTheSide()
{
    for (int axis = 0; axis < 3; ++axis) {
        Asking asking;
        ui::askForMirror(&asking.window, asking.answer);
        asking.in<QRadioButton>("mirrorDialog", qPrintable(QStringLiteral("choice%1").arg(axis)))->setChecked(true);
        asking.dialog("mirrorDialog")->accept();
        QCOMPARE(std::get<Mirror>(asking.command.value()).axis, axis);
    }
}

void TestModelDialogs::symmetry_givesPlaneAndHalf()
{
    using core::Half;
    using core::Symmetry;
    const std::pair<Symmetry, Half> choices[] = {{Symmetry::X, Half::Positive}, {Symmetry::X, Half::Negative},
                                                 {Symmetry::Y, Half::Positive}, {Symmetry::Y, Half::Negative},
                                                 {Symmetry::Z, Half::Positive}, {Symmetry::Z, Half::Negative}};
    for (int i = 0; i < 6; ++i) {
        Asking asking;
        ui::askForSymmetry(&asking.window, asking.answer);
        asking.in<QRadioButton>("symmetryDialog", qPrintable(QStringLiteral("choice%1").arg(i)))->setChecked(true);
        asking.dialog("symmetryDialog")->accept();
        const auto command = std::get<core::Symmetrize>(asking.command.value());
        QVERIFY(command.plane == choices[i].first && command.keep == choices[i].second);
    }
}

void TestModelDialogs::remesh_saysWhatWillBe()
{
    Asking asking;
    ui::askForRemesh(&asking.window, ball(), asking.answer);
    asking.type("remeshDialog", "longest", 2);
    const QString text = asking.in<QLabel>("remeshDialog", "outcome")->text();
    QVERIFY2(text.contains(QStringLiteral("1.00")) && text.contains(QStringLiteral("2.00")) &&
                 text.contains(QStringLiteral("37,000")),
             qPrintable(text));
    asking.dialog("remeshDialog")->accept();
    QCOMPARE(std::get<RemeshUniformly>(asking.command.value()).detailLength, 2.0);
}

void TestModelDialogs::remesh_untouchedIsTheDefault()
{
    Asking asking;
    ui::askForRemesh(&asking.window, ball(), asking.answer);
    asking.dialog("remeshDialog")->accept();
    QCOMPARE(std::get<RemeshUniformly>(asking.command.value()).detailLength, 0.0);
}

void TestModelDialogs::insert_givesThePlace()
{
    Asking asking;
    std::optional<ui::InsertRequest> insertion;
    ui::askForPlace(&asking.window, QStringLiteral("/models/part.stl"),
                    [&insertion](const ui::InsertRequest& given) { insertion = given; });
    QVERIFY(
        asking.dialog("insertDialog")->findChildren<QLabel*>().first()->text().startsWith(QStringLiteral("part.stl")));
    QVERIFY(!asking.in<QDoubleSpinBox>("insertDialog", "x")->isEnabled());
    asking.in<QRadioButton>("insertDialog", "choice2")->setChecked(true);
    QVERIFY(asking.in<QDoubleSpinBox>("insertDialog", "x")->isEnabled());
    asking.type("insertDialog", "y", 70);
    asking.in<QComboBox>("insertDialog", "unit")->setCurrentText(QStringLiteral("Inches"));
    asking.dialog("insertDialog")->accept();
    QVERIFY(insertion && insertion->path == QStringLiteral("/models/part.stl") && !insertion->repair);
    QVERIFY(insertion->place == Insert::Place::Centre && insertion->centre == Vec3(0, 70, 0));
    QCOMPARE(insertion->unit, 25.4);
}

void TestModelDialogs::insert_givesTheCombination()
{
    Asking asking;
    std::optional<ui::InsertRequest> insertion;
    ui::askForPlace(&asking.window, QStringLiteral("/models/part.stl"),
                    [&insertion](const ui::InsertRequest& given) { insertion = given; });
    auto* combine = asking.in<QComboBox>("insertDialog", "combine");
    QCOMPARE(combine->currentText(), QStringLiteral("As a part of its own"));
    QVERIFY(asking.in<QRadioButton>("insertDialog", "choice0")->isChecked());
    combine->setCurrentText(QStringLiteral("Subtract"));
    QVERIFY(asking.in<QRadioButton>("insertDialog", "choice1")->isChecked()); // beside it, it would have no effect
    asking.dialog("insertDialog")->accept();
    QVERIFY(insertion->combination == Insert::Combination::Subtract && insertion->place == Insert::Place::AsItIs);

    Asking next; // the choice is remembered
    ui::askForPlace(&next.window, QStringLiteral("/models/part.stl"),
                    [&insertion](const ui::InsertRequest& given) { insertion = given; });
    QCOMPARE(next.in<QComboBox>("insertDialog", "combine")->currentText(), QStringLiteral("Subtract"));
    QVERIFY(next.in<QRadioButton>("insertDialog", "choice1")->isChecked());
    next.in<QComboBox>("insertDialog", "combine")->setCurrentText(QStringLiteral("As a part of its own"));
    next.dialog("insertDialog")->accept();
    QVERIFY(insertion->combination == Insert::Combination::Part);
}

void TestModelDialogs::verb_isTheDefaultButton()
{
    Asking asking;
    ui::askForMirror(&asking.window, asking.answer);
    const auto buttons = asking.dialog("mirrorDialog")->findChild<QDialogButtonBox*>()->buttons();
    QCOMPARE(buttons.size(), 2);
    for (QAbstractButton* button : buttons)
        QCOMPARE(static_cast<QPushButton*>(button)->isDefault(), button->text() == QStringLiteral("Mirror"));
}

void TestModelDialogs::cancelled_isNoAnswer()
{
    Asking asking;
    ui::askForMirror(&asking.window, asking.answer);
    ui::askForRemesh(&asking.window, ball(), asking.answer);
    asking.dialog("mirrorDialog")->reject();
    asking.dialog("remeshDialog")->reject();
    QVERIFY(!asking.command);
}

FETTLE_TEST(TestModelDialogs, ui::TestApplication)
#include "tst_model_dialogs.moc"
