// Compares the reference of file formats (resources/reference) with the program: its examples are read by the program's
// readers, and its tables of keys, defaults and ranges are compared with readers and writers.
#include "app/classroom/class_file.h"
#include "app/classroom/work_archive.h"

#include "core/io/mesh_io.h"
#include "core/io/stroke/brush_file.h"
#include "core/io/stroke/stroke_keys.h"
#include "core/lesson/lesson_file.h"
#include "core/sculpt/deform/alpha.h"
#include "tests/app/commands/reference_page.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <cstring>
#include <functional>
#include <memory>
#include <sstream>

using core::StrokeFileError;

namespace
{
QString toText(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

template <class Names> QStringList textsOf(const Names& names)
{
    QStringList texts;
    for (const std::string_view name : names)
        texts << toText(name);
    return texts;
}

QStringList sorted(QStringList list)
{
    list.sort();
    return list;
}

QByteArray bytesAt(const QString& path)
{
    QFile file(path);
    return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray();
}

void writeBytes(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QFile::WriteOnly));
    file.write(bytes);
}

QJsonObject jsonAt(const QString& path)
{
    return QJsonDocument::fromJson(bytesAt(path)).object();
}

QJsonObject objectIn(const QJsonObject& object, const char* key)
{
    const QJsonValue value = object.value(QLatin1StringView(key));
    return value.isArray() ? value.toArray()[0].toObject() : value.toObject();
}

/// Compares the keys of an object with those of a table.
void compareKeys(const QJsonObject& object, const ReferenceTable& table)
{
    QCOMPARE(object.keys(), sorted(table.keys()));
}

/// Adds a key to a JSON object, or replaces its value.
QString withKey(const QString& object, const QString& key, const QString& value)
{
    QJsonObject all = QJsonDocument::fromJson(object.toUtf8()).object();
    const QByteArray wrapped = QStringLiteral("[%1]").arg(value).toUtf8();
    all.insert(key, QJsonDocument::fromJson(wrapped).array().at(0));
    return QString::fromUtf8(QJsonDocument(all).toJson());
}

QString withoutKey(const QString& object, const QString& key)
{
    QJsonObject all = QJsonDocument::fromJson(object.toUtf8()).object();
    all.remove(key);
    return QString::fromUtf8(QJsonDocument(all).toJson());
}

std::vector<core::FileEntry> parse(const QString& entry)
{
    const QString file = QStringLiteral(R"({"format":"fettle-strokes","version":1,"strokes":[%1]})").arg(entry);
    return core::parseStrokes(file.toStdString());
}

std::optional<StrokeFileError> refusalOf(const QString& entry)
{
    try {
        parse(entry);
    } catch (const StrokeFileError& error) {
        return error;
    }
    return std::nullopt;
}

/// Writes an entry as the program does.
QString writtenAgain(const QString& entry)
{
    std::ostringstream text;
    core::writeStrokes(text, parse(entry));
    return QString::fromStdString(text.str()).replace(QStringLiteral("-0.0"), QStringLiteral("0"));
}

const QString plainSample = QStringLiteral(R"({"position":[0,0,0]})");
const QString plainStroke = QStringLiteral(R"({"tool":"paint","radius":1,"samples":[{"position":[0,0,0]}]})");

/// Returns a stroke whose only sample is `sample`, and which has no rays.
QString strokeOf(const QString& sample)
{
    return withKey(plainStroke, QStringLiteral("samples"), u'[' + sample + u']');
}

/// Returns the range that a refusal states, as "0, 3 to 16".
QString rangeOf(const StrokeFileError& error)
{
    return QStringLiteral("%1%2 to %3")
        .arg(error.orZero ? QStringLiteral("0, ") : QString())
        .arg(*error.min)
        .arg(*error.max);
}

/// Converts a range of the reference to the form of rangeOf().
QString plainRange(QString text)
{
    static const QRegularExpression words(QStringLiteral("(or )|((three|four)? ?(whole )?numbers? (from )?)")),
        range(QStringLiteral("^((0, )?)([-0-9.e]+) to ([-0-9.e]+)"));
    const auto match = range.match(text.remove(words));
    if (!match.hasMatch())
        return {};
    return QStringLiteral("%1%2 to %3")
        .arg(match.captured(1))
        .arg(match.captured(3).toDouble())
        .arg(match.captured(4).toDouble());
}

/// Compares the documented values of a key with those that the reader accepts. `entry` makes a stroke or a command with
/// a value for the key.
void compareValues(const QString& key, const QString& values, const std::function<QString(const QString&)>& entry)
{
    const QStringList words = codesIn(values);
    if (!words.isEmpty()) {
        const auto refusal = refusalOf(entry(QStringLiteral("\"nothing\"")));
        QVERIFY2(refusal && refusal->kind == StrokeFileError::Kind::UnknownValue, qPrintable(key));
        QCOMPARE(textsOf(refusal->words), words);
    } else if (const QString range = plainRange(values); !range.isEmpty()) {
        const qsizetype count = values.contains(QStringLiteral("three"))  ? 3
                                : values.contains(QStringLiteral("four")) ? 4
                                                                          : 0;
        QStringList numbers;
        for (qsizetype i = 0; i < count; ++i)
            numbers << QStringLiteral("1e300");
        const auto refusal =
            refusalOf(entry(count == 0 ? QStringLiteral("1e300") : QStringLiteral("[%1]").arg(numbers.join(u','))));
        QVERIFY2(refusal && refusal->min && refusal->max, qPrintable(key));
        QCOMPARE(rangeOf(*refusal), range);
        if (count == 0) {
            const double between = *refusal->min + 0.3;
            const auto fraction = refusalOf(entry(QString::number(between)));
            QVERIFY2(fraction.has_value() == values.contains(QStringLiteral("whole")), qPrintable(key));
        }
    } else if (values == QLatin1String("true, false")) {
        QVERIFY2(!refusalOf(entry(QStringLiteral("true"))) && !refusalOf(entry(QStringLiteral("false"))) &&
                     refusalOf(entry(QStringLiteral("5"))),
                 qPrintable(key));
    } else if (values == QLatin1String("text")) {
        QVERIFY2(!refusalOf(entry(QStringLiteral("\"a.stl\""))) && refusalOf(entry(QStringLiteral("\"\""))),
                 qPrintable(key));
    } else if (values == QLatin1String("text or nothing")) {
        QVERIFY2(!refusalOf(entry(QStringLiteral("\"a\""))) && !refusalOf(entry(QStringLiteral("\"\""))) &&
                     refusalOf(entry(QStringLiteral("5"))),
                 qPrintable(key));
    } else {
        static const QStringList others{QStringLiteral("list"), QStringLiteral("fingerprint"),
                                        QStringLiteral("a [tool](stroke-tools.md)")};
        QVERIFY2(others.contains(values), qPrintable(key + u' ' + values));
    }
}

/// Compares documented default values with those of a stroke without the key.
void compareDefaults(const ReferenceTable& table, const std::function<QString(const QString&, const QString&)>& entry)
{
    const QString without = writtenAgain(entry({}, {}));
    for (const QStringList& row : table.rows) {
        const QString key = codesIn(row[0]).value(0), standard = codesIn(row[1]).value(0);
        if (standard.isEmpty() || standard.contains(QStringLiteral("mean edge")))
            continue;
        QCOMPARE(writtenAgain(entry(key, standard)), without);
    }
}

ReferencePage strokePage()
{
    return ReferencePage(QStringLiteral("stroke-file"));
}

ReferenceTable strokeTable()
{
    return strokePage().table(QStringLiteral("key of a stroke"));
}

/// Returns `count` keys of the stroke reader, starting at index `from`.
QStringList strokeKeys(std::size_t from, std::size_t count)
{
    const auto& names = core::strokeKeys.names;
    return textsOf(std::vector(names.begin() + static_cast<std::ptrdiff_t>(from),
                               names.begin() + static_cast<std::ptrdiff_t>(from + count)));
}

/// Returns a valid value for a key of a command.
QString valueFor(const QString& key)
{
    static const QMap<QString, QString> values{{QStringLiteral("by"), QStringLiteral("[1,0,0]")},
                                               {QStringLiteral("rotation"), QStringLiteral("[0,0,0,1]")},
                                               {QStringLiteral("centre"), QStringLiteral("[0,0,0]")},
                                               {QStringLiteral("color"), QStringLiteral("[9,9,9]")},
                                               {QStringLiteral("plane"), QStringLiteral("\"x\"")},
                                               {QStringLiteral("keep"), QStringLiteral("\"positive\"")},
                                               {QStringLiteral("file"), QStringLiteral("\"a.stl\"")},
                                               {QStringLiteral("where"), QStringLiteral("\"centre\"")},
                                               {QStringLiteral("how"), QStringLiteral("\"color\"")},
                                               {QStringLiteral("outline"), QStringLiteral("[[1,0,0],[0,1,0],[0,0,0]]")},
                                               {QStringLiteral("along"), QStringLiteral("[0,0,-1]")},
                                               {QStringLiteral("eye"), QStringLiteral("[0,0,9]")},
                                               {QStringLiteral("scale"), QStringLiteral("[1,2,1]")},
                                               {QStringLiteral("scale_axes"), QStringLiteral("[0,0,0,1]")},
                                               {QStringLiteral("side"), QStringLiteral("\"inside\"")},
                                               {QStringLiteral("front"), QStringLiteral("true")},
                                               {QStringLiteral("invert"), QStringLiteral("true")},
                                               {QStringLiteral("remove"), QStringLiteral("\"inside\"")},
                                               {QStringLiteral("symmetry"), QStringLiteral("\"x\"")},
                                               {QStringLiteral("name"), QStringLiteral("\"a\"")},
                                               {QStringLiteral("parts"), QStringLiteral("[1]")},
                                               {QStringLiteral("locked"), QStringLiteral("true")},
                                               {QStringLiteral("tag"), QStringLiteral("[1,2,3]")},
                                               {QStringLiteral("operation"), QStringLiteral("\"union\"")},
                                               {QStringLiteral("what"), QStringLiteral("\"masked\"")},
                                               {QStringLiteral("combine"), QStringLiteral("\"join\"")},
                                               {QStringLiteral("primitive"), QStringLiteral("\"ball\"")},
                                               {QStringLiteral("axis"), QStringLiteral("\"x\"")},
                                               {QStringLiteral("path"), QStringLiteral("[[0,0,0,1],[9,0,0,2]]")},
                                               {QStringLiteral("profile"), QStringLiteral("[[0,0],[1,1],[0,2]]")}};
    return values.value(key, QStringLiteral("1"));
}

/// Extracts the known keys of each JSON object from the source of the lesson reader. Map key: name of the object.
QMap<QString, QStringList> keysOfLessonReader()
{
    static const QRegularExpression list(QStringLiteral("knowsOnly\\(\\w+, \"?(\\w*)\"?, \\{([^}]*)\\}\\)"));
    const QString source =
        QString::fromUtf8(bytesAt(QStringLiteral(FETTLE_SOURCE_DIR "/core/lesson/lesson_json_reader.cpp")));
    QMap<QString, QStringList> keys;
    for (auto i = list.globalMatch(source); i.hasNext();) {
        const auto match = i.next();
        QStringList names;
        for (const QString& name : match.captured(2).split(u','))
            names << name.trimmed().remove(u'"');
        keys.insert(match.captured(1), names);
    }
    return keys;
}

/// Returns a class with a value for each key.
ui::Classroom fullClass()
{
    ui::Classroom all{QStringLiteral("5b"), QStringLiteral("/works"), {core::Starter::Ball}, {core::Tool::Pull}};
    all.names = {QStringLiteral("Anna")};
    all.lesson = QStringLiteral("first-clay");
    all.pin = QStringLiteral("pin");
    return all;
}

/// Returns metadata with every part that the document of a GLB can contain.
core::DocumentMetadata fullMetadata()
{
    core::MeshFrame frame{core::Lattice(16)};
    frame.place = core::Vec3(0, 0, 1000);
    frame.parts = core::PartList({{0, "Body", true, false, core::Rgb{1, 2, 3}}});
    core::DocumentMetadata all{{core::Rgb{1, 2, 3}},   frame, core::SavedView(), core::StrokeSettings(),
                               core::WorkDone{3, 4.5}, {}};
    all.references.push_back({"front", "/lion.jpg"});
    return all;
}

/// Returns the JSON part of a GLB.
QJsonObject jsonOfGlb(const QString& path)
{
    const QByteArray bytes = bytesAt(path);
    quint32 size = 0;
    std::memcpy(&size, bytes.constData() + 12, sizeof size);
    return QJsonDocument::fromJson(bytes.mid(20, size)).object();
}

/// Replaces the Fettle extension in a GLB.
void replaceExtension(const QString& path, const QJsonObject& extension)
{
    QJsonObject json = jsonOfGlb(path);
    json[QStringLiteral("extensions")] = QJsonObject{{QStringLiteral("FETTLE_document"), extension}};
    QByteArray text = QJsonDocument(json).toJson(QJsonDocument::Compact);
    text.append((4 - text.size() % 4) % 4, ' ');
    QByteArray bytes = bytesAt(path);
    quint32 old = 0;
    std::memcpy(&old, bytes.constData() + 12, sizeof old);
    bytes.replace(20, old, text);
    const auto size = static_cast<quint32>(text.size()), whole = static_cast<quint32>(bytes.size());
    std::memcpy(bytes.data() + 12, &size, sizeof size);
    std::memcpy(bytes.data() + 8, &whole, sizeof whole);
    writeBytes(path, bytes);
}

app::TurnWork fullWork()
{
    app::LessonResult lesson;
    lesson.lesson = lesson.title = QStringLiteral("mug");
    lesson.verdict.facts.push_back({});
    const QDateTime begun(QDate(2026, 11, 24), QTime(10, 15));
    app::TurnWork work{QStringLiteral("7"),
                       QStringLiteral("Anna"),
                       begun,
                       begun.addSecs(60),
                       1,
                       std::make_shared<core::TriangleMesh>(shapes::cube(20)),
                       1,
                       {},
                       std::vector<core::FileEntry>{},
                       lesson};
    work.usedMs = 30'000;
    return work;
}
} // namespace

class TestReference : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void pages_areShort_data();
    void pages_areShort();
    void strokes_haveTheseKeys();
    void strokes_haveTheseValues();
    void strokes_haveTheseDefaults();
    void commands_ofStrokeFiles();
    void primitives_haveTheseMeasures();
    void words_ofStrokeFiles();
    void formats_areThoseOfTheProgram();
    void presets_haveTheseKeys();
    void lessons_haveTheseKeys();
    void lessons_haveTheseGoals();
    void lessons_exampleIsRead();
    void classes_haveTheseKeys();
    void classes_haveTheseValues();
    void works_haveTheseFiles();
    void works_examplesAreRead();
    void glb_hasTheseKeys();
    void glb_exampleIsRead();

private:
    QString at(const char* name) const { return m_folder->filePath(QString::fromUtf8(name)); }
    /// Reads a class file with this text. Returns the message of a refusal, or an empty text.
    QString readClass(const QString& text, ui::Classroom& classroom) const;

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestReference::pages_areShort_data()
{
    QTest::addColumn<QString>("path");
    QTest::newRow("README.md") << QStringLiteral("README.md");
    const QString reference = QStringLiteral("resources/reference/"), root = QStringLiteral(FETTLE_SOURCE_DIR "/");
    for (const QString& name : QDir(root + reference).entryList(QDir::Files))
        if (name != QLatin1String("paper.md"))
            QTest::addRow("%s", qPrintable(name)) << reference + name;
}

void TestReference::pages_areShort()
{
    QFETCH(QString, path);
    const QFileInfo page(QStringLiteral(FETTLE_SOURCE_DIR "/") + path);
    const QString text = QString::fromUtf8(bytesAt(page.filePath()));
    const QStringList lines = text.split(u'\n');
    QVERIFY(lines.size() <= 121); // including an empty line after the last line break
    for (const QString& line : lines)
        QVERIFY2(line.size() <= 120, qPrintable(line));
    static const QRegularExpression link(QStringLiteral("\\]\\(([^)#]+)\\)"));
    for (auto i = link.globalMatch(text); i.hasNext();) {
        const QString target = i.next().captured(1);
        QVERIFY2(page.dir().exists(target), qPrintable(target));
    }
}

void TestReference::strokes_haveTheseKeys()
{
    QCOMPARE(sorted(strokeTable().keys()), sorted(strokeKeys(0, core::CommandKey)));
    const ReferenceTable samples = strokePage().table(QStringLiteral("key of a sample"));
    QCOMPARE(sorted(samples.keys()), sorted(textsOf(core::sampleKeys.names)));
    QStringList required, requiredOfSample;
    for (const QStringList& row : strokeTable().rows)
        if (row[1] == QLatin1String("required"))
            required << codesIn(row[0]);
    for (const QStringList& row : samples.rows)
        if (row[1] == QLatin1String("required"))
            requiredOfSample << codesIn(row[0]);
    QCOMPARE(required, strokeKeys(0, core::strokeKeys.required));
    QCOMPARE(requiredOfSample, QStringList(toText(core::sampleKeys.names[0])));
    for (const QString& example : strokePage().examples(QStringLiteral("json")))
        QVERIFY(core::parseStrokes(example.toStdString()).size() > 2);
}

void TestReference::strokes_haveTheseValues()
{
    for (const QStringList& row : strokeTable().rows) {
        const QString key = codesIn(row[0])[0];
        compareValues(key, row[2], [&](const QString& value) { return withKey(plainStroke, key, value); });
    }
    for (const QStringList& row : strokePage().table(QStringLiteral("key of a sample")).rows) {
        const QString key = codesIn(row[0])[0];
        compareValues(key, row[2], [&](const QString& value) { return strokeOf(withKey(plainSample, key, value)); });
    }
}

void TestReference::strokes_haveTheseDefaults()
{
    compareDefaults(strokeTable(), [](const QString& key, const QString& value) {
        return key.isEmpty() ? plainStroke : withKey(plainStroke, key, value);
    });
    compareDefaults(strokePage().table(QStringLiteral("key of a sample")),
                    [](const QString& key, const QString& value) {
                        return key.isEmpty() ? plainStroke : strokeOf(withKey(plainSample, key, value));
                    });
}

void TestReference::commands_ofStrokeFiles()
{
    const ReferenceTable commands = strokePage().table(QStringLiteral("command")),
                         values = strokePage().table(QStringLiteral("key of a command"));
    const QStringList keys = strokeKeys(core::ByKey, core::strokeKeys.names.size() - core::ByKey);
    QCOMPARE(sorted(values.keys()), sorted(keys));
    QStringList names;
    for (const QStringList& row : commands.rows) {
        names << codesIn(row[0]).value(0);
        const QStringList required = codesIn(row[1]), optional = codesIn(row[2]);
        QString plain = QStringLiteral(R"({"command":"%1"})").arg(names.last());
        for (const QString& key : required)
            plain = withKey(plain, key, key == QLatin1String("how") ? QStringLiteral("\"blur\"") : valueFor(key));
        QVERIFY2(!refusalOf(plain), qPrintable(plain));
        for (const QString& key : required)
            QVERIFY2(refusalOf(withoutKey(plain, key)), qPrintable(key));
        QString full = plain;
        for (const QString& key : required + optional)
            full = withKey(full, key, valueFor(key));
        QVERIFY2(!refusalOf(full), qPrintable(full));
        for (const QString& key : keys + QStringList{QStringLiteral("color"), QStringLiteral("detail_length")})
            QVERIFY2((required + optional).contains(key) || refusalOf(withKey(full, key, valueFor(key))),
                     qPrintable(names.last() + u' ' + key));
        for (const QStringList& value : values.rows)
            for (const QString& key : codesIn(value[0]))
                if ((required + optional).contains(key))
                    compareValues(key, value[1], [&](const QString& text) { return withKey(full, key, text); });
    }
    const auto refusal = refusalOf(QStringLiteral(R"({"command":"nothing"})"));
    QVERIFY(refusal);
    QCOMPARE(sorted(names), sorted(textsOf(refusal->words)));
}

void TestReference::primitives_haveTheseMeasures()
{
    const ReferencePage page(QStringLiteral("primitives"));
    const ReferenceTable table = page.table(QStringLiteral("primitive"));
    const ReferenceTable values = strokePage().table(QStringLiteral("key of a command"));
    QStringList kinds;
    for (const QStringList& row : table.rows) {
        kinds << codesIn(row[0])[0];
        const core::Primitive::Kind kind = core::primitiveNamed(kinds.last().toStdString()).value();
        QStringList measures;
        for (const core::Primitive::Measure measure : core::measuresOf(kind))
            measures << QString::fromUtf8(core::name(measure));
        if (kind == core::Primitive::Kind::Lathe)
            measures << QStringLiteral("profile");
        if (kind == core::Primitive::Kind::Tube)
            measures << QStringLiteral("path");
        QStringList documented = codesIn(row[1]);
        documented.removeDuplicates();
        QCOMPARE(sorted(documented), sorted(measures));
        QString plain = withKey(QStringLiteral(R"({"command":"insert","edge_length":1})"), QStringLiteral("primitive"),
                                u'"' + kinds.last() + u'"');
        for (const QString& key : measures)
            plain = withKey(plain, key, valueFor(key));
        QVERIFY2(!refusalOf(plain), qPrintable(plain));
        const bool isTurned = !refusalOf(withKey(plain, QStringLiteral("axis"), QStringLiteral("\"z\"")));
        QVERIFY2(isTurned == core::hasAxis(kind), qPrintable(plain));
        for (const QString& key : measures)
            QVERIFY2(refusalOf(withoutKey(plain, key)), qPrintable(key));
        for (const QStringList& value : values.rows)
            for (const QString& key : codesIn(value[0]))
                if (measures.contains(key) && key != QLatin1String("profile") && key != QLatin1String("path"))
                    compareValues(key, value[1], [&](const QString& text) { return withKey(plain, key, text); });
    }
    QCOMPARE(kinds.size(), qsizetype(core::Primitive::kinds));
    QCOMPARE(page.table(QStringLiteral("`where`")).keys().size(), qsizetype(core::placeNames.size()));
    QCOMPARE(sorted(page.table(QStringLiteral("`combine`")).keys()), sorted(textsOf(core::combinationNames)));
}

void TestReference::words_ofStrokeFiles()
{
    const ReferencePage page(QStringLiteral("stroke-tools"));
    QCOMPARE(page.table(QStringLiteral("tool")).keys(), textsOf(core::toolNames()));
    for (const QStringList& row : page.table(QStringLiteral("tool")).rows)
        for (const QString& name : codesIn(row[0]))
            QVERIFY2(core::hasInverse(*core::named<core::Tool>(name.toStdString())) ==
                         !row[1].startsWith(QLatin1String("no")),
                     qPrintable(name));
    QCOMPARE(sorted(page.table(QStringLiteral("`topology`")).keys()),
             sorted(textsOf(core::valueNames<core::Topology>)));
    QCOMPARE(page.table(QStringLiteral("alpha of the program")).keys(), textsOf(core::builtInAlphas()));
    const QString airbrush =
        page.text(QStringLiteral("Tools")).filter(QStringLiteral("`airbrush` works with")).join(u' ');
    for (const std::string_view name : core::toolNames())
        QVERIFY2(codesIn(airbrush).contains(toText(name)) == core::canAirbrush(*core::named<core::Tool>(name)),
                 qPrintable(toText(name)));
}

void TestReference::formats_areThoseOfTheProgram()
{
    QStringList read, written;
    for (const QStringList& row : ReferencePage(QStringLiteral("formats")).table(QStringLiteral("format")).rows) {
        const QString ending = row[0].section(QRegularExpression(QStringLiteral("[, ]")), 0, 0).toLower();
        read << ending;
        if (row[2] != QLatin1String("no"))
            written << ending;
    }
    const std::span<const std::string_view> all = core::meshEndings(), some = core::writtenEndings();
    QCOMPARE(sorted(read), sorted(textsOf(all)));
    QCOMPARE(sorted(written), sorted(textsOf(some)));
}

void TestReference::presets_haveTheseKeys()
{
    const ReferencePage page(QStringLiteral("presets"));
    const QString example = page.examples(QStringLiteral("json")).value(0);
    core::BrushPreset all = core::parseBrush(example.toStdString());
    QCOMPARE(all.name, "Scales");
    all.chosen = {true, true, true, true};
    all.stroke.inverted = all.stroke.anchored = true;
    all.alphaImage = "AAAA";
    const QJsonObject written = QJsonDocument::fromJson(QByteArray::fromStdString(core::toJson(all))).object();
    const ReferenceTable ofStroke = page.table(QStringLiteral("key of its stroke"));
    compareKeys(written, page.table(QStringLiteral("key of a preset")));
    compareKeys(objectIn(written, "stroke"), ofStroke);

    const auto preset = [](const QString& stroke) {
        const QString file =
            QStringLiteral(R"({"format":"fettle-brush","version":1,"name":"a","stroke":%1})").arg(stroke);
        return core::toJson(core::parseBrush(file.toStdString()));
    };
    const QString plain = QStringLiteral(R"({"tool":"pull"})");
    for (const QStringList& row : ofStroke.rows)
        if (const QString standard = codesIn(row[1]).value(0); !standard.isEmpty())
            QCOMPARE(preset(withKey(plain, codesIn(row[0])[0], standard)), preset(plain));
    for (const QStringList& row : page.table(QStringLiteral("key of a preset")).rows)
        if (row[0] == QLatin1String("`radius_share`"))
            QCOMPARE(row[2], QStringLiteral("%1 to %2").arg(core::minPresetRadius).arg(core::maxPresetRadius));
}

void TestReference::lessons_haveTheseKeys()
{
    const ReferencePage page(QStringLiteral("lesson-file"));
    const QMap<QString, QStringList> keys = keysOfLessonReader();
    QCOMPARE(keys.size(), 6);
    const auto documented = [&page](const char* head) { return sorted(page.table(QString::fromLatin1(head)).keys()); };
    QCOMPARE(documented("key of a lesson"), sorted(keys[QString()]));
    QCOMPARE(documented("key of a step"), sorted(keys[QStringLiteral("steps")]));
    QCOMPARE(documented("key of a view"), sorted(keys[QStringLiteral("view")]));
    QCOMPARE(documented("key of a target"), sorted(keys[QStringLiteral("target")]));
}

void TestReference::lessons_haveTheseGoals()
{
    const ReferenceTable table = ReferencePage(QStringLiteral("lesson-file")).table(QStringLiteral("goal"));
    QStringList goals;
    for (const core::FactInfo& fact : core::factTable) {
        const QStringList row = table.rows.value(goals.size());
        goals << toText(fact.key);
        QCOMPARE(codesIn(row.value(0)), QStringList(goals.last()));
        if (goals.last() == QLatin1String("print_ready"))
            continue;
        QCOMPARE(plainRange(row.value(1)), QStringLiteral("0 to %1").arg(fact.max));
        QCOMPARE(row.value(1).contains(QStringLiteral("whole")), fact.isWhole);
    }
    QCOMPARE(table.keys(), goals << QStringLiteral("target"));
}

void TestReference::lessons_exampleIsRead()
{
    const ReferencePage page(QStringLiteral("lesson-file"));
    writeBytes(at("lesson.json"), page.examples(QStringLiteral("json")).value(0).toUtf8());
    writeBytes(at("pull.json"), page.examples(QStringLiteral("json")).value(1).toUtf8());
    QVERIFY(QImage(8, 8, QImage::Format_RGB32).save(at("step-1.png")));
    const core::Lesson lesson = core::readLesson(std::filesystem::path(m_folder->path().toStdString()));
    QCOMPARE(lesson.steps.size(), std::size_t(1));
    QVERIFY(lesson.steps[0].view && lesson.steps[0].checkpoint.target);
}

QString TestReference::readClass(const QString& text, ui::Classroom& classroom) const
{
    writeBytes(at("a.fettleclass"), text.toUtf8());
    try {
        classroom = app::ClassFile::read(at("a.fettleclass"));
    } catch (const app::ClassFileError& error) {
        return error.sentence;
    }
    return {};
}

void TestReference::classes_haveTheseKeys()
{
    const ReferencePage page(QStringLiteral("class-file"));
    QCOMPARE(app::ClassFile::write(at("a.fettleclass"), fullClass()), QString());
    QStringList keys;
    for (const QString& line : QString::fromUtf8(bytesAt(at("a.fettleclass"))).split(u'\n', Qt::SkipEmptyParts))
        if (!line.startsWith(u'#'))
            keys << line.section(u' ', 0, 0);
    QCOMPARE(sorted(page.table(QStringLiteral("key of a class")).keys()), sorted(keys));
    ui::Classroom classroom;
    QCOMPARE(readClass(page.examples(QStringLiteral("ini")).value(0), classroom), QString());
    QCOMPARE(classroom.names.size(), 3);
    QCOMPARE(classroom.lesson, QStringLiteral("first-clay"));
}

void TestReference::classes_haveTheseValues()
{
    const ReferencePage page(QStringLiteral("class-file"));
    QMap<QString, QString> lines;
    for (const QString& line : page.examples(QStringLiteral("ini")).value(0).split(u'\n', Qt::SkipEmptyParts))
        if (!line.startsWith(u'#'))
            lines.insert(line.section(u'=', 0, 0).trimmed(), line.section(u'=', 1).trimmed());
    lines[QStringLiteral("other_names")] = QStringLiteral("yes"); // "no" would need a list of names
    const auto textOf = [](const QMap<QString, QString>& entries) {
        QString text;
        for (auto i = entries.begin(); i != entries.end(); ++i)
            text += QStringLiteral("%1 = %2\n").arg(i.key(), i.value());
        return text;
    };
    for (const QStringList& row : page.table(QStringLiteral("key of a class")).rows) {
        const QString key = codesIn(row[0])[0], standard = codesIn(row[1]).value(0);
        QMap<QString, QString> changed = lines;
        changed.remove(key);
        ui::Classroom without, with;
        const QString missing = readClass(textOf(changed), without);
        QVERIFY2(missing.isEmpty() == (row[1] != QLatin1String("required")), qPrintable(key + missing));
        if (!standard.isEmpty()) {
            changed[key] = standard;
            QCOMPARE(readClass(textOf(changed), with), QString());
            QVERIFY2(with == without, qPrintable(key));
        }
        changed[key] = QStringLiteral("-1");
        const QString refusal = readClass(textOf(changed), with);
        if (row[2].startsWith(QLatin1String("whole number from 0 to 240")))
            QVERIFY2(refusal.contains(QStringLiteral("a whole number from 0 to 240, not")), qPrintable(refusal));
        else if (row[2].contains(QStringLiteral(", ")) && !standard.isEmpty())
            QVERIFY2(refusal.endsWith(QStringLiteral("is none of %1.").arg(row[2])), qPrintable(refusal));
    }
}

void TestReference::works_haveTheseFiles()
{
    const ReferencePage page(QStringLiteral("work-folder"));
    const QString outbox = at("waiting");
    const app::WorkArchive archive(at("class"), outbox);
    const app::ArchivedWork work = archive.add(fullWork());
    QVERIFY2(work.problem.isEmpty(), qPrintable(work.problem));
    app::TurnAnswers answers{QStringLiteral("7"), {}};
    for (std::optional<int>& answer : answers.questionnaire.answers)
        answer = 4;
    QCOMPARE(answers.write(work.folder), QString());
    QCOMPARE(sorted(page.table(QStringLiteral("file")).keys()),
             QDir(work.folder).entryList(QDir::Files | QDir::Hidden, QDir::Name));
    QVERIFY(page.text(page.sections().first()).join(u' ').contains(QFileInfo(work.folder).fileName()));
    const QJsonObject turn = jsonAt(work.folder + QStringLiteral("/turn.json"));
    compareKeys(turn, page.table(QStringLiteral("key of a turn")));
    compareKeys(objectIn(turn, "lesson"), page.table(QStringLiteral("key of its lesson")));
    compareKeys(objectIn(objectIn(turn, "lesson"), "goals"),
                ReferencePage(QStringLiteral("lesson-output")).table(QStringLiteral("field of a goal")));
    compareKeys(objectIn(jsonAt(work.folder + QStringLiteral("/answers.json")), "answers"),
                page.table(QStringLiteral("key of the answers")));
    QCOMPARE(QImage(work.folder + QStringLiteral("/picture.png")).size(), QSize(512, 512));
}

void TestReference::works_examplesAreRead()
{
    const QStringList examples = ReferencePage(QStringLiteral("work-folder")).examples(QStringLiteral("json"));
    writeBytes(at("turn.json"), examples.value(0).toUtf8());
    writeBytes(at("answers.json"), examples.value(1).toUtf8());
    const app::TurnFacts turn = app::WorkArchive::turnOf(m_folder->path());
    QCOMPARE(turn.pupil, QStringLiteral("Anna"));
    QVERIFY(turn.seconds() && turn.lesson && turn.lesson->verdict.isMet());
    const app::TurnAnswers answers = app::TurnAnswers::read(m_folder->path());
    QCOMPARE(answers.problem, QString());
    QCOMPARE(answers.turnId, turn.id);
    for (const std::optional<int>& answer : answers.questionnaire.answers)
        QVERIFY(answer);
}

void TestReference::glb_hasTheseKeys()
{
    const ReferencePage page(QStringLiteral("glb-extension"));
    core::writeMesh(at("a.glb").toStdString(), shapes::cube(20), {.metadata = fullMetadata()});
    const QJsonObject json = objectIn(objectIn(jsonOfGlb(at("a.glb")), "extensions"), "FETTLE_document");
    const auto table = [&page](const char* head) { return page.table(QString::fromLatin1(head)); };
    compareKeys(json, table("key of the extension"));
    compareKeys(objectIn(json, "view"), table("key of the view"));
    compareKeys(objectIn(json, "work"), table("key of the work"));
    compareKeys(objectIn(json, "references"), table("key of a reference"));
    compareKeys(objectIn(json, "parts"), table("key of a part"));
    for (const QString& key : objectIn(json, "brush").keys())
        QVERIFY2(strokeTable().keys().contains(key), qPrintable(key));
}

void TestReference::glb_exampleIsRead()
{
    core::writeMesh(at("a.glb").toStdString(), shapes::cube(20), {.metadata = fullMetadata()});
    const QString example = ReferencePage(QStringLiteral("glb-extension")).examples(QStringLiteral("json")).value(0);
    replaceExtension(at("a.glb"), QJsonDocument::fromJson(example.toUtf8()).object());
    const core::DocumentMetadata read = core::readMetadata(at("a.glb").toStdString());
    QCOMPARE(read.palette.size(), std::size_t(2));
    QVERIFY(read.frame && read.view && read.brush && read.work);
    QCOMPARE(read.references.size(), std::size_t(1));
    QCOMPARE(read.place().z(), 250000.0);
    QVERIFY(read.frame->parts.all().front().tag == core::Rgb({255, 0, 0}));
    QCOMPARE(read.brush->tool, core::Tool::Clay);
    QCOMPARE(read.work->strokes, std::uint64_t(120));
}

FETTLE_TEST(TestReference, QCoreApplication)
#include "tst_reference.moc"
