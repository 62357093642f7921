#include "app/commands/command_line.h"

#include "core/analysis/mesh_check.h"
#include "core/geometry/face_geometry.h"
#include "core/io/mesh_io.h"
#include "core/primitives/starter_models.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"
#include "tests/support/unwritable_places.h"
#include "ui/util/number_format.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace
{
struct Answer
{
    int status = -1;
    QByteArray out, err;

    QJsonObject json() const { return QJsonDocument::fromJson(out).object(); }
    /// Returns whether the program refused bad input: exit status 2, one line on stderr, nothing on stdout.
    bool isRefusal(const QString& with = {}) const
    {
        return status == 2 && out.isEmpty() && err.count('\n') == 1 && err.endsWith('\n') &&
               err.startsWith("fettle: ") && QString::fromUtf8(err).contains(with);
    }
};

/// Runs a program as a script does: without a display, in the C locale unless `variables` says otherwise.
Answer run(const QString& program, const QStringList& arguments, const QString& folder,
           const QMap<QString, QString>& variables = {})
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(QString::fromLatin1(name));
    environment.insert(QStringLiteral("LC_ALL"), QStringLiteral("C.UTF-8"));
    for (auto i = variables.begin(); i != variables.end(); ++i)
        environment.insert(i.key(), i.value());
    process.setProcessEnvironment(environment);
    if (!folder.isEmpty())
        process.setWorkingDirectory(folder);
    process.start(program, arguments);
    Answer answer;
    if (!process.waitForFinished(-1) || process.exitStatus() != QProcess::NormalExit)
        return answer;
    answer.status = process.exitCode();
    answer.out = process.readAllStandardOutput();
    answer.err = process.readAllStandardError();
    return answer;
}

Answer fettle(const QStringList& arguments, const QMap<QString, QString>& variables = {}, const QString& folder = {})
{
    return run(QStringLiteral(FETTLE_PROGRAM), arguments, folder, variables);
}

QByteArray read(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

QStringList filesIn(const QString& folder)
{
    return QDir(folder).entryList(QDir::Files | QDir::Hidden, QDir::Name);
}

QByteArray strokes(const QByteArray& stroke, const QByteArray& samples = R"({"position":[1,0,0]})")
{
    return R"({"format":"fettle-strokes","version":1,"strokes":[{"samples":[)" + samples + "]," + stroke + "}]}";
}

const QByteArray cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                        "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
} // namespace

#define VERIFY_REFUSED(answer, with)                                                                                   \
    QVERIFY2((answer).isRefusal(QStringLiteral(with)), ((answer).err + (answer).out).constData())

class TestCommandLine : public QObject
{
    Q_OBJECT

public:
    explicit TestCommandLine(const places::SmallDisk* smallDisk) : m_smallDisk(smallDisk) {}

private Q_SLOTS:
    void init();
    void version_andHelp();
    void output_thatCannotBeWrittenIsAnError();
    void files_thatMayNotBeReadSayWhy();
    void usage_isRefused_data();
    void usage_isRefused();
    void words_winOverFileNames();
    void words_thatAreNothingAreToldAsSuch_data();
    void words_thatAreNothingAreToldAsSuch();
    void words_thatAreOneOfSomeAreListed_data();
    void words_thatAreOneOfSomeAreListed();
    void files_ofAnotherFormatAreToldAsSuch();
    void spellings_ofBothKindsAreTaken();
    void new_writesEachStarter();
    void new_writesPrimitives();
    void standardFiles_carryModels();
    void standardFiles_areNamedInErrors();
    void standardOutput_isNoTerminalForBinaries();
    void noClobber_keepsWhatIsThere_data();
    void noClobber_keepsWhatIsThere();
    void window_withoutADisplaySaysSo();
    void window_withADeadDisplaySaysSo();
    void window_startsInVrIfAsked();
    void window_startsInTheSimulatorIfAsked();
    void class_isRefusedWithItsReason();
    void check_cube();
    void check_openModelIsNotReady();
    void check_severalAndFolders();
    void check_folderOfAClass();
    void check_csvOfOddNames();
    void check_tableOfLongNames();
    void check_workOfGlbFiles();
    void check_badFiles_data();
    void check_badFiles();
    void check_print();
    void check_overhangAngle();
    void check_unit();
    void check_printRefusals_data();
    void check_printRefusals();
    void check_goesOnAfterABadFile();
    void convert_keepsCoordinates();
    void convert_recentre();
    void convert_unitAndSize();
    void convert_triangles();
    void convert_up();
    void convert_brokenModelWritesNothing();
    void convert_legalise();
    void convert_wrap();
    void convert_tellsOfTheReducedModel();
    void convert_leavesSheetsOut();
    void convert_refusals_data();
    void convert_refusals();
    void convert_ontoItself();
    void convert_ontoAFullDisk_data();
    void convert_ontoAFullDisk();
    void convert_whereNothingMayBeWritten();
    void pages_ontoAFullDisk_data();
    void pages_ontoAFullDisk();
    void replay_statsHaveTheFields();
    void replay_isDeterministic();
    void replay_outIsInOrder();
    void replay_fullVerifies();
    void replay_neverMovesTheModel();
    void replay_refusals_data();
    void replay_refusals();
    void replay_extremesHaveAnAnswer();
    void replay_refusalWritesNothing();
    void replay_oddStrokesAreTaken();
    void replay_radiusHasToFitTheLattice();
    void numbers_haveNoLocale();
    void locale_givesTheLanguage_data();
    void locale_givesTheLanguage();

private:
    QString at(const char* name) const { return m_folder->filePath(QString::fromUtf8(name)); }
    QStringList left() const { return filesIn(m_folder->path()); }

    const places::SmallDisk* m_smallDisk;
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestCommandLine::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestCommandLine::version_andHelp()
{
    const Answer version = fettle({QStringLiteral("--version")});
    QCOMPARE(version.status, 0);
    QVERIFY2(version.out.startsWith("fettle " FETTLE_VERSION) && version.err.isEmpty(), version.out.constData());
    for (const char* told : {"\nQt ", ", OpenXR ", ", OpenMesh ", "\nMIT License"})
        QVERIFY2(version.out.contains(told), told);
    for (const QStringList& arguments : {QStringList{QStringLiteral("--help")},
                                         {QStringLiteral("help")},
                                         {QStringLiteral("help"), QStringLiteral("replay")},
                                         {QStringLiteral("--vr"), QStringLiteral("--help")},
                                         {QStringLiteral("help"), QStringLiteral("new")},
                                         {QStringLiteral("check"), QStringLiteral("--help")},
                                         {QStringLiteral("convert"), QStringLiteral("--help")},
                                         {QStringLiteral("help"), QStringLiteral("report")},
                                         {QStringLiteral("sheet"), QStringLiteral("--help")}}) {
        const Answer help = fettle(arguments);
        QCOMPARE(help.status, 0);
        QVERIFY(help.out.contains("fettle") && help.err.isEmpty());
        QVERIFY(!help.out.contains("--help-all") && !help.out.contains("Qt"));
    }
    QVERIFY(fettle({QStringLiteral("check"), QStringLiteral("--help")})
                .out.startsWith("Usage: fettle check [options] FILE..."));
}

/// A shell redirects and limits the output. $1 is the program.
void TestCommandLine::output_thatCannotBeWrittenIsAnError()
{
    write(at("a.obj"), cube);
    const auto shell = [&](const char* script) {
        return run(
            QStringLiteral("sh"),
            {QStringLiteral("-c"), QString::fromLatin1(script), QStringLiteral("sh"), QStringLiteral(FETTLE_PROGRAM)},
            m_folder->path());
    };
    for (const char* script :
         {"\"$1\" check a.obj > /dev/full", "\"$1\" check --json a.obj > /dev/full", "\"$1\" --version > /dev/full"})
        VERIFY_REFUSED(shell(script), "standard output");
    write(at("s.json"), strokes(R"("tool":"pull","radius":0.25)"));
    VERIFY_REFUSED(shell("ulimit -f 1; \"$1\" replay --strokes s.json --out big.ply"), "big.ply was not written");
    QCOMPARE(left(), QStringList({QStringLiteral("a.obj"), QStringLiteral("s.json")}));
}

void TestCommandLine::files_thatMayNotBeReadSayWhy()
{
    write(at("a.obj"), cube);
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("locked")));
    const auto check = [&](const QString& name) {
        return fettle({QStringLiteral("check"), name}, {}, m_folder->path());
    };
    QCOMPARE(check(QStringLiteral("a.obj")).status, 0);
    QFile::setPermissions(at("a.obj"), {});
    QFile::setPermissions(at("locked"), {});
    VERIFY_REFUSED(check(QStringLiteral("a.obj")), "a.obj cannot be read (Permission denied)");
    VERIFY_REFUSED(check(QStringLiteral("locked")), "locked: this folder cannot be read (Permission denied)");
    QFile::setPermissions(at("locked"), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
}

void TestCommandLine::usage_isRefused_data()
{
    QTest::addColumn<QString>("line");
    for (const char* line : {"check",
                             "check --jsn a.stl",
                             "check --json --csv a.stl",
                             "convert",
                             "convert a.stl",
                             "convert a.stl b.stl c.stl",
                             "convert a.stl b.stl --unit ft",
                             "convert a.stl b.stl --size 0",
                             "convert a.stl b.stl --triangles 3",
                             "convert a.stl b.stl --triangles many",
                             "convert a.stl b.stl --size nan",
                             "convert a.stl b.stl --size 1e999",
                             "convert a.stl b.stl --size 10mm",
                             "convert a.stl b.stl --up x",
                             "convert a.stl b.stl --inner-parts hollow",
                             "convert a.stl b.stl --wrap",
                             "convert a.stl b.stl --legalise --large-holes perhaps",
                             "replay",
                             "replay s.json",
                             "replay --strokes",
                             "replay --strokes s.json --verify most",
                             "replay --strokes s.json --verify none --out a.stl",
                             "replay --strokes s.json --stats ./s.json",
                             "replay --strokes s.json --in a.stl --out b/../a.stl",
                             "replay --strokes - --in - --from stl",
                             "replay --strokes s.json --out - --stats - --to stl",
                             "replay --strokes s.json --every 2",
                             "help me",
                             "new",
                             "new ball",
                             "new bal a.stl",
                             "new ball a.xyz",
                             "new ball -",
                             "new ball - --to xyz",
                             "new ball a.stl --size 0",
                             "new ball a.stl b.stl",
                             "check -",
                             "check - --from xyz",
                             "convert - b.stl",
                             "lesson first-clay --json --csv",
                             "lesson first-clay --pictures none",
                             "report",
                             "report .",
                             "report . . -o a.html",
                             "report . -o a.txt",
                             "report . -o",
                             "report . -o a.html --unit ft",
                             "sheet",
                             "sheet .",
                             "sheet a.stl -o a.svg",
                             "sheet -o a.pdf",
                             "sheet a.stl -o a.pdf --unit ft"})
        QTest::newRow(line) << QString::fromUtf8(line);
}

void TestCommandLine::usage_isRefused()
{
    QFETCH(QString, line);
    const Answer answer = fettle(line.split(QLatin1Char(' ')), {}, m_folder->path());
    VERIFY_REFUSED(answer, "");
    QVERIFY(left().isEmpty());
}

void TestCommandLine::words_winOverFileNames()
{
    write(at("check"), cube);
    VERIFY_REFUSED(fettle({QStringLiteral("check")}, {}, m_folder->path()), "check: no file");
}

/// Unknown words are refused before a display is needed, with a suggestion of what may have been meant.
void TestCommandLine::words_thatAreNothingAreToldAsSuch_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("answer");
    const auto row = [](const char* line, const char* answer) {
        QTest::newRow(line) << QString::fromLatin1(line) << QString::fromLatin1(answer);
    };
    row("chekc a.obj", "\"chekc\" is neither a command nor a file. Did you mean check?");
    row("version", "\"version\" is neither a command nor a file. Did you mean --version?");
    row("nofile.stl", "\"nofile.stl\" is neither a command nor a file. See fettle --help");
    row("--bogus", "\"--bogus\" is not an option. See fettle --help");
    row("--vr --clasroom a.ini", "\"--clasroom\" is not an option. Did you mean --classroom?");
    row("-platform offscreen --bogus", "\"--bogus\" is not an option.");
    row("a.obj nofile.stl", "\"nofile.stl\" is neither");
    row("a.obj a.obj", "One file at a time");
    row("help chekc", "no command \"chekc\": the commands are new, check, ");
    row("a.obj", "there is no display");
    row("-style fusion a.obj", "there is no display");
    row("-- a.obj", "there is no display");
}

void TestCommandLine::words_thatAreNothingAreToldAsSuch()
{
    QFETCH(const QString, line);
    QFETCH(const QString, answer);
    write(at("a.obj"), cube);
    const Answer refusal = fettle(line.split(u' '), {}, m_folder->path());
    QVERIFY2(refusal.isRefusal(answer), refusal.err.constData());
}

void TestCommandLine::words_thatAreOneOfSomeAreListed_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("answer");
    const auto row = [](const char* line, const char* answer) {
        QTest::newRow(line) << QString::fromLatin1(line) << QString::fromLatin1(answer);
    };
    row("check a.obj --unit ft", "check: --unit must be one of mm, cm, m, in, not \"ft\".");
    row("sheet a.obj -o a.pdf --unit ft", "sheet: --unit must be one of mm, cm, m, in, not \"ft\".");
    row("convert a.obj b.stl --up x", "convert: --up must be one of y, z, not \"x\".");
    row("convert a.obj b.stl --legalise --large-holes all", "--large-holes must be one of fill, refuse, not \"all\".");
    row("convert a.obj b.stl --size 0", "convert: --size must be a number from 0.001 to 1000000, not \"0\".");
    row("convert a.obj b.stl --triangles 3", "convert: --triangles must be a whole number, 4 or more, not \"3\".");
    row("convert a.obj b.stl --wrap", "convert: --wrap can only be used with --repair.");
    row("convert a.obj b.xyz",
        "b.xyz: cannot tell the format: the ending must be one of stl, obj, ply, off, glb, 3mf.");
    row("convert a.obj", "convert: needs two files, IN and OUT; 1 was given.");
    row("convert a.obj - --to x", "convert: --to must be one of stl, obj, ply, off, glb, 3mf, not \"x\".");
    row("check a.obj --json --csv", "check: --json and --csv cannot be used together.");
    row("replay --strokes s.json --verify most", "replay: --verify must be one of local, full, none, not \"most\".");
    row("replay --strokes s.json --frames . --every 0",
        "replay: --every must be a whole number, 1 or more, not \"0\".");
    row("new bal b.stl", "new: the shape must be one of ball, cube, torus, slab, vase, head, tablet, or with measures "
                         "box, ball, cylinder, cone, capsule, torus, lathe, tube, not \"bal\".");
    row("lesson nonsense", "\"nonsense\" is not a lesson: it is neither one of first-clay, mug, creature, toy-car nor "
                           "a folder or ZIP file.");
}

void TestCommandLine::words_thatAreOneOfSomeAreListed()
{
    QFETCH(const QString, line);
    QFETCH(const QString, answer);
    write(at("a.obj"), cube);
    const Answer refusal = fettle(line.split(u' '), {}, m_folder->path());
    QVERIFY2(refusal.isRefusal(answer), refusal.err.constData());
    QCOMPARE(left(), QStringList{QStringLiteral("a.obj")});
}

/// Messages name the format that the file's ending promises.
void TestCommandLine::files_ofAnotherFormatAreToldAsSuch()
{
    write(at("a.stl"), "this is plain text, and long enough to be no cut header of a binary file: it goes on and on");
    VERIFY_REFUSED(fettle({QStringLiteral("check"), at("a.stl")}),
                   "a.stl is not a valid STL file; it looks like plain text.");
    write(at("b.ply"), "\x89PNG\r\n\x1a\n");
    VERIFY_REFUSED(fettle({QStringLiteral("check"), at("b.ply")}), "b.ply is not a valid PLY file; it looks like PNG.");
}

void TestCommandLine::spellings_ofBothKindsAreTaken()
{
    core::TriangleMesh open = core::icosphere(3, 10);
    open.triangles.resize(open.triangles.size() - 3);
    core::writeMesh(at("open.ply").toStdString(), open);
    write(at("ball.obj"), cube);
    for (const char* option : {"--repair", "--legalise", "--legalize"})
        QCOMPARE(fettle({QStringLiteral("convert"), at("open.ply"), at("out.stl"), QLatin1String(option)}).status, 0);
    QList<QByteArray> models;
    for (const QByteArray& centre : {QByteArrayLiteral("centre"), QByteArrayLiteral("center")}) {
        const QByteArray recentre = centre == "center" ? "recenter" : "recentre";
        write(at("s.json"), R"({"format":"fettle-strokes","version":1,"strokes":[{"command":"move","by":[1,0,0]},)"
                            R"({"command":")" +
                                recentre + R"("},{"command":"insert","file":"ball.obj","where":")" + centre + R"(",")" +
                                centre + R"(":[0,3,0]}]})");
        const Answer answer = fettle({QStringLiteral("replay"), QStringLiteral("--strokes"), at("s.json"),
                                      QStringLiteral("--out"), at("out.ply")});
        QVERIFY2(answer.status == 0, answer.err.constData());
        models << read(at("out.ply"));
    }
    QCOMPARE(models[0], models[1]);
}

void TestCommandLine::new_writesEachStarter()
{
    for (const core::Starter starter : core::starters) {
        const QString word = QString::fromUtf8(core::name(starter));
        const Answer answer = fettle({QStringLiteral("new"), word, at("a.ply")});
        QVERIFY2(answer.status == 0 && answer.out.isEmpty() && answer.err.isEmpty(), answer.err.constData());
        QVERIFY(core::readMesh(at("a.ply").toStdString()).points == core::starterModel(starter).points);
    }
    QCOMPARE(fettle({QStringLiteral("new"), QStringLiteral("vase"), at("a.stl"), QStringLiteral("--size"),
                     QStringLiteral("80")})
                 .status,
             0);
    QCOMPARE(core::boxOf(core::readMesh(at("a.stl").toStdString())).sizes().maxCoeff(), 80.0);
}

void TestCommandLine::new_writesPrimitives()
{
    const auto make = [&](const char* words) {
        return fettle(QStringList{QStringLiteral("new")} + QProcess::splitCommand(QString::fromUtf8(words)) +
                      QStringList{at("a.ply")});
    };
    for (const char* words :
         {"box --width 10 --height 20 --depth 30", "ball --radius 5", "cylinder --radius 5 --height 20",
          "cone --radius 5 --height 20", "cone --radius 5 --height 20 --top-radius 2", "capsule --radius 5 --height 20",
          "torus --radius 5 --tube-radius 2 --edge-length 0.3", "lathe --profile \"0,0 10,0 8,20\"",
          "tube --path \"0,0,0,2 9,5,0,1 0,9,0,2\""}) {
        const Answer answer = make(words);
        QVERIFY2(answer.status == 0 && answer.out.isEmpty() && answer.err.isEmpty(), answer.err.constData());
        QVERIFY2(core::checkMesh(core::readMesh(at("a.ply").toStdString())).printReady(), words);
    }
    for (const auto& [words, part] :
         {std::pair("box --width 10 --height 20", "box needs --depth"),
          std::pair("ball --radius 5 --height 3", "ball has no --height"),
          std::pair("vase --radius 5", "vase has no measures but --size"),
          std::pair("ball --radius 5 --size 10", "has no --size"), std::pair("blob", "with measures box, ball"),
          std::pair("ball --radius 0", "--radius must be a number from"),
          std::pair("torus --radius 2 --tube-radius 3", "larger than the radius of its"),
          std::pair("lathe --profile 1,2,3", "as in \"10,0 8,20\""),
          std::pair("tube --path 1,2,3", "as in \"0,0,0,2 9,5,0,1\""), std::pair("tube", "tube needs --path"),
          std::pair("tube --path 0,0,0,1", "2 to 1000 points"),
          std::pair("ball --radius 5 --edge-length 3", "may be 0.833 mm long at most")}) {
        const Answer answer = make(words);
        QCOMPARE(answer.status, 2);
        QVERIFY2(answer.err.contains(part) && answer.err.count('\n') == 1, answer.err.constData());
    }
}

void TestCommandLine::standardFiles_carryModels()
{
    write(at("s.json"), strokes(R"("tool":"pull","radius":0.25)"));
    const auto shell = [&](const char* script) {
        return run(
            QStringLiteral("sh"),
            {QStringLiteral("-c"), QString::fromLatin1(script), QStringLiteral("sh"), QStringLiteral(FETTLE_PROGRAM)},
            m_folder->path());
    };
    const Answer check = shell("\"$1\" new torus - --to glb | \"$1\" convert - - --from glb --to off --unit cm | "
                               "\"$1\" check - --from off --json");
    QVERIFY2(check.status == 0 && check.err.isEmpty(), check.err.constData());
    QCOMPARE(check.json()[QStringLiteral("file")].toString(), QStringLiteral("(standard input)"));
    QCOMPARE(check.json()[QStringLiteral("genus")].toInt(), 1);
    QCOMPARE(check.json()[QStringLiteral("size_mm")].toArray()[0].toDouble(), 1000.0);

    for (const char* format : {"stl", "obj", "ply", "off", "glb", "3mf"}) {
        const QByteArray to =
            QByteArray("\"$1\" new cube a.") + format + " && \"$1\" new cube - --to " + format + " | cmp - a." + format;
        QVERIFY2(shell(to.constData()).status == 0, format);
    }
    QCOMPARE(shell("\"$1\" replay --strokes - --out a.ply < s.json && "
                   "\"$1\" replay --strokes s.json --out - --to ply | cmp - a.ply")
                 .status,
             0);
    QCOMPARE(shell("cat a.ply | \"$1\" replay --strokes s.json --in - --from ply --out b.ply && "
                   "\"$1\" replay --strokes s.json --in a.ply --out c.ply && cmp b.ply c.ply")
                 .status,
             0);
    QCOMPARE(shell("\"$1\" replay --strokes s.json --stats -").json()[QStringLiteral("dabs")].toArray().size(), 1);
    QVERIFY(shell("\"$1\" new vase - --to stl | \"$1\" sheet - --from stl -o -").out.startsWith("%PDF"));

    QVERIFY(shell("\"$1\" report . -o - --to html").out.contains("a.ply"));
    QVERIFY(shell("\"$1\" report . --out - --to pdf").out.startsWith("%PDF"));
    VERIFY_REFUSED(shell("\"$1\" report . -o -"), "report: --to must say the format of -: one of html, pdf.");

    // The repair report goes to standard error if the model goes to standard output.
    write(at("open.obj"), QByteArray(cube).chopped(10)); // without its last face
    const Answer mended = shell("\"$1\" convert open.obj - --to off --legalise");
    QVERIFY2(mended.status == 0 && mended.out.startsWith("OFF") && mended.err.contains("Holes filled: 1\n"),
             mended.err.constData());
}

void TestCommandLine::standardFiles_areNamedInErrors()
{
    const auto shell = [&](const char* script) {
        return run(
            QStringLiteral("sh"),
            {QStringLiteral("-c"), QString::fromLatin1(script), QStringLiteral("sh"), QStringLiteral(FETTLE_PROGRAM)},
            m_folder->path());
    };
    for (const char* script : {"\"$1\" check - --from stl < /dev/null", "\"$1\" convert - b.stl --from obj < /dev/null",
                               "\"$1\" replay --strokes s.json --in - --from stl < /dev/null"}) {
        write(at("s.json"), strokes(R"("tool":"pull","radius":0.25)"));
        VERIFY_REFUSED(shell(script), "fettle: (standard input) is empty");
    }
    VERIFY_REFUSED(shell("\"$1\" replay --strokes - < /dev/null"), "JSON");
    VERIFY_REFUSED(shell("\"$1\" new ball - --to stl > /dev/full"), "standard output");
    QCOMPARE(left(), QStringList{QStringLiteral("s.json")});
}

void TestCommandLine::standardOutput_isNoTerminalForBinaries()
{
#ifndef Q_OS_LINUX
    QSKIP("The program that makes a terminal is Linux's.");
#endif
    const auto atTerminal = [&](const char* format) {
        return run(
            QStringLiteral("script"),
            {QStringLiteral("-qec"),
             QStringLiteral("\"%1\" new cube - --to %2").arg(QStringLiteral(FETTLE_PROGRAM), QLatin1String(format)),
             QStringLiteral("/dev/null")},
            m_folder->path());
    };
    const Answer binary = atTerminal("stl");
    QCOMPARE(binary.status, 2);
    QVERIFY2(binary.out.contains("new: STL is binary") && binary.out.count('\n') == 1, binary.out.constData());
    QVERIFY(atTerminal("obj").out.startsWith("v "));
}

void TestCommandLine::noClobber_keepsWhatIsThere_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("file");
    const auto row = [](const char* line, const char* file) {
        QTest::newRow(line) << QString::fromLatin1(line) << QString::fromLatin1(file);
    };
    row("new ball out.stl", "out.stl");
    row("convert a.obj out.stl", "out.stl");
    row("convert a.obj a.obj", "a.obj");
    row("replay --strokes s.json --out out.stl", "out.stl");
    row("replay --strokes s.json --stats t.json", "t.json");
    row("sheet a.obj -o out.pdf", "out.pdf");
    row("report . -o out.html", "out.html");
    row("brush pores --picture out.png", "out.png");
    row("lesson first-clay --out out.stl", "out.stl");
    row("lesson first-clay --pack out.zip", "out.zip");
    row("lesson first-clay --unpack folder", "folder");
    row("lesson first-clay --pictures folder", "folder/step-3.png");
}

void TestCommandLine::noClobber_keepsWhatIsThere()
{
    QFETCH(const QString, line);
    QFETCH(const QString, file);
    write(at("a.obj"), cube);
    write(at("s.json"), strokes(R"("tool":"pull","radius":0.25)"));
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("folder")));
    const QString path = m_folder->filePath(file);
    if (!QFile::exists(path))
        write(path, "what was there");
    const QByteArray before = read(path);
    const QStringList files = left();
    const Answer answer = fettle(line.split(u' ') + QStringList{QStringLiteral("--no-clobber")}, {}, m_folder->path());
    QVERIFY2(answer.isRefusal(file + QStringLiteral(" already exists")), answer.err.constData());
    QCOMPARE(read(path), before);
    QCOMPARE(left(), files);
}

void TestCommandLine::window_withoutADisplaySaysSo()
{
    write(at("model.stl"), cube);
    VERIFY_REFUSED(fettle({}), "display");
    VERIFY_REFUSED(fettle({at("model.stl")}), "display");
}

void TestCommandLine::class_isRefusedWithItsReason()
{
    using app::CommandLine;
    const QString word = QStringLiteral("--classroom"), file = at("5b.ini");
    write(file, "");
    const auto start = [](const QStringList& arguments) { return CommandLine::windowStart(arguments); };
    QCOMPARE(start({word, file}).classFile, file);
    QVERIFY(start({QStringLiteral("--vr"), word, file}).entersVr && start({file}).classFile.isEmpty());
    // after -- the word is a file name, and there is no such file
    QVERIFY_THROWS_EXCEPTION(app::CommandFailure, start({QStringLiteral("--"), word}));
    QVERIFY_THROWS_EXCEPTION(app::CommandFailure, start({word}));
    QVERIFY_THROWS_EXCEPTION(app::CommandFailure, start({word, file, at("a.stl")}));
    QVERIFY_THROWS_EXCEPTION(app::CommandFailure, start({word, file, word, file}));
    write(file, "title = 5b\nfolder = /none\nstarters = ball\ntools = melt\n");
    const QStringList shown{QStringLiteral("-platform"), QStringLiteral("offscreen"), word};
    const QMap<QString, QString> quiet{{QStringLiteral("XDG_RUNTIME_DIR"), QFileInfo(file).path()}};
    VERIFY_REFUSED(fettle(shown + QStringList(file), quiet), "5b.ini, line 4: tools: \"melt\" is none of");
    VERIFY_REFUSED(fettle(shown + QStringList(at("none.ini")), quiet), "none.ini cannot be read");
    QVERIFY(fettle({QStringLiteral("--help")}).out.contains("--classroom CLASS.fettleclass"));
}

void TestCommandLine::window_startsInVrIfAsked()
{
    using app::CommandLine;
    const QString vr = QStringLiteral("--vr"), file = at("a.stl");
    write(file, "");
    const auto start = [](const QStringList& arguments) { return CommandLine::windowStart(arguments); };
    QVERIFY(start({}).file.isEmpty() && !start({}).entersVr);
    QVERIFY(start({vr}).file.isEmpty() && start({vr}).entersVr);
    QVERIFY(start({file}).file == file && !start({file}).entersVr);
    for (const QStringList& arguments : {QStringList{vr, file}, {file, vr}})
        QVERIFY(start(arguments).file == file && start(arguments).entersVr);
    const QString before = QDir::currentPath();
    write(at("--vr"), "");
    QVERIFY(QDir::setCurrent(m_folder->path()));
    // after -- the word is a file name, and there is such a file
    const app::WindowStart named = start({QStringLiteral("--"), vr});
    QVERIFY(QDir::setCurrent(before));
    QVERIFY(named.file.endsWith(vr) && !named.entersVr);
    QVERIFY_THROWS_EXCEPTION(app::CommandFailure, start({QStringLiteral("--vr2")}));
    QVERIFY_THROWS_EXCEPTION(app::CommandFailure, start({file, vr, file}));
    QVERIFY(CommandLine::opensWindow({vr}) && CommandLine::opensWindow({}) && CommandLine::opensWindow({file}));
    QVERIFY(!CommandLine::opensWindow({QStringLiteral("check")}) && !CommandLine::opensWindow({at("b.stl")}));
    QVERIFY(fettle({QStringLiteral("--help")}).out.contains("--vr"));
    VERIFY_REFUSED(fettle({vr}), "display");
}

void TestCommandLine::window_startsInTheSimulatorIfAsked()
{
    const QString simulator = QString::fromLatin1(app::simulatorOption), file = at("a.stl");
    write(file, "");
    const auto start = [](const QStringList& arguments) { return app::CommandLine::windowStart(arguments); };
    for (const QStringList& arguments : {QStringList{simulator, file}, {file, simulator}}) {
        const app::WindowStart asked = start(arguments);
        QVERIFY(asked.file == file && asked.simulatesVr && asked.entersVr);
    }
    const app::WindowStart lesson = start({simulator, QStringLiteral("--classroom"), file});
    QVERIFY(lesson.simulatesVr && lesson.classFile == file);
    QVERIFY(!start({QStringLiteral("--vr")}).simulatesVr);
    // after -- the word is a file name, and there is no such file
    QVERIFY_THROWS_EXCEPTION(app::CommandFailure, start({QStringLiteral("--"), simulator}));
    QVERIFY(fettle({QStringLiteral("--help")}).out.contains("--vr-simulator [FILE]"));
    VERIFY_REFUSED(fettle({simulator}), "display");
    const QMap<QString, QString> quiet{{QStringLiteral("XDG_RUNTIME_DIR"), m_folder->path()}};
    VERIFY_REFUSED(fettle({QStringLiteral("-platform"), QStringLiteral("offscreen"), simulator}, quiet), "OpenGL");
}

void TestCommandLine::window_withADeadDisplaySaysSo()
{
    VERIFY_REFUSED(fettle({}, {{QStringLiteral("DISPLAY"), QStringLiteral(":987")}}), "display");
}

void TestCommandLine::check_cube()
{
    write(at("cube.obj"), cube);
    Answer plain = fettle({QStringLiteral("check"), at("cube.obj")});
    QCOMPARE(plain.status, 0);
    QVERIFY(plain.err.isEmpty() && plain.out.contains("is watertight."));
    // the page uses plain words, not JSON keys
    QVERIFY2(!plain.out.replace(at("cube.obj").toUtf8(), "").contains('_'), plain.out.constData());
    QVERIFY(plain.out.contains("bounds a solid") && plain.out.contains("holes through it"));

    const Answer answer = fettle({QStringLiteral("check"), at("cube.obj"), QStringLiteral("--json")});
    QCOMPARE(answer.status, 0);
    const QJsonObject json = answer.json();
    const QStringList keys{QStringLiteral("area_mm2"),
                           QStringLiteral("bounds_solid"),
                           QStringLiteral("closed"),
                           QStringLiteral("components"),
                           QStringLiteral("degenerate_faces"),
                           QStringLiteral("error"),
                           QStringLiteral("faces"),
                           QStringLiteral("file"),
                           QStringLiteral("format"),
                           QStringLiteral("genus"),
                           QStringLiteral("lattice_ok"),
                           QStringLiteral("manifold"),
                           QStringLiteral("max_edge_mm"),
                           QStringLiteral("min_edge_mm"),
                           QStringLiteral("oriented"),
                           QStringLiteral("print_ready"),
                           QStringLiteral("self_intersections"),
                           QStringLiteral("size_mm"),
                           QStringLiteral("strokes"),
                           QStringLiteral("time_spent_s"),
                           QStringLiteral("version"),
                           QStringLiteral("vertices"),
                           QStringLiteral("volume_mm3")};
    QCOMPARE(json.keys(), keys);
    QCOMPARE(json[QStringLiteral("file")].toString(), at("cube.obj"));
    QCOMPARE(json[QStringLiteral("format")].toString(), QStringLiteral("fettle-check"));
    QCOMPARE(json[QStringLiteral("version")].toInt(), 1);
    QVERIFY(json[QStringLiteral("error")].isNull());
    QCOMPARE(json[QStringLiteral("vertices")].toInt(), 8);
    QCOMPARE(json[QStringLiteral("faces")].toInt(), 12);
    QCOMPARE(json[QStringLiteral("components")].toInt(), 1);
    QCOMPARE(json[QStringLiteral("genus")].toInt(-1), 0);
    QCOMPARE(json[QStringLiteral("volume_mm3")].toDouble(), 1.0);
    QCOMPARE(json[QStringLiteral("area_mm2")].toDouble(), 6.0);
    QCOMPARE(json[QStringLiteral("size_mm")].toArray(), QJsonArray({1, 1, 1}));
    for (const char* key : {"closed", "manifold", "oriented", "bounds_solid", "lattice_ok", "print_ready"})
        QVERIFY2(json[QLatin1String(key)].toBool(), key);
}

void TestCommandLine::check_openModelIsNotReady()
{
    write(at("open.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Answer answer = fettle({QStringLiteral("check"), QStringLiteral("--json"), at("open.obj")});
    QCOMPARE(answer.status, 1);
    QVERIFY(answer.err.isEmpty());
    const QJsonObject json = answer.json();
    QVERIFY(!json[QStringLiteral("closed")].toBool(true) && !json[QStringLiteral("print_ready")].toBool(true));
    for (const char* key : {"genus", "bounds_solid", "volume_mm3"})
        QVERIFY2(json.contains(QLatin1String(key)) && json[QLatin1String(key)].isNull(), key);
    QCOMPARE(fettle({QStringLiteral("check"), at("open.obj")}).status, 1);
}

void TestCommandLine::check_severalAndFolders()
{
    write(at("a.obj"), cube);
    write(at("b.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write(at("note.txt"), "no model");
    const Answer table = fettle({QStringLiteral("check"), at("a.obj"), at("b.obj")});
    QCOMPARE(table.status, 1);
    QCOMPARE(table.out.count('\n'), 3);
    QCOMPARE(fettle({QStringLiteral("check"), m_folder->path()}).out.count('\n'), 3);

    const Answer lines = fettle({QStringLiteral("check"), QStringLiteral("--json"), m_folder->path()});
    const QList<QByteArray> objects = lines.out.trimmed().split('\n');
    QCOMPARE(objects.size(), 2);
    QVERIFY(QJsonDocument::fromJson(objects[0]).object()[QStringLiteral("print_ready")].toBool());
    QVERIFY(!QJsonDocument::fromJson(objects[1]).object()[QStringLiteral("print_ready")].toBool(true));

    const Answer csv = fettle({QStringLiteral("check"), QStringLiteral("--csv"), at("a.obj"), at("b.obj")});
    const QList<QByteArray> rows = csv.out.trimmed().split('\n');
    QCOMPARE(rows.size(), 3);
    QVERIFY(rows[0].startsWith("file,vertices,faces,closed"));
    for (const QByteArray& row : rows)
        QCOMPARE(row.count(','), rows[0].count(','));
}

/// Checks a folder of three hundred models: natural order by name, an entry for each unreadable model, and messages
/// about an empty and a locked folder.
void TestCommandLine::check_folderOfAClass()
{
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("class")) &&
            QDir(m_folder->path()).mkdir(QStringLiteral("empty")) &&
            QDir(m_folder->path()).mkdir(QStringLiteral("locked")));
    QFile::setPermissions(at("locked"), {});
    QStringList names;
    for (int i = 1; i <= 300; ++i)
        names << QStringLiteral("%1upil %2.obj").arg(QLatin1Char(i % 2 == 0 ? 'P' : 'p')).arg(i);
    for (const QString& name : names)
        write(at("class/") + name, name == names[41] ? QByteArray() : cube);
    const Answer csv = fettle({QStringLiteral("check"), QStringLiteral("empty"), QStringLiteral("class"),
                               QStringLiteral("locked"), QStringLiteral("--csv")},
                              {}, m_folder->path());
    QFile::setPermissions(at("locked"), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    QCOMPARE(csv.status, 2);
    QCOMPARE(csv.err.count('\n'), 3);
    QVERIFY(csv.err.contains("empty: this folder contains no models") &&
            csv.err.contains("locked: this folder cannot be read") && csv.err.contains("Pupil 42.obj is empty"));
    const QList<QByteArray> rows = csv.out.trimmed().split('\n');
    QCOMPARE(rows.size(), 301);
    for (qsizetype i = 0; i < names.size(); ++i)
        QVERIFY2(rows[i + 1].startsWith("class/" + names[i].toUtf8() + ','), rows[i + 1].constData());
    QCOMPARE(rows[42], "class/Pupil 42.obj" + QByteArray(rows[0].count(','), ','));
    QVERIFY(fettle({QStringLiteral("check"), QStringLiteral("--csv"), QStringLiteral("empty")}, {}, m_folder->path())
                .isRefusal(QStringLiteral("empty")));
}

/// Each name must be restored, as in RFC 4180, even if it contains separators or is not valid UTF-8.
void TestCommandLine::check_csvOfOddNames()
{
    const std::vector<std::string> names = {"a,b.obj", "c \"quoted\".obj", "d\nline.obj", "e\xe9.obj", "=1+1.obj"};
    for (const std::string& name : names)
        core::writeMesh(m_folder->path().toStdString() + '/' + name, core::icosphere(1, 10));
    const Answer csv =
        fettle({QStringLiteral("check"), QStringLiteral("--csv"), QStringLiteral(".")}, {}, m_folder->path());
    std::filesystem::remove(m_folder->path().toStdString() + '/' + names[3]); // Qt would not find this name
    QVERIFY2(csv.status == 0 && csv.err.isEmpty(), csv.err.constData());
    QStringList fields{QString()};
    bool isQuoted = false;
    for (const QChar c : QString::fromUtf8(csv.out)) {
        if (c == u'"')
            isQuoted = !isQuoted;
        if (!isQuoted && (c == u',' || c == u'\n'))
            fields << QString();
        else
            fields.last() += c;
    }
    const qsizetype columns = csv.out.split('\n')[0].count(',') + 1;
    QCOMPARE(fields.size(), (static_cast<qsizetype>(names.size()) + 1) * columns + 1);
    QStringList read;
    for (qsizetype at = columns; at + 1 < fields.size(); at += columns) {
        QString name = fields[at];
        if (name.startsWith(u'"'))
            name = name.sliced(1).chopped(1).replace(QStringLiteral("\"\""), QStringLiteral("\""));
        read << name;
    }
    read.sort();
    QStringList expected;
    for (const std::string& name : names)
        expected << QStringLiteral("./") + QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
    expected.sort();
    QCOMPARE(read, expected);
}

/// Columns must align with their headings on a terminal, where Chinese characters are two cells wide.
void TestCommandLine::check_tableOfLongNames()
{
    const QString end = QStringLiteral("the end.obj");
    const QStringList names{QStringLiteral("a.obj"), QString(150, u'b') + end, QStringLiteral("\u4e2d\u6587\u540d.obj"),
                            QStringLiteral("d\ne.obj"), QString(60, QChar(0x4e2d)) + end};
    for (const QString& name : names)
        write(m_folder->filePath(name), cube);
    const Answer table = fettle({QStringLiteral("check"), QStringLiteral(".")}, {}, m_folder->path());
    QCOMPARE(table.status, 0);
    const QStringList lines = QString::fromUtf8(table.out).trimmed().split(u'\n');
    QCOMPARE(lines.size(), names.size() + 1);
    const qsizetype head = lines[0].indexOf(QStringLiteral("size, mm"));
    for (const QString& line : lines.sliced(1)) {
        const qsizetype wide = line.count(QChar(0x4e2d)) + line.count(QChar(0x6587)) + line.count(QChar(0x540d));
        QCOMPARE(line.indexOf(QStringLiteral("1 x 1 x 1")) + wide, head);
        QVERIFY(line.endsWith(QStringLiteral("yes")));
    }
    QCOMPARE(table.out.count("the end.obj"), 2);
}

/// Strokes and time are given if the file contains them; otherwise null or an empty field.
void TestCommandLine::check_workOfGlbFiles()
{
    core::WriteOptions noted;
    noted.metadata.work = core::WorkDone{12, 34.6};
    core::writeMesh(at("a.glb").toStdString(), core::icosphere(1, 10), noted);
    core::writeMesh(at("b.glb").toStdString(), core::icosphere(1, 10));
    const QJsonObject known = fettle({QStringLiteral("check"), QStringLiteral("--json"), at("a.glb")}).json();
    QCOMPARE(known[QStringLiteral("strokes")], QJsonValue(12));
    QCOMPARE(known[QStringLiteral("time_spent_s")], QJsonValue(35));
    const QJsonObject unknown = fettle({QStringLiteral("check"), QStringLiteral("--json"), at("b.glb")}).json();
    QVERIFY(unknown.contains(QStringLiteral("strokes")) && unknown[QStringLiteral("strokes")].isNull() &&
            unknown[QStringLiteral("time_spent_s")].isNull());
    const QList<QByteArray> rows =
        fettle({QStringLiteral("check"), QStringLiteral("--csv"), m_folder->path()}).out.trimmed().split('\n');
    QVERIFY(rows[0].endsWith(",strokes,time_spent_s") && rows[1].endsWith(",12,35") && rows[2].endsWith(",,"));
}

/// Tests a plate of 20 x 20 x 0.5 mm. The print check is reported only with the option.
void TestCommandLine::check_print()
{
    write(at("plate.obj"), "v 0 0 0\nv 20 0 0\nv 20 0.5 0\nv 0 0.5 0\nv 0 0 20\nv 20 0 20\nv 20 0.5 20\nv 0 0.5 20\n"
                           "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    const QStringList asked{QStringLiteral("check"), at("plate.obj"), QStringLiteral("--print")};
    const Answer answer =
        fettle(asked + QStringList{QStringLiteral("--json"), QStringLiteral("--bed"), QStringLiteral("25,15,10")});
    QCOMPARE(answer.status, 0); // a thin model is still valid
    const QJsonObject json = answer.json();
    QCOMPARE(json.size(), 23 + 7);
    QCOMPARE(json[QStringLiteral("wall_limit_mm")].toDouble(), 0.8);
    QVERIFY(std::abs(json[QStringLiteral("min_wall_mm")].toDouble() - 0.5) < 1e-6);
    QVERIFY(std::abs(json[QStringLiteral("thin_share")].toDouble() - 800.0 / 840) < 1e-6);
    QCOMPARE(json[QStringLiteral("overhang_share")].toDouble(-1), 0.0);
    QCOMPARE(json[QStringLiteral("base_area_mm2")].toDouble(), 400.0);
    QVERIFY(!json[QStringLiteral("fits_bed")].toBool(true));
    QVERIFY(json[QStringLiteral("unit_doubt")].isNull());

    const auto lastLine = [&](const QStringList& options) {
        const Answer page = fettle(asked + options);
        return page.status == 0 ? page.out.trimmed().split('\n').constLast() : QByteArray();
    };
    QVERIFY(lastLine({}).endsWith("plate.obj is watertight, but: 95.2 % of its surface is thinner than 0.8 mm."));
    QVERIFY(lastLine({QStringLiteral("--nozzle"), QStringLiteral("0.2"), QStringLiteral("--bed"),
                      QStringLiteral("25,15,10")})
                .endsWith("plate.obj is watertight, but: it does not fit the bed."));
    QVERIFY(lastLine({QStringLiteral("--nozzle"), QStringLiteral("0.2"), QStringLiteral("--bed"),
                      QStringLiteral("25,25,10")})
                .endsWith("plate.obj is watertight."));

    const QJsonObject fine =
        fettle(asked + QStringList{QStringLiteral("--json"), QStringLiteral("--nozzle"), QStringLiteral("0.2")}).json();
    QCOMPARE(fine[QStringLiteral("thin_share")].toDouble(-1), 0.0);
    QVERIFY(fine[QStringLiteral("fits_bed")].isNull());

    // The wedge is 0.2 to 10 mm thick, and each side has two triangles. It is thin only near its end.
    write(at("wedge.obj"), "v 0 0 0\nv 100 0 0\nv 100 10 0\nv 0 0.2 0\nv 0 0 40\nv 100 0 40\nv 100 10 40\nv 0 0.2 40\n"
                           "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    const QJsonObject wedge =
        fettle({QStringLiteral("check"), at("wedge.obj"), QStringLiteral("--print"), QStringLiteral("--json")}).json();
    QVERIFY(std::abs(wedge[QStringLiteral("min_wall_mm")].toDouble() / 0.2 - 1) < 0.05);
    QVERIFY(std::abs(wedge[QStringLiteral("thin_share")].toDouble() - 0.051) < 0.006);

    write(at("cube.obj"), cube);
    const Answer csv = fettle(asked + QStringList{at("cube.obj"), QStringLiteral("--csv")});
    QCOMPARE(csv.out.count('\n'), 3);
    QVERIFY(csv.out.split('\n')[0].endsWith(
        "print_ready,strokes,time_spent_s,wall_limit_mm,min_wall_mm,thin_share,overhang_share,"
        "base_area_mm2,fits_bed,unit_doubt"));
    QVERIFY(csv.out.contains(",inches\n"));
    QCOMPARE(fettle(asked + QStringList{at("cube.obj")}).out.count('\n'), 3);
    QVERIFY(fettle({QStringLiteral("check"), at("cube.obj")}).out.contains("inches"));

    write(at("open.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Answer open =
        fettle({QStringLiteral("check"), at("open.obj"), QStringLiteral("--print"), QStringLiteral("--json")});
    QCOMPARE(open.status, 1);
    for (const char* key : {"min_wall_mm", "thin_share", "unit_doubt"})
        QVERIFY2(open.json()[QLatin1String(key)].isNull(), key);
}

/// Tests an inverted cone whose side leans outwards by 30 degrees.
void TestCommandLine::check_overhangAngle()
{
    QByteArray cone = "v 0 0 0\n";
    constexpr int corners = 64;
    for (int i = 0; i < corners; ++i) {
        const double turn = 2 * 3.14159265358979 * i / corners;
        cone += "v " + QByteArray::number(10 * std::tan(3.14159265358979 / 6) * std::cos(turn), 'f', 7) + " 10 " +
                QByteArray::number(10 * std::tan(3.14159265358979 / 6) * std::sin(turn), 'f', 7) + '\n';
    }
    QByteArray lid = "f";
    for (int i = 0; i < corners; ++i) {
        cone += "f 1 " + QByteArray::number(2 + i) + ' ' + QByteArray::number(2 + (i + 1) % corners) + '\n';
        lid += ' ' + QByteArray::number(1 + corners - i);
    }
    write(at("cone.obj"), cone + lid + '\n');
    const auto share = [&](const QStringList& options) {
        const Answer answer = fettle(
            QStringList{QStringLiteral("check"), at("cone.obj"), QStringLiteral("--print"), QStringLiteral("--json")} +
            options);
        return answer.json()[QStringLiteral("overhang_share")].toDouble(-1);
    };
    QCOMPARE(share({}), 0.0);
    QCOMPARE(share({QStringLiteral("--overhang"), QStringLiteral("31")}), 0.0);
    QVERIFY(share({QStringLiteral("--overhang"), QStringLiteral("29")}) > 0.6);
}

void TestCommandLine::check_unit()
{
    write(at("cube.obj"), cube);
    const QJsonObject inches = fettle({QStringLiteral("check"), QStringLiteral("--json"), QStringLiteral("--unit"),
                                       QStringLiteral("in"), at("cube.obj")})
                                   .json();
    QVERIFY(std::abs(inches[QStringLiteral("volume_mm3")].toDouble() - 25.4 * 25.4 * 25.4) < 0.01);
    const Answer page =
        fettle({QStringLiteral("check"), QStringLiteral("--unit"), QStringLiteral("in"), at("cube.obj")});
    QVERIFY(page.status == 0 && !page.out.contains("inches")); // an explicit unit is not questioned
    VERIFY_REFUSED(fettle({QStringLiteral("check"), QStringLiteral("--unit"), QStringLiteral("ft"), at("cube.obj")}),
                   "not \"ft\"");
}

void TestCommandLine::check_printRefusals_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QString>("reason");
    const QString print = QStringLiteral("--print"), nozzle = QStringLiteral("--nozzle"), bed = QStringLiteral("--bed");
    QTest::newRow("nozzle alone") << QStringList{nozzle, QStringLiteral("0.4")} << QStringLiteral("--print");
    const QString overhang = QStringLiteral("--overhang");
    QTest::newRow("overhang alone") << QStringList{overhang, QStringLiteral("30")} << QStringLiteral("--print");
    for (const QString& wrong :
         {QStringLiteral("-1"), QStringLiteral("90.5"), QStringLiteral("nan"), QStringLiteral("steep")})
        QTest::addRow("overhang %s", qPrintable(wrong))
            << QStringList{print, overhang, wrong}
            << QStringLiteral("--overhang must be a number from 0 to 90, not \"%1\".").arg(wrong);
    QTest::newRow("bed alone") << QStringList{bed, QStringLiteral("1,2,3")} << QStringLiteral("--print");
    for (const QString& wrong : {QStringLiteral("0"), QStringLiteral("-1"), QStringLiteral("six"),
                                 QStringLiteral("nan"), QStringLiteral("0,4")})
        QTest::addRow("nozzle %s", qPrintable(wrong))
            << QStringList{print, nozzle, wrong}
            << QStringLiteral("--nozzle must be a number from 0.001 to 5, not \"%1\".").arg(wrong);
    for (const QString& wrong : {QStringLiteral("200"), QStringLiteral("200,200"), QStringLiteral("200,200,0"),
                                 QStringLiteral("1,2,3,4"), QStringLiteral("a,b,c")})
        QTest::addRow("bed %s", qPrintable(wrong)) << QStringList{print, bed, wrong} << QStringLiteral("--bed");
}

void TestCommandLine::check_printRefusals()
{
    QFETCH(const QStringList, options);
    QFETCH(const QString, reason);
    write(at("cube.obj"), cube);
    const Answer answer = fettle(QStringList{QStringLiteral("check"), at("cube.obj")} + options);
    QVERIFY2(answer.isRefusal(reason), answer.err.constData());
}

void TestCommandLine::check_badFiles_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("missing") << QStringLiteral("missing.stl") << QByteArray();
    QTest::newRow("empty") << QStringLiteral("empty.stl") << QByteArray("");
    QTest::newRow("not what it says") << QStringLiteral("picture.ply") << QByteArray("\x89PNG\r\n\x1a\n and so on");
    QTest::newRow("cut off") << QStringLiteral("cut.stl") << QByteArray(84 + 30, '\1');
    QTest::newRow("NaN") << QStringLiteral("nan.obj") << QByteArray("v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    QTest::newRow("index") << QStringLiteral("index.obj") << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    QTest::newRow("no ending") << QStringLiteral("model") << cube;
    QTest::newRow("unknown ending") << QStringLiteral("model.step") << cube;
    QTest::newRow("line break in its name") << QStringLiteral("a\nb.stl") << QByteArray("");
}

void TestCommandLine::check_badFiles()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    const QString path = m_folder->filePath(name);
    if (!content.isNull())
        write(path, content);
    for (const char* option : {"", "--json", "--csv"}) {
        QStringList arguments{QStringLiteral("check"), path};
        if (*option)
            arguments << QString::fromLatin1(option);
        const Answer answer = fettle(arguments);
        QVERIFY2(answer.isRefusal(QString(name).replace(QLatin1Char('\n'), QLatin1Char(' '))), answer.err.constData());
    }
    const QStringList before = left();
    QVERIFY(fettle({QStringLiteral("convert"), path, at("out.stl")}).isRefusal());
    write(at("s.json"), strokes(R"("tool":"pull","radius":0.25)"));
    QVERIFY(fettle({QStringLiteral("replay"), QStringLiteral("--strokes"), at("s.json"), QStringLiteral("--in"), path,
                    QStringLiteral("--out"), at("out.stl")})
                .isRefusal());
    QFile::remove(at("s.json"));
    QCOMPARE(left(), before);
}

void TestCommandLine::check_goesOnAfterABadFile()
{
    write(at("a.obj"), cube);
    const Answer answer = fettle({QStringLiteral("check"), QStringLiteral("--json"), at("missing.stl"), at("a.obj")});
    QCOMPARE(answer.status, 2);
    QCOMPARE(answer.err.count('\n'), 1);
    const QList<QByteArray> rows = answer.out.trimmed().split('\n');
    QCOMPARE(rows.size(), 2);
    const QJsonObject bad = QJsonDocument::fromJson(rows[0]).object(), good = QJsonDocument::fromJson(rows[1]).object();
    QCOMPARE(bad.keys(), good.keys());
    QCOMPARE(QByteArray("fettle: " + bad[QStringLiteral("error")].toString().toUtf8() + '\n'), answer.err);
    QVERIFY(bad[QStringLiteral("faces")].isNull() && good[QStringLiteral("error")].isNull());
}

void TestCommandLine::convert_keepsCoordinates()
{
    const core::TriangleMesh model = core::icosphere(2, 1.0 / 3);
    core::writeMesh(at("a.ply").toStdString(), model);
    for (const char* name : {"b.obj", "b.stl", "b.PLY"}) {
        const Answer answer = fettle({QStringLiteral("convert"), at("a.ply"), at(name)});
        QCOMPARE(answer.status, 0);
        QVERIFY(answer.out.isEmpty() && answer.err.isEmpty());
        QCOMPARE(fettle({QStringLiteral("convert"), at(name), at("back.ply")}).status, 0);
        const core::TriangleMesh back = core::readMesh(at("back.ply").toStdString());
        QCOMPARE(back.triangles.size(), model.triangles.size());
        for (std::size_t f = 0; f < back.triangles.size(); ++f)
            for (std::size_t c = 0; c < 3; ++c)
                QVERIFY(back.points[back.triangles[f][c]] == model.points[model.triangles[f][c]]);
    }
}

/// Two balls that overlap, near the origin, far away, and so far that their union does not fit into floats there.
void TestCommandLine::convert_recentre()
{
    const QString option = QStringLiteral("--recentre"), repair = QStringLiteral("--repair");
    for (const float x : {0.3F, 1000.F, 3e5F}) {
        const core::TriangleMesh ball = shapes::moved(core::icosphere(3, 1), {x, 2 * x, 0});
        core::writeMesh(at("two.obj").toStdString(), shapes::together(ball, shapes::moved(ball, {0, 0, 0.7F})));
        const bool isFar = x > 1e5F;
        const Answer there = fettle({QStringLiteral("convert"), repair, at("two.obj"), at("there.stl")});
        QCOMPARE(there.status, isFar ? 2 : 1);
        QCOMPARE(there.err.contains("--recentre"), isFar);
        QCOMPARE(there.err.contains("lost surface inside"), !isFar);
        QCOMPARE(fettle({QStringLiteral("convert"), repair, option, at("two.obj"), at("here.stl")}).status, 1);
        const core::TriangleMesh here = core::readMesh(at("here.stl").toStdString());
        const core::Box box = core::boxOf(here);
        QVERIFY(box.center().norm() < 1e-3 && core::checkMesh(here).printReady());
        QCOMPARE(fettle({QStringLiteral("convert"), option, at("here.stl"), at("again.stl")}).status, 0);
        QVERIFY(core::readMesh(at("again.stl").toStdString()).points == here.points);
        if (!isFar) { // a sound model is moved only
            QCOMPARE(fettle({QStringLiteral("convert"), option, at("there.stl"), at("moved.stl")}).status, 0);
            QCOMPARE(core::readMesh(at("moved.stl").toStdString()).triangles.size(), here.triangles.size());
        }
    }
}

void TestCommandLine::convert_unitAndSize()
{
    write(at("a.obj"), cube);
    const auto sizeAfter = [&](const QStringList& options) {
        if (fettle(QStringList{QStringLiteral("convert"), at("a.obj"), at("b.obj")} + options).status != 0)
            return -1.0;
        return fettle({QStringLiteral("check"), QStringLiteral("--json"), at("b.obj")})
            .json()[QStringLiteral("size_mm")]
            .toArray()[0]
            .toDouble();
    };
    QCOMPARE(sizeAfter({}), 1.0);
    QCOMPARE(sizeAfter({QStringLiteral("--unit"), QStringLiteral("cm")}), 10.0);
    QCOMPARE(sizeAfter({QStringLiteral("--unit=m")}), 1000.0);
    QCOMPARE(float(sizeAfter({QStringLiteral("--unit"), QStringLiteral("in")})), 25.4f);
    QCOMPARE(sizeAfter({QStringLiteral("--size"), QStringLiteral("80")}), 80.0);
    QCOMPARE(sizeAfter({QStringLiteral("--size"), QStringLiteral("1e-300")}), -1.0); // the scaled model would vanish

    write(at("more.obj"), QByteArray(cube) + "v 90 0 0\n"); // adds a point that no face uses
    QCOMPARE(fettle({QStringLiteral("convert"), at("more.obj"), at("more.stl"), QStringLiteral("--size"),
                     QStringLiteral("80")})
                 .status,
             0);
    QCOMPARE(core::boxOf(core::readMesh(at("more.stl").toStdString())).sizes().maxCoeff(), 80.0);
}

void TestCommandLine::convert_triangles()
{
    core::TriangleMesh ball = core::icosphere(4, 30);
    for (const core::Vec3f& p : ball.points)
        ball.colors.push_back(p.x() > 0 ? core::Rgb{200, 10, 10} : core::Rgb{10, 10, 200});
    core::writeMesh(at("ball.ply").toStdString(), ball);
    QCOMPARE(fettle({QStringLiteral("convert"), at("ball.ply"), at("few.glb"), QStringLiteral("--triangles"),
                     QStringLiteral("400")})
                 .status,
             0);
    const core::TriangleMesh few = core::readMesh(at("few.glb").toStdString());
    QVERIFY(few.triangles.size() <= 400 && few.triangles.size() > 390 && !few.colors.empty());
    QCOMPARE(fettle({QStringLiteral("check"), at("few.glb")}).status, 0);
    QCOMPARE(fettle({QStringLiteral("convert"), at("ball.ply"), at("all.ply"), QStringLiteral("--triangles"),
                     QStringLiteral("5120")})
                 .status,
             0);
    QVERIFY(core::readMesh(at("all.ply").toStdString()).points == ball.points);

    core::writeMesh(at("ring.stl").toStdString(), shapes::torus({30, 8, 48, 24}));
    const Answer tooFew = fettle({QStringLiteral("convert"), at("ring.stl"), at("tiny.stl"),
                                  QStringLiteral("--triangles"), QStringLiteral("8")});
    QCOMPARE(tooFew.status, 1);
    QVERIFY2(tooFew.out.isEmpty() && tooFew.err.count('\n') == 1 &&
                 tooFew.err.contains("not to 8: its holes and parts need at least"),
             tooFew.err.constData());
    QVERIFY(!QFile::exists(at("tiny.stl")));
    const QString reached = QString::fromUtf8(tooFew.err).section(QStringLiteral("reduced to "), 1).section(u' ', 0, 0);
    QCOMPARE(fettle({QStringLiteral("convert"), at("ring.stl"), at("tiny.stl"), QStringLiteral("--triangles"), reached})
                 .status,
             0);
    QCOMPARE(core::readMesh(at("tiny.stl").toStdString()).triangles.size(), std::size_t(reached.toUInt()));
}

void TestCommandLine::convert_up()
{
    write(at("a.obj"), QByteArray(cube)
                           .replace("v 1 1 1", "v 1 1 3")
                           .replace("v 0 1 1", "v 0 1 3")
                           .replace("v 1 0 1", "v 1 0 3")
                           .replace("v 0 0 1", "v 0 0 3"));
    const auto sizes = [&](const char* name) {
        return fettle({QStringLiteral("check"), QStringLiteral("--json"), at(name)})
            .json()[QStringLiteral("size_mm")]
            .toArray();
    };
    QCOMPARE(sizes("a.obj"), QJsonArray({1, 1, 3}));
    QCOMPARE(fettle({QStringLiteral("convert"), at("a.obj"), at("b.obj"), QStringLiteral("--up"), QStringLiteral("z")})
                 .status,
             0);
    QCOMPARE(sizes("b.obj"), QJsonArray({1, 3, 1}));
    QCOMPARE(fettle({QStringLiteral("convert"), at("a.obj"), at("c.obj"), QStringLiteral("--up"), QStringLiteral("y")})
                 .status,
             0);
    QCOMPARE(sizes("c.obj"), QJsonArray({1, 1, 3}));
}

void TestCommandLine::convert_brokenModelWritesNothing()
{
    write(at("open.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write(at("out.stl"), "what was there");
    const Answer answer = fettle({QStringLiteral("convert"), at("open.obj"), at("out.stl")});
    QCOMPARE(answer.status, 1);
    QVERIFY(answer.err.contains("open.obj") && answer.err.count('\n') == 1);
    QCOMPARE(read(at("out.stl")), QByteArray("what was there"));
    QCOMPARE(left().size(), 2);
}

void TestCommandLine::convert_legalise()
{
    core::TriangleMesh open = core::icosphere(3, 10);
    open.triangles.resize(open.triangles.size() - 3);
    core::writeMesh(at("open.ply").toStdString(), open);
    const QStringList convert{QStringLiteral("convert"), at("open.ply"), at("out.stl"), QStringLiteral("--legalise")};
    const Answer answer = fettle(convert, {{QStringLiteral("LC_ALL"), QStringLiteral("C")}});
    QCOMPARE(answer.status, 0);
    QVERIFY(answer.err.isEmpty());
    QVERIFY(answer.out.contains("Holes filled: 1\n"));
    QVERIFY(answer.out.contains("The new surface is at most"));
    QVERIFY(core::checkMesh(core::readMesh(at("out.stl").toStdString())).printReady());

    QCOMPARE(fettle({QStringLiteral("convert"), at("out.stl"), at("same.stl"), QStringLiteral("--legalise")}).out,
             QByteArray());
    QCOMPARE(read(at("same.stl")), read(at("out.stl"))); // a valid model is not changed

    write(at("sheet.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Answer no =
        fettle({QStringLiteral("convert"), at("sheet.obj"), at("none.stl"), QStringLiteral("--legalise")});
    QCOMPARE(no.status, 1);
    QVERIFY(no.out.isEmpty() && no.err.contains("sheet.obj") && no.err.count('\n') == 1);
    QVERIFY(!QFile::exists(at("none.stl")));
}

/// The status is 0 only if the result is faithful to the model. Wrapping the surface needs --wrap.
void TestCommandLine::convert_wrap()
{
    core::writeMesh(at("apart.ply").toStdString(), shapes::takenApart(core::icosphere(3, 10)));
    QStringList convert{QStringLiteral("convert"), at("apart.ply"), at("out.stl"), QStringLiteral("--legalise")};
    const Answer no = fettle(convert);
    QCOMPARE(no.status, 1);
    QVERIFY(no.out.isEmpty() && no.err.contains("apart.ply") && no.err.contains("--wrap") && no.err.count('\n') == 1);
    QVERIFY(!QFile::exists(at("out.stl")));

    convert << QStringLiteral("--wrap");
    const Answer anew = fettle(convert);
    QCOMPARE(anew.status, 1);
    QVERIFY(anew.out.contains("Volume: ") && anew.err.contains("rebuilt") && anew.err.count('\n') == 1);
    QVERIFY(core::checkMesh(core::readMesh(at("out.stl").toStdString())).printReady());
}

/// The reported numbers must be those of the written file, which has fewer triangles than the repair produced.
void TestCommandLine::convert_tellsOfTheReducedModel()
{
    core::writeMesh(at("apart.ply").toStdString(), shapes::takenApart(core::icosphere(3, 10)));
    const Answer answer =
        fettle({QStringLiteral("convert"), at("apart.ply"), at("out.stl"), QStringLiteral("--legalise"),
                QStringLiteral("--wrap"), QStringLiteral("--triangles"), QStringLiteral("40")},
               {{QStringLiteral("LC_ALL"), QStringLiteral("C")}});
    QCOMPARE(answer.status, 1);
    const core::MeshReport written = core::checkMesh(core::readMesh(at("out.stl").toStdString()));
    QVERIFY(written.printReady() && written.faces <= 40);
    const QByteArray area = "Surface: " + ui::areaText(written.area).toUtf8();
    QVERIFY2(answer.out.contains(area), answer.out.constData());
    QVERIFY(answer.err.contains("rebuilt") && answer.err.count('\n') == 1);
}

void TestCommandLine::convert_leavesSheetsOut()
{
    write(at("floor.obj"), cube + "v -50 -1 -50\nv 50 -1 -50\nv 50 -1 50\nf -3 -2 -1\n");
    const Answer answer =
        fettle({QStringLiteral("convert"), at("floor.obj"), at("out.stl"), QStringLiteral("--legalise")},
               {{QStringLiteral("LC_ALL"), QStringLiteral("C")}});
    QCOMPARE(answer.status, 0);
    QVERIFY2(answer.out.contains("1 open sheet left out, which encloses no space; it is 100 x 100 mm\n"),
             answer.out.constData());
    QCOMPARE(core::readMesh(at("out.stl").toStdString()).triangles.size(), std::size_t(12));
}

void TestCommandLine::convert_refusals_data()
{
    QTest::addColumn<QString>("out");
    QTest::newRow("unknown format") << QStringLiteral("b.step");
    QTest::newRow("no ending") << QStringLiteral("b");
    QTest::newRow("no folder") << QStringLiteral("none/b.stl");
    QTest::newRow("a folder") << QStringLiteral("folder.stl");
}

void TestCommandLine::convert_refusals()
{
    QFETCH(QString, out);
    write(at("a.obj"), cube);
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("folder.stl")));
    const Answer answer = fettle({QStringLiteral("convert"), at("a.obj"), m_folder->filePath(out)});
    QVERIFY2(answer.isRefusal(out), answer.err.constData());
    QCOMPARE(left(), QStringList{QStringLiteral("a.obj")});
}

void TestCommandLine::convert_ontoItself()
{
    core::writeMesh(at("a.stl").toStdString(), core::icosphere(1, 1));
    const QByteArray before = read(at("a.stl"));
    QCOMPARE(fettle({QStringLiteral("convert"), at("a.stl"), at("a.stl")}).status, 0);
    QCOMPARE(core::readMesh(at("a.stl").toStdString()).triangles.size(), std::size_t(80));
    QCOMPARE(read(at("a.stl")).size(), before.size());
}

void TestCommandLine::convert_ontoAFullDisk_data()
{
    QTest::addColumn<QString>("name");
    for (const char* name : {"model.stl", "model.obj", "model.ply", "model.off"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void TestCommandLine::convert_ontoAFullDisk()
{
    if (!m_smallDisk->isThere())
        QSKIP("A small disk cannot be mounted here.");
    QFETCH(QString, name);
    const QString folder = QString::fromStdString(m_smallDisk->folder().string()),
                  out = folder + QLatin1Char('/') + name;
    core::writeMesh(at("large.stl").toStdString(), core::icosphere(5, 10));
    write(at("a.obj"), cube);
    QCOMPARE(fettle({QStringLiteral("convert"), at("a.obj"), out}).status, 0); // a small model fits on the disk
    const QByteArray before = read(out);
    const QStringList files = filesIn(folder);
    const Answer answer = fettle({QStringLiteral("convert"), at("large.stl"), out});
    VERIFY_REFUSED(answer, "the disk is full.");
    VERIFY_REFUSED(answer, "model.");
    QVERIFY(!before.isEmpty() && read(out) == before);
    QCOMPARE(filesIn(folder), files);
    QVERIFY(QFile::remove(out));
    VERIFY_REFUSED(fettle({QStringLiteral("convert"), at("large.stl"), out}), "the disk is full.");
    QVERIFY(filesIn(folder).isEmpty());
}

void TestCommandLine::pages_ontoAFullDisk_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<QString>("name");
    QTest::newRow("page") << QStringLiteral("report") << QStringLiteral("a.html");
    QTest::newRow("pages for a printer") << QStringLiteral("report") << QStringLiteral("a.pdf");
    QTest::newRow("sheets") << QStringLiteral("sheet") << QStringLiteral("a.pdf");
}

void TestCommandLine::pages_ontoAFullDisk()
{
    if (!m_smallDisk->isThere())
        QSKIP("A small disk cannot be mounted here.");
    QFETCH(QString, command);
    QFETCH(QString, name);
    write(at("a.obj"), cube);
    m_smallDisk->fill();
    const QString folder = QString::fromStdString(m_smallDisk->folder().string());
    const QStringList files = filesIn(folder);
    VERIFY_REFUSED(fettle({command, m_folder->path(), QStringLiteral("-o"), folder + QLatin1Char('/') + name}),
                   "the disk is full.");
    QCOMPARE(filesIn(folder), files);
    QFile::remove(folder + QStringLiteral("/filler"));
}

void TestCommandLine::convert_whereNothingMayBeWritten()
{
    write(at("a.obj"), cube);
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("closed")));
    write(at("closed/old.obj"), "old");
    QFile::setPermissions(at("closed"), QFile::ReadOwner | QFile::ExeOwner);
    for (const char* name : {"closed/old.obj", "closed/new.stl"}) {
        const Answer answer = fettle({QStringLiteral("convert"), at("a.obj"), at(name)});
        VERIFY_REFUSED(answer, "cannot be written: it is not allowed (Permission denied).");
        QVERIFY(QString::fromUtf8(answer.err).contains(at(name)));
    }
    QFile::setPermissions(at("closed"), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    QCOMPARE(filesIn(at("closed")), QStringList{QStringLiteral("old.obj")});
    QCOMPARE(read(at("closed/old.obj")), "old");
    QFile::setPermissions(at("closed/old.obj"), QFile::ReadOwner); // a read-only file must not be replaced either
    VERIFY_REFUSED(fettle({QStringLiteral("convert"), at("a.obj"), at("closed/old.obj")}),
                   "cannot be written: it is not allowed");
    QCOMPARE(read(at("closed/old.obj")), "old");
}

void TestCommandLine::replay_statsHaveTheFields()
{
    write(at("s.json"), strokes(R"("tool":"pull","radius":0.25)",
                                R"({"position":[1,0,0]},{"position":[0,1,0]},{"position":[0,7,0]})"));
    const Answer answer = fettle(
        {QStringLiteral("replay"), QStringLiteral("--strokes"), at("s.json"), QStringLiteral("--stats"), at("t.json")});
    QCOMPARE(answer.status, 0);
    QVERIFY2(answer.err.isEmpty() && answer.out.startsWith("Strokes: 1, commands: 0, dabs: 3. Size: 2.0") &&
                 answer.out.count('\n') == 1,
             answer.out.constData());
    const QJsonObject stats = QJsonDocument::fromJson(read(at("t.json"))).object();
    for (const char* key :
         {"vertices", "faces", "euler", "components", "genus", "splits", "collapses", "flips", "fusions", "separations",
          "rolled_back", "verify_tiers", "peak_rss_mb", "mesh_hash", "dabs"})
        QVERIFY2(stats.contains(QLatin1String(key)), key);
    QCOMPARE(stats[QStringLiteral("euler")].toInt(), 2);
    QCOMPARE(stats[QStringLiteral("components")].toInt(), 1);
    QCOMPARE(stats[QStringLiteral("genus")].toInt(-1), 0);
    QCOMPARE(stats[QStringLiteral("verify_tiers")].toArray().size(), 3);
    QVERIFY(stats[QStringLiteral("peak_rss_mb")].toDouble() > 1);
    QCOMPARE(stats[QStringLiteral("mesh_hash")].toString().size(), 16);
    const QJsonArray dabs = stats[QStringLiteral("dabs")].toArray();
    QCOMPARE(dabs.size(), 3);
    for (const QJsonValue& dab : dabs)
        for (const char* key : {"select_ms", "optimise_ms", "deform_ms", "fuse_ms", "verify_ms", "total_ms",
                                "touched_vertices", "touched_faces", "substeps", "asked", "reached", "contact", "wall",
                                "capped", "longest_edge", "conforming_share", "smallest_angle_deg", "outcome"})
            QVERIFY2(dab.toObject().contains(QLatin1String(key)), key);
    QVERIFY(dabs[0].toObject()[QStringLiteral("longest_edge")].toDouble(2) <= 1);
    QVERIFY(dabs[0].toObject()[QStringLiteral("conforming_share")].toDouble() > 0.9);
    QVERIFY(dabs[0].toObject()[QStringLiteral("smallest_angle_deg")].toDouble() > 20);
    QVERIFY(dabs[0].toObject()[QStringLiteral("smallest_angle_deg")].toDouble(90) <= 60);
    QVERIFY(dabs[2].toObject()[QStringLiteral("longest_edge")].isNull());
    QCOMPARE(dabs[0].toObject()[QStringLiteral("outcome")].toString(), QStringLiteral("committed"));
    QVERIFY(dabs[0].toObject()[QStringLiteral("touched_vertices")].toInt() > 10);
    QVERIFY(dabs[0].toObject()[QStringLiteral("reached")].toDouble() > 0.02);
    QCOMPARE(dabs[2].toObject()[QStringLiteral("outcome")].toString(), QStringLiteral("empty"));
}

void TestCommandLine::replay_isDeterministic()
{
    write(at("s.json"),
          strokes(R"("tool":"pull","radius":0.3,"spacing":0.1)", R"({"position":[1,0,0]},{"position":[0,1,0]})"));
    QByteArray hash;
    for (int i = 0; i < 3; ++i) {
        QCOMPARE(fettle({QStringLiteral("replay"), QStringLiteral("--strokes"), at("s.json"), QStringLiteral("--stats"),
                         at("t.json"), QStringLiteral("--out"), at("o.ply")})
                     .status,
                 0);
        const QByteArray now =
            QJsonDocument::fromJson(read(at("t.json"))).object()[QStringLiteral("mesh_hash")].toString().toLatin1() +
            read(at("o.ply"));
        QVERIFY(i == 0 || now == hash);
        hash = now;
    }
}

void TestCommandLine::replay_outIsInOrder()
{
    for (const char* tool : {"pull", "push", "smooth"}) {
        write(at("s.json"), strokes("\"tool\":\"" + QByteArray(tool) + "\",\"radius\":0.3,\"spacing\":0.2",
                                    R"({"position":[1,0,0]},{"position":[0,1,0]},{"position":[0,0,1]})"));
        QCOMPARE(fettle({QStringLiteral("replay"), QStringLiteral("--strokes"), at("s.json"), QStringLiteral("--out"),
                         at("o.stl")})
                     .status,
                 0);
        QCOMPARE(fettle({QStringLiteral("check"), at("o.stl")}).status, 0);
    }
}

void TestCommandLine::replay_fullVerifies()
{
    write(at("s.json"), strokes(R"("tool":"pull","radius":0.25)", R"({"position":[1,0,0]},{"position":[0,1,0]})"));
    QCOMPARE(fettle({QStringLiteral("replay"), QStringLiteral("--strokes"), at("s.json"), QStringLiteral("--verify"),
                     QStringLiteral("full")})
                 .status,
             0);
    QCOMPARE(fettle({QStringLiteral("replay"), QStringLiteral("--strokes"), at("s.json"), QStringLiteral("--verify"),
                     QStringLiteral("none"), QStringLiteral("--stats"), at("t.json")})
                 .status,
             0);
}

void TestCommandLine::replay_neverMovesTheModel()
{
    core::TriangleMesh model = core::icosphere(2, 1);
    for (core::Vec3f& p : model.points)
        p += core::Vec3f(2, 0, 0);
    core::writeMesh(at("a.ply").toStdString(), model);
    write(at("s.json"), strokes(R"("tool":"pull","radius":0.25)", R"({"position":[3,0,0]})"));
    QCOMPARE(fettle({QStringLiteral("replay"), QStringLiteral("--strokes"), at("s.json"), QStringLiteral("--in"),
                     at("a.ply"), QStringLiteral("--out"), at("b.ply")})
                 .status,
             0);
    core::Box box;
    for (const core::Vec3f& p : core::readMesh(at("b.ply").toStdString()).points)
        box.extend(p.cast<double>());
    QVERIFY(std::abs(box.min().x() - 1) < 0.01 && box.max().x() > 3.01);

    for (core::Vec3f& p : model.points)
        p += core::Vec3f(100000, 0, 0);
    core::writeMesh(at("a.ply").toStdString(), model);
    VERIFY_REFUSED(fettle({QStringLiteral("replay"), QStringLiteral("--strokes"), at("s.json"), QStringLiteral("--in"),
                           at("a.ply")}),
                   "s.json");
}

void TestCommandLine::replay_refusals_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("with");
    QTest::newRow("no JSON") << QByteArray("pull the nose") << QStringLiteral("line 1");
    QTest::newRow("empty") << QByteArray() << QStringLiteral("JSON");
    QTest::newRow("tool") << strokes(R"("tool":"melt","radius":1)")
                          << QStringLiteral("tool: \"melt\" is none of pull, push, inflate, ");
    QTest::newRow("plane") << strokes(R"("tool":"pull","radius":1,"symmetry":"w")")
                           << QStringLiteral("symmetry: \"w\" is none of none, x, y, z");
    QTest::newRow("placement") << strokes(R"("tool":"pull","radius":1,"place":"there")")
                               << QStringLiteral("place: \"there\" is none of point, nearest, ray");
    QTest::newRow("command") << QByteArray(R"({"format":"fettle-strokes","version":1,"strokes":[{"command":"melt"}]})")
                             << QStringLiteral("command: \"melt\" is none of move, rotate, transform, scale, ");
    QTest::newRow("plane of a command")
        << QByteArray(R"({"format":"fettle-strokes","version":1,"strokes":[{"command":"mirror","plane":"none"}]})")
        << QStringLiteral("plane: \"none\" is none of x, y, z");
    QTest::newRow("mask") << QByteArray(
                                 R"({"format":"fettle-strokes","version":1,"strokes":[{"command":"mask","how":"x"}]})")
                          << QStringLiteral("how: \"x\" is none of invert, clear, blur, ");
    QTest::newRow("alpha") << strokes(R"("tool":"pull","radius":1,"alpha":"bogus")")
                           << QStringLiteral("stroke 1 (strokes[0]): alpha: \"bogus\" is none of pores, scales, ");
    QTest::newRow("radius by name") << strokes(R"("tool":"pull","radius":"x")")
                                    << QStringLiteral("stroke 1 (strokes[0]): \"radius\" must be a number");
    QTest::newRow("half a falloff") << strokes(R"("tool":"pull","radius":1,"falloff":3.5)")
                                    << QStringLiteral("\"falloff\" must be a whole number");
    QTest::newRow("tool by number") << strokes(R"("tool":5,"radius":1)")
                                    << QStringLiteral("\"tool\" must be a word in quotation marks");
    QTest::newRow("inverted by number") << strokes(R"("tool":"clay","radius":1,"invert":1)")
                                        << QStringLiteral("\"invert\" must be true or false");
    QTest::newRow("flat position") << strokes(R"("tool":"pull","radius":1)", R"({"position":[0,1]})")
                                   << QStringLiteral(
                                          "sample 1 (strokes[0].samples[0]): \"position\" must be three numbers");
    QTest::newRow("flat rotation") << strokes(R"("tool":"pull","radius":1)",
                                              R"({"position":[0,1,0],"rotation":[0,1,0]})")
                                   << QStringLiteral("\"rotation\" must be four numbers, as in [0, 0, 0, 1]");
    QTest::newRow("half a color") << strokes(R"("tool":"paint","radius":1,"color":[1,2,3.5])")
                                  << QStringLiteral("\"color\" must be three whole numbers from 0 to 255");
    QTest::newRow("strokes by name") << QByteArray(R"({"format":"fettle-strokes","version":1,"strokes":"pull"})")
                                     << QStringLiteral("\"strokes\" must be a list of objects");
    QTest::newRow("version") << QByteArray(R"({"format":"fettle-strokes","version":2,"strokes":[]})")
                             << QStringLiteral("it has version 2; this program reads version 1");
    QTest::newRow("inserted file")
        << QByteArray(R"({"format":"fettle-strokes","version":1,"strokes":[{"command":"insert","file":"no.stl"}]})")
        << QStringLiteral("stroke 1 (strokes[0]): ");
    QTest::newRow("sectors") << strokes(R"("tool":"pull","radius":1,"radial":33)") << QStringLiteral("radial");
    QTest::newRow("key") << strokes(R"("tool":"pull","radius":1,"size":1)") << QStringLiteral("size");
    QTest::newRow("NaN") << strokes(R"("tool":"pull","radius":NaN)") << QStringLiteral("radius");
    QTest::newRow("infinite") << strokes(R"("tool":"pull","radius":1)", R"({"position":[1e999,0,0]})")
                              << QStringLiteral("position");
    QTest::newRow("denormal radius") << strokes(R"("tool":"pull","radius":1e-310)") << QStringLiteral("radius");
    QTest::newRow("radius 0") << strokes(R"("tool":"pull","radius":0)") << QStringLiteral("radius");
    QTest::newRow("radius below the lattice's detail")
        << strokes(R"("tool":"pull","radius":0.001)") << QStringLiteral("radius");
    QTest::newRow("radius beyond the volume") << strokes(R"("tool":"pull","radius":9)") << QStringLiteral("radius");
    QTest::newRow("detail length below the lattice's")
        << strokes(R"("tool":"pull","radius":1,"topology":"uniform","detail_length":0.0001)")
        << QStringLiteral("detail_length");
    QTest::newRow("position outside the volume")
        << strokes(R"("tool":"pull","radius":1)", R"({"position":[0,0,1]},{"position":[0,-8.5,0]})")
        << QStringLiteral("stroke 1, sample 2");
    QTest::newRow("jump of ten kilometres")
        << strokes(R"("tool":"pull","radius":1,"spacing":0.1)", R"({"position":[0,0,1]},{"position":[1e7,0,1]})")
        << QStringLiteral("position");
    QTest::newRow("nearest from outside")
        << strokes(R"("tool":"pull","radius":1,"place":"nearest")", R"({"position":[9,0,0]})")
        << QStringLiteral("position");
    QTest::newRow("no direction") << strokes(R"("tool":"pull","radius":1,"place":"ray")",
                                             R"({"position":[0,0,9],"direction":[0,0,1e-310]})")
                                  << QStringLiteral("direction");
    QTest::newRow("falloff 2") << strokes(R"("tool":"pull","radius":1,"falloff":2)") << QStringLiteral("0 or 3 to 16");
    QTest::newRow("falloff 17") << strokes(R"("tool":"pull","radius":1,"falloff":17)")
                                << QStringLiteral("0 or 3 to 16");
    QTest::newRow("spacing too small") << strokes(R"("tool":"pull","radius":1,"spacing":0.0001)")
                                       << QStringLiteral("0 or 0.001 to 4");
    QTest::newRow("spacing too large") << strokes(R"("tool":"pull","radius":1,"spacing":5)")
                                       << QStringLiteral("0 or 0.001 to 4");
    QTest::newRow("place") << strokes(R"("tool":"pull","radius":1)",
                                      R"({"position":[0,0,1]},{"position":[0,0,1],"pressure":7})")
                           << QStringLiteral("stroke 1, sample 2");
    QTest::newRow("cut off") << strokes(R"("tool":"pull","radius":1)").chopped(10) << QStringLiteral("line 1");
}

void TestCommandLine::replay_extremesHaveAnAnswer()
{
    for (const QByteArray& text :
         {strokes(R"("tool":"pull","radius":3)"), strokes(R"("tool":"pull","radius":8,"strength":10)"),
          strokes(R"("tool":"pull","radius":0.25)", R"({"position":[1e-310,0,1],"pressure":1e-310})"),
          strokes(R"("tool":"pull","radius":0.25,"place":"ray")", R"({"position":[0,0,1e9],"direction":[0,0,-1]})"),
          strokes(R"("tool":"pull","radius":0.25,"brush":"ray","spacing":0.1)",
                  R"({"position":[0,0,1e7],"direction":[0,0,-1]},{"position":[1e7,0,0],"direction":[-1,0,0]})")}) {
        write(at("s.json"), text);
        const Answer answer = fettle({QStringLiteral("replay"), QStringLiteral("--strokes"), at("s.json"),
                                      QStringLiteral("--out"), at("o.stl")});
        QVERIFY2(answer.status == 0 && answer.err.isEmpty(), text + answer.err);
        QCOMPARE(fettle({QStringLiteral("check"), at("o.stl")}).status, 0);
    }
}

void TestCommandLine::replay_refusals()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, with);
    write(at("s.json"), text);
    const Answer answer = fettle({QStringLiteral("replay"), QStringLiteral("--strokes"), at("s.json"),
                                  QStringLiteral("--out"), at("o.stl"), QStringLiteral("--stats"), at("t.json")});
    QVERIFY2(answer.isRefusal(with) && answer.isRefusal(QStringLiteral("s.json")), answer.err.constData());
    QCOMPARE(left(), QStringList{QStringLiteral("s.json")});
}

void TestCommandLine::replay_refusalWritesNothing()
{
    const QStringList replay{QStringLiteral("replay"), QStringLiteral("--strokes"), at("s.json")};
    VERIFY_REFUSED(fettle(replay), "s.json");
    write(at("s.json"), strokes(R"("tool":"pull","radius":0.25)"));
    VERIFY_REFUSED(fettle(replay + QStringList{QStringLiteral("--out"), at("o.what")}), "o.what");
    VERIFY_REFUSED(fettle(replay + QStringList{QStringLiteral("--out"), at("none/o.stl")}), "o.stl");
    QVERIFY(fettle(replay + QStringList{QStringLiteral("--out"), at("none/o.stl")})
                .isRefusal(QStringLiteral("the folder %1 does not exist").arg(at("none"))));
    VERIFY_REFUSED(fettle(replay + QStringList{QStringLiteral("--stats"), at("none/t.json")}), "t.json");
    VERIFY_REFUSED(fettle(replay + QStringList{at("a.stl")}), "a.stl");
    write(at("open.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    VERIFY_REFUSED(
        fettle(replay + QStringList{QStringLiteral("--in"), at("open.obj"), QStringLiteral("--out"), at("o.stl")}),
        "open.obj");
    QCOMPARE(left(), QStringList({QStringLiteral("open.obj"), QStringLiteral("s.json")}));
}

/// Decreasing sample times are accepted, and a stroke without samples does nothing.
void TestCommandLine::replay_oddStrokesAreTaken()
{
    const QStringList replay{QStringLiteral("replay"), QStringLiteral("--strokes"), at("s.json"),
                             QStringLiteral("--out"), at("o.ply")};
    write(at("s.json"), strokes(R"("tool":"pull","radius":0.25)", ""));
    const Answer empty = fettle(replay);
    QVERIFY2(empty.status == 0 && empty.out.startsWith("Strokes: 1, commands: 0, dabs: 0."), empty.out.constData());
    QCOMPARE(core::readMesh(at("o.ply").toStdString()).points.size(), std::size_t(2562));
    write(at("s.json"), strokes(R"("tool":"pull","radius":0.25,"turntable_deg_per_s":90)",
                                R"({"t":1,"position":[1,0,0]},{"t":0,"position":[1,0,0]})"));
    QCOMPARE(fettle(replay).status, 0);
}

void TestCommandLine::replay_radiusHasToFitTheLattice()
{
    for (const char* stroke : {R"("tool":"pull","radius":0.0005)", R"("tool":"pull","radius":100)",
                               R"("tool":"pull","radius":0.01,"detail":0.05)"}) {
        write(at("s.json"), strokes(stroke));
        VERIFY_REFUSED(fettle({QStringLiteral("replay"), QStringLiteral("--strokes"), at("s.json")}), "stroke 1");
    }
    write(at("s.json"), strokes(R"("tool":"pull","radius":0.25)", R"({"position":[1,0,0],"radius":0.0005})"));
    VERIFY_REFUSED(fettle({QStringLiteral("replay"), QStringLiteral("--strokes"), at("s.json")}), "sample 1");
}

void TestCommandLine::numbers_haveNoLocale()
{
    write(at("a.obj"), QByteArray(cube).replace("v 1 ", "v 1.5 "));
    for (const char* locale : {"C", "de_DE.UTF-8"}) {
        const QMap<QString, QString> variables{{QStringLiteral("LC_ALL"), QString::fromLatin1(locale)}};
        QCOMPARE(fettle({QStringLiteral("check"), QStringLiteral("--json"), at("a.obj")}, variables)
                     .json()[QStringLiteral("size_mm")]
                     .toArray()[0]
                     .toDouble(),
                 1.5);
        QCOMPARE(fettle({QStringLiteral("convert"), at("a.obj"), at("b.obj"), QStringLiteral("--size"),
                         QStringLiteral("2.5")},
                        variables)
                     .status,
                 0);
    }
}

void TestCommandLine::locale_givesTheLanguage_data()
{
    QTest::addColumn<QString>("variable");
    QTest::addColumn<QString>("locale");
    for (const char* variable : {"LC_ALL", "LANG"})
        for (const char* locale : {"de_DE.UTF-8", "de_DE.ISO-8859-1", "de_AT"})
            QTest::addRow("%s=%s", variable, locale) << QString::fromLatin1(variable) << QString::fromLatin1(locale);
}

/// The locale gives the language even if the system has no such locale, or if its encoding is not UTF-8.
void TestCommandLine::locale_givesTheLanguage()
{
    QFETCH(QString, variable);
    QFETCH(QString, locale);
    QMap<QString, QString> variables{{QStringLiteral("LC_ALL"), {}}, {QStringLiteral("LANGUAGE"), {}}};
    variables[variable] = locale;
    const Answer answer = fettle({QStringLiteral("check"), at("none.stl")}, variables);
    QCOMPARE(answer.status, 2);
    QVERIFY2(answer.err.contains("gibt es nicht"), answer.err.constData());
}

static int commandLineMain(int argc, char* argv[])
{
    const QTemporaryDir folder;
    const places::SmallDisk smallDisk(folder.filePath(QStringLiteral("small")).toStdString());
    places::obeyPermissions();
    const QCoreApplication application(argc, argv);
    TestCommandLine test(&smallDisk);
    return QTest::qExec(&test, argc, argv);
}

FETTLE_TEST_MAIN(TestCommandLine, commandLineMain)
#include "tst_command_line.moc"
