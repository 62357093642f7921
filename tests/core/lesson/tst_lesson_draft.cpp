// Tests that a lesson changed by its editor can still be written, read and played to its end.
#include "core/lesson/lesson_check.h"
#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_file.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>

using namespace core;

namespace
{
const std::string picture = "\x89PNG\r\n\x1a\n and so on";

LessonDraft draftOf(const char* name)
{
    return LessonDraft(readLesson(std::filesystem::path(FETTLE_SOURCE_DIR "/resources/lessons") / name));
}

/// Writes the lesson and reads it again.
Lesson readBack(const Lesson& lesson)
{
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath(QStringLiteral("lesson.zip")).toStdString();
    writeLesson(path, lesson);
    return readLesson(path);
}

/// Result of playing a lesson: the check of each step, the step indices in the order in which they were played, and the
/// hash and the first defect of the last model.
struct Played
{
    std::vector<StepCheck> checks;
    std::vector<std::size_t> seen;
    std::uint64_t hash = 0;
    std::string unsoundness;
};

Played play(const Lesson& lesson)
{
    Played played;
    LessonPlayback playback(std::make_shared<const Lesson>(lesson), "lesson");
    played.checks = checkLesson(playback, [&](std::size_t step, const TriangleMesh&) { played.seen.push_back(step); });
    played.unsoundness = mesh_asserts::unsoundness(playback.mesh());
    played.hash = playback.mesh().meshHash();
    return played;
}

bool isMet(const Played& played)
{
    return played.unsoundness.empty() && std::ranges::all_of(played.checks, [](const StepCheck& check) {
               return check.idle.empty() && check.verdict.isMet();
           });
}
} // namespace

class TestLessonDraft : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// A lesson that was opened and not changed gives the same model bit for bit, meets its checkpoints, and keeps its
    /// texts.
    void unchanged_isTheSameLesson_data()
    {
        QTest::addColumn<QByteArray>("name");
        for (const char* name : {"first-clay", "mug", "creature", "toy-car"})
            QTest::newRow(name) << QByteArray(name);
    }
    void unchanged_isTheSameLesson()
    {
        QFETCH(QByteArray, name);
        const LessonDraft draft = draftOf(name.constData());
        QVERIFY(!draft.missing());
        const Lesson back = readBack(draft.complete(std::vector(draft.steps(), picture)));
        const Played before = play(draft.lesson()), after = play(back);
        QCOMPARE(after.hash, before.hash);
        QCOMPARE(after.seen.size(), draft.steps());
        QVERIFY(isMet(after));
        for (std::size_t i = 0; i < draft.steps(); ++i) {
            QCOMPARE(back.steps[i].text.words, draft.step(i).text.words);
            QCOMPARE(back.files.at(back.steps[i].picture), picture);
        }
    }

    void renamed_inOneLanguageLeavesTheOthers()
    {
        LessonDraft draft = draftOf("mug");
        const std::string german = draft.step(1).title.in("de");
        draft.setTitle("en", "A cup");
        draft.setStepTitle(1, "en", "Another");
        draft.setStepText(1, "fr", "Creuse.");
        draft.setSummary("en", "  ");
        const Lesson back = readBack(draft.complete({}));
        QCOMPARE(back.title.in("en"), std::string("A cup"));
        QCOMPARE(back.steps[1].title.in("en"), std::string("Another"));
        QCOMPARE(back.steps[1].title.in("de"), german);
        QCOMPARE(back.steps[1].text.in("fr_CA"), std::string("Creuse."));
        QVERIFY(!back.summary.words.contains("en"));
    }

    /// Steps can change their order. Each keeps its texts and its checkpoint.
    void reordered_isPlayedInTheNewOrder()
    {
        LessonDraft draft = draftOf("first-clay");
        const std::string first = draft.step(0).title.in("en"), second = draft.step(1).title.in("en");
        const std::uint64_t before = play(draft.lesson()).hash;
        draft.moveStep(0, 1);
        QCOMPARE(draft.step(0).title.in("en"), second);
        QCOMPARE(draft.step(1).title.in("en"), first);
        const Lesson back = readBack(draft.complete({}));
        const Played turned = play(back);
        QVERIFY(turned.unsoundness.empty() && turned.hash != before);
        draft.moveStep(1, 0);
        QCOMPARE(play(readBack(draft.complete({}))).hash, before);
    }

    /// The creature does not stand without its legs. The checkpoint fails, and the lesson can still be played.
    void cut_isSaidWhereItMatters()
    {
        LessonDraft draft = draftOf("creature");
        const std::size_t strokes = draft.strokes();
        while (!draft.step(0).strokes.empty())
            draft.cutStroke(0, 0);
        QVERIFY(draft.strokes() < strokes);
        const Lesson back = readBack(draft.complete({}));
        QVERIFY(back.steps[0].strokesFile.empty());
        const Played played = play(back);
        QVERIFY(played.unsoundness.empty());
        QCOMPARE(played.checks.size(), draft.steps());
        QVERIFY(!played.checks[0].verdict.isMet());
    }

    /// A stroke that does not touch the model is reported by its index.
    void strokeThatMeetsNothing_isIdle()
    {
        LessonDraft draft = draftOf("first-clay");
        Stroke inTheAir = std::get<Stroke>(draft.step(0).strokes[0]);
        inTheAir.settings.brush = BrushShape::Sphere;
        inTheAir.settings.place = Placement::Point;
        inTheAir.settings.add = false;
        inTheAir.settings.radius = 5;
        inTheAir.samples.assign(1, StrokeSample());
        inTheAir.samples[0].position = Vec3(0, 200, 0);
        draft.addStroke(0, inTheAir);
        const Played played = play(readBack(draft.complete({})));
        QCOMPARE(played.checks[0].idle, std::vector{draft.step(0).strokes.size() - 1});
        QVERIFY(played.checks[1].idle.empty());
        QVERIFY(std::holds_alternative<Stroke>(draft.takeLastStroke(0)));
        QVERIFY(play(draft.complete({})).checks[0].idle.empty());
    }

    /// The step's view is the one at its first entry. Each tool has the brush of its first stroke.
    void firstStroke_saysViewAndBrush()
    {
        LessonDraft draft;
        draft.addStep();
        Stroke stroke;
        stroke.settings.radius = 9;
        stroke.settings.strength = 0.5;
        draft.addStroke(0, FileCommand{PlaceOnBed{}, {}}, LessonView{10, 20});
        draft.addStroke(0, stroke, LessonView{50, 60});
        stroke.settings.radius = 3;
        draft.addStroke(0, stroke);
        stroke.settings.tool = Tool::Smooth;
        draft.addStroke(0, stroke);
        QVERIFY(draft.step(0).view == std::optional(LessonView{10, 20}));
        const std::vector<LessonBrush> brushes = brushesOf(draft.step(0));
        QCOMPARE(brushes.size(), std::size_t(2));
        QVERIFY(brushes[0].tool == Tool::Pull && brushes[0].radius == 9 && brushes[0].strength == 0.5);
        QVERIFY(brushes[1].tool == Tool::Smooth && brushes[1].radius == 3);
    }

    void removedAndNewSteps_areCompletedBeforeTheyAreWritten()
    {
        LessonDraft draft;
        QCOMPARE(draft.missing()->what, LessonDraft::Required::Title);
        draft.setTitle("de", "Leer");
        QCOMPARE(draft.missing()->what, LessonDraft::Required::Steps);
        draft.addStep();
        draft.addStep();
        draft.setStepTitle(0, "de", "Eins");
        QCOMPARE(draft.missing()->what, LessonDraft::Required::StepText);
        draft.setStepText(0, "de", "Tun.");
        QCOMPARE(draft.missing()->what, LessonDraft::Required::StepTitle);
        QCOMPARE(draft.missing()->step, std::size_t(1));
        draft.removeStep(1);
        QVERIFY(!draft.missing());
        const Lesson back = readBack(draft.complete({}));
        QCOMPARE(back.steps.size(), std::size_t(1));
        QCOMPARE(back.title.in("en"), std::string("Leer"));
    }

    void checkpointAndTools_comeBackAsTheyWereSet()
    {
        LessonDraft draft = draftOf("first-clay");
        draft.setTools(0, {Tool::Smooth, Tool::Pull});
        draft.setTools(1, std::vector<Tool>(draft.step(1).tools));
        draft.setFact(0, {Fact::Height, 60, 80});
        draft.setFact(0, {Fact::Genus, 1, 1});
        draft.setFact(0, {Fact::Genus, 0, 0});
        draft.setFact(0, {Fact::Components, 0, FactBounds::unbounded});
        draft.setFact(0, {Fact::PrintReady, 1, 1});
        draft.setTolerance(0, 2.5);
        draft.setTolerance(1, 0);
        const Lesson back = readBack(draft.complete({}));
        QCOMPARE(back.steps[0].tools, (std::vector{Tool::Pull, Tool::Smooth}));
        const LessonDraft again(back);
        QCOMPARE(again.fact(0, Fact::Height), (FactBounds{Fact::Height, 60, 80}));
        QCOMPARE(again.fact(0, Fact::Genus), (FactBounds{Fact::Genus, 0, 0}));
        QVERIFY(!again.fact(0, Fact::Components));
        QVERIFY(again.fact(0, Fact::PrintReady));
        QCOMPARE(back.steps[0].checkpoint.target->tolerance, 2.5);
        QVERIFY(!back.steps[1].checkpoint.target);
        LessonDraft all = draft;
        std::vector<Tool> every;
        for (const std::string_view name : toolNames())
            every.push_back(*named<Tool>(name));
        all.setTools(0, every);
        QVERIFY(all.step(0).tools.empty());
    }

    /// A picture chosen by the author is kept. Generated pictures are made again, and unused files are removed.
    void pictures_ofOnesOwnStay()
    {
        Lesson lesson = draftOf("first-clay").lesson();
        lesson.files["photo.png"] = picture + "photo";
        lesson.files["forgotten.png"] = picture;
        lesson.steps[1].picture = "photo.png";
        const LessonDraft draft(lesson);
        QVERIFY(draft.makesPicture(0) && !draft.makesPicture(1));
        const Lesson complete = draft.complete({picture + "1", picture + "2", "", picture + "4"});
        QCOMPARE(complete.files.at(complete.steps[0].picture), picture + "1");
        QCOMPARE(complete.files.at(complete.steps[1].picture), picture + "photo");
        QVERIFY(complete.steps[2].picture.empty());
        QVERIFY(!complete.files.contains("forgotten.png"));
        QCOMPARE(readBack(complete).steps[1].picture, std::string("photo.png"));
    }

    void stopped_endsSoon()
    {
        LessonPlayback playback(std::make_shared<const Lesson>(draftOf("mug").lesson()), "mug");
        std::stop_source stop;
        std::vector<double> shares;
        const auto checks =
            checkLesson(playback, [](std::size_t, const TriangleMesh&) {}, {stop.get_token(), [&](double share) {
                                                                                shares.push_back(share);
                                                                                stop.request_stop();
                                                                            }});
        QCOMPARE(shares.size(), std::size_t(1));
        QCOMPARE(checks.size(), std::size_t(1));
        VERIFY_VALID(playback.mesh());
    }
};

FETTLE_TEST(TestLessonDraft)
#include "tst_lesson_draft.moc"
