// Tests lessons as files: what is restored, and what is refused.
#include "core/io/mesh_io.h"
#include "core/lesson/lesson_file.h"
#include "core/primitives/starter_models.h"
#include "tests/support/test_main.h"

#include <nlohmann/json.hpp>

#include <QTemporaryDir>
#include <QTest>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

#include <zip.h>

using namespace core;
using Json = nlohmann::json;
using Kind = LessonError::Kind;

namespace
{
const std::string png = "\x89PNG\r\n\x1a\n...";
const std::string strokes =
    R"({"format":"fettle-strokes","version":1,"strokes":[{"tool":"pull","radius":9,
        "samples":[{"position":[0,50,0]}]}]})";

Json text(const char* words)
{
    return {{"en", words}};
}

Json least()
{
    return {{"format", "fettle-lesson"},
            {"version", 1},
            {"title", text("A")},
            {"start", "ball"},
            {"steps", {{{"title", text("B")}, {"text", text("C")}}}}};
}

/// Returns a lesson with every possible key.
Json full()
{
    Json lesson = least();
    lesson["title"]["de"] = "Ä";
    lesson["summary"] = {{"zh_CN", "泥"}};
    lesson["start"] = {{"file", "models/start.stl"}};
    lesson["steps"][0].update({{"picture", "a.png"},
                               {"tools", {"pull", "smooth"}},
                               {"view", {{"yaw_deg", -30}, {"pitch_deg", 12.5}}},
                               {"strokes", "strokes/one.json"},
                               {"checkpoint",
                                {{"genus", 1},
                                 {"height_mm", {{"least", 60.1}}},
                                 {"volume_mm3", {{"most", 1e6}}},
                                 {"width_mm", {{"least", 1}, {"most", 1e3}}},
                                 {"feet", 4},
                                 {"base_mm2", {{"least", 12.5}}},
                                 {"print_ready", true},
                                 {"target", {{"file", "models/start.stl"}, {"tolerance_mm", 0.1}}}}}});
    lesson["steps"].push_back({{"title", text("D")},
                               {"text", text("E")},
                               {"strokes", "strokes/two.json"},
                               {"checkpoint", {{"target", {{"tolerance_mm", 2}}}}}});
    return lesson;
}

std::string stl()
{
    static const std::string bytes = [] {
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath(QStringLiteral("a.stl")).toStdString();
        writeMesh(path, icosphere(2, 50));
        std::ifstream file(path, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    }();
    return bytes;
}

/// Files of a lesson's folder; key: path.
using Content = std::map<std::string, std::string>;

Content contentOf(const Json& lesson)
{
    return {{"lesson.json", lesson.dump()},
            {"a.png", png},
            {"models/start.stl", stl()},
            {"strokes/one.json", strokes},
            {"strokes/two.json", strokes}};
}

LessonFiles filesOf(const Content& content)
{
    return {"a.zip", [content](const std::string& name, std::size_t most) -> std::optional<std::string> {
                const auto found = content.find(name);
                return found == content.end() ? std::nullopt : std::optional(found->second.substr(0, most + 1));
            }};
}

std::optional<LessonError> errorOf(const std::function<void()>& read)
{
    try {
        read();
    } catch (const LessonError& error) {
        return error;
    }
    return std::nullopt;
}

std::optional<LessonError> errorOf(const Content& content)
{
    return errorOf([&] { readLesson(filesOf(content)); });
}

std::optional<FileErrorKind> fileErrorOf(const std::function<void()>& act)
{
    try {
        act();
    } catch (const FileError& error) {
        return error.kind;
    }
    return std::nullopt;
}

void write(const std::filesystem::path& path, const std::string& bytes)
{
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << bytes;
}

std::string bytesOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
}

/// Packs a zip as another program might.
void pack(const std::filesystem::path& path, const Content& content, const std::string& folder = {})
{
    zip_t* const archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
    for (const auto& [name, bytes] : content)
        zip_file_add(archive, (folder + name).c_str(), zip_source_buffer(archive, bytes.data(), bytes.size(), 0),
                     ZIP_FL_ENC_UTF_8);
    zip_close(archive);
}

/// Returns everything in a lesson as one text, for comparison.
std::string whole(const Lesson& lesson)
{
    std::string all = lessonJson(lesson);
    for (const LessonStep& step : lesson.steps)
        all += strokesText(step);
    for (const auto& [name, bytes] : lesson.files)
        all += name + bytes;
    return all;
}
} // namespace

class TestLessonFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void values_arriveWhereTheyBelong()
    {
        const Lesson lesson = readLesson(filesOf(contentOf(full())));
        QCOMPARE(lesson.title.in("de"), std::string("Ä"));
        QCOMPARE(std::get<std::string>(lesson.start), std::string("models/start.stl"));
        QCOMPARE(lesson.steps.size(), std::size_t(2));
        const LessonStep& step = lesson.steps[0];
        QCOMPARE(step.tools, (std::vector{Tool::Pull, Tool::Smooth}));
        QCOMPARE(step.strokes.size(), std::size_t(1));
        QCOMPARE(std::get<Stroke>(step.strokes[0]).settings.radius, 9.0);
        const std::vector<FactBounds> facts = {{Fact::Genus, 1, 1},     {Fact::Height, 60.1},   {Fact::Width, 1, 1e3},
                                               {Fact::Feet, 4, 4},      {Fact::BaseArea, 12.5}, {Fact::Volume, 0, 1e6},
                                               {Fact::PrintReady, 1, 1}};
        QCOMPARE(step.checkpoint.facts, facts);
        QVERIFY(step.view == std::optional(LessonView{-30, 12.5}) && !lesson.steps[1].view);
        QCOMPARE(step.checkpoint.target->file, std::string("models/start.stl"));
        QCOMPARE(step.checkpoint.target->tolerance, 0.1);
        QVERIFY(lesson.steps[1].checkpoint.target->file.empty());
        QCOMPARE(lesson.files.at(step.picture), png);
        QCOMPARE(modelIn(lesson, "models/start.stl").triangles.size(), icosphere(2, 50).triangles.size());
        QCOMPARE(std::get<Starter>(readLesson(filesOf(contentOf(least()))).start), Starter::Ball);
    }

    void missingLanguage_fallsBack()
    {
        const LessonText text{{{"en", "e"}, {"de", "d"}, {"pt_BR", "b"}}};
        QCOMPARE(text.in("de_AT"), std::string("d"));
        QCOMPARE(text.in("pt_BR"), std::string("b"));
        QCOMPARE(text.in("fr"), std::string("e"));
        QCOMPARE(text.in(""), std::string("e"));
        QCOMPARE((LessonText{{{"zh", "z"}}}).in("de"), std::string("z"));
        QCOMPARE(LessonText().in("de"), std::string());
    }

    void writing_andReadingGivesTheSameBits_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("folder") << QStringLiteral("lesson");
        QTest::newRow("zip") << QStringLiteral("lesson.zip");
    }
    void writing_andReadingGivesTheSameBits()
    {
        QFETCH(QString, name);
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath(name).toStdString();
        const Lesson lesson = readLesson(filesOf(contentOf(full())));
        writeLesson(path, lesson);
        const Lesson again = readLesson(path);
        QCOMPARE(whole(again), whole(lesson));
        const std::filesystem::path second = folder.filePath(QStringLiteral("second") + name).toStdString();
        writeLesson(second, again);
        if (std::filesystem::is_regular_file(path))
            QCOMPARE(bytesOf(second), bytesOf(path));
    }

    void writing_leavesWhatIsThere()
    {
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath(QStringLiteral("lesson")).toStdString();
        const Lesson lesson = readLesson(filesOf(contentOf(full())));
        writeLesson(path, lesson);
        write(path / "mine.txt", "mine");
        QCOMPARE(fileErrorOf([&] { writeLesson(path, lesson); }), std::optional(FileErrorKind::WriteFailed));
        QCOMPARE(bytesOf(path / "mine.txt"), std::string("mine"));
        QCOMPARE(fileErrorOf([&] { writeLesson(path / "no" / "folder", lesson); }),
                 std::optional(FileErrorKind::NoFolder));
        QCOMPARE(fileErrorOf([&] { writeLesson(path / "no" / "a.zip", lesson); }),
                 std::optional(FileErrorKind::NoFolder));
        std::size_t entries = 0;
        for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path.parent_path()))
            ++entries;
        QCOMPARE(entries, std::size_t(1)); // no temporary file remains
    }

    void zip_mayHoldTheFolder()
    {
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath(QStringLiteral("a.zip")).toStdString();
        pack(path, contentOf(full()), "my lesson/");
        QCOMPARE(whole(readLesson(path)), whole(readLesson(filesOf(contentOf(full())))));
    }

    void refuses_data();
    void refuses();

    void refusal_namesFileStepAndKey()
    {
        Json lesson = full();
        lesson["steps"][1]["checkpoint"]["genus"] = -1;
        const LessonError error = errorOf(contentOf(lesson)).value();
        QCOMPARE(error.step, std::optional<std::size_t>(1));
        QCOMPARE(error.key, std::string("genus"));
        QCOMPARE(error.path, std::filesystem::path("a.zip"));
        Content content = contentOf(full());
        content["strokes/two.json"] =
            R"({"format":"fettle-strokes","version":1,"strokes":[{"tool":"pull","radius":-9,
                "samples":[{"position":[0,50,0]}]}]})";
        const LessonError inStrokes = errorOf(content).value();
        QCOMPARE(inStrokes.kind, Kind::Strokes);
        QCOMPARE(inStrokes.file, std::string("strokes/two.json"));
        QCOMPARE(inStrokes.step, std::optional<std::size_t>(1));
        QCOMPARE(inStrokes.strokes->stroke, std::optional<std::size_t>(0));
        QCOMPARE(inStrokes.strokes->key, std::string("radius"));
        content["lesson.json"] = "{\n\"format\": oh";
        const LessonError syntax = errorOf(content).value();
        QCOMPARE(syntax.kind, Kind::Syntax);
        QCOMPARE(syntax.line, std::size_t(2));
    }

    /// Built-in alphas are allowed. Strokes that need other files are refused.
    void strokesThatNeedFiles_areRefused()
    {
        const auto errorWith = [](const std::string& entry) {
            Content content = contentOf(full());
            content["strokes/one.json"] = R"({"format":"fettle-strokes","version":1,"strokes":[)" + entry + "]}";
            return errorOf(content);
        };
        const std::string stroke = R"({"tool":"clay","radius":9,"samples":[{"position":[0,50,0]}])";
        QVERIFY(!errorWith(stroke + R"(,"alpha":"pores"})"));
        QVERIFY(!errorWith(R"({"command":"place_on_bed"})"));
        for (const char* const needs : {R"(,"alpha":"mine.png"})", R"(,"model":"mine.stl"})"})
            QCOMPARE(errorWith(stroke + needs)->kind, Kind::NamesFiles);
        const LessonError insertion = errorWith(stroke + R"(},{"command":"insert","file":"mine.stl"})").value();
        QCOMPARE(insertion.kind, Kind::NamesFiles);
        QCOMPARE(insertion.strokes->stroke, std::optional<std::size_t>(1));
    }

    void newerVersion_isTold()
    {
        Json lesson = least();
        lesson["version"] = 7;
        lesson["more"] = 1;
        const LessonError error = errorOf(contentOf(lesson)).value();
        QCOMPARE(error.kind, Kind::Newer);
        QCOMPARE(error.version, std::uint64_t(7));
    }

    /// A zip truncated anywhere is refused, either as truncated or as containing no lesson.
    void cutOffZip_isRefused()
    {
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath(QStringLiteral("a.zip")).toStdString();
        writeLesson(path, readLesson(filesOf(contentOf(least()))));
        const std::string all = bytesOf(path);
        for (std::size_t size = 0; size < all.size(); ++size) {
            write(path, all.substr(0, size));
            const auto read = [&] { readLesson(path); };
            bool isRefused = false;
            try {
                read();
            } catch (const FileError& error) {
                isRefused = error.kind == FileErrorKind::CutOff || error.kind == FileErrorKind::Empty;
            } catch (const LessonError& error) {
                isRefused = error.kind == Kind::NoLesson;
            }
            QVERIFY2(isRefused, std::to_string(size).c_str());
        }
    }

    /// A zip is refused if its unpacked content is too large for the size of the zip.
    void bomb_isRefused()
    {
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath(QStringLiteral("a.zip")).toStdString();
        Content content = contentOf(least());
        content["lesson.json"] += std::string(std::size_t(20) << 20, ' ');
        pack(path, content);
        QVERIFY(std::filesystem::file_size(path) < 1 << 20);
        QCOMPARE(fileErrorOf([&] { readLesson(path); }), std::optional(FileErrorKind::UnpacksTooLarge));
        content["lesson.json"].resize(std::size_t(2) << 20);
        pack(path, content);
        QCOMPARE(errorOf([&] { readLesson(path); })->kind, Kind::TooLarge);
    }

    void pathsAndLinksOutOfTheFolder_areRefused()
    {
        const QTemporaryDir outer;
        const std::filesystem::path folder = outer.filePath(QStringLiteral("lesson")).toStdString();
        for (const auto& [name, bytes] : contentOf(full()))
            write(folder / name, bytes);
        QVERIFY(!errorOf([&] { readLesson(folder); }));
        write(folder.parent_path() / "secret.png", png);
        std::filesystem::remove(folder / "a.png");
        std::filesystem::create_symlink(folder.parent_path() / "secret.png", folder / "a.png");
        QCOMPARE(errorOf([&] { readLesson(folder); })->kind, Kind::BadName);
        std::filesystem::remove(folder / "a.png");
        // the target is inside the lesson's folder
        std::filesystem::create_symlink("models/../b.png", folder / "a.png");
        write(folder / "b.png", png);
        QVERIFY(!errorOf([&] { readLesson(folder); }));
    }

    void whatIsNoLesson_isTold()
    {
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.path().toStdString();
        QCOMPARE(errorOf([&] { readLesson(path); })->kind, Kind::NoLesson);
        QCOMPARE(fileErrorOf([&] { readLesson(path / "none"); }), std::optional(FileErrorKind::NotFound));
        write(path / "a.zip", stl());
        QCOMPARE(errorOf([&] { readLesson(path / "a.zip"); })->kind, Kind::NoLesson);
        pack(path / "b.zip", {{"readme.txt", "no"}});
        QCOMPARE(errorOf([&] { readLesson(path / "b.zip"); })->kind, Kind::NoLesson);
        Content many = contentOf(least());
        for (std::size_t i = 0; i <= LessonLimits::maxPackedFiles; ++i)
            many["f" + std::to_string(i)] = "";
        pack(path / "c.zip", many);
        QCOMPARE(errorOf([&] { readLesson(path / "c.zip"); })->kind, Kind::TooMany);
    }

    /// Tests lessons with bytes changed, removed or duplicated at random: each must be read or refused with a typed
    /// error.
    void strangersBytes_areTakenOrRefused()
    {
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath(QStringLiteral("a.zip")).toStdString();
        std::mt19937_64 random(7);
        const auto spoil = [&](std::string bytes) {
            for (std::size_t changes = 1 + random() % 4; changes > 0 && !bytes.empty(); --changes) {
                const std::size_t at = random() % bytes.size(), count = 1 + random() % 9;
                switch (random() % 3) {
                case 0:
                    bytes[at] = static_cast<char>(random());
                    break;
                case 1:
                    bytes.erase(at, count);
                    break;
                default:
                    bytes.insert(random() % bytes.size(), bytes.substr(at, count));
                }
            }
            return bytes;
        };
        std::size_t taken = 0, refused = 0;
        const auto count = [&](const std::function<void()>& read) {
            try {
                read();
                ++taken;
            } catch (const LessonError&) {
                ++refused;
            } catch (const FileError&) {
                ++refused;
            }
        };
        Content content = contentOf(full());
        writeLesson(path, readLesson(filesOf(content)));
        const std::string zipped = bytesOf(path);
        for (int i = 0; i < 1500; ++i) {
            Content spoiled = content;
            spoiled["lesson.json"] = spoil(content["lesson.json"]);
            spoiled["strokes/one.json"] = spoil(content["strokes/one.json"]);
            count([&] { readLesson(filesOf(spoiled)); });
            write(path, spoil(zipped));
            count([&] { readLesson(path); });
        }
        QVERIFY(refused > 1000);
        QVERIFY(taken > 0);
    }

    /// An unreadable start model is reported with its own error.
    void brokenModel_isTold()
    {
        Content content = contentOf(full());
        content["models/start.stl"] = "solid but no more";
        QVERIFY(fileErrorOf([&] { readLesson(filesOf(content)); }).has_value());
        content["models/start.stl"] = stl().substr(0, stl().size() - 50);
        QCOMPARE(fileErrorOf([&] { readLesson(filesOf(content)); }), std::optional(FileErrorKind::CutOff));
        std::string open = stl().substr(0, stl().size() - 50);
        const auto left = static_cast<std::uint32_t>((open.size() - 84) / 50);
        std::memcpy(open.data() + 80, &left, sizeof left); // the file announces one triangle less
        content["models/start.stl"] = open;
        const LessonError error = errorOf(content).value();
        QCOMPARE(error.kind, Kind::Unsound);
        QVERIFY(!error.report.closed);
    }
};

void TestLessonFile::refuses_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<Kind>("kind");
    const auto row = [](const char* name, Kind kind, const std::function<void(Json&)>& change) {
        Json lesson = full();
        change(lesson);
        QTest::newRow(name) << QByteArray::fromStdString(lesson.dump()) << kind;
    };
    const auto step = [&](const char* name, Kind kind, const char* key, const Json& value) {
        row(name, kind, [&](Json& lesson) { lesson["steps"][0][key] = value; });
    };
    const auto fact = [&](const char* name, Kind kind, const char* key, const Json& value) {
        step(name, kind, "checkpoint", {{key, value}});
    };
    row("other format", Kind::NotALesson, [](Json& lesson) { lesson["format"] = "fettle-strokes"; });
    row("a list", Kind::NotALesson, [](Json& lesson) { lesson = Json::array(); });
    row("version 0", Kind::OutOfRange, [](Json& lesson) { lesson["version"] = 0; });
    row("version by name", Kind::WrongType, [](Json& lesson) { lesson["version"] = "one"; });
    row("unknown key", Kind::UnknownKey, [](Json& lesson) { lesson["author"] = "me"; });
    row("no title", Kind::MissingKey, [](Json& lesson) { lesson.erase("title"); });
    row("no start", Kind::MissingKey, [](Json& lesson) { lesson.erase("start"); });
    row("no steps", Kind::WrongType, [](Json& lesson) { lesson["steps"] = Json::array(); });
    row("a step that is none", Kind::WrongType, [](Json& lesson) { lesson["steps"][0] = 5; });
    row("steps without end", Kind::TooMany,
        [](Json& lesson) { lesson["steps"] = Json(LessonLimits::maxSteps + 1, lesson["steps"][0]); });
    row("no language", Kind::NoWords, [](Json& lesson) { lesson["title"] = Json::object(); });
    row("no words", Kind::NoWords, [](Json& lesson) { lesson["title"]["de"] = "  "; });
    row("odd language", Kind::UnknownKey, [](Json& lesson) { lesson["title"]["../de"] = "a"; });
    row("a number for words", Kind::WrongType, [](Json& lesson) { lesson["title"]["de"] = 5; });
    row("a book", Kind::TooLong,
        [](Json& lesson) { lesson["title"]["de"] = std::string(LessonLimits::maxTextBytes + 1, 'a'); });
    row("unknown starter", Kind::UnknownValue, [](Json& lesson) { lesson["start"] = "cow"; });
    row("start without file", Kind::MissingKey, [](Json& lesson) { lesson["start"] = Json::object(); });
    step("unknown key in a step", Kind::UnknownKey, "sound", "a.mp3");
    step("unknown tool", Kind::UnknownValue, "tools", {"pull", "saw"});
    step("a tool twice", Kind::UnknownValue, "tools", {"pull", "pull"});
    step("no tools", Kind::WrongType, "tools", Json::array());
    step("missing file", Kind::MissingFile, "picture", "b.png");
    step("no picture", Kind::NotAPicture, "picture", "strokes/one.json");
    for (const char* const name : {"../a.png", "/etc/passwd", "models/../../a.png", "C:a.png", "C:/a.png",
                                   "models\\a.png", "./a.png", "a//b.png", "", "a\nb.png"})
        step(name[0] ? name : "empty name", Kind::BadName, "picture", name);
    step("strokes outside", Kind::BadName, "strokes", "../one.json");
    step("no strokes", Kind::Strokes, "strokes", "a.png");
    step("half a view", Kind::MissingKey, "view", {{"yaw_deg", 5}});
    step("a view by name", Kind::WrongType, "view", "front");
    step("beyond above", Kind::OutOfRange, "view", {{"yaw_deg", 5}, {"pitch_deg", 91}});
    step("unknown key in a view", Kind::UnknownKey, "view", {{"yaw_deg", 5}, {"pitch_deg", 9}, {"roll_deg", 1}});
    step("empty checkpoint", Kind::WrongType, "checkpoint", Json::object());
    fact("unknown fact", Kind::UnknownKey, "beauty", 5);
    fact("half a hole", Kind::WrongType, "genus", 0.5);
    fact("half a foot", Kind::WrongType, "feet", {{"least", 3.5}});
    fact("a base beyond all", Kind::OutOfRange, "base_mm2", 1e13);
    fact("fewer than none", Kind::OutOfRange, "height_mm", -1);
    fact("beyond all", Kind::OutOfRange, "height_mm", {{"most", 1e9}});
    fact("least above most", Kind::WrongType, "height_mm", {{"least", 2}, {"most", 1}});
    fact("no bounds", Kind::WrongType, "height_mm", Json::object());
    fact("not to be ready", Kind::WrongType, "print_ready", false);
    fact("no tolerance", Kind::MissingKey, "target", Json::object());
    fact("tolerance 0", Kind::OutOfRange, "target", {{"tolerance_mm", 0}});
    fact("target outside", Kind::BadName, "target", {{"file", "../a.stl"}, {"tolerance_mm", 1}});
    QTest::newRow("twice") << QByteArray(R"({"format":"fettle-lesson","version":1,"version":1})") << Kind::DuplicateKey;
    QTest::newRow("brackets") << QByteArray(R"({"format":)") + QByteArray(100'000, '[') << Kind::TooDeep;
    QTest::newRow("a number without end")
        << QByteArray(R"({"format":"fettle-lesson","version":1e999})") << Kind::Syntax;
    QTest::newRow("bytes") << QByteArray("\xff\xfe\0\0", 4) << Kind::Syntax;
}

void TestLessonFile::refuses()
{
    QFETCH(QByteArray, json);
    QFETCH(Kind, kind);
    Content content = contentOf(full());
    content["lesson.json"] = json.toStdString();
    const auto error = errorOf(content);
    QVERIFY(error.has_value());
    QCOMPARE(error->kind, kind);
}

FETTLE_TEST(TestLessonFile)
#include "tst_lesson_file.moc"
