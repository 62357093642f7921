#include "ui/widgets/side_column.h"

#include "tests/ui/ui_test.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QMainWindow>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

using ui::SideColumn;
using ui::SidePanel;
using State = SidePanel::State;

namespace
{
/// A window with a column of three forms and a list.
struct Column
{
    Column()
    {
        window.setCentralWidget(new QWidget);
        column = new SideColumn(&window);
        window.addDockWidget(Qt::RightDockWidgetArea, column);
        for (const char* name : {"first", "second", "third"})
            column->add(QLatin1StringView(name), QLatin1StringView(name), form(), State::Open);
        column->add(QStringLiteral("list"), QStringLiteral("list"), new QListWidget);
        window.resize(600, 300);
        window.show();
    }

    static QWidget* form()
    {
        auto* form = new QWidget;
        form->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
        auto* rows = new QVBoxLayout(form);
        auto* box = new QSpinBox;
        box->setRange(0, 100);
        box->setValue(50);
        rows->addWidget(box);
        for (int i = 0; i < 6; ++i)
            rows->addWidget(new QLabel(QStringLiteral("row")));
        return form;
    }

    SidePanel* panel(const char* name) const { return window.findChild<SidePanel*>(QLatin1StringView(name)); }
    QScrollArea* area() const { return column->findChild<QScrollArea*>(); }
    QToolButton* header(const char* name) const { return panel(name)->findChild<QToolButton*>(); }

    QMainWindow window;
    SideColumn* column = nullptr;
};

void turnWheel(QWidget* over)
{
    const QPointF at = over->rect().center();
    QWheelEvent event(at, over->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(over, &event);
}
} // namespace

class TestSideColumn : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void headers_foldAndUnfold()
    {
        const Column c;
        SidePanel* panel = c.panel("second");
        const int whole = panel->height();
        QTest::mouseClick(c.header("second"), Qt::LeftButton);
        QCOMPARE(panel->state(), State::Folded);
        QTRY_VERIFY(panel->height() < whole / 2);
        QTest::keyClick(c.header("second"), Qt::Key_Space);
        QCOMPARE(panel->state(), State::Open);
        QTRY_COMPARE(panel->height(), whole);
        QTest::mouseClick(c.header("second"), Qt::LeftButton, Qt::ControlModifier);
        QCOMPARE(panel->state(), State::Open);
        QCOMPARE(c.panel("first")->state(), State::Folded);
        QCOMPARE(c.panel("third")->state(), State::Folded);
    }

    /// A panel that becomes wider gets its full width, beside the scroll bar.
    void widerPanel_isSeenWhole()
    {
        const Column c;
        auto* wide = new QLabel(QStringLiteral("wide"));
        wide->setMinimumHeight(900);
        c.column->add(QStringLiteral("wide"), QStringLiteral("wide"), wide, State::Open);
        QTest::qWait(50);
        QVERIFY(c.column->width() < 333);
        wide->setMinimumWidth(333);
        QTRY_VERIFY(c.area()->viewport()->width() >= 333);
        QVERIFY(c.area()->verticalScrollBar()->isVisible());
    }

    /// The column's width does not change when panels are opened or folded, so the view keeps its size.
    void width_isThatOfTheWidestPanel()
    {
        const Column c;
        const int width = c.column->width();
        for (SidePanel* panel : c.column->panels())
            panel->setState(State::Folded);
        QTest::qWait(50);
        QCOMPARE(c.column->width(), width);
        c.panel("list")->bringForward();
        QTest::qWait(50);
        QCOMPARE(c.column->width(), width);
        for (SidePanel* panel : c.column->panels())
            panel->setState(State::Hidden);
        QVERIFY(!c.column->isVisible());
        c.panel("third")->toggleViewAction()->trigger();
        QVERIFY(c.column->isVisible() && c.panel("third")->state() == State::Open);
    }

    void panelsBroughtForward_areInSight()
    {
        const Column c;
        QTRY_VERIFY(c.area()->verticalScrollBar()->maximum() > 0);
        for (const char* name : {"list", "first", "third"}) {
            c.panel(name)->bringForward();
            const auto top = [&] { return c.panel(name)->mapTo(c.area()->viewport(), QPoint()).y(); };
            QTRY_VERIFY2(top() >= 0 && top() + c.header(name)->height() <= c.area()->viewport()->height(), name);
        }
    }

    void lists_haveSomeLines()
    {
        const Column c;
        c.panel("list")->bringForward();
        const auto* list = c.panel("list")->findChild<QListWidget*>();
        QTRY_VERIFY(list->height() >= 7 * list->fontMetrics().lineSpacing());
    }

    /// The wheel over a number scrolls the column, unless the number has the focus.
    void wheel_turnsWhatHasTheFocus()
    {
        Column c;
        c.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&c.window));
        auto* box = c.panel("first")->findChild<QSpinBox*>();
        box->clearFocus();
        turnWheel(box);
        QCOMPARE(box->value(), 50);
        box->setFocus();
        turnWheel(box);
        QCOMPARE(box->value(), 49);
    }

    void states_comeBack()
    {
        QStringList states;
        {
            const Column c;
            c.panel("first")->setState(State::Hidden);
            c.panel("second")->setState(State::Folded);
            states = c.column->panelStates();
        }
        const Column c;
        states << QStringLiteral("stranger open") << QStringLiteral("third") << QString();
        c.column->setPanelStates(states);
        QCOMPARE(c.panel("first")->state(), State::Hidden);
        QVERIFY(!c.panel("first")->toggleViewAction()->isChecked());
        QCOMPARE(c.panel("second")->state(), State::Folded);
        QCOMPARE(c.panel("third")->state(), State::Open);
    }
};

FETTLE_TEST(TestSideColumn, ui::TestApplication)
#include "tst_side_column.moc"
