#include "ui/model/model_panel.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QLabel>
#include <QLocale>
#include <QSignalSpy>

namespace
{
core::TriangleMesh open()
{
    core::TriangleMesh mesh = core::icosphere(2, 10);
    mesh.triangles.pop_back();
    return mesh;
}
} // namespace

class TestModelPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void figuresAreOfTheReport()
    {
        ui::ModelPanel panel;
        const core::MeshReport report = core::checkMesh(core::icosphere(3, 10));
        panel.setReport(report);
        const auto text = [&](const char* id) { return panel.findChild<QLabel*>(QLatin1StringView(id))->text(); };
        QCOMPARE(text("model.vertices"), QLocale().toString(qulonglong(report.vertices)));
        QCOMPARE(text("model.faces"), QLocale().toString(qulonglong(report.faces)));
        QCOMPARE(text("model.genus"), QLocale().toString(0));
        QCOMPARE(text("model.components"), QLocale().toString(1));
        QVERIFY(text("model.size").contains(QLocale().toString(20.0, 'f', 2)));
        QVERIFY(text("model.volume").contains(QLocale().toString(*report.volume / 1000, 'f', 3)));
    }

    void onlyACheckedModelIsSound()
    {
        ui::ModelPanel panel;
        const auto* word = panel.findChild<QLabel*>(QStringLiteral("health"));
        const auto* value = panel.findChild<QLabel*>(QStringLiteral("model.faces"));
        const QString unknown = word->text();
        panel.setReport(core::checkMesh(core::icosphere(2, 10)));
        const QString sound = word->text();
        QVERIFY(value->isEnabled());
        panel.setStale();
        QCOMPARE(word->text(), unknown);
        QVERIFY(!value->isEnabled() && !value->text().isEmpty());
        panel.setReport(core::checkMesh(open()));
        QVERIFY(word->text() != sound && word->text() != unknown && sound != unknown);
    }

    void itSaysWhetherItIsWatched()
    {
        ui::ModelPanel panel;
        QSignalSpy watched(&panel, &ui::ModelPanel::watched);
        panel.show();
        panel.hide();
        QCOMPARE(watched.count(), 2);
        QVERIFY(watched[0][0].toBool() && !watched[1][0].toBool());
    }
};

FETTLE_TEST(TestModelPanel, ui::TestApplication)
#include "tst_model_panel.moc"
