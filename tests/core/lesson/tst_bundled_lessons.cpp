// Tests Fettle's own lessons: each is played to its end and meets its checkpoints, in every language. Tests how lessons
// are played, too.
#include "core/lesson/lesson_playback.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/detached_part.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <filesystem>

using namespace core;

namespace
{
const std::filesystem::path lessons = FETTLE_SOURCE_DIR "/resources/lessons";

std::shared_ptr<const Lesson> lessonNamed(const char* name)
{
    return std::make_shared<const Lesson>(readLesson(lessons / name));
}

/// Plays a step with the player, which advances by `seconds` at a time.
void playByTime(LessonPlayer& player, LessonPlayback& playback, double seconds)
{
    for (player.play(); player.isPlaying();)
        for (const LessonCue& cue : player.advance(seconds))
            playback.apply(cue);
}

std::uint64_t hashAfter(LessonPlayback& playback)
{
    playback.goTo(playback.lesson().steps.size() - 1);
    playback.finish();
    return playback.mesh().meshHash();
}
} // namespace

class TestBundledLessons : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void each_meetsItsCheckpoints_data() { names(); }
    void each_meetsItsCheckpoints()
    {
        QFETCH(QByteArray, name);
        LessonPlayback playback(lessonNamed(name.constData()), lessons);
        for (std::size_t i = 0; i < playback.lesson().steps.size(); ++i) {
            playback.goTo(i);
            playback.finish();
            const Mesh& mesh = playback.mesh();
            for (const Part& part : mesh.frame().parts.all())
                VERIFY_VALID(Mesh(surfaceOf(mesh, part.id), mesh.lattice()));
            const Checkpoint& checkpoint = playback.step().checkpoint;
            QVERIFY(!checkpoint.asksNothing());
            const TriangleMesh target = checkpoint.target ? playback.target() : TriangleMesh();
            const bool isMet =
                evaluate(checkpoint, extractMesh(playback.mesh()), checkpoint.target ? &target : nullptr).isMet();
            QVERIFY2(isMet, std::to_string(i).c_str());
        }
    }

    void each_speaksAllLanguages_data() { names(); }
    void each_speaksAllLanguages()
    {
        QFETCH(QByteArray, name);
        const auto lesson = lessonNamed(name.constData());
        const auto requireAll = [](const LessonText& text) {
            for (const char* const language : {"en", "de", "zh"})
                QVERIFY2(text.words.contains(language) && text.in(language).size() > 2, language);
            QVERIFY(text.in("de") != text.in("en") && text.in("zh") != text.in("en"));
        };
        requireAll(lesson->title);
        requireAll(lesson->summary);
        for (const LessonStep& step : lesson->steps) {
            requireAll(step.title);
            requireAll(step.text);
            QVERIFY(lesson->files.contains(step.picture));
            QVERIFY(!step.strokes.empty());
        }
    }

    /// Plays each lesson twice at once, and with the player's cues at different speeds. The models must be identical
    /// bit for bit.
    void each_isTheSameToTheBit_data() { names(); }
    void each_isTheSameToTheBit()
    {
        QFETCH(QByteArray, name);
        const auto lesson = lessonNamed(name.constData());
        LessonPlayback first(lesson, lessons), second(lesson, lessons), third(lesson, lessons);
        const std::uint64_t hash = hashAfter(first);
        QCOMPARE(hashAfter(second), hash);
        LessonPlayer player(lesson);
        for (std::size_t i = 0; i < lesson->steps.size(); ++i) {
            player.setStep(i);
            third.goTo(i);
            player.setSpeed(i % 2 == 0 ? LessonPlayer::minSpeed : LessonPlayer::maxSpeed);
            playByTime(player, third, 0.07 + 0.1 * static_cast<double>(i));
        }
        QCOMPARE(third.mesh().meshHash(), hash);
        first.goTo(0);
        QCOMPARE(hashAfter(first), hash);
    }

    /// Plays and undoes a step stroke by stroke, including a stroke in progress, and plays it again.
    void oneByOne_leadsToTheSameModel()
    {
        const auto lesson = lessonNamed("creature");
        LessonPlayback playback(lesson, lessons);
        LessonPlayer player(lesson);
        std::vector<std::uint64_t> hashes = {playback.mesh().meshHash()};
        while (!player.isAtEnd()) {
            player.playOne();
            for (int ticks = 0; player.isPlaying(); ++ticks) {
                QVERIFY(ticks < 10'000);
                for (const LessonCue& cue : player.advance(0.1))
                    playback.apply(cue);
            }
            QVERIFY(!playback.sculptor().strokeOpen());
            QCOMPARE(playback.done(), hashes.size());
            hashes.push_back(playback.mesh().meshHash());
        }
        QCOMPARE(hashes.size(), lesson->steps[0].strokes.size() + 1);
        player.playOne();
        QVERIFY(!player.isPlaying());
        for (std::size_t i = hashes.size() - 1; i > 0; --i) {
            QVERIFY(playback.undoLast());
            QCOMPARE(playback.mesh().meshHash(), hashes[i - 1]);
        }
        QVERIFY(!playback.undoLast());
        player.setStep(0);
        player.play();
        for (const LessonCue& cue : player.advance(LessonPlayer::leadTime + 0.2))
            playback.apply(cue);
        QVERIFY(playback.sculptor().strokeOpen());
        QVERIFY(player.ghost()->isPressed);
        player.pause();
        QVERIFY(player.advance(5).empty());
        QVERIFY(playback.undoLast());
        QCOMPARE(playback.mesh().meshHash(), hashes[0]);
        player.setStep(0);
        playByTime(player, playback, 0.5);
        QCOMPARE(playback.mesh().meshHash(), hashes.back());
    }

    /// Twice the speed takes half the time. The speed is limited to a range.
    void speed_isOfTime()
    {
        LessonPlayer player(lessonNamed("first-clay"));
        for (const double speed : {0.25, 1.0, 2.0, 4.0}) {
            player.setStep(0);
            player.setSpeed(speed);
            player.play();
            double seconds = 0;
            for (; player.isPlaying(); seconds += 0.01)
                player.advance(0.01);
            QVERIFY(std::abs(seconds - player.duration() / speed) < 0.02);
        }
        player.setSpeed(99);
        QCOMPARE(player.speed(), LessonPlayer::maxSpeed);
        player.setSpeed(0);
        QCOMPARE(player.speed(), LessonPlayer::minSpeed);
    }

    /// The ghost brush moves from the end of a stroke to the start of the next one without a jump. It is pressed only
    /// in strokes.
    void ghost_movesWithoutALeap()
    {
        LessonPlayer player(lessonNamed("first-clay"));
        player.setStep(2);
        player.play();
        // s, mm/s; the fastest motion crosses the model between two strokes
        constexpr double step = 0.01, fastest = 500;
        GhostBrush last = player.ghost().value();
        QVERIFY(!last.isPressed);
        std::size_t pressed = 0, moments = 0;
        while (player.isPlaying()) {
            player.advance(step);
            const GhostBrush ghost = player.ghost().value();
            QVERIFY((ghost.position - last.position).norm() <= fastest * step);
            QCOMPARE(ghost.tool, Tool::Smooth);
            QCOMPARE(ghost.radius, 26.0);
            pressed += ghost.isPressed ? 1 : 0;
            ++moments;
            last = ghost;
        }
        QVERIFY(!last.isPressed);
        QVERIFY(pressed > moments / 4 && pressed < moments);
    }

    /// Tests unusual sample times: none, all equal, decreasing, years apart.
    void ghost_takesAnyTimes()
    {
        const auto durationOf = [](const std::vector<double>& times) {
            Lesson lesson;
            Stroke stroke;
            for (const double time : times) {
                stroke.samples.emplace_back();
                stroke.samples.back().time = time;
            }
            lesson.steps.resize(1);
            lesson.steps[0].strokes.emplace_back(stroke);
            LessonPlayer player(std::make_shared<const Lesson>(lesson));
            player.play();
            std::size_t cues = 0;
            while (player.isPlaying())
                cues += player.advance(0.1).size();
            return cues == times.size() + 2 ? player.duration() : -1;
        };
        QCOMPARE(durationOf({}), LessonPlayer::leadTime);
        QCOMPARE(durationOf({5, 5, 5}), LessonPlayer::leadTime + 2 * LessonPlayer::samplePause);
        QCOMPARE(durationOf({5, 3, 9}), LessonPlayer::leadTime + 2 * LessonPlayer::samplePause);
        QCOMPARE(durationOf({0, 0.5, 1e9}), LessonPlayer::leadTime + 0.5 + LessonPlayer::maxPause);
    }

    void pupilsCopy_isTheirOwn()
    {
        Lesson lesson = *lessonNamed("first-clay");
        lesson.steps[1].checkpoint.target = CheckpointTarget{"", 8};
        LessonPlayback playback(std::make_shared<const Lesson>(lesson), lessons);
        playback.goTo(1);
        const std::uint64_t before = playback.mesh().meshHash();
        Sculptor pupil(std::make_unique<Mesh>(playback.mesh()));
        QCOMPARE(pupil.mesh().meshHash(), before);
        StrokeSample sample;
        sample.position = {50, 0, 0};
        pupil.beginStroke({});
        pupil.addSample(sample);
        pupil.endStroke();
        QVERIFY(pupil.mesh().meshHash() != before);
        QCOMPARE(playback.mesh().meshHash(), before);
        const TriangleMesh target = playback.target();
        QCOMPARE(playback.mesh().meshHash(), before);
        QVERIFY(evaluate(playback.step().checkpoint, target, &target).isMet());
        const CheckpointVerdict verdict = evaluate(playback.step().checkpoint, extractMesh(pupil.mesh()), &target);
        QVERIFY(!verdict.isMet());
        QVERIFY(verdict.target->largest > 5);
    }

    /// Tests brushes too large for the model's lattice, positions outside its range, and commands that cannot be
    /// executed.
    void strokesThatDoNotFit_areRefused()
    {
        const auto errorOf = [](const FileEntry& entry) -> std::optional<LessonError> {
            Lesson lesson;
            lesson.steps.resize(2);
            lesson.steps[1].strokesFile = "a.json";
            lesson.steps[1].strokes = {entry};
            LessonPlayback playback(std::make_shared<const Lesson>(lesson), "a");
            const std::uint64_t before = playback.mesh().meshHash();
            playback.goTo(1);
            try {
                playback.finish();
            } catch (const LessonError& error) {
                return playback.mesh().meshHash() == before ? std::optional(error) : std::nullopt;
            }
            return std::nullopt;
        };
        Stroke stroke;
        stroke.samples.resize(1);
        stroke.settings.radius = 1e5;
        const auto radius = errorOf(stroke);
        QVERIFY(radius && radius->kind == LessonError::Kind::Strokes && radius->strokes->key == "radius");
        QCOMPARE(radius->step, std::optional<std::size_t>(1));
        QCOMPARE(radius->file, std::string("a.json"));
        stroke.settings.radius = 10;
        stroke.samples[0].position = {1e6, 0, 0};
        const auto position = errorOf(stroke);
        QVERIFY(position && position->strokes->key == "position" &&
                position->strokes->sample == std::optional<std::size_t>(0));
        const auto command = errorOf(FileCommand{FlattenBase{500}, {}});
        QVERIFY(command && command->kind == LessonError::Kind::Refused);
        QVERIFY(!errorOf(FileCommand{Reset{}, {}}));
    }

private:
    static void names()
    {
        QTest::addColumn<QByteArray>("name");
        for (const char* const name : {"first-clay", "mug", "creature", "toy-car"})
            QTest::newRow(name) << QByteArray(name);
    }
};

FETTLE_TEST(TestBundledLessons)
#include "tst_bundled_lessons.moc"
