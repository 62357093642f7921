#include "app/worker/job_queue.h"
#include "app/worker/sculpt_worker.h"

#include "core/mesh/mesh_builder.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/test_main.h"
#include "tests/support/viewer.h"
#include "ui/util/thread_mailbox.h"

#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <atomic>
#include <random>

using namespace app;

namespace
{
std::shared_ptr<core::Sculptor> sphere(int subdivisions = 3)
{
    return std::make_shared<core::Sculptor>(core::buildMesh(core::icosphere(subdivisions, 50)).mesh);
}

core::StrokeSettings settings(core::Tool tool = core::Tool::Pull)
{
    core::StrokeSettings result;
    result.tool = tool;
    result.radius = 15;
    return result;
}

core::StrokeSample sampleAt(const core::Vec3& position)
{
    core::StrokeSample sample;
    sample.position = position;
    sample.direction = -position;
    return sample;
}

core::Vec3 onSphere(std::mt19937_64& random)
{
    std::uniform_real_distribution<double> between(-1, 1);
    core::Vec3 p;
    do
        p = {between(random), between(random), between(random)};
    while (p.norm() > 1 || p.norm() < 0.1);
    return 50 * p.normalized();
}

/// Collects the values that a signal delivers.
template <class Value> struct SignalValues
{
    template <class Sender, class Signal> SignalValues(Sender& sender, Signal signal)
    {
        QObject::connect(&sender, signal, &here, [this](const Value& value) { all << value; });
    }

    qsizetype size() const { return all.size(); }
    bool isEmpty() const { return all.isEmpty(); }
    const Value& at(qsizetype i) const { return all.at(i); }
    const Value& last() const { return all.last(); }
    void clear() { all.clear(); }

    QList<Value> all;
    QObject here;
};
using Answer = std::optional<core::SurfaceHit>;

std::vector<Job> drain(JobQueue& queue)
{
    std::vector<Job> jobs;
    queue.push(Task());
    for (;;) {
        Job job = std::get<Job>(*queue.next());
        if (std::holds_alternative<Task>(job))
            return jobs;
        jobs.push_back(std::move(job));
    }
}
} // namespace

class TestSculptWorker : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void queue_keepsOrder();
    void queue_thinsSamplesThatPileUp();
    void queue_neverThinsAcrossStrokes();
    void queue_answersTheNewestQuestionFirst();
    void queue_whoAsksWithoutEnd_keepsNoJobWaiting();
    void worker_reportsEachStrokeOnce();
    void worker_refusesASecondSource();
    void worker_ignoresSamplesOutsideAStroke();
    void worker_answersDuringAStroke();
    void worker_saysWhatABrushWouldTake();
    void worker_answersTheNewestQuestion();
    void worker_answersWhatABallTouches();
    void worker_addsOneSphereAStroke();
    void worker_pullsWhereASphereWouldTouch();
    void worker_tellsWhatTheHeadsetsSamplesDid();
    void worker_answersWithoutAModel();
    void worker_endsTheStrokeWhenTheModelChanges();
    void worker_findsTheExactBoxAfterwards();
    void worker_stopsWithWorkLeft();
    void inbox_mergedEqualsWhole_data();
    void inbox_mergedEqualsWhole();
    void inbox_announcesOncePerFill();
    void inbox_survivesTwoThreads();
};

void TestSculptWorker::queue_keepsOrder()
{
    JobQueue queue;
    queue.push(BeginStroke{settings(core::Tool::Smooth)});
    queue.push(Sample{sampleAt({1, 0, 0})});
    queue.push(EndStroke{});
    const auto jobs = drain(queue);
    QCOMPARE(jobs.size(), std::size_t(3));
    QVERIFY(std::get<BeginStroke>(jobs[0]).settings.tool == core::Tool::Smooth);
    QVERIFY(std::get<Sample>(jobs[1]).sample.position.x() == 1);
    QVERIFY(std::holds_alternative<EndStroke>(jobs[2]));
}

void TestSculptWorker::queue_thinsSamplesThatPileUp()
{
    JobQueue queue;
    queue.push(BeginStroke{});
    for (int i = 0; i < 1000; ++i)
        queue.push(Sample{sampleAt({double(i), 0, 0})});
    queue.push(EndStroke{});
    const auto jobs = drain(queue);
    QVERIFY(jobs.size() <= JobQueue::maxWaitingSamples + 2);
    QVERIFY(jobs.size() >= JobQueue::maxWaitingSamples / 2);
    QCOMPARE(queue.droppedSamples(), quint64(1000 - (jobs.size() - 2)));
    QCOMPARE(std::get<Sample>(jobs[1]).sample.position.x(), 0.0);
    QCOMPARE(std::get<Sample>(jobs[jobs.size() - 2]).sample.position.x(), 999.0);
    for (std::size_t i = 2; i + 1 < jobs.size(); ++i)
        QVERIFY(std::get<Sample>(jobs[i]).sample.position.x() > std::get<Sample>(jobs[i - 1]).sample.position.x());
}

void TestSculptWorker::queue_neverThinsAcrossStrokes()
{
    JobQueue queue;
    for (int stroke = 0; stroke < 10; ++stroke) {
        queue.push(BeginStroke{});
        for (int i = 0; i < 5; ++i)
            queue.push(Sample{sampleAt({double(i), 0, 0})});
        queue.push(EndStroke{});
    }
    QCOMPARE(drain(queue).size(), std::size_t(70));
    QCOMPARE(queue.droppedSamples(), quint64(0));
}

void TestSculptWorker::queue_answersTheNewestQuestionFirst()
{
    JobQueue queue;
    queue.push(BeginStroke{});
    for (int i = 1; i <= 3; ++i)
        queue.ask({Source::Desktop, {core::Vec3(i, 0, 0), core::Vec3(1, 0, 0)}, {}});
    queue.ask({Source::Headset, {core::Vec3(9, 0, 0), core::Vec3(1, 0, 0)}, {}});
    QCOMPARE(std::get<Question>(*queue.next()).ray.origin.x(), 3.0);
    QCOMPARE(std::get<Question>(*queue.next()).ray.origin.x(), 9.0);
    QVERIFY(std::ranges::none_of(queue.takeQuestions(), [](const auto& question) { return question.has_value(); }));
    QVERIFY(std::holds_alternative<Job>(*queue.next()));
    queue.stop();
    QVERIFY(!queue.next());
}

/// Simulates a headset whose queries take longer than its frames.
void TestSculptWorker::queue_whoAsksWithoutEnd_keepsNoJobWaiting()
{
    JobQueue queue;
    for (int i = 0; i < 3; ++i)
        queue.push(Task());
    const auto isJobNext = [&] {
        for (const Source source : {Source::Desktop, Source::Headset})
            queue.ask({source, {core::Vec3(0, 0, 9), core::Vec3(0, 0, -1)}, {}});
        return std::holds_alternative<Job>(*queue.next());
    };
    for (int i = 0; i < 3; ++i) {
        QVERIFY(!isJobNext());
        QVERIFY(!isJobNext());
        QVERIFY(isJobNext());
    }
    QVERIFY(!isJobNext());
}

void TestSculptWorker::worker_reportsEachStrokeOnce()
{
    SculptWorker worker;
    SignalValues<MeshFacts> modelSet(worker, &SculptWorker::modelSet);
    SignalValues<StrokeReport> finished(worker, &SculptWorker::strokeFinished);
    worker.setModel(sphere());
    QTRY_COMPARE(modelSet.size(), 1);
    std::mt19937_64 random(1);
    for (int i = 0; i < 20; ++i) {
        QVERIFY(worker.strokes().beginStroke(Source::Desktop, settings(static_cast<core::Tool>(i % 3))));
        worker.strokes().addSample(Source::Desktop, sampleAt(onSphere(random)));
        worker.strokes().endStroke(Source::Desktop);
    }
    // A stroke that touches nothing is reported, too.
    QVERIFY(worker.strokes().beginStroke(Source::Desktop, settings()));
    worker.strokes().addSample(Source::Desktop, sampleAt({0, 300, 0}));
    worker.strokes().endStroke(Source::Desktop);
    QCOMPARE(worker.strokes().begun(), quint64(21));
    QTRY_COMPARE(finished.size(), 21);
    for (int i = 0; i < 20; ++i) {
        const auto report = finished.at(i);
        QVERIFY(report.tool == static_cast<core::Tool>(i % 3));
        QCOMPARE(report.dabs, quint64(1));
        QVERIFY(report.facts.faces > 0 && !report.facts.box.isEmpty());
    }
    QVERIFY(finished.at(0).delta);
    QVERIFY(!finished.at(20).delta);
}

void TestSculptWorker::worker_refusesASecondSource()
{
    SculptWorker worker;
    SignalValues<Source> refused(worker.strokes(), &StrokeGate::refused);
    SignalValues<StrokeReport> finished(worker, &SculptWorker::strokeFinished);
    worker.setModel(sphere());
    QVERIFY(worker.strokes().beginStroke(Source::Headset, settings()));
    QVERIFY(!worker.strokes().beginStroke(Source::Desktop, settings()));
    QTRY_COMPARE(refused.size(), 1);
    QVERIFY(refused.at(0) == Source::Desktop);
    worker.strokes().addSample(Source::Desktop, sampleAt({50, 0, 0}));
    worker.strokes().endStroke(Source::Desktop); // has no effect, because another source's stroke is open
    QVERIFY(worker.strokes().isOpen());
    worker.strokes().endStroke(Source::Headset);
    QVERIFY(!worker.strokes().isOpen());
    QTRY_COMPARE(finished.size(), 1);
    QCOMPARE(finished.at(0).dabs, quint64(0));
    QVERIFY(worker.strokes().beginStroke(Source::Desktop, settings()));
    worker.strokes().endStroke(Source::Desktop);
    QTRY_COMPARE(finished.size(), 2);
}

void TestSculptWorker::worker_ignoresSamplesOutsideAStroke()
{
    SculptWorker worker;
    SignalValues<StrokeReport> finished(worker, &SculptWorker::strokeFinished);
    worker.setModel(sphere());
    worker.strokes().addSample(Source::Desktop, sampleAt({50, 0, 0}));
    worker.strokes().endStroke(Source::Desktop);
    QVERIFY(worker.strokes().beginStroke(Source::Desktop, settings()));
    worker.strokes().endStroke(Source::Desktop);
    QTRY_COMPARE(finished.size(), 1);
    QCOMPARE(worker.stats().samples, quint64(0));
}

void TestSculptWorker::worker_answersDuringAStroke()
{
    SculptWorker worker;
    SignalValues<MeshFacts> modelSet(worker, &SculptWorker::modelSet);
    SignalValues<Answer> answered(worker, &SculptWorker::answeredDesktop);
    worker.setModel(sphere());
    QTRY_COMPARE(modelSet.size(), 1);
    QVERIFY(worker.strokes().beginStroke(Source::Desktop, settings()));
    worker.strokes().addSample(Source::Desktop, sampleAt({50, 0, 0}));
    worker.ask(Source::Desktop, {core::Vec3(0, 0, 200), core::Vec3(0, 0, -1)});
    QTRY_COMPARE(answered.size(), 1);
    const auto hit = answered.at(0);
    QVERIFY(hit);
    QVERIFY((hit->position - core::Vec3(0, 0, 50)).norm() < 2);
    QVERIFY(hit->normal.z() > 0.9);
    worker.strokes().endStroke(Source::Desktop);
    worker.ask(Source::Desktop, {core::Vec3(0, 100, 200), core::Vec3(0, 0, -1)});
    QTRY_COMPARE(answered.size(), 2);
    QVERIFY(!answered.at(1));
}

void TestSculptWorker::worker_saysWhatABrushWouldTake()
{
    SculptWorker worker;
    QList<std::shared_ptr<const core::Footprint>> footprints;
    connect(&worker, &SculptWorker::answeredDesktop, this,
            [&](const std::optional<core::SurfaceHit>&, const std::shared_ptr<const core::Footprint>& footprint) {
                footprints << footprint;
            });
    const core::Ray ray{core::Vec3(0, 0, 200), core::Vec3(0, 0, -1)};
    core::StrokeSettings brush = settings();
    brush.brush = core::BrushShape::Ray;
    worker.setModel(sphere());
    const auto answerTo = [&](const core::Ray& asked, const std::optional<core::StrokeSettings>& what) {
        const qsizetype before = footprints.size();
        worker.ask(Source::Desktop, asked, what);
        return QTest::qWaitFor([&] { return footprints.size() > before; }) ? footprints.last() : nullptr;
    };
    QVERIFY(!answerTo(ray, {}));
    QVERIFY(!answerTo({ray.origin, -ray.direction}, brush));
    const auto footprint = answerTo(ray, brush);
    QVERIFY(footprint && !footprint->slots.empty());
    QCOMPARE(footprint->slots, sphere()->footprint(brush, sphere()->hit(ray)->position).slots);
}

void TestSculptWorker::worker_answersTheNewestQuestion()
{
    QList<Answer> answered;
    ui::ThreadMailbox mail;
    SculptWorker worker;
    SignalValues<MeshFacts> modelSet(worker, &SculptWorker::modelSet);
    connect(
        &worker, &SculptWorker::answeredHeadset, &mail,
        [&](const Answer& hit) { mail.post([&answered, hit] { answered << hit; }); }, Qt::DirectConnection);
    worker.setModel(sphere());
    QTRY_COMPARE(modelSet.size(), 1);
    for (int i = 0; i <= 1000; ++i)
        worker.ask(Source::Headset, {core::Vec3(0.01 * i, 0, 200), core::Vec3(0, 0, -1)});
    const auto lastIsNewest = [&] {
        const auto hit = answered.isEmpty() ? Answer() : answered.last();
        return hit && std::abs(hit->position.x() - 10) < 1e-6;
    };
    QTRY_VERIFY(lastIsNewest());
    QVERIFY(answered.size() <= 1001);
}

void TestSculptWorker::worker_answersWhatABallTouches()
{
    SculptWorker worker;
    SignalValues<MeshFacts> modelSet(worker, &SculptWorker::modelSet);
    worker.setModel(sphere());
    QTRY_COMPARE(modelSet.size(), 1);
    const auto at = [&](const core::Vec3& centre, const core::StrokeSettings& brush) {
        SignalValues<Answer> answered(worker, &SculptWorker::answeredDesktop);
        worker.ask(Source::Desktop, {centre, core::Vec3(1, 0, 0)}, brush);
        return QTest::qWaitFor([&] { return !answered.isEmpty(); }) ? answered.last() : Answer();
    };
    const auto near = at({0, 0, 60}, settings());
    QVERIFY(near && (near->position - core::Vec3(0, 0, 50)).norm() < 2 && near->distance < 15);
    QVERIFY(!at({0, 0, 70}, settings()));
    core::StrokeSettings byRay = settings(); // the ray from this place misses the model
    byRay.place = core::Placement::Ray;
    QVERIFY(!at({0, 0, 60}, byRay));
}

/// A stroke adds at most one ball, however far the controller moves on. If the ball is refused, the stroke becomes a
/// pull when it meets the surface.
void TestSculptWorker::worker_addsOneSphereAStroke()
{
    SculptWorker worker;
    SignalValues<StrokeReport> finished(worker, &SculptWorker::strokeFinished);
    worker.setModel(sphere());
    core::StrokeSettings adding = settings();
    adding.add = true;
    const auto stroke = [&](const std::vector<core::Vec3>& samples) {
        const qsizetype before = finished.size();
        worker.strokes().beginStroke(Source::Headset, adding);
        for (const core::Vec3& position : samples)
            worker.strokes().addSample(Source::Headset, sampleAt(position));
        worker.strokes().endStroke(Source::Headset);
        return QTest::qWaitFor([&] { return finished.size() > before; }) ? finished.last() : StrokeReport();
    };
    const StrokeReport one = stroke({{90, 0, 0}});
    QVERIFY(one.added && one.delta && one.dabs == 1);
    const StrokeReport row = stroke({{-90, 0, 0}, {-130, 0, 0}, {-170, 0, 0}, {-60, 0, 0}});
    QVERIFY(row.added && row.delta && row.dabs == 4);
    const quint64 ballFaces = one.facts.faces - sphere()->mesh().live().faces;
    QVERIFY(row.facts.faces - one.facts.faces < 2 * ballFaces);
    const StrokeReport inside = stroke({{0, 0, 0}, {10, 0, 0}});
    QVERIFY(!inside.delta && inside.shortfall == core::Shortfall::Inside && inside.dabs == 2);
    const StrokeReport waiting = stroke({{0, 66, 0}, {0, 62, 0}, {0, 58, 0}});
    QVERIFY(waiting.delta && !waiting.added && waiting.shortfall == core::Shortfall::None);
    const auto* const recorded = std::get_if<core::Stroke>(waiting.recordedStep.get());
    QVERIFY(recorded && !recorded->settings.add && recorded->samples.size() == 3);
    const StrokeReport none = stroke({});
    QVERIFY(!none.delta && none.dabs == 0);
}

/// The refused stroke must equal an ordinary pull.
void TestSculptWorker::worker_pullsWhereASphereWouldTouch()
{
    std::vector<std::uint64_t> states;
    for (const bool adds : {false, true}) {
        SculptWorker worker;
        SignalValues<StrokeReport> finished(worker, &SculptWorker::strokeFinished);
        worker.setModel(sphere());
        core::StrokeSettings pull = settings();
        pull.add = adds;
        worker.strokes().beginStroke(Source::Headset, pull);
        for (const double x : {60.0, 55.0, 100.0, 58.0}) // the third sample touches nothing
            worker.strokes().addSample(Source::Headset, sampleAt({x, 0, 0}));
        worker.strokes().endStroke(Source::Headset);
        std::atomic<std::uint64_t> state = 0;
        worker.post([&](core::Sculptor& sculptor) { state = sculptor.mesh().stateHash(); });
        QTRY_COMPARE(finished.size(), 1);
        QTRY_VERIFY(state != 0);
        states.push_back(state);
        QVERIFY(!finished.at(0).added && finished.at(0).delta);
        QCOMPARE(finished.at(0).dabs, quint64(4));
    }
    QVERIFY(states.size() == 2 && states[0] == states[1]);
}

void TestSculptWorker::worker_tellsWhatTheHeadsetsSamplesDid()
{
    QList<core::Shortfall> told;
    SculptWorker worker;
    connect(
        &worker, &SculptWorker::sampledHeadset, &worker, [&](quint64, core::Shortfall shortfall) { told << shortfall; },
        Qt::DirectConnection);
    worker.setModel(sphere());
    core::StrokeSettings adding = settings();
    adding.add = true;
    for (const Source source : {Source::Desktop, Source::Headset}) {
        worker.strokes().beginStroke(source, adding);
        worker.strokes().addSample(source, sampleAt({0, 0, 0}));
        worker.strokes().endStroke(source);
        worker.strokes().beginStroke(source, settings(core::Tool::Smooth));
        worker.strokes().addSample(source, sampleAt({50, 0, 0}));
        worker.strokes().endStroke(source);
    }
    SignalValues<StrokeReport> finished(worker, &SculptWorker::strokeFinished);
    QTRY_COMPARE(finished.size(), 4);
    worker.stop();
    QCOMPARE(told, (QList<core::Shortfall>{core::Shortfall::Inside, core::Shortfall::None}));
}

void TestSculptWorker::worker_answersWithoutAModel()
{
    SculptWorker worker;
    SignalValues<Answer> answered(worker, &SculptWorker::answeredDesktop);
    SignalValues<StrokeReport> finished(worker, &SculptWorker::strokeFinished);
    worker.ask(Source::Desktop, {});
    QTRY_COMPARE(answered.size(), 1);
    QVERIFY(!answered.at(0));
    worker.strokes().beginStroke(Source::Desktop, settings());
    worker.strokes().addSample(Source::Desktop, sampleAt({50, 0, 0}));
    worker.strokes().endStroke(Source::Desktop);
    QTRY_COMPARE(finished.size(), 1);
}

void TestSculptWorker::worker_endsTheStrokeWhenTheModelChanges()
{
    SculptWorker worker;
    SignalValues<MeshFacts> modelSet(worker, &SculptWorker::modelSet);
    SignalValues<StrokeReport> finished(worker, &SculptWorker::strokeFinished);
    worker.setModel(sphere());
    worker.strokes().beginStroke(Source::Headset, settings());
    worker.strokes().addSample(Source::Headset, sampleAt({50, 0, 0}));
    worker.setModel(sphere(2));
    worker.strokes().addSample(Source::Headset, sampleAt({50, 0, 0}));
    worker.strokes().endStroke(Source::Headset);
    QTRY_COMPARE(modelSet.size(), 2);
    QTRY_COMPARE(finished.size(), 1);
    QCOMPARE(modelSet.at(1).vertices, quint64(162));
    QCOMPARE(worker.stats().samples, quint64(1));
}

void TestSculptWorker::worker_findsTheExactBoxAfterwards()
{
    SculptWorker worker;
    SignalValues<MeshFacts> modelSet(worker, &SculptWorker::modelSet);
    SignalValues<StrokeReport> finished(worker, &SculptWorker::strokeFinished);
    SignalValues<MeshFacts> facts(worker, &SculptWorker::factsChanged);
    worker.setModel(sphere());
    QTRY_COMPARE(modelSet.size(), 1);
    const core::Box before = modelSet.at(0).box;
    QVERIFY((before.sizes() - core::Vec3(100, 100, 100)).norm() < 2);
    worker.strokes().beginStroke(Source::Desktop, settings());
    for (int i = 0; i < 5; ++i)
        worker.strokes().addSample(Source::Desktop, sampleAt({51, 0, 0}));
    worker.strokes().endStroke(Source::Desktop);
    QTRY_VERIFY(!facts.isEmpty());
    QVERIFY(facts.last().box.max().x() > before.max().x() + 1);
    const auto delta = finished.at(0).delta;
    facts.clear();
    worker.post([delta](core::Sculptor& sculptor) { sculptor.swap(*delta); });
    QTRY_VERIFY(!facts.isEmpty());
    QVERIFY(facts.last().box.isApprox(before, 0));
}

void TestSculptWorker::worker_stopsWithWorkLeft()
{
    SculptWorker worker;
    worker.setModel(sphere());
    std::mt19937_64 random(1);
    worker.strokes().beginStroke(Source::Desktop, settings());
    for (int i = 0; i < 100; ++i)
        worker.strokes().addSample(Source::Desktop, sampleAt(onSphere(random)));
    worker.stop();
    worker.stop();
    worker.strokes().endStroke(Source::Desktop); // no effect is expected after stop()
}

void TestSculptWorker::inbox_mergedEqualsWhole_data()
{
    QTest::addColumn<int>("patchesPerTake");
    for (const int n : {1, 2, 7, 1000})
        QTest::newRow(qPrintable(QString::number(n))) << n;
}

/// A viewer that draws only every n-th patch, merged, must show the same mesh.
void TestSculptWorker::inbox_mergedEqualsWhole()
{
    QFETCH(int, patchesPerTake);
    const auto sculptor = sphere();
    PatchInbox inbox;
    Viewer seen, whole;
    inbox.put(sculptor->wholePatch());
    sculptor->takePatch();
    if (patchesPerTake < 1000)
        seen.apply(*inbox.take());

    std::mt19937_64 random(3);
    std::vector<core::MeshDelta> deltas;
    for (int i = 0; i < 60; ++i) {
        if (i % 5 == 4 && !deltas.empty()) {
            sculptor->swap(deltas.back());
            deltas.pop_back();
        } else {
            core::StrokeSettings stroke = settings(static_cast<core::Tool>(i % 3));
            stroke.detail = i % 2 ? 0.5 : 2;
            sculptor->beginStroke(stroke);
            sculptor->addSample(sampleAt(onSphere(random)));
            deltas.push_back(sculptor->endStroke());
        }
        if (core::MeshPatch patch = sculptor->takePatch(); !patch.empty())
            inbox.put(std::move(patch));
        if (i % patchesPerTake == patchesPerTake - 1)
            if (const auto patch = inbox.take())
                seen.apply(*patch);
    }
    if (const auto patch = inbox.take())
        seen.apply(*patch);
    whole.apply(sculptor->wholePatch());
    QVERIFY(seen.drawsLike(whole));
}

void TestSculptWorker::inbox_announcesOncePerFill()
{
    const auto sculptor = sphere(1);
    PatchInbox inbox;
    QSignalSpy filled(&inbox, &PatchInbox::filled);
    QVERIFY(!inbox.take());
    for (int i = 0; i < 3; ++i)
        inbox.put(sculptor->wholePatch());
    QCOMPARE(filled.size(), 1);
    QVERIFY(inbox.take());
    QVERIFY(!inbox.take());
    inbox.put(sculptor->wholePatch());
    QCOMPARE(filled.size(), 2);
}

void TestSculptWorker::inbox_survivesTwoThreads()
{
    const auto sculptor = sphere(1);
    PatchInbox inbox;
    std::atomic<bool> done = false;
    std::thread producer([&] {
        std::mt19937_64 random(4);
        inbox.put(sculptor->wholePatch());
        for (int i = 0; i < 300; ++i) {
            core::StrokeSettings stroke = settings(core::Tool::Smooth);
            stroke.detail = 4;
            sculptor->beginStroke(stroke);
            sculptor->addSample(sampleAt(onSphere(random)));
            sculptor->endStroke();
            inbox.put(sculptor->takePatch());
        }
        done = true;
    });
    Viewer seen, whole;
    while (!done)
        if (const auto patch = inbox.take())
            seen.apply(*patch);
    producer.join();
    if (const auto patch = inbox.take())
        seen.apply(*patch);
    whole.apply(sculptor->wholePatch());
    QVERIFY(seen.drawsLike(whole));
}

FETTLE_TEST(TestSculptWorker, QCoreApplication)
#include "tst_sculpt_worker.moc"
