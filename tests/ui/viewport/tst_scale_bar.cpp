#include "ui/viewport/scale_bar.h"

#include "ui/scene/orbit_camera.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <cmath>

using Projection = ui::OrbitCamera::Projection;

class TestScaleBar : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isTrueAndRoundAtEverySize_data()
    {
        QTest::addColumn<Projection>("projection");
        QTest::newRow("perspective") << Projection::Perspective;
        QTest::newRow("orthographic") << Projection::Orthographic;
    }

    /// Two points at the distance that the bar states, parallel to the picture, are as far apart on the screen as the
    /// bar is long.
    void isTrueAndRoundAtEverySize()
    {
        QFETCH(Projection, projection);
        QWidget parent;
        parent.resize(800, 600);
        ui::ScaleBar bar(&parent);
        ui::OrbitCamera camera;
        camera.setViewport(800, 600);
        for (double size = 0.5; size < 2000; size *= 1.37) {
            camera.frame(core::Box(core::Vec3(-size, -size, -size), core::Vec3(size, size, size)));
            camera.setProjection(projection);
            bar.showFor(camera);
            const core::Vec3 from = camera.pivot(), to = from + bar.millimetres() * camera.right();
            QVERIFY(std::abs((camera.project(to) - camera.project(from)).norm() - bar.pixels()) < 0.01);
            QVERIFY(bar.pixels() > 50 && bar.pixels() <= bar.width());
            const double power = std::pow(10.0, std::floor(std::log10(bar.millimetres()) + 1e-9));
            const double mantissa = bar.millimetres() / power;
            QVERIFY(std::abs(mantissa - 1) < 1e-9 || std::abs(mantissa - 2) < 1e-9 || std::abs(mantissa - 5) < 1e-9);
        }
    }

    void staysInTheCorner()
    {
        QWidget parent;
        parent.resize(800, 600);
        const ui::ScaleBar bar(&parent);
        parent.show();
        for (const QSize size : {QSize(400, 300), QSize(1000, 700)}) {
            parent.resize(size);
            QCoreApplication::processEvents();
            QVERIFY(parent.rect().contains(bar.geometry()));
            QVERIFY(bar.geometry().bottom() > size.height() - 40 && bar.x() < 40);
        }
    }

    void saysItsLengthToWhoeverCannotSeeIt()
    {
        QWidget parent;
        parent.resize(800, 600);
        ui::ScaleBar bar(&parent);
        ui::OrbitCamera camera;
        camera.setViewport(800, 600);
        bar.showFor(camera);
        QVERIFY(bar.accessibleName().contains(QLocale().toString(bar.millimetres())));
    }
};

FETTLE_TEST(TestScaleBar, ui::TestApplication)
#include "tst_scale_bar.moc"
