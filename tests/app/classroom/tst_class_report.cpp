#include "app/classroom/report_writer.h"
#include "tests/support/program_driver.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include "core/io/mesh_io.h"
#include "core/primitives/starter_models.h"
#include "ui/util/number_format.h"

#include <QAction>
#include <QCryptographicHash>
#include <QDir>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <fstream>
#include <sstream>

using namespace app;
namespace fs = std::filesystem;

namespace
{
struct Answer
{
    int status = -1;
    QByteArray out, err;
};

/// Runs the program as a script does, without a display.
Answer fettle(const QStringList& arguments, const QString& folder)
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(QString::fromLatin1(name));
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(folder);
    process.start(QStringLiteral(FETTLE_PROGRAM), arguments);
    if (!process.waitForFinished(-1) || process.exitStatus() != QProcess::NormalExit)
        return {};
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

QByteArray read(const fs::path& path)
{
    std::ifstream in(path, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return QByteArray::fromStdString(out.str());
}

void write(const fs::path& path, const QByteArray& bytes)
{
    std::ofstream(path, std::ios::binary) << bytes.toStdString();
}

const std::string strangeName = "m\xfcller.stl", evilName = "<script>alert(1)<b>&.stl", lineName = "a\nb.obj";
std::string longName()
{
    std::string name(180, 'w');
    return name += ".stl";
}

core::WriteOptions with(const core::WorkDone& work)
{
    core::WriteOptions options;
    options.metadata.work = work;
    return options;
}

constexpr qsizetype models = 30, unreadable = 3, unsound = 2;

/// Fills a folder with the models of thirty pupils.
void fillClass(const fs::path& folder)
{
    const core::TriangleMesh ball = core::icosphere(2, 20);
    core::writeMesh(folder / "anna10.glb", core::starterModel(core::Starter::Vase), with({1234, 3725}));
    core::writeMesh(folder / "Anna2.glb", core::starterModel(core::Starter::Head), with({7, 59.4}));
    core::writeMesh(folder / longName(), ball);
    core::writeMesh(folder / strangeName, ball);
    core::writeMesh(folder / evilName, ball);
    core::writeMesh(folder / lineName, ball);
    core::writeMesh(folder / "comma, \"quote\" 100%#?.ply", ball);
    core::writeMesh(folder / "tiny.obj", core::icosphere(2, 0.5));
    core::writeMesh(folder / "open.ply", shapes::openCone(12));
    core::writeMesh(folder / "crossing.off", shapes::sphereThroughSphere());
    write(folder / "empty.stl", "");
    write(folder / "cut.stl", QByteArray(84 + 30, '\1'));
    write(folder / "picture.ply", "\x89PNG\r\n\x1a\n and so on");
    for (int i = 0; i < 17; ++i)
        core::writeMesh(folder / ("pupil " + std::to_string(i) + ".stl"), shapes::cube(10.0F + static_cast<float>(i)));
    write(folder / "note.txt", "no model");
    write(folder / ".hidden.stl", "");
    fs::create_directory(folder / "folder.stl");
}

QStringList captured(const QByteArray& page, const char* pattern)
{
    QStringList all;
    for (auto i = QRegularExpression(QLatin1StringView(pattern)).globalMatch(QString::fromUtf8(page)); i.hasNext();)
        all << i.next().captured(1);
    return all;
}

/// Returns the table row that contains the name.
QString rowOf(const QByteArray& page, const QString& name)
{
    for (const QString& row : QString::fromUtf8(page).split(QStringLiteral("<tr>")))
        if (row.contains(QStringLiteral("<bdi>%1</bdi>").arg(name)))
            return row;
    return {};
}
} // namespace

class TestClassReport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    // deletes with std::filesystem, because Qt does not find names that are not valid UTF-8
    void cleanupTestCase() { fs::remove_all(at("class")); }
    void page_hasARowForEach();
    void page_isAloneAndNamesAreHarmless();
    void page_linksLeadToTheModels();
    void page_hasPictures();
    void rows_sayWhatIsKnown();
    void pdf_hasPagesAndLinks();
    void unit_isTaken();
    void stopped_writesNothing();
    void refusals_writeNothing_data();
    void refusals_writeNothing();
    void sheets_areAPageEach();
    void sheets_ofNothingAreNoFile();
    void durations_areWhatAPersonWouldSay();
    void window_writesAReport();

private:
    fs::path at(const std::string& name) const { return fs::path(m_folder.path().toStdString()) / name; }
    QStringList left() const { return QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden, QDir::Name); }

    QTemporaryDir m_folder;
    QByteArray m_page;
};

void TestClassReport::initTestCase()
{
    fs::create_directory(at("class"));
    fillClass(at("class"));
    const Answer answer =
        fettle({QStringLiteral("report"), QStringLiteral("class"), QStringLiteral("-o"), QStringLiteral("report.html")},
               m_folder.path());
    QVERIFY2(answer.status == 1 && answer.out.isEmpty() && answer.err.count('\n') == unreadable,
             answer.err.constData());
    m_page = read(at("report.html"));
}

void TestClassReport::page_hasARowForEach()
{
    const QStringList names = captured(m_page, "<bdi>([^<]*)</bdi>");
    QCOMPARE(names.size(), models);
    QVERIFY(names.indexOf(QStringLiteral("Anna2.glb")) < names.indexOf(QStringLiteral("anna10.glb")));
    QVERIFY(names.indexOf(QStringLiteral("pupil 2.stl")) < names.indexOf(QStringLiteral("pupil 10.stl")));
    QVERIFY(names.contains(QString::fromStdString(longName())) && names.contains(QStringLiteral("a b.obj")));
    QVERIFY(names.contains(QStringLiteral("m\uFFFDller.stl")));
    QCOMPARE(m_page.count("class=\"ready\""), models - unreadable - unsound);
    QCOMPARE(m_page.count("class=\"not\""), unreadable + unsound);
}

/// The page must load nothing from elsewhere. Its policy allows only the hash of Fettle's own script.
void TestClassReport::page_isAloneAndNamesAreHarmless()
{
    QVERIFY(!m_page.contains("http:") && !m_page.contains("https:") && !m_page.contains("//www"));
    QCOMPARE(m_page.count("<script>"), 1);
    QVERIFY(m_page.contains("&lt;script&gt;alert(1)&lt;b&gt;&amp;.stl"));
    QCOMPARE(captured(m_page, "src=\"(?!data:)([^\"]*)").size(), 0);
    const QByteArray script =
        m_page.mid(m_page.indexOf("<script>") + 8, m_page.indexOf("</script>") - m_page.indexOf("<script>") - 8);
    QVERIFY(m_page.contains("script-src 'sha256-" +
                            QCryptographicHash::hash(script, QCryptographicHash::Sha256).toBase64() + "'"));
}

void TestClassReport::page_linksLeadToTheModels()
{
    const QStringList links = captured(m_page, "<th scope=\"row\"><a href=\"([^\"]*)\"");
    QCOMPARE(links.size(), models);
    for (const QString& link : links) {
        static const QRegularExpression allowed(QStringLiteral("^class/[A-Za-z0-9._~%-]+$"));
        QVERIFY2(allowed.match(link).hasMatch(), qPrintable(link));
        QVERIFY2(fs::exists(at(QByteArray::fromPercentEncoding(link.toLatin1()).toStdString())), qPrintable(link));
    }
    QVERIFY(links.contains(QStringLiteral("class/m%FCller.stl")));

    fs::create_directories(at("desk/of the teacher"));
    ReportWriter::run({at("class"), at("desk/of the teacher/r.html")});
    QVERIFY(read(at("desk/of the teacher/r.html")).contains("href=\"../../class/anna10.glb\""));
    ReportWriter::run({at("class"), at("class/r.html")});
    QVERIFY(read(at("class/r.html")).contains("href=\"anna10.glb\""));
    fs::remove(at("class/r.html"));
}

void TestClassReport::page_hasPictures()
{
    const QStringList pictures = captured(m_page, "src=\"data:image/png;base64,([^\"]*)\"");
    QCOMPARE(pictures.size(), models - unreadable);
    for (const QString& data : pictures) {
        const QImage picture = QImage::fromData(QByteArray::fromBase64(data.toLatin1()), "PNG");
        QVERIFY(!picture.isNull() && picture.width() == picture.height());
        QVERIFY(qAlpha(picture.pixel(picture.rect().center())) == 255 && qAlpha(picture.pixel(0, 0)) == 0);
    }
}

void TestClassReport::rows_sayWhatIsKnown()
{
    const QString vase = rowOf(m_page, QStringLiteral("anna10.glb"));
    QVERIFY2(vase.contains(QStringLiteral(">1 h 02 min<")) &&
                 vase.contains(QStringLiteral(">%1<").arg(ui::number(1234))),
             qPrintable(vase.right(600)));
    QVERIFY(vase.contains(QStringLiteral("data-key=\"3725\"")) && vase.contains(QStringLiteral("data-key=\"1234\"")));
    QVERIFY(rowOf(m_page, QStringLiteral("Anna2.glb")).contains(QStringLiteral(">59 s<")));
    const QString cube = rowOf(m_page, QStringLiteral("pupil 0.stl"));
    QVERIFY2(cube.contains(QStringLiteral(">10.0 × 10.0 × 10.0<")) &&
                 cube.contains(QStringLiteral("data-key=\"1000\"")),
             qPrintable(cube.right(600)));
    // an STL file contains neither strokes nor time
    QCOMPARE(cube.count(QStringLiteral("<td class=\"figure\"></td>")), 2);
    QVERIFY(rowOf(m_page, QStringLiteral("open.ply")).contains(QStringLiteral("open edges: 12")));
    QVERIFY(rowOf(m_page, QStringLiteral("crossing.off")).contains(QStringLiteral("pairs of faces that intersect")));
    QVERIFY(rowOf(m_page, QStringLiteral("empty.stl")).contains(QStringLiteral("<small>empty.stl is empty.</small>")));
    QVERIFY(rowOf(m_page, QStringLiteral("tiny.obj")).contains(QStringLiteral("inches")));
}

void TestClassReport::pdf_hasPagesAndLinks()
{
    const Answer answer = fettle(
        {QStringLiteral("report"), QStringLiteral("class"), QStringLiteral("--output"), QStringLiteral("report.PDF")},
        m_folder.path());
    QVERIFY2(answer.status == 1 && answer.out.isEmpty() && answer.err.count('\n') == unreadable,
             answer.err.constData());
    const QByteArray pdf = read(at("report.PDF"));
    QVERIFY(pdf.startsWith("%PDF-") && pdf.trimmed().endsWith("%%EOF"));
    QVERIFY(pdf.count("/Type /Page\n") >= 3);
    QVERIFY(pdf.count("/URI (class/") >= models); // a name of several lines has a link on each line
    QVERIFY(pdf.contains("/URI (class/m%FCller.stl)"));
}

void TestClassReport::unit_isTaken()
{
    const Answer answer = fettle({QStringLiteral("report"), QStringLiteral("class"), QStringLiteral("--unit"),
                                  QStringLiteral("in"), QStringLiteral("-o"), QStringLiteral("inches.html")},
                                 m_folder.path());
    QCOMPARE(answer.status, 1);
    QVERIFY(rowOf(read(at("inches.html")), QStringLiteral("pupil 0.stl"))
                .contains(QStringLiteral(">254.0 × 254.0 × 254.0<")));
}

void TestClassReport::stopped_writesNothing()
{
    const QStringList before = left();
    std::stop_source stop;
    double reached = 0;
    const core::JobControl control{stop.get_token(), [&](double share) {
                                       reached = share;
                                       if (share > 0.3)
                                           stop.request_stop();
                                   }};
    QVERIFY_THROWS_EXCEPTION(core::ReadingCancelled, ReportWriter::run({at("class"), at("stopped.html")}, control));
    QVERIFY(reached > 0.3 && reached < 0.5);
    QCOMPARE(left(), before);
}

void TestClassReport::refusals_writeNothing_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("reason");
    QTest::newRow("no folder") << QStringLiteral("report -o a.html") << QStringLiteral("one folder");
    QTest::newRow("two folders") << QStringLiteral("report class class -o a.html") << QStringLiteral("one folder");
    QTest::newRow("no file") << QStringLiteral("report class") << QStringLiteral("name it with -o");
    QTest::newRow("another ending") << QStringLiteral("report class -o a.txt") << QStringLiteral("HTML or PDF");
    QTest::newRow("missing folder") << QStringLiteral("report missing -o a.html")
                                    << QStringLiteral("missing: there is no such");
    QTest::newRow("empty folder") << QStringLiteral("report class/folder.stl -o a.html")
                                  << QStringLiteral("this folder contains no models");
    QTest::newRow("a file as folder") << QStringLiteral("report class/tiny.obj -o a.html")
                                      << QStringLiteral("cannot be read");
    QTest::newRow("nowhere") << QStringLiteral("report class -o gone/a.html") << QStringLiteral("does not exist");
    QTest::newRow("sheet of nothing") << QStringLiteral("sheet -o a.pdf") << QStringLiteral("no file was given");
    QTest::newRow("sheet to nothing") << QStringLiteral("sheet class") << QStringLiteral("name it with -o");
    QTest::newRow("sheet as a picture") << QStringLiteral("sheet class -o a.png") << QStringLiteral(".pdf");
    QTest::newRow("sheet nowhere") << QStringLiteral("sheet class -o gone/a.pdf") << QStringLiteral("does not exist");
}

void TestClassReport::refusals_writeNothing()
{
    QFETCH(const QString, line);
    QFETCH(const QString, reason);
    const QStringList before = left();
    const Answer answer = fettle(line.split(QLatin1Char(' ')), m_folder.path());
    QCOMPARE(answer.status, 2);
    QVERIFY2(answer.out.isEmpty() && answer.err.count('\n') == 1 && QString::fromUtf8(answer.err).contains(reason),
             answer.err.constData());
    QCOMPARE(left(), before);
}

void TestClassReport::sheets_areAPageEach()
{
    const Answer answer =
        fettle({QStringLiteral("sheet"), QStringLiteral("class"), QStringLiteral("-o"), QStringLiteral("sheets.pdf")},
               m_folder.path());
    QCOMPARE(answer.status, 1);
    QVERIFY(answer.out.isEmpty());
    QCOMPARE(answer.err.count('\n'), unreadable + 1); // one message more for the open model
    QVERIFY(answer.err.contains("empty.stl is empty") && answer.err.contains("open.ply has no sheet"));
    QCOMPARE(read(at("sheets.pdf")).count("/Type /Page\n"), models - unreadable - 1);

    const Answer two =
        fettle({QStringLiteral("sheet"), QStringLiteral("class/anna10.glb"), QStringLiteral("class/tiny.obj"),
                QStringLiteral("--shaded"), QStringLiteral("-o"), QStringLiteral("two.pdf")},
               m_folder.path());
    QVERIFY2(two.status == 0 && two.err.isEmpty(), two.err.constData());
    QCOMPARE(read(at("two.pdf")).count("/Type /Page\n"), 2);
}

void TestClassReport::sheets_ofNothingAreNoFile()
{
    const Answer answer = fettle(
        {QStringLiteral("sheet"), QStringLiteral("class/empty.stl"), QStringLiteral("-o"), QStringLiteral("none.pdf")},
        m_folder.path());
    QCOMPARE(answer.status, 2);
    QVERIFY(answer.err.contains("none.pdf was not written"));
    QVERIFY(!fs::exists(at("none.pdf")));
}

void TestClassReport::durations_areWhatAPersonWouldSay()
{
    const auto is = [](double seconds, const char* text) {
        return ui::durationText(seconds) == QLatin1StringView(text);
    };
    QVERIFY(is(0, "0 s") && is(59.4, "59 s") && is(59.6, "1 min") && is(89, "1 min") && is(91, "2 min"));
    QVERIFY(is(59 * 60 + 29, "59 min") && is(59 * 60 + 31, "1 h 00 min") && is(3600 + 300, "1 h 05 min") &&
            is(26 * 3600, "26 h 00 min"));
}

/// Writes a report from the menu with two dialogs. A second, cancelled report must not be written.
void TestClassReport::window_writesAReport()
{
    Program program;
    sculptBall(program);
    const QString path = QString::fromStdString(at("by hand.html").string());
    const auto ask = [&](const QString& file) {
        program.window.action(QStringLiteral("file.report"))->trigger();
        chooseFile(program, "folderDialog", QString::fromStdString(at("class").string()));
        chooseFile(program, "reportDialog", file);
    };
    ask(path);
    QTRY_VERIFY(QFile::exists(path));
    QTRY_VERIFY(!program.document.job().isBusy());
    QTRY_VERIFY(notice(program).contains(QStringLiteral("Saved by hand.html.")));
    QCOMPARE(captured(read(at("by hand.html")), "<bdi>([^<]*)</bdi>").size(), models);
    QVERIFY(program.document.savedState().isModified()); // the open model is not affected

    ask(QString::fromStdString(at("on paper.pdf").string()));
    QTRY_VERIFY(notice(program).contains(QStringLiteral("Saved on paper.pdf.")));
    QVERIFY(read(at("on paper.pdf")).count("/URI (class/") >= models);

    Q_EMIT program.window.files()->reportRequested(QString::fromStdString(at("class/folder.stl").string()), path);
    const QMessageBox* problem = nullptr;
    QTRY_VERIFY((problem = program.window.findChild<QMessageBox*>(QStringLiteral("problem"))) && problem->isVisible());
    QVERIFY(problem->text().contains(QStringLiteral("this folder contains no models")));
    QTest::mouseClick(problem->button(QMessageBox::Ok), Qt::LeftButton);
    QVERIFY(QFile::exists(path));

    const QString second = QString::fromStdString(at("second.html").string());
    connect(&program.document.job(), &BackgroundJob::progressed, &program.document, &Document::cancelJob);
    ask(second);
    QTRY_VERIFY(notice(program).contains(QStringLiteral("second.html was not written.")));
    QVERIFY(!QFile::exists(second) && !program.document.job().isBusy());
}

FETTLE_TEST(TestClassReport, app::OnScreen)
#include "tst_class_report.moc"
