// Tests `fettle lesson` as a teacher's script calls it.
#include "core/io/mesh_io.h"
#include "core/lesson/lesson_file.h"
#include "core/primitives/starter_models.h"
#include "tests/support/test_main.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <tuple>

namespace
{
const QString lessonsFolder = QStringLiteral(FETTLE_SOURCE_DIR "/resources/lessons/");

struct LessonAnswer
{
    int status = -1;
    QString out, err;
};

LessonAnswer lesson(const QStringList& arguments)
{
    QProcess program;
    program.start(QStringLiteral(FETTLE_PROGRAM), QStringList(QStringLiteral("lesson")) + arguments);
    if (!program.waitForFinished(-1) || program.exitStatus() != QProcess::NormalExit)
        return {};
    return {program.exitCode(), QString::fromUtf8(program.readAllStandardOutput()),
            QString::fromUtf8(program.readAllStandardError())};
}

/// Returns a copy of the first bundled lesson in which `from` is replaced by `to` in lesson.json.
QString changed(const QTemporaryDir& folder, const QByteArray& from, const QByteArray& to)
{
    const QString copy = folder.filePath(QStringLiteral("lesson"));
    QDir().mkpath(copy);
    const QDir ours(lessonsFolder + QStringLiteral("first-clay"));
    for (const QString& name : ours.entryList(QDir::Files))
        QFile::copy(ours.filePath(name), QDir(copy).filePath(name));
    QFile file(QDir(copy).filePath(QStringLiteral("lesson.json")));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QByteArray text = file.readAll();
    file.close();
    file.remove();
    if (!text.contains(from) || !file.open(QIODevice::WriteOnly))
        return {};
    file.write(QByteArray(text).replace(from, to));
    return copy;
}
} // namespace

class TestLessonCommand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void ours_areListedInEachLanguage()
    {
        for (const auto& [language, title] :
             {std::pair("en", "A mug with a handle"), std::pair("de", "Eine Tasse mit Henkel"),
              std::pair("zh", "带把手的杯子")}) {
            const LessonAnswer answer = lesson({QStringLiteral("--language"), QString::fromLatin1(language)});
            QCOMPARE(answer.status, 0);
            QVERIFY(answer.out.contains(QString::fromUtf8(title)));
            QCOMPARE(answer.out.count(QLatin1Char('\n')), 4);
        }
    }

    /// The bundled lesson, its folder and its zip are all played to the end with the same verdicts.
    void played_saysEachVerdict()
    {
        const QTemporaryDir folder;
        const QString zip = folder.filePath(QStringLiteral("clay.zip")),
                      model = folder.filePath(QStringLiteral("pear.ply"));
        const LessonAnswer answer =
            lesson({QStringLiteral("first-clay"), QStringLiteral("--pack"), zip, QStringLiteral("--out"), model,
                    QStringLiteral("--pictures"), folder.path()});
        QVERIFY2(answer.status == 0 && answer.err.isEmpty(), qPrintable(answer.err));
        QCOMPARE(answer.out.count(QStringLiteral("\n   yes ")), 17);
        QCOMPARE(answer.out.count(QStringLiteral("\n   no ")), 0);
        QCOMPARE(lesson({zip}).out, answer.out);
        QCOMPARE(lesson({lessonsFolder + QStringLiteral("first-clay")}).out, answer.out);
        const QString unpacked = folder.filePath(QStringLiteral("clay"));
        QCOMPARE(lesson({zip, QStringLiteral("--unpack"), unpacked}).out, answer.out);
        QCOMPARE(lesson({unpacked}).out, answer.out);
        QVERIFY(core::readMesh(model.toStdString()).triangles.size() > 1000);
        QVERIFY(QFile::exists(folder.filePath(QStringLiteral("step-4.png"))));
    }

    void unmet_isTheAnswerNoAndIsNotPacked()
    {
        const QTemporaryDir folder;
        const QString zip = folder.filePath(QStringLiteral("clay.zip"));
        const QString bad = changed(folder, "\"least\": 125", "\"least\": 215");
        const LessonAnswer answer = lesson({bad, QStringLiteral("--pack"), zip});
        QCOMPARE(answer.status, 1);
        QCOMPARE(answer.out.count(QStringLiteral("\n   no ")), 1);
        QVERIFY(answer.out.contains(QStringLiteral("at least 215 mm tall (now 137.5 mm)")));
        QVERIFY(!QFile::exists(zip));
    }

    void stepWithoutGoal_isToldSo()
    {
        const QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("lesson.json")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"format":"fettle-lesson","version":1,"title":{"en":"A"},"start":"ball",
                       "steps":[{"title":{"en":"B"},"text":{"en":"C"}}]})");
        file.close();
        const LessonAnswer answer = lesson({folder.path()});
        QCOMPARE(answer.status, 0);
        QVERIFY2(answer.out.endsWith(QStringLiteral("\n   no goal\n")), qPrintable(answer.out));
    }

    void pupilsModel_isChecked()
    {
        const QTemporaryDir folder;
        const QString ball = folder.filePath(QStringLiteral("ball.stl")),
                      pear = folder.filePath(QStringLiteral("pear.stl"));
        core::writeMesh(ball.toStdString(), core::starterModel(core::Starter::Ball));
        QCOMPARE(lesson({QStringLiteral("first-clay"), QStringLiteral("--out"), pear}).status, 0);
        const auto checked = [](const QString& model, const char* step) {
            return lesson({QStringLiteral("first-clay"), QStringLiteral("--model"), model, QStringLiteral("--step"),
                           QString::fromLatin1(step)});
        };
        QCOMPARE(checked(pear, "4").status, 0);
        QCOMPARE(checked(ball, "4").status, 1);
        const LessonAnswer height = checked(ball, "3");
        QCOMPARE(height.status, 1);
        QVERIFY(height.out.contains(QStringLiteral("no    105 mm to 132 mm tall (now 100 mm)")));
        QCOMPARE(checked(ball, "5").status, 2);
        QCOMPARE(checked(ball, "0").status, 2);
    }

    /// Each language has its own texts, and each step is on one page.
    void handouts_arePages()
    {
        const QTemporaryDir folder;
        const QString pdf = folder.filePath(QStringLiteral("mug.pdf"));
        for (const char* language : {"en", "de", "zh"}) {
            const LessonAnswer answer = lesson({QStringLiteral("mug"), QStringLiteral("--language"),
                                                QString::fromLatin1(language), QStringLiteral("--pdf"), pdf});
            QVERIFY2(answer.status == 0 && answer.out.isEmpty() && answer.err.isEmpty(), qPrintable(answer.err));
            QFile file(pdf);
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QByteArray bytes = file.readAll();
            QVERIFY(bytes.startsWith("%PDF-") && bytes.trimmed().endsWith("%%EOF"));
            const qsizetype pages = bytes.count("/Type /Page\n");
            QVERIFY2(pages == 1, qPrintable(QString::number(pages)));
            QVERIFY(bytes.count("/Subtype /Image") >= 3);
        }
        QCOMPARE(
            lesson({QStringLiteral("mug"), QStringLiteral("--pdf"), folder.filePath(QStringLiteral("mug.txt"))}).status,
            2);
        QCOMPARE(lesson({QStringLiteral("mug"), QStringLiteral("--pdf"), pdf, QStringLiteral("--no-clobber")}).status,
                 2);
        QCOMPARE(lesson({QStringLiteral("mug"), QStringLiteral("--pdf"), folder.filePath(QStringLiteral("no/mug.pdf"))})
                     .status,
                 2);
    }

    /// Results contain the required and the measured values as numbers, independent of language.
    void results_areJsonAndCsv()
    {
        const QTemporaryDir folder;
        const QString ball = folder.filePath(QStringLiteral("ball.stl"));
        core::writeMesh(ball.toStdString(), core::starterModel(core::Starter::Ball));
        const LessonAnswer played = lesson({QStringLiteral("first-clay"), QStringLiteral("--json")});
        QCOMPARE(played.status, 0);
        const QJsonObject all = QJsonDocument::fromJson(played.out.toUtf8()).object();
        QCOMPARE(all[QStringLiteral("format")].toString(), QStringLiteral("fettle-lesson-results"));
        QCOMPARE(all[QStringLiteral("steps")].toArray().size(), 4);
        QVERIFY(all[QStringLiteral("met")].toBool() && all[QStringLiteral("model")].isNull());

        const QStringList judge{QStringLiteral("first-clay"), QStringLiteral("--model"), ball, QStringLiteral("--step"),
                                QStringLiteral("1")};
        const LessonAnswer json = lesson(judge + QStringList{QStringLiteral("--json")});
        QCOMPARE(json.status, 1);
        const QJsonObject judged = QJsonDocument::fromJson(json.out.toUtf8()).object();
        QVERIFY(!judged[QStringLiteral("met")].toBool(true));
        QCOMPARE(judged[QStringLiteral("model")].toString(), ball);
        const QJsonObject height =
            judged[QStringLiteral("steps")].toArray()[0].toObject()[QStringLiteral("goals")].toArray()[2].toObject();
        QCOMPARE(height[QStringLiteral("goal")].toString(), QStringLiteral("height_mm"));
        QCOMPARE(height[QStringLiteral("least")].toDouble(), 125.0);
        QCOMPARE(height[QStringLiteral("measured")].toDouble(), 100.0);
        QVERIFY(height[QStringLiteral("most")].isNull() && !height[QStringLiteral("met")].toBool(true));

        const QStringList rows =
            lesson(judge + QStringList{QStringLiteral("--csv")}).out.trimmed().split(QLatin1Char('\n'));
        QCOMPARE(rows.size(), 5);
        QCOMPARE(rows[0], QStringLiteral("lesson,model,step,title,goal,least,most,measured,met"));
        QVERIFY2(rows[3].startsWith(QStringLiteral("first-clay,") + ball) &&
                     rows[3].endsWith(QStringLiteral(",height_mm,125.0,,100.0,false")),
                 qPrintable(rows[3]));
        QCOMPARE(QJsonDocument::fromJson(lesson({QStringLiteral("--json")}).out.toUtf8()).array().size(), 4);
        QCOMPARE(lesson({QStringLiteral("--csv")}).out.count(QLatin1Char('\n')), 5);
    }

    void language_isThatOfTheWholeAnswer()
    {
        const QStringList judge{QStringLiteral("first-clay"), QStringLiteral("--language")};
        for (const auto& [language, strokes, yes] : {std::tuple("de", "(Striche: 1; Werkzeuge: Ziehen)", "\n   ja "),
                                                     std::tuple("zh_CN", "（笔画：1；工具：拉出）", "\n   是 "),
                                                     std::tuple("en", "(strokes: 1; tools: Pull)", "\n   yes ")}) {
            const QString out = lesson(judge + QStringList{QString::fromLatin1(language)}).out;
            QVERIFY2(out.contains(QString::fromUtf8(strokes)) && out.contains(QString::fromUtf8(yes)), qPrintable(out));
        }
    }

    void texts_arePrinted()
    {
        const LessonAnswer german = lesson(
            {QStringLiteral("mug"), QStringLiteral("--texts"), QStringLiteral("--language"), QStringLiteral("de")});
        QCOMPARE(german.status, 0);
        QVERIFY(german.out.startsWith(QStringLiteral("Eine Tasse mit Henkel\n")));
        const core::Lesson mug = core::readLesson((lessonsFolder + QStringLiteral("mug")).toStdString());
        for (const core::LessonStep& step : mug.steps)
            QVERIFY(
                german.out.contains(QString::fromStdString(step.title.in("de") + '\n' + step.text.in("de") + '\n')));
    }

    void badInput_isOneSentence_data()
    {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QString>("with");
        QTest::newRow("newer") << QByteArray("\"version\": 1") << QByteArray("\"version\": 2")
                               << QStringLiteral("newer version");
        QTest::newRow("outside") << QByteArray("step-2.png") << QByteArray("../step-2.png")
                                 << QStringLiteral("step 2 (steps[1]): it refers to a file that is outside");
        QTest::newRow("gone") << QByteArray("push.json") << QByteArray("none.json")
                              << QStringLiteral("none.json, step 2 (steps[1]): this file is missing");
        QTest::newRow("no strokes") << QByteArray("push.json") << QByteArray("step-1.png")
                                    << QStringLiteral("step-1.png, step 2 (steps[1]), line 1");
        QTest::newRow("no words") << QByteArray("\"Den Hals ziehen\"") << QByteArray("\"\"")
                                  << QStringLiteral("no text");
        QTest::newRow("no JSON") << QByteArray("\"steps\":") << QByteArray("steps:") << QStringLiteral("not JSON");
        QTest::newRow("unknown") << QByteArray("\"summary\"") << QByteArray("\"sumary\"")
                                 << QStringLiteral("unknown key sumary");
        const auto wrong = [](const char* from, const char* to, const char* with) {
            QTest::newRow(to) << QByteArray(from) << QByteArray(to) << QString::fromUtf8(with);
        };
        wrong("\"version\": 1", "\"version\": 1.5", "\"version\" must be a whole number");
        wrong("\"start\": \"ball\"", "\"start\": 1", "\"start\" must be a name in quotation marks");
        wrong("\"picture\": \"step-2.png\"", "\"picture\": 2",
              "step 2 (steps[1]): \"picture\" must be a name in quotation marks");
        wrong("\"components\": 1", "\"components\": 1.5",
              "\"components\" must be a whole number or a range, such as {\"least\": 1, \"most\": 2}");
        wrong("\"least\": 125", "\"least\": \"tall\"", "\"height_mm\" must be a number or a range");
        wrong("\"print_ready\": true", "\"print_ready\": 1", "\"print_ready\" must be true");
        wrong("\"tools\": [\n    \"push\"\n   ]", "\"tools\": \"push\"", "\"tools\" must be a list of tools");
    }
    void badInput_isOneSentence()
    {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(QString, with);
        const QTemporaryDir folder;
        const QString bad = changed(folder, from, to);
        QVERIFY(!bad.isEmpty());
        const LessonAnswer answer = lesson({bad});
        QCOMPARE(answer.status, 2);
        QVERIFY(answer.out.isEmpty());
        QVERIFY2(answer.err.startsWith(QStringLiteral("fettle: ") + bad) && answer.err.count(QLatin1Char('\n')) == 1 &&
                     answer.err.contains(with),
                 qPrintable(answer.err));
    }

    void badUsage_isOneSentence()
    {
        for (const QStringList& arguments :
             QList<QStringList>{{QStringLiteral("nothing-of-ours")},
                                {QStringLiteral("mug"), QStringLiteral("creature")},
                                {QStringLiteral("mug"), QStringLiteral("--step"), QStringLiteral("1")},
                                {QStringLiteral("--texts")},
                                {QStringLiteral("mug"), QStringLiteral("--texts"), QStringLiteral("--json")},
                                {QStringLiteral("mug"), QStringLiteral("--pack"), QStringLiteral("mug.rar")},
                                {QStringLiteral("mug"), QStringLiteral("--unpack"), QStringLiteral("mug.zip")},
                                {QStringLiteral("--out"), QStringLiteral("a.stl")},
                                {QStringLiteral("mug"), QStringLiteral("--out"), QStringLiteral("a.xyz")}}) {
            const LessonAnswer answer = lesson(arguments);
            QCOMPARE(answer.status, 2);
            QVERIFY(answer.out.isEmpty() && answer.err.count(QLatin1Char('\n')) == 1);
        }
    }
};

FETTLE_TEST(TestLessonCommand, QCoreApplication)
#include "tst_lesson_command.moc"
