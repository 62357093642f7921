#include "ui/model/primitive_dialog.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"
#include "ui/model/primitive_messages.h"
#include "ui/settings/settings.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>

#include <optional>

using namespace core;
using Measure = core::Primitive::Measure;

namespace
{
/// A parent window with an open dialog, and the command that the dialog returned.
struct PrimitiveQuestion
{
    QWidget window;
    std::optional<Insert> insertion;
    QDialog* dialog = nullptr;

    explicit PrimitiveQuestion(
        const std::shared_ptr<ui::PrimitiveMemory>& memory = std::make_shared<ui::PrimitiveMemory>())
    {
        const ui::ModelInfo ball{
            QStringLiteral("Ball"), 2562, 5120, {100, 50, 20}, Box(Vec3(-50, -25, -10), Vec3(50, 25, 10)), 31400, 5};
        ui::askForPrimitive(&window, ball, memory,
                            [this](const ModelCommand& command) { insertion = std::get<Insert>(command); });
        dialog = window.findChild<QDialog*>(QStringLiteral("primitiveDialog"));
    }
    template <class Widget> Widget* in(const char* child)
    {
        return dialog->findChild<Widget*>(QLatin1StringView(child));
    }
    void choose(const char* list, const char* text) { in<QComboBox>(list)->setCurrentText(QLatin1StringView(text)); }
    void type(const char* box, double value) { in<QDoubleSpinBox>(box)->setValue(value); }
    QPushButton* accepting()
    {
        for (QPushButton* button : dialog->findChildren<QPushButton*>())
            if (button->isDefault())
                return button;
        return nullptr;
    }
};
} // namespace

class TestPrimitiveDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void accepted_givesMeasuresPlaceAndCombination();
    void parts_areNamedByTheirShape();
    void rows_areThoseOfTheShape();
    void everyShape_isPossibleAtFirst();
    void accepted_isRememberedByShape();
    void impossibleMeasures_cannotBeAccepted();
    void profile_isReadLineByLine();
    void problems_areSentences();
};

void TestPrimitiveDialog::accepted_givesMeasuresPlaceAndCombination()
{
    PrimitiveQuestion asking;
    QCOMPARE(asking.in<QDoubleSpinBox>("width")->value(), 25.0); // a quarter of the model
    asking.choose("kind", "Cylinder");
    asking.type("radius", 6);
    asking.type("height", 80);
    asking.choose("axis", "X, to the right");
    asking.type("edge", 0.8);
    QVERIFY(!asking.in<QDoubleSpinBox>("x")->isEnabled());
    asking.choose("combine", "Subtract");
    QCOMPARE(asking.in<QComboBox>("place")->currentText(), QStringLiteral("With its middle at"));
    asking.choose("place", "With the middle of its bottom at");
    QVERIFY(asking.in<QDoubleSpinBox>("x")->isEnabled());
    asking.type("y", 7);
    QVERIFY(asking.accepting()->isEnabled());
    asking.accepting()->click();
    QVERIFY(asking.insertion && asking.insertion->primitive);
    QVERIFY(asking.insertion->place == Insert::Place::Floor && asking.insertion->centre == Vec3(0, 7, 0));
    QVERIFY(asking.insertion->combination == Insert::Combination::Subtract);
    const Primitive& cylinder = *asking.insertion->primitive;
    QVERIFY(cylinder.kind == Primitive::Kind::Cylinder);
    QCOMPARE(cylinder.length(Measure::Radius), 6.0);
    QCOMPARE(cylinder.length(Measure::Height), 80.0);
    QCOMPARE(cylinder.axis, core::Vec3::UnitX());
    QCOMPARE(cylinder.edge, 0.8);
    QVERIFY(asking.insertion->name.empty());
    ui::Settings().set(&ui::Setting::insertUse, ui::InsertUse::Part);
}

void TestPrimitiveDialog::parts_areNamedByTheirShape()
{
    PrimitiveQuestion asking;
    QCOMPARE(asking.in<QComboBox>("combine")->currentText(), QStringLiteral("As a part of its own"));
    asking.choose("kind", "Cone");
    asking.accepting()->click();
    QVERIFY(asking.insertion->combination == Insert::Combination::Part);
    QVERIFY(asking.insertion->place == Insert::Place::Beside);
    QCOMPARE(asking.insertion->name, std::string("Cone"));
}

void TestPrimitiveDialog::rows_areThoseOfTheShape()
{
    PrimitiveQuestion asking;
    for (std::size_t kind = 0; kind < Primitive::kinds; ++kind) {
        asking.in<QComboBox>("kind")->setCurrentIndex(static_cast<int>(kind));
        const auto measures = measuresOf(static_cast<Primitive::Kind>(kind));
        for (std::size_t i = 0; i < Primitive::measures; ++i) {
            const auto measure = static_cast<Measure>(i);
            QCOMPARE(asking.in<QDoubleSpinBox>(name(measure).data())->isVisible(),
                     std::ranges::count(measures, measure) > 0);
        }
        QCOMPARE(asking.in<QPlainTextEdit>("profile")->isVisible(),
                 static_cast<Primitive::Kind>(kind) == Primitive::Kind::Lathe);
        QCOMPARE(asking.in<QPlainTextEdit>("path")->isVisible(),
                 static_cast<Primitive::Kind>(kind) == Primitive::Kind::Tube);
    }
}

void TestPrimitiveDialog::everyShape_isPossibleAtFirst()
{
    for (std::size_t kind = 0; kind < Primitive::kinds; ++kind) {
        PrimitiveQuestion asking;
        asking.in<QComboBox>("kind")->setCurrentIndex(static_cast<int>(kind));
        QVERIFY2(asking.accepting()->isEnabled(), qPrintable(asking.in<QLabel>("problem")->text()));
        asking.accepting()->click();
        QVERIFY(makePrimitive(*asking.insertion->primitive).mesh);
    }
}

/// The next question begins with the shape, the measures and the place of the last one; other shapes have their own.
void TestPrimitiveDialog::accepted_isRememberedByShape()
{
    const auto memory = std::make_shared<ui::PrimitiveMemory>();
    const auto insert = [&](const char* kind, double radius, double x) {
        PrimitiveQuestion asking(memory);
        asking.choose("kind", kind);
        asking.type("radius", radius);
        asking.choose("axis", "Z, to the front");
        asking.choose("place", "With its middle at");
        asking.type("x", x);
        asking.accepting()->click();
        return *asking.insertion;
    };
    const Insert cone = insert("Cone", 9, 3);
    const Insert wheel = insert("Cylinder", 14, 28);
    const auto again = [&](const char* kind) {
        PrimitiveQuestion asking(memory);
        if (kind)
            asking.choose("kind", kind);
        asking.accepting()->click();
        return *asking.insertion;
    };
    const auto isSame = [](const Insert& a, const Insert& b) {
        return a.primitive->kind == b.primitive->kind && a.primitive->lengths == b.primitive->lengths &&
               a.primitive->axis == b.primitive->axis && a.place == b.place && a.centre == b.centre;
    };
    QVERIFY(isSame(again(nullptr), wheel));
    QVERIFY(isSame(again("Cone"), cone));
    {
        PrimitiveQuestion asking(memory);
        asking.type("radius", 99);
        asking.dialog->reject(); // is forgotten
    }
    QVERIFY(isSame(again(nullptr), cone));
    PrimitiveQuestion fresh(std::make_shared<ui::PrimitiveMemory>());
    fresh.choose("kind", "Torus");
    fresh.accepting()->click();
    QVERIFY(isSame(again("Torus"), *fresh.insertion)); // not as the cone was
    const Insert lathe = again("Turned profile");
    QCOMPARE(again("Turned profile").primitive->profile.size(), lathe.primitive->profile.size());
}

void TestPrimitiveDialog::impossibleMeasures_cannotBeAccepted()
{
    PrimitiveQuestion asking;
    asking.choose("kind", "Torus");
    asking.type("tube_radius", 500);
    QVERIFY(!asking.accepting()->isEnabled());
    QCOMPARE(asking.in<QLabel>("problem")->text(),
             QStringLiteral("The radius of a torus must be larger than the radius of its tube."));
    asking.type("tube_radius", 1);
    QVERIFY(asking.accepting()->isEnabled() && asking.in<QLabel>("problem")->text().isEmpty());
    asking.type("radius", 0);
    QVERIFY(!asking.accepting()->isEnabled());
    asking.type("radius", 10);
    asking.type("edge", 0.3);
    QCOMPARE(asking.in<QLabel>("problem")->text(),
             QStringLiteral("For this shape, the edges may be 0.166 mm long at most."));
}

void TestPrimitiveDialog::profile_isReadLineByLine()
{
    PrimitiveQuestion asking;
    asking.choose("kind", "Turned profile");
    auto* text = asking.in<QPlainTextEdit>("profile");
    for (const char* bad : {"", "10 0", "10 0\n8 x", "10 0\n8", "10 0\n8 5 3", "-1 0\n8 5", "1,000.5 0\n8 5"}) {
        text->setPlainText(QLatin1StringView(bad));
        QVERIFY2(!asking.accepting()->isEnabled(), bad);
    }
    text->setPlainText(QStringLiteral("  10.5  0 \n\n8,25; 20\n0 30\n"));
    QVERIFY(asking.accepting()->isEnabled());
    asking.accepting()->click();
    const std::vector<ProfilePoint> expected = {{10.5, 0}, {8.25, 20}, {0, 30}};
    QVERIFY(asking.insertion->primitive->profile == expected);
}

void TestPrimitiveDialog::problems_areSentences()
{
    for (int fault = 1; fault <= static_cast<int>(PrimitiveFault::TooManyFaces); ++fault) {
        PrimitiveResult result;
        result.fault = static_cast<PrimitiveFault>(fault);
        result.limit = 0.123456;
        result.faces = 5e6;
        const QString sentence = ui::PrimitiveMessages::problem(result);
        QVERIFY2(sentence.endsWith(u'.') && !sentence.contains(u'%'), qPrintable(sentence));
    }
    PrimitiveResult tooLong;
    tooLong.fault = PrimitiveFault::EdgeTooLong;
    tooLong.limit = 0.123789;
    QVERIFY(ui::PrimitiveMessages::problem(tooLong).contains(QStringLiteral("0.123 mm")));
}

FETTLE_TEST(TestPrimitiveDialog, ui::TestApplication)
#include "tst_primitive_dialog.moc"
