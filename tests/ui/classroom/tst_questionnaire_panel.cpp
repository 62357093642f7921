#include "ui/classroom/answer_scale.h"
#include "ui/classroom/questionnaire_panel.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QToolButton>

using ui::Questionnaire;
using ui::QuestionnairePanel;

/// Tests the form with mouse and keys, above a widget that must not receive any input.
class TestQuestionnairePanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { m_window.reset(); }
    void sixQuestions_haveSevenPointsAndTwoEnds();
    void aClick_answersAndTakesBack();
    void digits_answerFromAnywhere();
    void allKeys_fillTheForm();
    void arrows_stayInTheScale();
    void tab_comesToEachQuestionOnce();
    void skip_takesAllBack();
    void opening_forgetsTheLastPupil();
    void theWidgetBelow_isOutOfReach();
    void keysOfTheWindow_areTheForms();
    void tab_goesRound();
    void aLowWindow_scrolls();
    void aNarrowWindow_hasAllInReach_data();
    void aNarrowWindow_hasAllInReach();
    void ends_standBesideOrBelow();

private:
    QToolButton* point(int question, int answer) const
    {
        return m_panel->findChild<QToolButton*>(QStringLiteral("question%1.%2").arg(question).arg(answer));
    }
    QPushButton* button(const char* name) const { return m_panel->findChild<QPushButton*>(QLatin1StringView(name)); }
    void key(Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); }
    bool isInSight(const QWidget* widget) const
    {
        return widget->visibleRegion().boundingRect() == widget->rect() &&
               m_below->rect().contains(QRect(widget->mapTo(m_below, QPoint()), widget->size()));
    }

    std::unique_ptr<QWidget> m_window;
    QWidget* m_below = nullptr;
    QuestionnairePanel* m_panel = nullptr;
};

namespace
{
/// A widget that counts the mouse presses that reach it.
class Below : public QWidget
{
public:
    using QWidget::QWidget;
    int presses = 0;

protected:
    void mousePressEvent(QMouseEvent*) override { ++presses; }
    void wheelEvent(QWheelEvent*) override { ++presses; }
};

Questionnaire of(const std::array<int, ui::questionCount>& answers)
{
    Questionnaire made;
    for (std::size_t i = 0; i < answers.size(); ++i)
        if (answers[i] != 0)
            made.answers[i] = answers[i];
    return made;
}
} // namespace

void TestQuestionnairePanel::init()
{
    m_window = std::make_unique<QWidget>();
    m_window->resize(1000, 700);
    m_below = new Below(m_window.get());
    m_below->setFocusPolicy(Qt::StrongFocus);
    m_below->setGeometry(m_window->rect());
    m_panel = new QuestionnairePanel(m_below);
    QVERIFY(m_panel->isHidden());
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_panel->open(QStringLiteral("Anna <b>"));
}

void TestQuestionnairePanel::sixQuestions_haveSevenPointsAndTwoEnds()
{
    QCOMPARE(m_panel->findChildren<ui::AnswerScale*>().size(), 6);
    QCOMPARE(m_panel->findChildren<QToolButton*>().size(), 42);
    QVERIFY(m_panel->isVisible() && m_panel->size() == m_below->size());
    QVERIFY(m_panel->questionnaire().isEmpty());
    QStringList texts;
    for (const QLabel* label : m_panel->findChildren<QLabel*>())
        texts << label->text();
    QVERIFY(texts.contains(QStringLiteral("How was it, Anna <b>?")));
    QSet<QString> names;
    for (std::size_t i = 0; i < ui::questionCount; ++i) {
        const auto words = ui::QuestionWords::of(static_cast<ui::Question>(i));
        QVERIFY(texts.contains(words.question) && texts.contains(words.low) && texts.contains(words.high));
        for (int answer = ui::minAnswer; answer <= ui::maxAnswer; ++answer) {
            const QToolButton* button = point(static_cast<int>(i) + 1, answer);
            QVERIFY(button->accessibleName().contains(words.question));
            names << button->accessibleName();
        }
        QVERIFY(point(static_cast<int>(i) + 1, 1)->accessibleName().contains(words.low));
        QVERIFY(point(static_cast<int>(i) + 1, 7)->accessibleName().contains(words.high));
    }
    QCOMPARE(names.size(), 42);
}

void TestQuestionnairePanel::aClick_answersAndTakesBack()
{
    const QSignalSpy answered(m_panel, &QuestionnairePanel::answered);
    const QSignalSpy finished(m_panel, &QuestionnairePanel::finished);
    QTest::mouseClick(point(1, 6), Qt::LeftButton);
    QTest::mouseClick(point(6, 1), Qt::LeftButton);
    QCOMPARE(m_panel->questionnaire(), of({6, 0, 0, 0, 0, 1}));
    QTest::mouseClick(point(1, 2), Qt::LeftButton);
    QVERIFY(!point(1, 6)->isChecked() && point(1, 2)->isChecked());
    QTest::mouseClick(point(6, 1), Qt::LeftButton);
    QCOMPARE(m_panel->questionnaire(), of({2, 0, 0, 0, 0, 0}));
    QCOMPARE(answered.size(), 4);
    QCOMPARE(answered.last().constFirst().value<Questionnaire>(), m_panel->questionnaire());
    QCOMPARE(finished.size(), 0);
    QTest::mouseClick(button("questionsDone"), Qt::LeftButton);
    QCOMPARE(finished.size(), 1);
    QCOMPARE(m_panel->questionnaire(), of({2, 0, 0, 0, 0, 0}));
}

void TestQuestionnairePanel::digits_answerFromAnywhere()
{
    point(2, 1)->setFocus();
    for (const auto& [digit, answer] : {std::pair(Qt::Key_1, 1), std::pair(Qt::Key_7, 7), std::pair(Qt::Key_4, 4)}) {
        key(digit);
        QCOMPARE(m_panel->questionnaire(), of({0, answer, 0, 0, 0, 0}));
        QCOMPARE(QApplication::focusWidget(), point(2, answer));
    }
    for (const Qt::Key none : {Qt::Key_0, Qt::Key_8, Qt::Key_9, Qt::Key_A})
        key(none);
    QCOMPARE(m_panel->questionnaire(), of({0, 4, 0, 0, 0, 0}));
    key(Qt::Key_Delete);
    QVERIFY(m_panel->questionnaire().isEmpty());
    key(Qt::Key_Space);
    QCOMPARE(m_panel->questionnaire(), of({0, 4, 0, 0, 0, 0}));
    key(Qt::Key_Space);
    QVERIFY(m_panel->questionnaire().isEmpty());
}

/// A digit and Return answer each question, and a last Return presses Done. No mouse is needed, and Skip is not pressed
/// by mistake.
void TestQuestionnairePanel::allKeys_fillTheForm()
{
    const QSignalSpy finished(m_panel, &QuestionnairePanel::finished);
    for (const Qt::Key digit : {Qt::Key_7, Qt::Key_6, Qt::Key_5, Qt::Key_4, Qt::Key_3, Qt::Key_2}) {
        key(digit);
        key(Qt::Key_Return);
    }
    QCOMPARE(QApplication::focusWidget(), button("questionsDone"));
    QCOMPARE(finished.size(), 0);
    key(Qt::Key_Return);
    QCOMPARE(finished.size(), 1);
    QCOMPARE(m_panel->questionnaire(), of({7, 6, 5, 4, 3, 2}));
}

void TestQuestionnairePanel::arrows_stayInTheScale()
{
    QCOMPARE(QApplication::focusWidget(), point(1, 1));
    key(Qt::Key_Left);
    QCOMPARE(QApplication::focusWidget(), point(1, 1));
    key(Qt::Key_Right);
    key(Qt::Key_Right);
    QCOMPARE(QApplication::focusWidget(), point(1, 3));
    key(Qt::Key_End);
    key(Qt::Key_Right);
    QCOMPARE(QApplication::focusWidget(), point(1, 7));
    key(Qt::Key_Down);
    QCOMPARE(QApplication::focusWidget(), point(2, 1));
    key(Qt::Key_Up);
    QCOMPARE(QApplication::focusWidget(), point(1, 7)); // the point focused last in that question
    QVERIFY(m_panel->questionnaire().isEmpty());        // moving the focus answers nothing
}

void TestQuestionnairePanel::tab_comesToEachQuestionOnce()
{
    key(Qt::Key_5);
    for (int question = 2; question <= 6; ++question) {
        key(Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget(), point(question, 1));
    }
    key(Qt::Key_Tab);
    QCOMPARE(QApplication::focusWidget(), button("questionsDone"));
    key(Qt::Key_Tab);
    QCOMPARE(QApplication::focusWidget(), button("skipQuestions"));
    for (int back = 0; back < 7; ++back)
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backtab, Qt::ShiftModifier);
    QCOMPARE(QApplication::focusWidget(), point(1, 5)); // point(1, 5) is the answered point
}

void TestQuestionnairePanel::skip_takesAllBack()
{
    QTest::mouseClick(point(3, 3), Qt::LeftButton);
    QStringList told;
    connect(m_panel, &QuestionnairePanel::answered, this, [&told](const Questionnaire& soFar) {
        told << (soFar.isEmpty() ? QStringLiteral("nothing") : QStringLiteral("something"));
    });
    connect(m_panel, &QuestionnairePanel::finished, this, [&told] { told << QStringLiteral("finished"); });
    button("skipQuestions")->setFocus();
    key(Qt::Key_Return);
    QCOMPARE(told, QStringList({"nothing", "finished"}));
    QVERIFY(m_panel->questionnaire().isEmpty());
}

void TestQuestionnairePanel::opening_forgetsTheLastPupil()
{
    QTest::mouseClick(point(4, 7), Qt::LeftButton);
    m_panel->close();
    QVERIFY(m_panel->isHidden() && m_below->hasFocus());
    m_panel->open(QStringLiteral("Ben"));
    QVERIFY(m_panel->questionnaire().isEmpty());
    QCOMPARE(m_panel->findChildren<QToolButton*>().size(), 42);
    for (const QToolButton* each : m_panel->findChildren<QToolButton*>())
        QVERIFY(!each->isChecked());
    QCOMPARE(QApplication::focusWidget(), point(1, 1));
}

void TestQuestionnairePanel::theWidgetBelow_isOutOfReach()
{
    m_below->resize(900, 650);
    QCOMPARE(m_panel->size(), m_below->size());
    for (const QPoint at : {QPoint(3, 3), m_below->rect().center(), m_below->rect().bottomRight() - QPoint(3, 3)})
        QTest::mouseClick(m_window->windowHandle(), Qt::LeftButton, {}, at);
    QCOMPARE(static_cast<Below*>(m_below)->presses, 0);
    m_panel->close();
    QTest::mouseClick(m_window->windowHandle(), Qt::LeftButton, {}, m_below->rect().center());
    QCOMPARE(static_cast<Below*>(m_below)->presses, 1);
}

/// While the form is open, the window's shortcuts with digits, letters and Ctrl do not run; those with Alt, function
/// keys and Quit do.
void TestQuestionnairePanel::keysOfTheWindow_areTheForms()
{
    QStringList triggered;
    const auto press = [&](const QKeySequence& keys) {
        QAction action;
        action.setShortcut(keys);
        connect(&action, &QAction::triggered, this, [&] { triggered << keys.toString(QKeySequence::PortableText); });
        m_window->addAction(&action);
        for (QWidget* at : {static_cast<QWidget*>(point(2, 3)), static_cast<QWidget*>(button("skipQuestions"))}) {
            at->setFocus();
            QTest::keyClick(at, keys[0].key(), keys[0].keyboardModifiers());
        }
    };
    for (const char* keys : {"3", "9", "Home", "Q", "Esc", "[", "Ctrl+Z", "Ctrl+Shift+V", "Shift+R"})
        press(QKeySequence(QLatin1StringView(keys)));
    QCOMPARE(triggered, QStringList());
    QCOMPARE(m_panel->questionnaire(), of({0, 3, 0, 0, 0, 0}));
    for (const QKeySequence& keys : {QKeySequence(Qt::Key_F11), QKeySequence(Qt::ALT | Qt::Key_V)})
        press(keys);
    QCOMPARE(triggered, QStringList({"F11", "F11", "Alt+V", "Alt+V"}));
    triggered.clear();
    const QList<QKeySequence> quits = QKeySequence::keyBindings(QKeySequence::Quit);
    for (const QKeySequence& quit : quits)
        press(quit);
    QCOMPARE(triggered.size(), 2 * quits.size());
    QVERIFY(m_panel->isVisible());
}

/// Tab stays within the form, although the window has another widget that accepts Tab.
void TestQuestionnairePanel::tab_goesRound()
{
    auto* beside = new QPushButton(QStringLiteral("beside"), m_window.get());
    beside->show();
    key(Qt::Key_Up);
    QCOMPARE(QApplication::focusWidget(), button("skipQuestions"));
    key(Qt::Key_Tab);
    QCOMPARE(QApplication::focusWidget(), point(1, 1));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backtab, Qt::ShiftModifier);
    QCOMPARE(QApplication::focusWidget(), button("skipQuestions"));
    QSet<QWidget*> met;
    for (int i = 0; i < 20; ++i) {
        key(Qt::Key_Tab);
        QVERIFY(m_panel->isAncestorOf(QApplication::focusWidget()));
        met << QApplication::focusWidget();
    }
    QCOMPARE(met.size(), 6 + 2);
}

/// If the form is too high for the window, its buttons stay visible and the focused question is scrolled into view.
void TestQuestionnairePanel::aLowWindow_scrolls()
{
    m_below->resize(900, 320);
    QTRY_VERIFY(isInSight(button("questionsDone")) && isInSight(button("skipQuestions")));
    QVERIFY(!isInSight(point(6, 1)));
    for (int question = 2; question <= 6; ++question) {
        key(Qt::Key_Tab);
        QTRY_VERIFY(isInSight(point(question, 1)));
    }
}

void TestQuestionnairePanel::aNarrowWindow_hasAllInReach_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<bool>("fits");
    QTest::newRow("beside the panels of 640 x 360") << QSize(255, 240) << true;
    QTest::newRow("between both arrangements") << QSize(560, 300) << true;
    QTest::newRow("beside the panels of 1024 x 600") << QSize(640, 470) << true;
    QTest::newRow("too narrow for the points") << QSize(170, 240) << false;
}

/// The buttons are visible, and each point is visible or can be scrolled to. If the form fits, nothing extends beyond
/// the window's right edge.
void TestQuestionnairePanel::aNarrowWindow_hasAllInReach()
{
    QFETCH(QSize, size);
    QFETCH(bool, fits);
    m_below->resize(size);
    QApplication::processEvents(); // updates layouts
    auto* scroll = m_panel->findChild<QScrollArea*>();
    QTRY_COMPARE(scroll->horizontalScrollBar()->maximum() == 0, fits);
    QVERIFY(m_panel->size() == size);
    QTRY_VERIFY(isInSight(button("questionsDone")) && isInSight(button("skipQuestions")));
    for (int question = 1; question <= 6; ++question) {
        for (int answer = ui::minAnswer; answer <= ui::maxAnswer; ++answer) {
            scroll->ensureWidgetVisible(point(question, answer));
            QVERIFY(isInSight(point(question, answer)));
        }
    }
    point(6, 1)->setFocus();
    for (const Qt::Key way : {Qt::Key_End, Qt::Key_Home, Qt::Key_Up, Qt::Key_End}) {
        key(way);
        QVERIFY(isInSight(QApplication::focusWidget()));
    }
    button("skipQuestions")->setFocus();
    key(Qt::Key_Tab);
    QVERIFY(QApplication::focusWidget() == point(1, 1) && isInSight(point(1, 1)));
}

/// The positions of the parts depend on the present width only, not on earlier widths.
void TestQuestionnairePanel::ends_standBesideOrBelow()
{
    const auto words = ui::QuestionWords::of(ui::Question::Mastering);
    QList<QLabel*> ends;
    for (QLabel* label : m_panel->findChildren<QLabel*>())
        if (label->text() == words.low || label->text() == words.high)
            ends << label;
    QCOMPARE(ends.size(), 2);
    const auto areBelow = [&] {
        return std::ranges::all_of(ends,
                                   [&](const QLabel* end) { return end->y() >= point(1, 1)->geometry().bottom(); });
    };
    const auto areBeside = [&] {
        return ends[0]->geometry().right() < point(1, 1)->x() && ends[1]->x() > point(1, 7)->geometry().right() &&
               point(1, 1)->width() == point(1, 7)->width();
    };
    QTRY_VERIFY(areBeside());
    for (int i = 0; i < 2; ++i) {
        m_below->resize(255, 240);
        QTRY_VERIFY(areBelow() && point(1, 7)->geometry().right() > ends[1]->x());
        m_below->resize(1000, 700);
        QTRY_VERIFY(areBeside());
    }
    const int wide = point(1, 1)->width();
    m_below->resize(255, 240);
    QTRY_VERIFY(point(1, 1)->width() < wide);
}

FETTLE_TEST(TestQuestionnairePanel, ui::TestApplication)
#include "tst_questionnaire_panel.moc"
