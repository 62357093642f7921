#include "ui/classroom/class_report.h"
#include "ui/classroom/report_html.h"
#include "ui/classroom/report_pdf.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QRegularExpression>
#include <QTranslator>

using namespace ui;

namespace
{
ClassReport reportOf(const QList<Questionnaire>& questionnaires, int models = 1)
{
    ClassReport report{QStringLiteral("5b"), QDate(2026, 11, 24), {}, questionnaires};
    for (int i = 0; i < models; ++i)
        report.rows << ReportRow{"model.glb", QStringLiteral("model.glb is empty."), {}, {}, {}, {}, {}};
    return report;
}

Questionnaire answering(int question, int answer)
{
    Questionnaire made;
    made.answers.at(static_cast<std::size_t>(question)) = answer;
    return made;
}
} // namespace

/// Tests the sums of a class's answers and their tables in both report formats.
class TestClassReportQuestions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sums_countEachAnswerOnce();
    void meansAndMissingAnswers();
    void withoutAnswers_thereIsNoTable();
    void html_hasARowForEachQuestion();
    void pdf_hasRoomForTheTable();
    void pdf_breaksNoHead();
};

/// Sums of random answers equal counts made independently by the test.
void TestClassReportQuestions::sums_countEachAnswerOnce()
{
    std::array<std::array<int, maxAnswer>, questionCount> expected{};
    QList<Questionnaire> all;
    std::uint32_t state = 7;
    for (int pupil = 0; pupil < 200; ++pupil) {
        Questionnaire made;
        for (std::size_t i = 0; i < questionCount; ++i) {
            state = state * 1664525 + 1013904223;
            const int answer = static_cast<int>(state >> 24) % 8; // 0: no answer
            if (answer == 0)
                continue;
            made.answers[i] = answer;
            ++expected[i][static_cast<std::size_t>(answer - 1)];
        }
        all << made;
    }
    const auto sums = sumsOf(all);
    for (std::size_t i = 0; i < questionCount; ++i) {
        QCOMPARE(sums[i].counts, expected[i]);
        int total = 0, points = 0;
        for (int answer = 1; answer <= maxAnswer; ++answer) {
            total += expected[i][static_cast<std::size_t>(answer - 1)];
            points += answer * expected[i][static_cast<std::size_t>(answer - 1)];
        }
        QVERIFY(total > 0 && total < 200);
        QCOMPARE(sums[i].total(), total);
        QCOMPARE(sums[i].mean(), static_cast<double>(points) / total);
    }
}

void TestClassReportQuestions::meansAndMissingAnswers()
{
    const auto sums = sumsOf({answering(0, 7), answering(0, 4), answering(5, 1), {}});
    QCOMPARE(sums[0].total(), 2);
    QCOMPARE(sums[0].mean(), 5.5);
    QCOMPARE(sums[5].mean(), 1.0);
    QCOMPARE(sums[1].total(), 0);
    QCOMPARE(sums[1].mean(), 0.0);
    const QList<QuestionCells> cells = questionCellsOf(reportOf({answering(0, 7), answering(0, 4), answering(5, 1)}));
    QCOMPARE(cells.size(), 6);
    QCOMPARE(cells[0].answers, QStringLiteral("2"));
    QVERIFY(cells[0].mean.startsWith(u'5') && cells[0].mean.endsWith(QStringLiteral("50")));
    QCOMPARE(cells[0].counts, (std::array<QString, 7>{{{}, {}, {}, QStringLiteral("1"), {}, {}, QStringLiteral("1")}}));
    QVERIFY(cells[1].mean.isEmpty()); // the mean of no answers is empty
    QCOMPARE(cells[1].answers, QStringLiteral("0"));
    QCOMPARE(questionHeads().size(), 3 + maxAnswer);
}

void TestClassReportQuestions::withoutAnswers_thereIsNoTable()
{
    QVERIFY(questionCellsOf(reportOf({})).isEmpty());
    QVERIFY(!reportHtml(reportOf({}), "r.html").contains("class=\"questions\""));
}

void TestClassReportQuestions::html_hasARowForEachQuestion()
{
    const QByteArray page = reportHtml(reportOf({answering(0, 7), answering(0, 7), answering(2, 3)}), "r.html");
    const QByteArray table = page.mid(page.indexOf("<table class=\"questions\">"));
    QCOMPARE(table.count("<th scope=\"row\">"), 6);
    QCOMPARE(table.count("<th scope=\"col\""), 10);
    for (std::size_t i = 0; i < questionCount; ++i) {
        const auto words = QuestionWords::of(static_cast<Question>(i));
        QVERIFY(table.contains(words.question.toHtmlEscaped().toUtf8()) &&
                table.contains(words.low.toHtmlEscaped().toUtf8()));
    }
    static const QRegularExpression cell(QStringLiteral("<td class=\"figure\">([^<]*)</td>"));
    QStringList figures;
    for (auto i = cell.globalMatch(QString::fromUtf8(table)); i.hasNext();)
        figures << i.next().captured(1);
    QCOMPARE(figures.size(), 6 * 9);
    QCOMPARE(figures.first(), QStringLiteral("2"));
    QCOMPARE(figures[8], QStringLiteral("2")); // number of answers with 7 points
    // Third question, number of answers with 3 points
    QCOMPARE(figures[2 * 9 + 4], QStringLiteral("1"));
    // The script sorts the first table of the page
    QVERIFY(page.indexOf("<table>") < page.indexOf("<table class=\"questions\">"));
}

/// The table is on the last page for any number of rows. A page is added only if the table does not fit.
void TestClassReportQuestions::pdf_hasRoomForTheTable()
{
    const auto pages = [](const ClassReport& report) { return reportPdf(report, "r.pdf").count("/Type /Page\n"); };
    int added = 0;
    for (int models = 1; models < 60; models += 3) {
        const auto without = pages(reportOf({}, models)), with = pages(reportOf({answering(1, 1)}, models));
        QVERIFY(with == without || with == without + 1);
        added += static_cast<int>(with - without);
    }
    QVERIFY(added > 0 && added < 20);
}

namespace
{
/// A translator with short questions and a given head for the column of answer counts.
class OneHead : public QTranslator
{
public:
    explicit OneHead(const QString& head) : m_head(head) {}
    QString translate(const char* context, const char* source, const char*, int) const override
    {
        if (qstrcmp(context, "ui::Questionnaire") == 0)
            return QStringLiteral("x");
        return qstrcmp(source, "Answers") == 0 ? m_head : QString();
    }
    bool isEmpty() const override { return false; }

private:
    QString m_head;
};

/// Returns the number of text pieces that a PDF draws, one for each line of text.
qsizetype linesIn(const QByteArray& pdf)
{
    qsizetype lines = 0;
    for (qsizetype at = 0; (at = pdf.indexOf("\nstream\n", at)) >= 0;) {
        at += 8;
        if (pdf[at] != 'x') // an 'x' begins a compressed stream
            continue;
        const QByteArray length = QByteArray::fromHex("00100000"); // length prefix that qUncompress() expects
        lines += qUncompress(length + pdf.mid(at, pdf.indexOf("\nendstream", at) - at)).count("\nBT\n");
    }
    return lines;
}
} // namespace

/// A longer head widens its column instead of wrapping; all other texts have one line.
void TestClassReportQuestions::pdf_breaksNoHead()
{
    const auto lines = [](const QString& head) {
        OneHead words(head);
        QCoreApplication::installTranslator(&words);
        return linesIn(reportPdf(reportOf({answering(0, 7)}), "r.pdf"));
    };
    const qsizetype one = lines(QStringLiteral("n"));
    QVERIFY(one > 20);
    for (const char* head : {"Antworten", "Beantwortungen", "WWWWWWWWWWWWWWWW"})
        QVERIFY2(lines(QString::fromUtf8(head)) == one, head);
    QVERIFY(lines(QStringLiteral("%1 %1").arg(QString(30, u'W'))) > one); // linesIn() detects a wrapped head
}

FETTLE_TEST(TestClassReportQuestions, ui::TestApplication)
#include "tst_class_report_questions.moc"
