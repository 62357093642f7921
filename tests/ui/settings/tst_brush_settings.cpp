#include "ui/settings/brush_settings.h"

#include "core/geometry/lattice.h"
#include "core/sculpt/deform/alpha.h"
#include "tests/support/test_main.h"

#include <QSignalSpy>
#include <QTest>

#include <limits>

using core::Parameter;

namespace
{
ui::ModelInfo model(double size)
{
    ui::ModelInfo modelInfo;
    modelInfo.size = core::Vec3(size, size / 2, size / 3);
    modelInfo.minDetail = core::Lattice::forExtent(size / 2).minDetail();
    return modelInfo;
}
} // namespace

class TestBrushSettings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsPaintedFirstCanBeSeen()
    {
        QVERIFY(!(ui::BrushSettings().stroke().color == core::Rgb())); // Rgb() is the colour of unpainted models
    }

    void valuesAreClampedToTheTable()
    {
        for (const Parameter p : {Parameter::Strength, Parameter::Detail, Parameter::Spacing, Parameter::Radius}) {
            ui::BrushSettings brush;
            brush.setValue(p, 1e9);
            QCOMPARE(brush.value(p), core::info(p).max);
            brush.setValue(p, -1e9);
            QCOMPARE(brush.value(p), core::info(p).min);
        }
    }

    void falloffIsAlwaysLegal()
    {
        ui::BrushSettings brush;
        for (double n = -2; n < 20; n += 0.25) {
            brush.setValue(Parameter::Falloff, n);
            QVERIFY(core::isFalloff(brush.stroke().falloff));
        }
    }

    /// The radius ranges from the finest that the lattice allows to half the model's longest side.
    void theRadiusStaysInTheModelsRange()
    {
        ui::BrushSettings brush;
        const ui::ModelInfo modelInfo = model(60);
        brush.fitTo(modelInfo, 0.1);
        QCOMPARE(brush.value(Parameter::Radius), 6.0);
        brush.scaleRadius(1000);
        QCOMPARE(brush.value(Parameter::Radius), 30.0);
        brush.scaleRadius(1e-9);
        const double least = brush.value(Parameter::Radius);
        QVERIFY(core::edgeBounds(least, 1).detail >= modelInfo.minDetail * (1 - 1e-12));
        QVERIFY(core::edgeBounds(0.99 * least, 1).detail < modelInfo.minDetail);
        brush.fitTo(modelInfo, 1e-9);
        QCOMPARE(brush.value(Parameter::Radius), least);
        brush.fitTo(modelInfo, 9);
        QCOMPARE(brush.value(Parameter::Radius), 30.0);
    }

    void theRadiusKeepsItsShareOfTheModel()
    {
        ui::BrushSettings brush;
        brush.fitTo(model(60), 0.1);
        brush.setValue(Parameter::Radius, 12);
        QCOMPARE(brush.radiusShare(), 0.2);
        QVERIFY(brush.fits(model(60)) && brush.fits(model(119)) && brush.fits(model(31)));
        QVERIFY(!brush.fits(model(121)) && !brush.fits(model(29)));
        brush.fitTo(model(600), brush.radiusShare());
        QCOMPARE(brush.value(Parameter::Radius), 120.0);
    }

    void whatIsClampedIsTold()
    {
        ui::BrushSettings brush;
        QSignalSpy clamped(&brush, &ui::BrushSettings::clamped);
        brush.fitTo(model(60), 100); // not requested by the user, so not reported
        brush.setValue(Parameter::Radius, 5);
        QCOMPARE(clamped.count(), 0);
        for (const double impossible : {0.0, -3.0, 31.0, 1e-5, 1e300, -std::numeric_limits<double>::infinity()}) {
            brush.setValue(Parameter::Radius, impossible);
            QCOMPARE(clamped.count(), 1);
            QCOMPARE(clamped.takeFirst()[0].value<Parameter>(), Parameter::Radius);
        }
        brush.setValue(Parameter::Radius, 30); // the limit itself is allowed
        QCOMPARE(clamped.count(), 0);
        brush.setValue(Parameter::Strength, 11);
        QCOMPARE(clamped.count(), 1);
    }

    /// The smallest radius depends on the detail, so that the smallest brush's edges are never finer than the lattice
    /// allows.
    void finerDetailNeedsALargerBrush()
    {
        ui::BrushSettings brush;
        const ui::ModelInfo modelInfo = model(60);
        brush.fitTo(modelInfo, 1e-9);
        const double least = brush.value(Parameter::Radius);
        brush.setValue(Parameter::Detail, 0.5);
        QVERIFY(qFuzzyCompare(brush.value(Parameter::Radius), 2 * least));
        QVERIFY(qFuzzyCompare(brush.minOf(Parameter::Radius), 2 * least));
        brush.setValue(Parameter::Detail, 2);
        QVERIFY(qFuzzyCompare(brush.minOf(Parameter::Radius), least / 2));
    }

    void symmetryComesBackAboutTheSamePlane()
    {
        ui::BrushSettings brush;
        brush.setSymmetric(true);
        QCOMPARE(brush.stroke().symmetry, core::Symmetry::X);
        brush.set(&core::StrokeSettings::symmetry, core::Symmetry::Z);
        brush.setSymmetric(false);
        QCOMPARE(brush.stroke().symmetry, core::Symmetry::None);
        brush.setSymmetric(true);
        QCOMPARE(brush.stroke().symmetry, core::Symmetry::Z);
    }

    void sectorsComeBackAsTheyWere()
    {
        ui::BrushSettings brush;
        brush.setRadial(true);
        QCOMPARE(brush.stroke().radial, 6);
        brush.set(&core::StrokeSettings::radial, 4);
        brush.setRadial(false);
        QCOMPARE(brush.stroke().radial, 1);
        brush.setRadial(true);
        QCOMPARE(brush.stroke().radial, 4);
        core::StrokeSettings other = brush.stroke();
        other.radial = 9;
        brush.apply(other);
        brush.setRadial(false);
        brush.setRadial(true);
        QCOMPARE(brush.stroke().radial, 9);
    }

    void anAlphaFromAFileStays()
    {
        ui::BrushSettings brush;
        const auto file = std::make_shared<const core::Alpha>(1, 1, std::vector<std::uint8_t>{200}, "mine.png");
        brush.set(&core::StrokeSettings::alpha, file);
        core::StrokeSettings other;
        brush.apply(other);
        QCOMPARE(brush.stroke().alpha, file);
        other.alpha = core::builtInAlpha("star");
        brush.apply(other);
        QCOMPARE(brush.stroke().alpha, other.alpha);
        other.alpha = nullptr;
        brush.apply(other);
        QVERIFY(!brush.stroke().alpha);
    }

    void keysHeldChangeTheTool()
    {
        using core::Tool;
        const auto with = [](Tool tool, Qt::KeyboardModifiers keys) {
            ui::BrushSettings brush;
            brush.setTool(tool);
            return ui::withModifiers(brush, keys);
        };
        for (std::size_t i = 0; i < core::toolNames().size(); ++i) {
            const auto tool = static_cast<Tool>(i);
            QCOMPARE(with(tool, Qt::ShiftModifier).tool, Tool::Smooth);
            QVERIFY(with(tool, Qt::NoModifier).tool == tool && !with(tool, Qt::NoModifier).inverted);
            const Tool inverse = tool == Tool::Pull ? Tool::Push : tool == Tool::Push ? Tool::Pull : tool;
            QCOMPARE(with(tool, Qt::ControlModifier).tool, inverse);
            QCOMPARE(with(tool, Qt::ControlModifier).inverted, core::hasInverse(tool));
            QVERIFY(!with(tool, Qt::ControlModifier | Qt::ShiftModifier).inverted);
        }
    }

    void eachToolHasItsOwnValues()
    {
        using core::Tool;
        ui::BrushSettings brush;
        brush.fitTo(model(100), 0.1);
        const auto use = [&](Tool tool, double factor) {
            brush.setTool(tool);
            brush.setValue(Parameter::Strength, factor);
            brush.setValue(Parameter::Falloff, 3 + 2 * factor);
            brush.setValue(Parameter::Spacing, factor);
            brush.set(&core::StrokeSettings::alpha, core::builtInAlpha(factor > 1 ? "star" : "ring"));
            brush.set(&core::StrokeSettings::alphaFollows, factor > 1);
            brush.tools()->setAirbrush(tool, factor > 1);
        };
        use(Tool::Clay, 2);
        use(Tool::Inflate, 1);
        brush.setTool(Tool::Crease);
        const core::StrokeSettings crease = brush.stroke();
        QVERIFY(crease.strength == 1 && crease.falloff == 4 && crease.spacing == ui::defaultSpacing && !crease.alpha);
        for (const auto& [tool, factor] : {std::pair(Tool::Clay, 2.0), std::pair(Tool::Inflate, 1.0)}) {
            brush.setTool(tool);
            const core::StrokeSettings& stroke = brush.stroke();
            QCOMPARE(stroke.strength, factor);
            QCOMPARE(stroke.falloff, static_cast<int>(3 + 2 * factor));
            QCOMPARE(stroke.spacing, factor);
            QCOMPARE(stroke.alpha, core::builtInAlpha(factor > 1 ? "star" : "ring"));
            QCOMPARE(stroke.alphaFollows, factor > 1);
            QCOMPARE(brush.tools()->isAirbrush(tool), factor > 1);
        }
        brush.reset();
        brush.setTool(Tool::Clay);
        QVERIFY(brush.stroke().strength == 1 && !brush.stroke().alpha);
    }

    void theRadiusIsSharedUnlessEachToolHasItsOwn()
    {
        using core::Tool;
        ui::BrushSettings brush;
        brush.fitTo(model(100), 0.1);
        brush.setValue(Parameter::Radius, 7);
        brush.setTool(Tool::Clay);
        QCOMPARE(brush.stroke().radius, 7.0);
        brush.tools()->setSharesRadius(false);
        brush.setValue(Parameter::Radius, 20);
        brush.setTool(Tool::Smooth);
        QVERIFY(qFuzzyCompare(brush.stroke().radius, 7.0)); // Smooth has never had a radius of its own
        brush.setValue(Parameter::Radius, 3);
        brush.setTool(Tool::Clay);
        QVERIFY(qFuzzyCompare(brush.stroke().radius, 20.0));
        brush.tools()->setSharesRadius(true);
        brush.setTool(Tool::Smooth);
        QVERIFY(qFuzzyCompare(brush.stroke().radius, 20.0));
        brush.setTool(Tool::Clay);
        brush.tools()->setSharesRadius(false);
        brush.setTool(Tool::Smooth);
        QVERIFY(qFuzzyCompare(brush.stroke().radius, 3.0));
        brush.fitTo(model(1000), brush.radiusShare()); // all radii scale with the model
        brush.setTool(Tool::Clay);
        QVERIFY(qFuzzyCompare(brush.stroke().radius, 200.0));
    }

    /// Smoothing with Shift uses Smooth's own values, except the radius.
    void shiftSmoothsAsStronglyAsSmooth()
    {
        ui::BrushSettings brush;
        brush.setTool(core::Tool::Smooth);
        brush.setValue(Parameter::Strength, 0.25);
        brush.setTool(core::Tool::Clay);
        brush.setValue(Parameter::Strength, 2);
        brush.setValue(Parameter::Spacing, 1.5);
        brush.setValue(Parameter::Radius, 12);
        const core::StrokeSettings smooth = ui::withModifiers(brush, Qt::ShiftModifier);
        QCOMPARE(smooth.strength, 0.25);
        QCOMPARE(smooth.spacing, ui::defaultSpacing);
        QCOMPARE(smooth.radius, 12.0);
        QCOMPARE(ui::withModifiers(brush, Qt::NoModifier).strength, 2.0);
        QCOMPARE(ui::withModifiers(brush, Qt::ControlModifier).strength, 2.0);
    }

    void smallerAndLargerUndoEachOther()
    {
        ui::BrushSettings brush;
        const double radius = brush.value(Parameter::Radius);
        brush.scaleRadius(0.9);
        QVERIFY(brush.value(Parameter::Radius) < radius);
        brush.scaleRadius(1 / 0.9);
        QVERIFY(qFuzzyCompare(brush.value(Parameter::Radius), radius));
    }

    void onlyChangesAreTold()
    {
        ui::BrushSettings brush;
        QSignalSpy changed(&brush, &ui::BrushSettings::changed);
        brush.setTool(brush.tool());
        brush.setValue(Parameter::Strength, brush.value(Parameter::Strength));
        QCOMPARE(changed.count(), 0);
        brush.setTool(core::Tool::Smooth);
        QCOMPARE(changed.count(), 1);
    }
};

FETTLE_TEST(TestBrushSettings)
#include "tst_brush_settings.moc"
