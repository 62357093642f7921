#include "ui/classroom/class_bar.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QTranslator>

namespace
{
/// A translator whose texts are longer than those of Fettle's languages.
class LongWords : public QTranslator
{
public:
    LongWords() { QCoreApplication::installTranslator(this); }
    QString translate(const char* /*context*/, const char* source, const char* /*comment*/, int) const override
    {
        const QString text = QString::fromUtf8(source);
        return text + QString(text.size() / 3, u'n');
    }
    bool isEmpty() const override { return false; }
};
} // namespace

/// Tests that all important parts of the bar are visible, however long names and texts are.
class TestClassBar : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aNarrowWindow_showsAllButtons_data();
    void aNarrowWindow_showsAllButtons();
    void aWideWindow_cutsNothing();
};

namespace
{
/// A window whose class bar shows all its parts at once.
struct FullBar
{
    FullBar(const QString& pupil, int width)
    {
        window.addToolBar(QStringLiteral("below"));
        bar = new ui::ClassBar(QStringLiteral("Class 5b, Tuesday"), &window);
        bar->setPupil(pupil);
        bar->setResumable(pupil);
        bar->setUndelivered(12, QStringLiteral("tip"));
        bar->setTime(ui::TurnTime{19 * 60, true, 0});
        window.resize(width, 540);
        window.show();
    }
    static bool isWhole(const QWidget* widget)
    {
        return widget->visibleRegion().boundingRect() == widget->rect() &&
               widget->width() >= widget->minimumSizeHint().width();
    }

    QMainWindow window;
    ui::ClassBar* bar = nullptr;
};
} // namespace

void TestClassBar::aNarrowWindow_showsAllButtons_data()
{
    QTest::addColumn<bool>("hasLongWords");
    QTest::newRow("English") << false;
    QTest::newRow("longer words") << true;
}

void TestClassBar::aNarrowWindow_showsAllButtons()
{
    QFETCH(const bool, hasLongWords);
    const auto words = hasLongWords ? std::make_unique<LongWords>() : nullptr;
    FullBar full(QStringLiteral("Wilhelmine-Charlotte von der Heide-Loos"), 960);
    QVERIFY(QTest::qWaitForWindowExposed(&full.window));
    QCOMPARE(full.window.width(), 960); // the bar did not widen the window
    for (const QPushButton* button : full.bar->findChildren<QPushButton*>())
        QTRY_VERIFY2(FullBar::isWhole(button), qPrintable(button->text()));
    for (const char* label : {"classTitle", "classPupil", "classWaiting", "classClock", "classTime"})
        QVERIFY2(FullBar::isWhole(full.bar->findChild<QLabel*>(QLatin1StringView(label))), label);
    QVERIFY(!full.bar->findChild<QWidget*>(QStringLiteral("qt_toolbar_ext_button"))->isVisible());
    const auto* pupil = full.bar->findChild<QLabel*>(QStringLiteral("classPupil"));
    QCOMPARE(pupil->toolTip(), pupil->text());
}

void TestClassBar::aWideWindow_cutsNothing()
{
    FullBar full(QStringLiteral("Anna"), 1600);
    QVERIFY(QTest::qWaitForWindowExposed(&full.window));
    for (const QLabel* label : full.bar->findChildren<QLabel*>())
        QTRY_VERIFY2(label->width() >= label->sizeHint().width(), qPrintable(label->objectName()));
}

FETTLE_TEST(TestClassBar, ui::TestApplication)
#include "tst_class_bar.moc"
