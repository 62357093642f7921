#include "app/classroom/report_writer.h"
#include "app/classroom/turn_answers.h"
#include "app/classroom/work_archive.h"
#include "app/model/model_loader.h"

#include "tests/support/test_main.h"

#include "core/io/mesh_io.h"
#include "core/primitives/starter_models.h"

#include <QDir>
#include <QGuiApplication>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

using namespace app;

namespace
{
const QDateTime noon(QDate(2026, 11, 24), QTime(12, 0));

ui::Questionnaire answersOf(const std::array<int, ui::questionCount>& answers)
{
    ui::Questionnaire made;
    for (std::size_t i = 0; i < answers.size(); ++i)
        if (answers[i] != 0)
            made.answers[i] = answers[i];
    return made;
}

QString answersFile(const QString& folder)
{
    return folder + u'/' + TurnAnswers::fileName;
}

QByteArray bytesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void writeBytes(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

QByteArray fileWith(const QByteArray& answers)
{
    return R"({"format": "fettle-answers", "version": 1, "id": "1", "answers": )" + answers + "}";
}

/// A class folder with works that are saved and delivered like those of a turn.
struct KeptClass
{
    KeptClass() { QDir().mkpath(works); }
    WorkArchive archive() const { return {works, outbox}; }
    /// Saves a work on this computer and returns its folder. Works of one turn differ in their number of steps.
    QString add(const QString& id, const QString& pupil, int steps = 0) const
    {
        TurnWork work{id, pupil, noon, noon.addSecs(600), steps, nullptr, 0, {}, {}};
        work.mesh = std::make_shared<core::TriangleMesh>(core::starterModel(core::Starter::Cube));
        return archive().add(work).folder;
    }
    /// Saves a work with answers. Returns the error message, or an empty text.
    QString keepWith(const QString& id, const QString& pupil, const std::array<int, ui::questionCount>& answers,
                     int steps = 0) const
    {
        return archive().addAnswers(add(id, pupil, steps), {id, answersOf(answers)});
    }
    QByteArray report(const char* ending = "html") const
    {
        const QString path = root.filePath(QStringLiteral("report.") + QLatin1StringView(ending));
        ReportWriter::run({toPath(works), toPath(path)});
        return bytesOf(path);
    }

    QTemporaryDir root;
    QString works = root.filePath(QStringLiteral("works")), outbox = root.filePath(QStringLiteral("own"));
};

/// Returns the table cells of a question on a page: number of answers, mean, and the numbers of pupils who chose 1 to
/// 7.
QStringList figuresOf(const QByteArray& page, ui::Question question)
{
    const QString text = QString::fromUtf8(page);
    const qsizetype begin = text.indexOf(ui::QuestionWords::of(question).question.toHtmlEscaped());
    static const QRegularExpression cell(QStringLiteral("<td class=\"figure\">([^<]*)</td>"));
    QStringList figures;
    if (begin >= 0)
        for (auto i = cell.globalMatch(text.mid(begin, text.indexOf(QStringLiteral("</tr>"), begin) - begin));
             i.hasNext();)
            figures << i.next().captured(1);
    return figures;
}
} // namespace

/// Tests that answers stay with their work, wherever it is delivered, and are counted in the report.
class TestTurnAnswers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsWritten_isReadAgain();
    void noAnswers_areNoFile();
    void wrongValues_areLeftOut_data();
    void wrongValues_areLeftOut();
    void strangeFiles_areNamed_data();
    void strangeFiles_areNamed();
    void aNewerVersion_isNamed();
    void whatIsNoFile_isNamed();
    void noPlace_isSaid();
    void answers_goWithTheWork();
    void lateAnswers_areDelivered();
    void theReport_sumsAllWorks();
    void answersTakenBack_areTakenBackThere();
    void aResumedTurn_countsOnce();
    void brokenAnswers_costNoRow();
};

void TestTurnAnswers::whatIsWritten_isReadAgain()
{
    const QTemporaryDir folder;
    for (const auto& answers :
         {std::array{1, 2, 3, 4, 5, 6}, std::array{7, 0, 0, 0, 0, 0}, std::array{0, 0, 0, 0, 0, 7}}) {
        const TurnAnswers written{QStringLiteral("id of Ä"), answersOf(answers)};
        QCOMPARE(written.write(folder.path()), QString());
        const TurnAnswers read = TurnAnswers::read(folder.path());
        QCOMPARE(read.questionnaire, written.questionnaire);
        QCOMPARE(read.turnId, written.turnId);
        QCOMPARE(read.problem, QString());
    }
}

void TestTurnAnswers::noAnswers_areNoFile()
{
    const QTemporaryDir folder;
    QCOMPARE((TurnAnswers{QStringLiteral("1"), {}}.write(folder.path())), QString());
    QVERIFY(!QFile::exists(answersFile(folder.path())));
    QVERIFY(TurnAnswers::read(folder.path()).questionnaire.isEmpty());
    QCOMPARE(TurnAnswers::read(folder.path()).problem, QString());
    QCOMPARE((TurnAnswers{QStringLiteral("1"), answersOf({1})}.write(folder.path())), QString());
    QVERIFY(QFile::exists(answersFile(folder.path())));
    // withdrawing the last answer removes the file
    QCOMPARE((TurnAnswers{QStringLiteral("1"), {}}.write(folder.path())), QString());
    QVERIFY(!QFile::exists(answersFile(folder.path())));
}

void TestTurnAnswers::wrongValues_areLeftOut_data()
{
    QTest::addColumn<QByteArray>("value");
    for (const char* value : {"0", "8", "-1", "3.5", "\"4\"", "null", "true", "[4]", "{}", "1e300", "7.0000001"})
        QTest::newRow(value) << QByteArray(value);
}

/// The other answers remain, and a message states which one is left out and why.
void TestTurnAnswers::wrongValues_areLeftOut()
{
    QFETCH(QByteArray, value);
    const QTemporaryDir folder;
    writeBytes(answersFile(folder.path()),
               fileWith(R"({"mastering": 7, "other": 9, "errors": )" + value + R"(, "overall": 1})"));
    const TurnAnswers read = TurnAnswers::read(folder.path());
    QCOMPARE(read.questionnaire, answersOf({7, 0, 0, 0, 0, 1}));
    QCOMPARE(read.problem,
             QStringLiteral(
                 "answers.json: the answer \"errors\" is left out, because it is not a whole number from 1 to 7."));
}

void TestTurnAnswers::strangeFiles_areNamed_data()
{
    QTest::addColumn<QByteArray>("bytes");
    const QByteArray whole = fileWith(R"({"mastering": 7})");
    QTest::newRow("empty") << QByteArray("");
    QTest::newRow("cut") << whole.chopped(3);
    QTest::newRow("no JSON") << QByteArray("\x89PNG\r\n\x1a\n");
    QTest::newRow("a list") << QByteArray("[7, 7]");
    QTest::newRow("another format") << QByteArray(whole).replace("fettle-answers", "fettle-turn");
    QTest::newRow("no format") << QByteArray(R"({"answers": {"mastering": 7}})");
    QTest::newRow("no answers") << QByteArray(R"({"format": "fettle-answers"})");
    QTest::newRow("no version") << QByteArray(whole).replace("\"version\": 1, ", "");
    QTest::newRow("version 0") << QByteArray(whole).replace("\"version\": 1", "\"version\": 0");
    QTest::newRow("a version in words") << QByteArray(whole).replace("\"version\": 1", "\"version\": \"2\"");
    QTest::newRow("a newer version of another format")
        << QByteArray(whole).replace("\"version\": 1", "\"version\": 2").replace("fettle-answers", "fettle-turn");
    QTest::newRow("answers as a list") << fileWith("[7]");
    QTest::newRow("too long") << whole + QByteArray(70'000, ' ');
    QTest::newRow("deep") << fileWith(QByteArray(5000, '[') + QByteArray(5000, ']'));
    QTest::newRow("not UTF-8") << QByteArray(whole).replace("mastering", "\xff\xfe");
}

void TestTurnAnswers::strangeFiles_areNamed()
{
    QFETCH(QByteArray, bytes);
    const QTemporaryDir folder;
    writeBytes(answersFile(folder.path()), bytes);
    const TurnAnswers read = TurnAnswers::read(folder.path());
    QVERIFY(read.questionnaire.isEmpty());
    QCOMPARE(read.problem, QStringLiteral("answers.json contains no answers that can be read."));
}

void TestTurnAnswers::aNewerVersion_isNamed()
{
    const QTemporaryDir folder;
    const QByteArray whole = fileWith(R"({"mastering": 7})");
    for (const char* version : {"2", "1.5", "99999"}) {
        writeBytes(answersFile(folder.path()),
                   QByteArray(whole).replace("\"version\": 1", QByteArray("\"version\": ") + version));
        const TurnAnswers read = TurnAnswers::read(folder.path());
        QVERIFY(read.questionnaire.isEmpty());
        QCOMPARE(read.problem, QStringLiteral("answers.json was made by a newer version of Fettle."));
    }
}

/// Reading must not block on a pipe or read from a device.
void TestTurnAnswers::whatIsNoFile_isNamed()
{
    const QTemporaryDir folder;
    const QString path = answersFile(folder.path());
    const auto problem = [&] {
        const TurnAnswers read = TurnAnswers::read(folder.path());
        QFile::remove(path);
        return read.questionnaire.isEmpty() ? read.problem : QString();
    };
    const QString notAFile = QStringLiteral("answers.json is not a file but a folder or a device.");
    QCOMPARE(::mkfifo(QFile::encodeName(path).constData(), 0600), 0);
    QCOMPARE(problem(), notAFile);
    QVERIFY(QFile::link(QStringLiteral("/dev/zero"), path));
    QCOMPARE(problem(), notAFile);
    QVERIFY(QFile::link(folder.filePath(QStringLiteral("gone.json")), path));
    QCOMPARE(problem(), QStringLiteral("answers.json is a link to a file that is not there."));
    QCOMPARE(problem(), QString()); // a missing file is not an error
    writeBytes(folder.filePath(QStringLiteral("there.json")), fileWith(R"({"mastering": 7})"));
    QVERIFY(QFile::link(folder.filePath(QStringLiteral("there.json")), path));
    QCOMPARE(TurnAnswers::read(folder.path()).questionnaire, answersOf({7})); // a link to a file is accepted
}

void TestTurnAnswers::noPlace_isSaid()
{
    const QTemporaryDir root;
    const QString problem =
        TurnAnswers{QStringLiteral("1"), answersOf({1})}.write(root.filePath(QStringLiteral("none")));
    QVERIFY2(problem.contains(QStringLiteral("does not exist")), qPrintable(problem));
    QDir(root.path()).mkpath(TurnAnswers::fileName); // a folder has the name of the file
    QCOMPARE(TurnAnswers::read(root.path()).problem,
             QStringLiteral("answers.json is not a file but a folder or a device."));
}

void TestTurnAnswers::answers_goWithTheWork()
{
    const KeptClass kept;
    const QString folder = kept.add(QStringLiteral("1"), QStringLiteral("Anna"));
    QCOMPARE(kept.archive().addAnswers(folder, {QStringLiteral("1"), answersOf({1, 2})}), QString());
    QCOMPARE(kept.archive().addAnswers(folder, {QStringLiteral("1"), answersOf({1, 3})}), QString());
    const QString there = kept.archive().deliver().moved.value(folder);
    QCOMPARE(TurnAnswers::read(there).questionnaire, answersOf({1, 3}));
    // the work has already been delivered
    QCOMPARE(kept.archive().addAnswers(folder, {QStringLiteral("1"), answersOf({1, 4})}), QString());
    QCOMPARE(TurnAnswers::read(there).questionnaire, answersOf({1, 4}));
    QVERIFY(!QDir(folder).exists());
}

/// Simulates a power cut between the delivery of a work and its removal from this computer, followed by new answers.
void TestTurnAnswers::lateAnswers_areDelivered()
{
    const KeptClass kept;
    kept.add(QStringLiteral("1"), QStringLiteral("Anna"));
    kept.archive().deliver();
    const QString folder = kept.add(QStringLiteral("1"), QStringLiteral("Anna"));
    QCOMPARE(kept.archive().addAnswers(folder, {QStringLiteral("1"), answersOf({0, 5})}), QString());
    const Delivery delivery = kept.archive().deliver();
    QCOMPARE(delivery.undelivered, 0);
    QCOMPARE(WorkArchive::worksIn(kept.works).size(), 1);
    QCOMPARE(TurnAnswers::read(delivery.moved.value(folder)).questionnaire, answersOf({0, 5}));
}

/// The delivered work has answers, all of which are then withdrawn.
void TestTurnAnswers::answersTakenBack_areTakenBackThere()
{
    const KeptClass kept;
    QCOMPARE(kept.keepWith(QStringLiteral("1"), QStringLiteral("Anna"), {7}), QString());
    kept.archive().deliver();
    const QString folder = kept.add(QStringLiteral("1"), QStringLiteral("Anna"));
    const Delivery delivery = kept.archive().deliver();
    QCOMPARE(delivery.undelivered, 0);
    QCOMPARE(WorkArchive::worksIn(kept.works).size(), 1);
    QVERIFY(!QFile::exists(answersFile(delivery.moved.value(folder))));
}

void TestTurnAnswers::theReport_sumsAllWorks()
{
    const KeptClass kept;
    QCOMPARE(kept.keepWith(QStringLiteral("1"), QStringLiteral("Anna"), {7, 1, 0, 4, 4, 4}), QString());
    QCOMPARE(kept.keepWith(QStringLiteral("2"), QStringLiteral("Ben"), {5, 1, 0, 4, 3, 0}), QString());
    QCOMPARE(kept.keepWith(QStringLiteral("3"), QStringLiteral("Cem"), {5, 2, 0, 4, 0, 0}), QString());
    kept.add(QStringLiteral("4"), QStringLiteral("Dana")); // a work whose pupil skipped the questions
    QCOMPARE(kept.archive().deliver().moved.size(), 4);
    const QByteArray page = kept.report();
    QCOMPARE(page.count("<bdi>"), 4);
    QVERIFY(page.contains("<bdi>Anna</bdi>") && page.contains("href=\"works/2026-11-24-1200-Dana/model.glb\""));
    using enum ui::Question;
    const QString no;
    QCOMPARE(figuresOf(page, Mastering), QStringList({"3", "5.67", no, no, no, no, "2", no, "1"}));
    QCOMPARE(figuresOf(page, Functions), QStringList({"3", "1.33", "2", "1", no, no, no, no, no}));
    QCOMPARE(figuresOf(page, Errors), QStringList({"0", no, no, no, no, no, no, no, no}));
    QCOMPARE(figuresOf(page, Details), QStringList({"3", "4.00", no, no, no, "3", no, no, no}));
    QCOMPARE(figuresOf(page, Topology), QStringList({"2", "3.50", no, no, "1", "1", no, no, no}));
    QCOMPARE(figuresOf(page, Overall), QStringList({"1", "4.00", no, no, no, "1", no, no, no}));
    QVERIFY(kept.report("pdf").startsWith("%PDF-"));

    core::writeMesh(toPath(kept.works + QStringLiteral("/loose.stl")), core::starterModel(core::Starter::Ball));
    const QByteArray both = kept.report(); // other models in the folder do not matter
    QCOMPARE(both.count("<bdi>"), 5);
    QCOMPARE(figuresOf(both, Mastering), figuresOf(page, Mastering));
}

void TestTurnAnswers::aResumedTurn_countsOnce()
{
    const KeptClass kept;
    int steps = 0;
    // with ten steps, alphabetical order would differ from numerical order
    for (const int answer : {1, 2, 3, 4, 5, 6, 7, 6, 5, 4, 3}) {
        QCOMPARE(kept.keepWith(QStringLiteral("1"), QStringLiteral("Anna"), {answer}, ++steps), QString());
        kept.archive().deliver();
    }
    QCOMPARE(WorkArchive::worksIn(kept.works).size(), steps);
    QCOMPARE(kept.keepWith(QStringLiteral("2"), QStringLiteral("Ben"), {7}), QString());
    kept.archive().deliver();
    const QString no;
    QCOMPARE(figuresOf(kept.report(), ui::Question::Mastering),
             QStringList({"2", "5.00", no, no, "1", no, no, no, "1"}));
    // skipping the form in the last resumption cancels the turn's earlier answers
    kept.add(QStringLiteral("1"), QStringLiteral("Anna"), ++steps);
    kept.archive().deliver();
    QCOMPARE(figuresOf(kept.report(), ui::Question::Mastering),
             QStringList({"1", "7.00", no, no, no, no, no, no, "1"}));
}

void TestTurnAnswers::brokenAnswers_costNoRow()
{
    const KeptClass kept;
    kept.keepWith(QStringLiteral("1"), QStringLiteral("Anna"), {7});
    kept.keepWith(QStringLiteral("2"), QStringLiteral("Ben"), {7});
    kept.keepWith(QStringLiteral("3"), QStringLiteral("Cem"), {7});
    kept.archive().deliver();
    const QStringList works = WorkArchive::worksIn(kept.works);
    QCOMPARE(works.size(), 3);
    writeBytes(answersFile(works[0]), "{");
    writeBytes(answersFile(works[1]), fileWith(R"({"mastering": 99, "overall": 2})"));
    const QByteArray page = kept.report();
    QCOMPARE(page.count("<bdi>"), 3);
    QCOMPARE(page.count("class=\"ready\""), 3);
    QVERIFY(page.contains("answers.json contains no answers that can be read.") &&
            page.contains("the answer &quot;mastering&quot; is left out"));
    QCOMPARE(figuresOf(page, ui::Question::Mastering).constFirst(), QStringLiteral("1"));
    QCOMPARE(figuresOf(page, ui::Question::Overall).constFirst(), QStringLiteral("1"));
}

FETTLE_TEST(TestTurnAnswers, QGuiApplication)
#include "tst_turn_answers.moc"
