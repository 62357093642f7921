#include "app/classroom/class_works.h"
#include "app/classroom/work_archive.h"
#include "app/model/model_loader.h"
#include "tests/support/test_main.h"

#include "core/io/mesh_io.h"
#include "core/primitives/starter_models.h"
#include "core/util/file_error.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

using namespace app;

namespace
{
struct WorksAnswer
{
    int status = -1;
    QString out, err;

    QStringList lines() const { return out.split(u'\n', Qt::SkipEmptyParts); }
};

WorksAnswer runFettle(const QStringList& arguments)
{
    QProcess process;
    process.start(QStringLiteral(FETTLE_PROGRAM), arguments);
    if (!process.waitForFinished(-1) || process.exitStatus() != QProcess::NormalExit)
        return {};
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

void writeWork(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The folder of a class after some turns.
struct ClassFolder
{
    QString add(const QString& folder, const QString& pupil, const QString& id,
                core::Starter starter = core::Starter::Cube) const
    {
        const QString path = root.filePath(folder);
        QDir().mkpath(path);
        core::writeMesh(toPath(path + QStringLiteral("/model.glb")), core::starterModel(starter));
        writeWork(path + QStringLiteral("/turn.json"),
                  QJsonDocument(QJsonObject{{QStringLiteral("format"), QStringLiteral("fettle-turn")},
                                            {QStringLiteral("id"), id},
                                            {QStringLiteral("name"), pupil},
                                            {QStringLiteral("begun"), QStringLiteral("2026-11-24T10:15:00")},
                                            {QStringLiteral("ended"), QStringLiteral("2026-11-24T10:19:00")}})
                      .toJson());
        return path;
    }

    QTemporaryDir root;
};

/// Adds the works of three pupils. Ben's turn was resumed; his first work is the ball.
void fillWorks(const ClassFolder& works)
{
    works.add(QStringLiteral("2026-11-24-1000-Cem"), QStringLiteral("Cem"), QStringLiteral("3"), core::Starter::Torus);
    works.add(QStringLiteral("2026-11-24-1015-Ben"), QStringLiteral("Ben"), QStringLiteral("1"), core::Starter::Ball);
    works.add(QStringLiteral("2026-11-24-1015-Ben-2"), QStringLiteral("Ben"), QStringLiteral("1"));
    works.add(QStringLiteral("2026-11-24-1020-Anna"), QStringLiteral("Anna"), QStringLiteral("2"));
}
} // namespace

/// Tests that reports and commands assign the works in a class folder to pupils.
class TestClassWorks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void works_areByPupilAndOnceATurn();
    void theTimeIsWhatWasUsed();
    void sameNames_areToldApart();
    void aWorkAlone_isOneToo();
    void theReport_namesPupilsAndTurns();
    void check_namesPupils();
    void sheets_areAPageAPupil();
    void theLesson_judgesEachPupil();
    void theReport_saysHowFarALessonCame();
    void anUnreadableWork_isSaidByAll();
};

void TestClassWorks::works_areByPupilAndOnceATurn()
{
    const ClassFolder works;
    fillWorks(works);
    core::writeMesh(toPath(works.root.filePath(QStringLiteral("aaa.stl"))), core::starterModel(core::Starter::Cube));
    QDir().mkpath(works.root.filePath(QStringLiteral("no work")));
    const QList<FoundModel> found = modelsAndWorks(toPath(works.root.path()));
    QStringList titles;
    for (const FoundModel& model : found)
        titles << model.title();
    QCOMPARE(titles, QStringList({"Anna", "Ben", "Cem", "aaa.stl"}));
    QVERIFY(found[1].work.endsWith(QStringLiteral("Ben-2")));
    QCOMPARE(found[0].turn.seconds().value_or(0), 240.0);
    QVERIFY(!found[3].turn.seconds());
    QVERIFY_THROWS_EXCEPTION(core::FileError, modelsAndWorks(toPath(works.root.filePath(QStringLiteral("no work")))));
}

/// The time of a turn excludes pauses. For works of older versions it is the time from beginning to end.
void TestClassWorks::theTimeIsWhatWasUsed()
{
    const ClassFolder works;
    const QString folder = works.add(QStringLiteral("a"), QStringLiteral("Anna"), QStringLiteral("1"));
    const QByteArray turn = contentOf(folder + QStringLiteral("/turn.json"));
    for (const auto& [used, seconds] :
         {std::pair("90", 90.0), std::pair("0", 0.0), std::pair("-1", 240.0), std::pair("\"long\"", 240.0)}) {
        writeWork(folder + QStringLiteral("/turn.json"),
                  QByteArray(turn).replace("{", QByteArray("{ \"used_seconds\": ") + used + ','));
        QCOMPARE(WorkArchive::turnOf(folder).seconds(), std::optional(seconds));
    }
}

void TestClassWorks::sameNames_areToldApart()
{
    const ClassFolder works;
    works.add(QStringLiteral("a"), QStringLiteral("Anna"), QStringLiteral("1"));
    works.add(QStringLiteral("b"), QStringLiteral("Anna"), QStringLiteral("2"));
    works.add(QStringLiteral("c"), QString(), QString());
    const QList<FoundModel> found = modelsAndWorks(toPath(works.root.path()));
    QCOMPARE(found.size(), 3);
    QVERIFY(found[0].title().startsWith(QStringLiteral("Anna (")) && found[0].title().contains(QStringLiteral("15")));
    QCOMPARE(found[0].turn.pupil, QStringLiteral("Anna"));
    QCOMPARE(found[2].title(), QStringLiteral("c")); // a work without a pupil has the name of its folder as its title
}

void TestClassWorks::aWorkAlone_isOneToo()
{
    const ClassFolder works;
    const QString folder = works.add(QStringLiteral("x"), QStringLiteral("Anna"), QStringLiteral("1"));
    const WorksAnswer answer = runFettle({QStringLiteral("check"), folder});
    QVERIFY2(answer.status == 0 && answer.out.contains(QStringLiteral("\nAnna ")), qPrintable(answer.out));
}

void TestClassWorks::theReport_namesPupilsAndTurns()
{
    const ClassFolder works;
    fillWorks(works);
    const QString page = works.root.filePath(QStringLiteral("r.html"));
    const WorksAnswer answer = runFettle({QStringLiteral("report"), works.root.path(), QStringLiteral("-o"), page});
    QVERIFY2(answer.status == 0 && answer.err.isEmpty(), qPrintable(answer.err));
    const QByteArray text = contentOf(page);
    QCOMPARE(text.count("<bdi>"), 3);
    for (const char* pupil : {"Anna", "Ben", "Cem"})
        QVERIFY(text.contains(QByteArray("<bdi>") + pupil + "</bdi>"));
    QVERIFY(text.contains("data-key=\"240\"") && text.contains(">4 min<"));
}

void TestClassWorks::check_namesPupils()
{
    const ClassFolder works;
    fillWorks(works);
    const WorksAnswer table = runFettle({QStringLiteral("check"), works.root.path()});
    QCOMPARE(table.status, 0);
    QCOMPARE(table.lines().size(), 4);
    QVERIFY(table.lines()[1].startsWith(QStringLiteral("Anna ")) &&
            table.lines()[3].startsWith(QStringLiteral("Cem ")));
    const WorksAnswer csv = runFettle({QStringLiteral("check"), QStringLiteral("--csv"), works.root.path()});
    QVERIFY(csv.lines().value(0).endsWith(QStringLiteral(",pupil,turn_begun,turn_s")));
    QVERIFY(csv.lines().value(2).endsWith(QStringLiteral(",Ben,2026-11-24T10:15:00,240.0")));
    const WorksAnswer json = runFettle({QStringLiteral("check"), QStringLiteral("--json"), works.root.path()});
    const QJsonObject first = QJsonDocument::fromJson(json.lines().value(0).toUtf8()).object();
    QCOMPARE(first[QStringLiteral("pupil")].toString(), QStringLiteral("Anna"));
    QVERIFY(first[QStringLiteral("file")].toString().endsWith(QStringLiteral("Anna/model.glb")));
}

void TestClassWorks::sheets_areAPageAPupil()
{
    const ClassFolder works;
    fillWorks(works);
    const QString pdf = works.root.filePath(QStringLiteral("s.pdf"));
    const WorksAnswer answer = runFettle({QStringLiteral("sheet"), works.root.path(), QStringLiteral("-o"), pdf});
    QVERIFY2(answer.status == 0 && answer.err.isEmpty(), qPrintable(answer.err));
    QCOMPARE(contentOf(pdf).count("/Type /Page\n"), 3);
}

/// None of the works meets the goals of this step of the lesson.
void TestClassWorks::theLesson_judgesEachPupil()
{
    const ClassFolder works;
    fillWorks(works);
    const QStringList judge{QStringLiteral("lesson"), QStringLiteral("first-clay"), QStringLiteral("--model"),
                            works.root.path(),        QStringLiteral("--step"),     QStringLiteral("1")};
    const WorksAnswer text = runFettle(judge);
    QVERIFY2(text.status == 1 && text.err.isEmpty(), qPrintable(text.err));
    QVERIFY(text.out.contains(QStringLiteral("\nAnna\n")) && text.out.contains(QStringLiteral("\nCem\n")));
    const WorksAnswer csv = runFettle(judge + QStringList{QStringLiteral("--csv")});
    QCOMPARE(csv.status, 1);
    QCOMPARE(csv.lines().size(), 4);
    QVERIFY2(csv.lines()[0].startsWith(QStringLiteral("lesson,step,title,model,pupil,turn_begun,met,")) &&
                 csv.lines()[0].contains(QStringLiteral(",height_mm,height_mm_met,")) &&
                 csv.lines()[0].endsWith(QStringLiteral(",error")),
             qPrintable(csv.lines()[0]));
    QVERIFY(csv.lines()[1].contains(QStringLiteral(",Anna,2026-11-24T10:15:00,false,")));
    const WorksAnswer json = runFettle(judge + QStringList{QStringLiteral("--json")});
    QCOMPARE(json.lines().size(), 3);
    const QJsonObject ben = QJsonDocument::fromJson(json.lines()[1].toUtf8()).object();
    QCOMPARE(ben[QStringLiteral("format")].toString(), QStringLiteral("fettle-lesson-result"));
    QCOMPARE(ben[QStringLiteral("pupil")].toString(), QStringLiteral("Ben"));
    QVERIFY(!ben[QStringLiteral("met")].toBool(true));
}

/// The report uses the language of the reader, whatever language the class had. Unknown goals in the file are left out.
void TestClassWorks::theReport_saysHowFarALessonCame()
{
    const ClassFolder works;
    const QString folder = works.add(QStringLiteral("a"), QStringLiteral("Anna"), QStringLiteral("1"));
    QJsonObject turn = QJsonDocument::fromJson(contentOf(folder + QStringLiteral("/turn.json"))).object();
    turn.insert(QStringLiteral("lesson"),
                QJsonDocument::fromJson(R"({"lesson": "mug", "title": "Der <Becher>", "step": 2, "steps": 5, "goals": [
                    {"goal": "components", "least": 1, "most": 1, "measured": 1, "met": true},
                    {"goal": "height_mm", "least": 200, "most": null, "measured": 40, "met": false},
                    {"goal": "distance_mm", "least": 0, "most": 3, "measured": 5, "met": false},
                    {"goal": "bribe", "met": true}, 7]})")
                    .object());
    writeWork(folder + QStringLiteral("/turn.json"), QJsonDocument(turn).toJson());
    const QString report = works.root.filePath(QStringLiteral("r.html"));
    QCOMPARE(runFettle({QStringLiteral("report"), works.root.path(), QStringLiteral("-o"), report}).status, 0);
    const QString page = QString::fromUtf8(contentOf(report));
    const QString said = page.mid(page.indexOf(QStringLiteral("Lesson Der")), 300);
    QVERIFY2(
        said.startsWith(QStringLiteral("Lesson Der &lt;Becher&gt;: step 2 of 5 · ✓ in one piece · ○ at least 200 mm "
                                       "tall (now 40 mm) · ○ like the teacher's to 3")),
        qPrintable(said));
    QVERIFY(!page.contains(QStringLiteral("bribe")));
}

void TestClassWorks::anUnreadableWork_isSaidByAll()
{
    const ClassFolder works;
    fillWorks(works);
    writeWork(works.add(QStringLiteral("z"), QStringLiteral("Zoe"), QStringLiteral("9")) + QStringLiteral("/model.glb"),
              {});
    const QString folder = works.root.path(), page = works.root.filePath(QStringLiteral("r.html")),
                  pdf = works.root.filePath(QStringLiteral("s.pdf"));
    const auto said = [](const WorksAnswer& answer, int status) {
        return answer.status == status && answer.err.count(u'\n') == 1 &&
               answer.err.contains(QStringLiteral("is empty"));
    };
    const WorksAnswer report = runFettle({QStringLiteral("report"), folder, QStringLiteral("-o"), page});
    QVERIFY2(said(report, 1) && report.err.contains(QStringLiteral("Zoe")), qPrintable(report.err));
    QCOMPARE(contentOf(page).count("<bdi>"), 4);
    QVERIFY(said(runFettle({QStringLiteral("sheet"), folder, QStringLiteral("-o"), pdf}), 1));
    const WorksAnswer check = runFettle({QStringLiteral("check"), folder});
    QVERIFY(said(check, 2) && check.out.contains(QStringLiteral("\nZoe ")));
    const WorksAnswer csv = runFettle({QStringLiteral("lesson"), QStringLiteral("first-clay"),
                                       QStringLiteral("--model"), folder, QStringLiteral("--csv")});
    QVERIFY2(said(csv, 2), qPrintable(csv.err));
    QCOMPARE(csv.lines().size(), 5);
    QVERIFY2(csv.lines()[4].contains(QStringLiteral(",Zoe,")) && !csv.lines()[4].contains(QStringLiteral("false")),
             qPrintable(csv.lines()[4]));
}

FETTLE_TEST(TestClassWorks, QCoreApplication)
#include "tst_class_works.moc"
