#include "ui/history/history_panel.h"
#include "ui/settings/settings.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QLabel>
#include <QLocale>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QTreeView>

namespace
{
/// Returns a history of four steps: the first has expired and the last is undone.
ui::History fourSteps()
{
    ui::History history;
    history.steps = {{QStringLiteral("Pull"), QStringLiteral("pull"), 12, 0},
                     {QStringLiteral("Push"), QStringLiteral("push"), 1, 3},
                     {QStringLiteral("Fill"), QStringLiteral("fill"), 0, 0},
                     {QStringLiteral("Smooth"), QStringLiteral("smooth"), 5, 0}};
    history.present = 3;
    history.first = 1;
    history.last = 4;
    history.bytes = 5 << 19;
    return history;
}

struct Shown
{
    Shown()
    {
        panel.resize(240, 400);
        panel.show();
    }

    QTreeView* list() const { return panel.findChild<QTreeView*>(); }
    QString text(int row, int column) const { return list()->model()->index(row, column).data().toString(); }
    void click(int row) const
    {
        const QRect place = list()->visualRect(list()->model()->index(row, 0));
        QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, place.center());
    }

    ui::Settings settings;
    ui::HistoryPanel panel{&settings};
};
} // namespace

class TestHistoryPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QSettings().clear(); }

    void everyStepIsNamedAndMarked()
    {
        Shown s;
        s.panel.setHistory(fourSteps());
        QCOMPARE(s.list()->model()->rowCount(), 5);
        QCOMPARE(s.text(1, 0), QStringLiteral("Pull"));
        QVERIFY(s.text(2, 1).contains(QLocale().toString(1)) && s.text(2, 1).contains(QLocale().toString(3)));
        QVERIFY(s.text(3, 1).isEmpty());
        for (int row = 0; row < 5; ++row)
            QVERIFY(!s.list()->model()->index(row, 0).data(Qt::DecorationRole).isNull());
        QCOMPARE(s.list()->currentIndex().row(), 3);
        QVERIFY(s.panel.findChild<QLabel*>(QStringLiteral("historyMemory"))
                    ->text()
                    .contains(QLocale().toString(2.5, 'f', 1)));
    }

    void aClickGoesToAnyStepThatIsKept()
    {
        Shown s;
        QVERIFY(QTest::qWaitForWindowExposed(&s.panel));
        s.panel.setHistory(fourSteps());
        QSignalSpy jumps(&s.panel, &ui::HistoryPanel::jumpRequested);
        for (const int row : {1, 4, 2}) {
            jumps.clear();
            s.click(row);
            QVERIFY(!jumps.isEmpty());
            for (const QList<QVariant>& jump : jumps)
                QCOMPARE(jump[0].toInt(), row);
        }
    }

    void whatExpiredSaysSoAndCannotBeReached()
    {
        Shown s;
        QVERIFY(QTest::qWaitForWindowExposed(&s.panel));
        s.panel.setHistory(fourSteps());
        QSignalSpy jumps(&s.panel, &ui::HistoryPanel::jumpRequested);
        s.click(0);
        QCOMPARE(jumps.count(), 0);
        QVERIFY(!s.text(0, 1).isEmpty() && s.text(0, 1) != s.text(4, 1));
    }

    void keysGoThere()
    {
        Shown s;
        s.panel.setHistory(fourSteps());
        QSignalSpy jumps(&s.panel, &ui::HistoryPanel::jumpRequested);
        QTest::keyClick(s.list(), Qt::Key_Up);
        QCOMPARE(jumps.count(), 0); // moving the selection does not jump
        QTest::keyClick(s.list(), Qt::Key_Return);
        QCOMPARE(jumps.count(), 1);
        QCOMPARE(jumps[0][0].toInt(), 2);
    }

    void theTimelineSpansWhatIsKept()
    {
        Shown s;
        s.panel.setHistory(fourSteps());
        const auto* slider = s.panel.findChild<QSlider*>();
        QCOMPARE(slider->minimum(), 1);
        QCOMPARE(slider->maximum(), 4);
        QCOMPARE(slider->value(), 3);
        const auto text = [&s] { return s.panel.findChild<QLabel*>(QStringLiteral("timelineText"))->text(); };
        QVERIFY2(text().contains(QStringLiteral("Fill")), qPrintable(text()));
        s.panel.setHistory({});
        QVERIFY(!slider->isEnabled());
    }

    void theTimelineStaysWhereItWasPulledUntilTheModelIsThere()
    {
        Shown s;
        ui::History history = fourSteps();
        s.panel.setHistory(history);
        auto* slider = s.panel.findChild<QSlider*>();
        QSignalSpy wanted(&s.panel, &ui::HistoryPanel::stateRequested);
        const auto comeTo = [&](int present) {
            history.present = present;
            s.panel.setHistory(history);
        };
        slider->setValue(1);
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted[0][0].toInt(), 1);
        comeTo(2); // between the old and the requested state
        QCOMPARE(slider->value(), 1);
        comeTo(1);
        comeTo(3); // a Redo
        QCOMPARE(slider->value(), 3);
        slider->setValue(1);
        comeTo(4); // a change away from the requested state, made elsewhere
        QCOMPARE(slider->value(), 4);
        slider->setValue(2);
        history.steps.append({QStringLiteral("Pull"), QStringLiteral("pull"), 1, 0});
        history.last = 5;
        comeTo(5); // a new stroke
        QCOMPARE(slider->value(), 5);
        QCOMPARE(wanted.count(), 3); // changes of the model request nothing
    }

    void theCapComesBack()
    {
        {
            Shown s;
            QSignalSpy capped(&s.panel, &ui::HistoryPanel::capChanged);
            s.panel.findChild<QSpinBox*>()->setValue(100);
            QCOMPARE(capped.count(), 1);
            QCOMPARE(capped[0][0].toLongLong(), qint64(100) << 20);
        }
        QCOMPARE(Shown().panel.cap(), qint64(100) << 20);
        QSettings().setValue(QStringLiteral("history/megabytes"), -5);
        QCOMPARE(Shown().panel.cap(), qint64(ui::defaultHistoryMegabytes) << 20);
    }
};

FETTLE_TEST(TestHistoryPanel, ui::TestApplication)
#include "tst_history_panel.moc"
