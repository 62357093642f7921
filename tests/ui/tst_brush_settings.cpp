#include "ui/brush_settings.h"

#include <QSignalSpy>
#include <QTest>

using core::Parameter;

class TestBrushSettings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
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

    void theRadiusStaysInTheModelsRange()
    {
        ui::BrushSettings brush;
        brush.setRadiusRange(2, 30);
        brush.scaleRadius(1000);
        QCOMPARE(brush.value(Parameter::Radius), 30.0);
        brush.scaleRadius(1e-9);
        QCOMPARE(brush.value(Parameter::Radius), 2.0);
        brush.setRadiusRange(5, 6);
        QCOMPARE(brush.value(Parameter::Radius), 5.0);
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

QTEST_APPLESS_MAIN(TestBrushSettings)
#include "tst_brush_settings.moc"
