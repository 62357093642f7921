// Compares the command-line reference (resources/reference) with the program: commands, options, examples, and fields
// of JSON and CSV output.
#include "app/commands/command_line.h"

#include "core/io/mesh_io.h"
#include "core/primitives/primitives.h"
#include "core/primitives/starter_models.h"
#include "core/stroke/stroke.h"
#include "tests/app/commands/reference_page.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <memory>
#include <tuple>

namespace
{
const QStringList optionPages{QStringLiteral("primitives"), QStringLiteral("commands"),
                              QStringLiteral("commands-class")};

struct ShellAnswer
{
    int status = -1;
    QString out, err;
};

/// Runs a shell command in which `fettle` is the program, without a display and in the C locale.
ShellAnswer shell(const QString& line, const QString& folder)
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(QString::fromLatin1(name));
    environment.insert(QStringLiteral("LC_ALL"), QStringLiteral("C.UTF-8"));
    QProcess process;
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(folder);
    const QString define = QStringLiteral("fettle() { '%1' \"$@\"; }\n").arg(QStringLiteral(FETTLE_PROGRAM));
    process.start(QStringLiteral("bash"), {QStringLiteral("-c"), define + line});
    if (!process.waitForFinished(-1) || process.exitStatus() != QProcess::NormalExit)
        return {};
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

struct OptionRow
{
    QString value;    ///< name of its value; empty: it has none
    QString standard; ///< default; empty: none is given
    QString values;   ///< allowed values; empty: any
};
/// Options by all their names, for example "-o, --out".
using OptionRows = QMap<QString, OptionRow>;

/// Adds an option. Splits the name of its value from the end of its names.
void addOption(OptionRows& rows, QString names, OptionRow row)
{
    const qsizetype space = names.lastIndexOf(u' ');
    if (space >= 0 && names[space + 1] != u'-') {
        row.value = names.mid(space + 1);
        names.truncate(space);
    }
    rows.insert(names, row);
}

/// Parses the options from a command's help text, which has two columns.
OptionRows optionsInHelp(const QString& command)
{
    OptionRows rows;
    QList<QStringList> lines; // names and description of each option
    const QString help = shell(QStringLiteral("fettle help ") + command, {}).out;
    const qsizetype options = help.indexOf(QStringLiteral("Options:\n")) + 9;
    const QStringList all = help.mid(options).section(QStringLiteral("\n\n"), 0, 0).split(u'\n');
    qsizetype column = 0;
    for (const QString& line : all)
        column = std::max(column, line.indexOf(QStringLiteral("Show this help.")));
    for (const QString& line : all) {
        const QString left = line.left(column).trimmed(), right = line.mid(column).trimmed();
        if (left.startsWith(u'-'))
            lines << QStringList{left, right};
        else if (!lines.isEmpty())
            lines.last() = {lines.last()[0] + left, lines.last()[1] + u' ' + right};
    }
    static const QRegularExpression standard(QStringLiteral("\\(default: ([^)]*)\\)")),
        words(QStringLiteral("^[a-z0-9|]+$"));
    for (const QStringList& line : std::as_const(lines)) {
        QString names = line[0];
        names.remove(u'<').remove(u'>');
        OptionRow row{{}, standard.match(line[1]).captured(1), {}};
        const QString value = names.section(u' ', -1);
        if (value.contains(u'|') && words.match(value).hasMatch())
            row.values = QStringLiteral("one of ") + value.split(u'|').join(QStringLiteral(", "));
        addOption(rows, names, row);
    }
    return rows;
}

/// Adds the options of a table: all of them, or those in `only`.
void addTable(OptionRows& rows, const ReferenceTable& table, const QStringList& only = {})
{
    for (const QStringList& row : table.rows) {
        const QStringList names = codesIn(row[0]);
        const QString last = names.last().section(u' ', 0, 0);
        if (only.isEmpty() || only.contains(last))
            addOption(rows, names.join(QStringLiteral(", ")), {{}, row[2], row[3]});
    }
}

QString titleOf(const QString& command)
{
    return QStringLiteral("fettle ") + command;
}

/// Reads the options of a command from the reference: those of its own table, and the shared ones that its line "Also:"
/// names.
OptionRows optionsInReference(const QString& command)
{
    OptionRows rows;
    const ReferencePage shared(QStringLiteral("command-line"));
    for (const QString& name : optionPages) {
        const ReferencePage page(name);
        for (const QString& line : page.text(titleOf(command)))
            if (line.startsWith(QLatin1String("Also:")))
                addTable(rows, shared.table(QStringLiteral("option")), codesIn(line));
        addTable(rows, page.table(QStringLiteral("option"), titleOf(command)));
    }
    return rows;
}

/// Parses the names of commands from the general help text.
QStringList commandsOfProgram()
{
    static const QRegularExpression row(QStringLiteral("^  fettle ([a-z]+)\\b"), QRegularExpression::MultilineOption);
    QStringList commands;
    for (auto i = row.globalMatch(shell(QStringLiteral("fettle help"), {}).out); i.hasNext();)
        commands << i.next().captured(1);
    return commands;
}

/// Returns whether a JSON value has the type that the reference gives.
bool isOfKind(const QJsonValue& value, const QString& kind)
{
    if (value.isNull())
        return true;
    if (kind == QLatin1String("text"))
        return value.isString();
    if (kind == QLatin1String("number"))
        return value.isDouble();
    if (kind == QLatin1String("whole number"))
        return value.isDouble() && value.toDouble() == std::floor(value.toDouble());
    if (kind == QLatin1String("true or false"))
        return value.isBool();
    return kind == QLatin1String("list") && value.isArray();
}

/// Compares the fields of an object with the tables. `extra`: a field that is in no table.
void compareFields(const QJsonObject& object, const QList<ReferenceTable>& tables, const QString& extra = {})
{
    QStringList documented;
    for (const ReferenceTable& table : tables)
        for (const QStringList& row : table.rows)
            for (const QString& field : codesIn(row[0])) {
                documented << field;
                QVERIFY2(isOfKind(object.value(field), row[1]), qPrintable(field + u' ' + row[1]));
            }
    QStringList printed = object.keys();
    printed.removeAll(extra);
    documented.sort();
    QCOMPARE(printed, documented);
}

QJsonObject objectOf(const QString& text)
{
    return QJsonDocument::fromJson(text.toUtf8()).object();
}

void writeFile(const QString& path, const QString& text)
{
    QFile file(path);
    QVERIFY(file.open(QFile::WriteOnly));
    file.write(text.toUtf8());
}
} // namespace

class TestReferenceCommands : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void commands_areThoseOfTheProgram();
    void options_areThoseOfTheProgram_data();
    void options_areThoseOfTheProgram();
    void ranges_areThoseOfTheProgram_data();
    void ranges_areThoseOfTheProgram();
    void defaults_changeNothing_data();
    void defaults_changeNothing();
    void examples_run_data();
    void examples_run();
    void examplesOfTheReadme_run();
    void statuses_areThoseOfTheProgram();
    void fields_ofCheck();
    void fields_ofReplay();
    void fields_ofLesson();
    void completion_hasTheOptions_data();
    void completion_hasTheOptions();
    void completion_hasTheWords();

private:
    ShellAnswer run(const QString& line) const { return shell(line, m_folder->path()); }
    QString at(const char* name) const { return m_folder->filePath(QString::fromUtf8(name)); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

/// Creates the files that the examples use.
void TestReferenceCommands::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    for (const char* name : {"class/2026-11-24-1015-Anna", "my-lesson", "film"})
        QVERIFY(QDir().mkpath(at(name)));
    for (const char* name : {"model.stl", "model.obj", "class/model.glb", "class/2026-11-24-1015-Anna/model.glb"})
        core::writeMesh(at(name).toStdString(), core::icosphere(4, 1));
    for (const char* name : {"broken.stl", "class/broken.stl"})
        core::writeMesh(at(name).toStdString(), shapes::openCone(12));
    const auto example = [](const char* page, const char* language, qsizetype index = 0) {
        return ReferencePage(QString::fromLatin1(page)).examples(QString::fromLatin1(language)).value(index);
    };
    writeFile(at("class/2026-11-24-1015-Anna/turn.json"), example("work-folder", "json"));
    writeFile(at("s.json"), example("stroke-file", "json"));
    writeFile(at("my-brush.json"), example("presets", "json"));
    writeFile(at("5b.fettleclass"), example("class-file", "ini"));
    writeFile(at("my-lesson/lesson.json"), example("lesson-file", "json"));
    writeFile(at("my-lesson/pull.json"), example("lesson-file", "json", 1));
    QImage picture(8, 8, QImage::Format_RGB32);
    picture.fill(Qt::gray);
    QVERIFY(picture.save(at("my-lesson/step-1.png")));
}

void TestReferenceCommands::commands_areThoseOfTheProgram()
{
    QStringList commands = commandsOfProgram();
    QVERIFY(commands.size() > 5);
    QCOMPARE(ReferencePage(QStringLiteral("command-line"))
                 .table(QStringLiteral("command"))
                 .keys()
                 .filter(QRegularExpression(QStringLiteral("^[a-z]+$"))),
             commands);
    commands.removeAll(QStringLiteral("help"));
    QStringList titles;
    for (const QString& name : optionPages)
        titles << ReferencePage(name).sections().filter(QRegularExpression(QStringLiteral("^fettle ")));
    for (QString& command : commands)
        command = titleOf(command);
    QCOMPARE(titles, commands);
}

void TestReferenceCommands::options_areThoseOfTheProgram_data()
{
    QTest::addColumn<QString>("command");
    for (const QString& command : commandsOfProgram())
        if (command != QLatin1String("help"))
            QTest::addRow("%s", qPrintable(command)) << command;
}

void TestReferenceCommands::options_areThoseOfTheProgram()
{
    QFETCH(QString, command);
    const OptionRows program = optionsInHelp(command), reference = optionsInReference(command);
    QVERIFY(program.size() > 1);
    QCOMPARE(reference.keys(), program.keys());
    for (auto i = program.begin(); i != program.end(); ++i) {
        const OptionRow& told = reference[i.key()];
        QVERIFY2(told.standard == i->standard, qPrintable(i.key() + u' ' + told.standard));
        QVERIFY2(told.value.isEmpty() == i->value.isEmpty(), qPrintable(i.key() + u' ' + told.value));
        if (i->values.isEmpty()) // the values are not a list of words
            QVERIFY2(told.value == i->value, qPrintable(i.key() + u' ' + told.value));
        else
            QVERIFY2(told.values == i->values, qPrintable(i.key() + u' ' + told.values));
        static const QRegularExpression number(QStringLiteral("^(MM|N|DEGREES|X,Y,Z)$"));
        QVERIFY2(!told.values.isEmpty() || !number.match(told.value).hasMatch(), qPrintable(i.key()));
    }
}

namespace
{
/// Returns a valid command line for the command and the option.
QString lineWith(const QString& command, const QString& option)
{
    static const QMap<QString, QString> lines{
        {QStringLiteral("new"), QStringLiteral("fettle new ball - --to obj")},
        {QStringLiteral("check"), QStringLiteral("fettle check broken.stl --print --json")},
        {QStringLiteral("convert"), QStringLiteral("fettle convert broken.stl - --to obj --repair")},
        {QStringLiteral("boolean"), QStringLiteral("fettle boolean union model.stl model.stl -o - --to obj")},
        {QStringLiteral("replay"), QStringLiteral("fettle replay --strokes s.json --out - --to obj")},
        {QStringLiteral("report"), QStringLiteral("fettle report class -o - --to html")},
        {QStringLiteral("sheet"), QStringLiteral("fettle sheet model.stl -o sheet.pdf")},
        {QStringLiteral("lesson"), QStringLiteral("fettle lesson my-lesson --model model.stl --json")},
    };
    static const QMap<QString, QString> primitives{
        {QStringLiteral("--width"), QStringLiteral("box - --to obj --width 1 --height 1 --depth 1")},
        {QStringLiteral("--height"), QStringLiteral("box - --to obj --width 1 --height 1 --depth 1")},
        {QStringLiteral("--depth"), QStringLiteral("box - --to obj --width 1 --height 1 --depth 1")},
        {QStringLiteral("--radius"), QStringLiteral("ball - --to obj --radius 1")},
        {QStringLiteral("--top-radius"), QStringLiteral("cone - --to obj --radius 1 --height 1")},
        {QStringLiteral("--tube-radius"), QStringLiteral("torus - --to obj --radius 1")},
        {QStringLiteral("--profile"), QStringLiteral("lathe - --to obj")},
        {QStringLiteral("--path"), QStringLiteral("tube - --to obj")},
        {QStringLiteral("--edge-length"), QStringLiteral("ball - --to obj --radius 1")},
    };
    if (command == QLatin1String("new") && primitives.contains(option))
        return QStringLiteral("fettle new ") + primitives.value(option);
    return lines.value(command) + (option == QLatin1String("--every") ? QStringLiteral(" --frames film") : QString());
}

QString withoutDate(QString answer)
{
    static const QRegularExpression time(QStringLiteral("\\d+:\\d\\d[^<]*"));
    return answer.remove(time);
}
} // namespace

void TestReferenceCommands::ranges_areThoseOfTheProgram_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("values");
    for (const QString& command : commandsOfProgram()) {
        const OptionRows rows = optionsInReference(command);
        for (auto i = rows.begin(); i != rows.end(); ++i) {
            const QString name = i.key().section(u' ', -1);
            if (!i->values.isEmpty() && !name.endsWith(QLatin1String("from")) && !name.endsWith(QLatin1String("to")))
                QTest::addRow("%s %s", qPrintable(command), qPrintable(name))
                    << QStringLiteral("%1 %2 nothing").arg(lineWith(command, name), name) << i->values;
        }
    }
}

void TestReferenceCommands::ranges_areThoseOfTheProgram()
{
    QFETCH(QString, line);
    QFETCH(QString, values);
    const ShellAnswer answer = run(line);
    QCOMPARE(answer.status, 2);
    QVERIFY2(answer.err.contains(QStringLiteral(" must be %1, not \"nothing\".").arg(values)), qPrintable(answer.err));
}

void TestReferenceCommands::defaults_changeNothing_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("option");
    static const QRegularExpression number(QStringLiteral("^[0-9.]+$"));
    for (const QString& command : commandsOfProgram()) {
        const OptionRows rows = optionsInReference(command);
        for (auto i = rows.begin(); i != rows.end(); ++i) {
            const QString name = i.key().section(u' ', -1);
            const bool isWord = i->values.startsWith(QLatin1String("one of ")) && !i->standard.contains(u' ');
            if (!i->standard.isEmpty() && (isWord || number.match(i->standard).hasMatch()))
                QTest::addRow("%s %s", qPrintable(command), qPrintable(name))
                    << lineWith(command, name) << QStringLiteral(" %1 %2").arg(name, i->standard);
        }
    }
}

void TestReferenceCommands::defaults_changeNothing()
{
    QFETCH(QString, line);
    QFETCH(QString, option);
    const QStringList rest{QStringLiteral("film"), QStringLiteral("sheet.pdf")};
    const auto outcome = [&] {
        const ShellAnswer answer = run(line);
        const QStringList frames = QDir(at("film")).entryList(QDir::Files);
        for (const QString& frame : frames)
            QFile::remove(at("film/") + frame);
        return std::tuple(answer.status, withoutDate(answer.out), answer.err, frames);
    };
    const auto without = outcome();
    QVERIFY2(std::get<0>(without) < 2, qPrintable(std::get<2>(without)));
    line += option;
    QCOMPARE(outcome(), without);
}

void TestReferenceCommands::examples_run_data()
{
    QTest::addColumn<QString>("page");
    for (const QString& page : QStringList{QStringLiteral("command-line")} + optionPages)
        QTest::addRow("%s", qPrintable(page)) << page;
}

void TestReferenceCommands::examples_run()
{
    QFETCH(QString, page);
    QDir::setCurrent(m_folder->path());
    static const QRegularExpression status(QStringLiteral("  # status (\\d)$"));
    const QStringList lines =
        ReferencePage(page).examples(QStringLiteral("sh")).join(QString()).split(u'\n', Qt::SkipEmptyParts);
    QVERIFY(!lines.isEmpty());
    for (const QString& line : lines) {
        const QStringList words = QProcess::splitCommand(line);
        QCOMPARE(words.value(0), QStringLiteral("fettle"));
        if (app::CommandLine::opensWindow(words.mid(1)))
            continue;
        const ShellAnswer answer = run(line);
        QVERIFY2(answer.status == status.match(line).captured(1).toInt(), qPrintable(line + u'\n' + answer.err));
    }
    QDir::setCurrent(QDir::tempPath());
}

/// Creates further files that the command lines of the README use.
void TestReferenceCommands::examplesOfTheReadme_run()
{
    for (const auto& [copy, file] : {std::pair("in.obj", "model.obj"), std::pair("a.stl", "model.stl")})
        QVERIFY(QFile::copy(at(file), at(copy)));
    core::writeMesh(at("big.glb").toStdString(), core::icosphere(6, 50));
    QFile readme(QStringLiteral(FETTLE_SOURCE_DIR "/README.md"));
    QVERIFY(readme.open(QFile::ReadOnly));
    static const QRegularExpression example(QStringLiteral("^    (fettle .*?)(  .*)?$"));
    int count = 0;
    for (const QString& line : QString::fromUtf8(readme.readAll()).split(u'\n')) {
        const auto match = example.match(line);
        if (!match.hasMatch())
            continue;
        ++count;
        const ShellAnswer answer = run(match.captured(1));
        QVERIFY2(answer.status == app::Done || answer.status == app::AnswerIsNo, qPrintable(line + u'\n' + answer.err));
    }
    QVERIFY(count >= 10);
}

void TestReferenceCommands::statuses_areThoseOfTheProgram()
{
    QStringList told;
    for (const QStringList& row : ReferencePage(QStringLiteral("command-line")).table(QStringLiteral("status")).rows)
        told << row[0];
    QStringList known;
    for (const app::ExitStatus status : {app::Done, app::AnswerIsNo, app::BadInput})
        known << QString::number(status);
    QCOMPARE(told, known);
    const QString help = run(QStringLiteral("fettle help")).out;
    QVERIFY(help.contains(QStringLiteral("Status: 0 done, 1 the answer is no, 2 bad input")));
    QCOMPARE(run(QStringLiteral("fettle check model.stl")).status, 0);
    QCOMPARE(run(QStringLiteral("fettle check broken.stl")).status, 1);
    QCOMPARE(run(QStringLiteral("fettle check missing.stl")).status, 2);
    QCOMPARE(run(QStringLiteral("fettle check --nonsense model.stl")).status, 2);
}

void TestReferenceCommands::fields_ofCheck()
{
    const ReferencePage page(QStringLiteral("command-output"));
    const QString field = QStringLiteral("field"), print = QStringLiteral("With --print"),
                  works = QStringLiteral("Pupils' models of a class");
    const ReferenceTable all = page.table(field, QStringLiteral("check --json")), ofPrint = page.table(field, print),
                         ofWorks = page.table(field, works);
    compareFields(objectOf(run(QStringLiteral("fettle check --json model.stl")).out), {all});
    compareFields(objectOf(run(QStringLiteral("fettle check --json --print model.stl")).out), {all, ofPrint});
    const QString lines = run(QStringLiteral("fettle check --json --print --bed 9,9,9 class")).out;
    QCOMPARE(lines.count(u'\n'), 3);
    for (const QString& line : lines.split(u'\n', Qt::SkipEmptyParts))
        compareFields(objectOf(line), {all, ofPrint, ofWorks});

    QStringList columns = all.keys() + ofPrint.keys() + ofWorks.keys();
    for (const char* name : {"format", "version", "error"})
        QCOMPARE(columns.removeAll(QString::fromLatin1(name)), 1);
    const QString csv = run(QStringLiteral("fettle check --csv --print class")).out.section(u'\n', 0, 0);
    const QStringList sides = codesIn(page.text(QStringLiteral("check --csv")).join(u' ')).filter(u"size_"_qs).mid(1);
    QCOMPARE(csv, columns.join(u',').replace(QStringLiteral("size_mm"), sides.join(u',')));
}

void TestReferenceCommands::fields_ofReplay()
{
    const ReferencePage page(QStringLiteral("command-output"));
    const QJsonObject stats = objectOf(run(QStringLiteral("fettle replay --strokes s.json --stats -")).out);
    const QJsonArray dabs = stats.value(QStringLiteral("dabs")).toArray();
    QVERIFY(!dabs.isEmpty());
    const ReferenceTable ofDab = page.table(QStringLiteral("field of a dab"));
    compareFields(dabs[0].toObject(), {ofDab});
    compareFields(stats, {page.table(QStringLiteral("field of the totals"))}, QStringLiteral("dabs"));
    QStringList outcomes;
    for (const std::string_view name : core::valueNames<core::DabOutcome>)
        outcomes << QString::fromUtf8(name);
    QCOMPARE(ofDab.rows.last().value(0), QStringLiteral("`outcome`"));
    QCOMPARE(codesIn(ofDab.rows.last().value(2)), outcomes);
}

void TestReferenceCommands::fields_ofLesson()
{
    const ReferencePage page(QStringLiteral("lesson-output"));
    const auto table = [&page](const char* head) { return page.table(QString::fromLatin1(head)); };
    const auto firstOf = [](const QJsonObject& object, const char* key) {
        return object.value(QLatin1StringView(key)).toArray()[0].toObject();
    };
    const QJsonObject played = objectOf(run(QStringLiteral("fettle lesson my-lesson --json")).out);
    const QJsonObject step = firstOf(played, "steps");
    compareFields(played, {table("field")});
    compareFields(step, {table("field of a step")});
    compareFields(firstOf(step, "goals"), {table("field of a goal")});
    const QString folder = QStringLiteral("fettle lesson my-lesson --model class ");
    const QJsonObject judged = objectOf(run(folder + QStringLiteral("--json")).out.section(u'\n', 0, 0));
    compareFields(judged, {table("field of a model")});
    compareFields(firstOf(judged, "goals"), {table("field of a goal")});
    const QString list = run(QStringLiteral("fettle lesson --json")).out;
    compareFields(QJsonDocument::fromJson(list.toUtf8()).array()[0].toObject(), {table("field of the list")});

    const auto columns = [&page](const char* section) {
        return codesIn(page.text(QString::fromLatin1(section)).join(u' '));
    };
    const auto head = [this](const QString& line) { return run(line).out.section(u'\n', 0, 0); };
    QCOMPARE(head(QStringLiteral("fettle lesson my-lesson --csv")), columns("lesson LESSON --csv").join(u','));
    QStringList told = columns("lesson LESSON --model FOLDER --csv");
    const QString error = told.takeLast(), met = told.takeLast();
    for (const QJsonValue& goal : judged.value(QStringLiteral("goals")).toArray()) {
        const QString key = goal.toObject().value(QStringLiteral("goal")).toString();
        told << key << key + met;
    }
    QCOMPARE(head(folder + QStringLiteral("--csv")), (told << error).join(u','));
    QCOMPARE(head(QStringLiteral("fettle lesson --csv")), table("field of the list").keys().join(u','));
}

namespace
{
/// Returns the completions that bash offers for the last word of a command line.
QStringList completionsOf(const QStringList& words)
{
    QStringList quoted;
    for (const QString& word : words)
        quoted << u'\'' + word + u'\'';
    const QString last = words.last(), before = words[words.size() - 2];
    const QString script = QStringLiteral("source '" FETTLE_SOURCE_DIR
                                          "/resources/packaging/fettle.bash'; COMP_WORDS=(%1); COMP_CWORD=%2; "
                                          "_fettle fettle '%3' '%4'; printf '%s\\n' \"${COMPREPLY[@]}\"");
    QStringList offered = shell(script.arg(quoted.join(u' ')).arg(words.size() - 1).arg(last, before), {})
                              .out.split(u'\n', Qt::SkipEmptyParts);
    offered.sort();
    return offered;
}

/// Returns the first word of each line that a command prints.
QStringList firstWords(const QString& command)
{
    QStringList words;
    for (const QString& line : shell(command, {}).out.split(u'\n', Qt::SkipEmptyParts))
        words << line.section(u' ', 0, 0);
    words.sort();
    return words;
}
} // namespace

void TestReferenceCommands::completion_hasTheOptions_data()
{
    options_areThoseOfTheProgram_data();
}

void TestReferenceCommands::completion_hasTheOptions()
{
    QFETCH(QString, command);
    const OptionRows rows = optionsInHelp(command);
    const QString fettle = QStringLiteral("fettle");
    QStringList options;
    for (auto i = rows.begin(); i != rows.end(); ++i) {
        const QStringList names = i.key().split(QStringLiteral(", "));
        options << names;
        if (i->values.isEmpty())
            continue;
        QStringList words = i->values.mid(QStringLiteral("one of ").size()).split(QStringLiteral(", "));
        words.sort();
        QCOMPARE(completionsOf({fettle, command, names.last(), QString()}), words);
        QCOMPARE(completionsOf({fettle, command, names.last(), QStringLiteral("="), words[0]}).value(0), words[0]);
    }
    options.sort();
    QCOMPARE(completionsOf({fettle, command, QStringLiteral("-")}), options);
}

void TestReferenceCommands::completion_hasTheWords()
{
    const QString fettle = QStringLiteral("fettle");
    QStringList commands = commandsOfProgram();
    commands.sort();
    QStringList offered = completionsOf({fettle, QString()});
    offered.removeIf([](const QString& word) { return word.startsWith(u'-'); });
    QCOMPARE(offered, commands);
    for (const QString& option : completionsOf({fettle, QStringLiteral("-")}))
        QVERIFY2(!run(QStringLiteral("fettle %1 --nonsense").arg(option)).err.contains(option + u'"'),
                 qPrintable(option));
    commands.removeAll(QStringLiteral("help"));
    QCOMPARE(completionsOf({fettle, QStringLiteral("help"), QString()}), commands);
    QStringList starters;
    for (const core::Starter starter : core::starters)
        starters << QString::fromUtf8(core::name(starter));
    for (std::size_t i = 0; i < core::Primitive::kinds; ++i)
        starters << QString::fromUtf8(core::name(static_cast<core::Primitive::Kind>(i)));
    starters.removeDuplicates();
    starters.sort();
    for (const auto& [command, words] :
         {std::pair(QStringLiteral("new"), starters),
          std::pair(QStringLiteral("lesson"), firstWords(QStringLiteral("fettle lesson"))),
          std::pair(QStringLiteral("brush"), firstWords(QStringLiteral("fettle brush")))})
        QCOMPARE(completionsOf({fettle, command, QString()}), words);
}

FETTLE_TEST(TestReferenceCommands, QCoreApplication)
#include "tst_reference_commands.moc"
