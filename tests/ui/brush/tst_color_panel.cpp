#include "ui/actions/actions.h"
#include "ui/brush/color_panel.h"
#include "ui/brush/color_swatches.h"
#include "ui/brush/color_wheel.h"
#include "ui/settings/brush_settings.h"
#include "ui/settings/settings.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QAction>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>

#include <cmath>

using core::Rgb;

namespace
{
/// The colour panel in its own window.
struct Palette
{
    Palette()
    {
        window.setCentralWidget(panel);
        window.show();
    }

    template <class Widget> Widget* child(const char* name) const
    {
        return panel->findChild<Widget*>(QLatin1StringView(name));
    }
    const Rgb& color() const { return brush.stroke().color; }
    void drag(const QPointF& from, const QPointF& to)
    {
        sendMouse(panel->wheel(), QEvent::MouseButtonPress, from.toPoint(), Qt::LeftButton);
        sendMouse(panel->wheel(), QEvent::MouseMove, to.toPoint(), Qt::LeftButton);
        sendMouse(panel->wheel(), QEvent::MouseButtonRelease, to.toPoint(), Qt::LeftButton);
    }
    void type(const QString& text)
    {
        auto* name = child<QLineEdit>("colorName");
        name->selectAll();
        QTest::keyClicks(name, text);
        QTest::keyClick(name, Qt::Key_Return);
    }

    QMainWindow window;
    ui::BrushSettings brush;
    ui::Settings settings;
    ui::Actions actions{&window};
    ui::ColorPanel* panel = new ui::ColorPanel(&brush, &settings, actions);
};

bool isNear(const Rgb& a, const Rgb& b, int by)
{
    return std::abs(a.r - b.r) <= by && std::abs(a.g - b.g) <= by && std::abs(a.b - b.b) <= by;
}
} // namespace

class TestColorPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QSettings().clear(); }

    void everyViewShowsTheBrush()
    {
        Palette p;
        const Rgb color{12, 200, 77};
        p.brush.set(&core::StrokeSettings::color, color);
        QCOMPARE(p.panel->wheel()->color(), color);
        QCOMPARE(p.child<QSpinBox>("red.box")->value(), 12);
        QCOMPARE(p.child<QSlider>("green.slider")->value(), 200);
        QCOMPARE(p.child<QSpinBox>("blue.box")->value(), 77);
        QCOMPARE(p.child<QLineEdit>("colorName")->text(), QStringLiteral("#0cc84d"));
        QCOMPARE(p.color(), color); // showing a colour does not change it
    }

    void channelsAreSetOneByOne()
    {
        Palette p;
        p.brush.set(&core::StrokeSettings::color, Rgb{1, 2, 3});
        p.child<QSpinBox>("red.box")->setValue(255);
        QCOMPARE(p.color(), (Rgb{255, 2, 3}));
        p.child<QSlider>("blue.slider")->setValue(0);
        QCOMPARE(p.color(), (Rgb{255, 2, 0}));
    }

    void theWheelIsDragged()
    {
        Palette p;
        ui::ColorWheel* wheel = p.panel->wheel();
        p.brush.set(&core::StrokeSettings::color, Rgb{255, 0, 0});
        const QPointF grey = wheel->placeInSquare(0, 0.5);
        p.drag(grey, wheel->placeInSquare(1, 1));
        QVERIFY(isNear(p.color(), {255, 0, 0}, 4));
        p.drag(wheel->placeOfHue(0), wheel->placeOfHue(1.0 / 3));
        QVERIFY(isNear(p.color(), {0, 255, 0}, 10));
        // Beyond the corner of the square
        p.drag(wheel->placeInSquare(0.5, 0.5), wheel->placeInSquare(1, 0) + QPointF(50, 50));
        QVERIFY(isNear(p.color(), {0, 0, 0}, 0));
    }

    void aGreyKeepsItsHue()
    {
        Palette p;
        ui::ColorWheel* wheel = p.panel->wheel();
        p.brush.set(&core::StrokeSettings::color, Rgb{0, 0, 255});
        p.drag(wheel->placeInSquare(1, 1), wheel->placeInSquare(0, 1) - QPointF(20, 0));
        QVERIFY(isNear(p.color(), {255, 255, 255}, 4));
        p.drag(wheel->placeInSquare(0, 1), wheel->placeInSquare(1, 1) + QPointF(20, 0));
        QVERIFY(isNear(p.color(), {0, 0, 255}, 4));
    }

    void theWheelHasKeys()
    {
        Palette p;
        p.brush.set(&core::StrokeSettings::color, Rgb{200, 50, 50});
        const auto press = [&](Qt::Key key) {
            const Rgb before = p.color();
            QTest::keyClick(p.panel->wheel(), key);
            return !(p.color() == before);
        };
        for (const Qt::Key key :
             {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::Key_PageUp, Qt::Key_PageDown})
            QVERIFY(press(key));
        QVERIFY(isNear(p.color(), {200, 50, 50}, 2)); // opposite keys cancel each other
    }

    void aColourIsTyped()
    {
        Palette p;
        QSignalSpy refused(p.panel, &ui::ColorPanel::refused), entered(p.panel, &ui::ColorPanel::entered);
        p.type(QStringLiteral("#0a141e"));
        QCOMPARE(p.color(), (Rgb{10, 20, 30}));
        p.type(QStringLiteral("ff8000"));
        QCOMPARE(p.color(), (Rgb{255, 128, 0}));
        QCOMPARE(entered.count(), 2);
        QCOMPARE(refused.count(), 0);
        p.type(QStringLiteral("#zz"));
        QCOMPARE(p.color(), (Rgb{255, 128, 0}));
        QCOMPARE(refused.count(), 1);
        QCOMPARE(p.child<QLineEdit>("colorName")->text(), QStringLiteral("#ff8000"));
    }

    void twoColoursAreSwapped()
    {
        Palette p;
        p.brush.set(&core::StrokeSettings::color, Rgb{1, 2, 3});
        p.child<QToolButton>("colorPair")->click();
        const Rgb other = p.color();
        QVERIFY(!(other == Rgb{1, 2, 3}));
        p.actions.get(QStringLiteral("color.swap"))->trigger();
        QCOMPARE(p.color(), (Rgb{1, 2, 3}));
        p.actions.get(QStringLiteral("color.swap"))->trigger();
        QCOMPARE(p.color(), other);
    }

    void swatchesAreTakenKeptAndRemoved()
    {
        const Rgb mine{9, 8, 7};
        {
            Palette p;
            auto* swatches = p.child<ui::ColorSwatches>("swatches");
            const QList<Rgb> before = swatches->colors();
            QVERIFY(!before.isEmpty());
            p.child<QPushButton>("swatch")->click();
            QCOMPARE(p.color(), before.front());
            p.brush.set(&core::StrokeSettings::color, mine);
            p.child<QToolButton>("addSwatch")->click();
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            p.child<QToolButton>("addSwatch")->click(); // adding the same colour again
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            QCOMPARE(swatches->colors(), before + QList<Rgb>{mine});
            p.child<QPushButton>("swatch")->actions().front()->trigger();
            QCOMPARE(swatches->colors(), before.sliced(1) + QList<Rgb>{mine});
        }
        Palette p;
        QVERIFY(p.child<ui::ColorSwatches>("swatches")->colors().contains(mine));
        QCOMPARE(p.child<ui::ColorSwatches>("swatches")->colors(), p.settings.get(&ui::Setting::swatches));
    }

    /// A swatch of the window's colour is visible by its frame, which has the text colour.
    void theSwatchesFramesFollowTheTheme()
    {
        ui::ColorSwatches swatches;
        swatches.setColors({{128, 128, 128}});
        const auto frame = [&](const QColor& text) {
            QPalette palette;
            palette.setColor(QPalette::WindowText, text);
            swatches.setPalette(palette);
            const QList<QPushButton*> all = swatches.findChildren<QPushButton*>(QStringLiteral("swatch"));
            return all.last()->icon().pixmap(20, 20).toImage().pixelColor(0, 0).lightness();
        };
        QVERIFY(frame(Qt::black) < 128);
        QVERIFY(frame(Qt::white) > 128);
        QVERIFY(frame(Qt::black) < 128);
    }

    void swatchesHaveRoomForSoMany()
    {
        Palette p;
        auto* swatches = p.child<ui::ColorSwatches>("swatches");
        for (int i = 0; i <= ui::ColorSwatches::maxSwatches; ++i)
            swatches->add({0, 0, static_cast<std::uint8_t>(i)});
        QCOMPARE(swatches->colors().size(), ui::ColorSwatches::maxSwatches);
        QCOMPARE(swatches->colors().back(), (Rgb{0, 0, ui::ColorSwatches::maxSwatches}));
    }

    void everyControlHasANameAndATip()
    {
        Palette p;
        for (const QWidget* widget : p.panel->findChildren<QWidget*>()) {
            if (widget->focusPolicy() == Qt::NoFocus || widget->objectName().startsWith(QStringLiteral("qt_")))
                continue;
            const auto* button = qobject_cast<const QToolButton*>(widget);
            QVERIFY2(!widget->accessibleName().isEmpty() || (button && button->defaultAction()),
                     qPrintable(widget->objectName()));
            QVERIFY2(!widget->toolTip().isEmpty(), qPrintable(widget->objectName()));
        }
    }
};

FETTLE_TEST(TestColorPanel, ui::TestApplication)
#include "tst_color_panel.moc"
