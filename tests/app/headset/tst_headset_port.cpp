#include "app/document/document.h"
#include "app/headset/headset_port.h"

#include "core/sculpt/sculptor.h"
#include "tests/support/ask_worker.h"
#include "tests/support/test_main.h"
#include "tests/support/viewer.h"
#include "ui/util/thread_mailbox.h"

#include <QSignalSpy>
#include <QStandardPaths>
#include <QTest>

#include <atomic>
#include <thread>
#include <utility>

using namespace app;

namespace
{
core::StrokeSettings brush(core::Tool tool = core::Tool::Pull)
{
    core::StrokeSettings settings;
    settings.tool = tool;
    settings.radius = 12;
    return settings;
}

core::StrokeSample sampleAt(const core::Vec3& position)
{
    core::StrokeSample sample;
    sample.position = position;
    return sample;
}

/// A document with a ball of clay of radius 50 mm, and the port of a visit. Requests are handled when a test calls
/// handle().
struct Visit
{
    Visit()
    {
        document.opener().openBall();
        wait();
        port->begin();
    }
    ~Visit() { port->end(); }

    void wait()
    {
        QTRY_VERIFY(!document.job().isBusy() && document.queue().isSettled());
        meshRests();
        QCoreApplication::processEvents();
    }

    void meshRests() { stateHash(); }

    std::uint64_t stateHash() { return app::stateHash(worker); }

    Viewer mesh()
    {
        return viewerOf(ask(worker, [](core::Sculptor& sculptor) { return sculptor.wholePatch(); }));
    }

    bool stroke(const core::Vec3& where, core::Tool tool = core::Tool::Pull)
    {
        const bool begun = port->beginStroke(brush(tool));
        port->addSample(sampleAt(where));
        port->endStroke();
        return begun;
    }

    /// Handles all requests in order, as the GUI thread does.
    void handle()
    {
        for (const vr::DocumentRequest& request : port->takeMessages().requests)
            turns.push_back(request);
        handleNext();
    }
    void handleNext()
    {
        if (turns.empty() || std::exchange(isHandling, true))
            return;
        const vr::DocumentRequest request = turns.front();
        turns.pop_front();
        if (std::holds_alternative<vr::Undo>(request))
            document.history().undo();
        if (std::holds_alternative<vr::RestoreModel>(request))
            document.changer().apply(core::Reset());
        document.queue().enqueue([this] {
            port->requestDone();
            isHandling = false;
            handleNext();
        });
    }

    SculptWorker worker;
    Document document{&worker};
    std::shared_ptr<HeadsetPort> port = std::make_shared<HeadsetPort>(&worker);
    std::deque<vr::DocumentRequest> turns;
    bool isHandling = false;
};

const core::Vec3 right(50, 0, 0), top(0, 50, 0), front(0, 0, 50);
} // namespace

class TestHeadsetPort : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void strokes_areTheDocuments();
    void strokesAfterAnUndo_comeAfterIt();
    void strokesBetweenRequests_comeBetweenThem();
    void strokesAfterARestore_comeAfterIt();
    void heldStroke_goesOnWhereItWas();
    void heldStroke_isThinned();
    void brushRequests_holdNoStroke();
    void stroke_isRefusedWhileTheDesktopDraws();
    void desktop_isRefusedWhileTheHeadsetDraws();
    void heldStroke_isRefusedWhileTheDesktopDraws();
    void effects_tellFusions();
    void effects_tellRefusals();
    void answers_ofARay();
    void answers_ofABall();
    void patches_areWholeThenChanges();
    void end_keepsTheOpenStroke();
    void end_keepsWhatIsHeld();
    void end_isTheHeadsetsEnd();
    void end_isBeforeTheWorkers();
    void nothingIsSculptedWhileAnotherModelComes();
    void anotherModel_comesWhole();
    void update_latestWins();
    void messages_areAnnouncedOnce();
    void port_outlivesItsVisit();
    void twoThreads_getAlong();
};

void TestHeadsetPort::strokes_areTheDocuments()
{
    Visit visit;
    const std::uint64_t before = visit.stateHash();
    QVERIFY(visit.stroke(right));
    QTRY_COMPARE(visit.document.history().stack().count(), 1);
    QVERIFY(visit.stateHash() != before);
    visit.document.history().undo();
    visit.wait();
    QCOMPARE(visit.stateHash(), before);
}

void TestHeadsetPort::strokesAfterAnUndo_comeAfterIt()
{
    Visit one, other;
    QVERIFY(one.stroke(top));
    one.wait();
    const std::uint64_t expected = one.stateHash();

    QVERIFY(other.stroke(right));
    QTRY_COMPARE(other.document.history().stack().count(), 1);
    other.port->request(vr::Undo());
    QVERIFY(other.stroke(top)); // the undo has not been carried out yet
    QVERIFY(other.port->takeEffect().refusals == 0);
    QCOMPARE(other.worker.strokes().begun(), quint64(1));
    other.handle();
    other.wait();
    QCOMPARE(other.worker.strokes().begun(), quint64(2));
    QCOMPARE(other.document.history().stack().count(), 1);
    QCOMPARE(other.stateHash(), expected);
}

/// The GUI thread handles nothing until all strokes and requests are made. Their order must be kept.
void TestHeadsetPort::strokesBetweenRequests_comeBetweenThem()
{
    Visit one, other;
    QVERIFY(one.stroke(front));
    one.wait();
    const std::uint64_t expected = one.stateHash();

    QVERIFY(other.stroke(right));
    other.port->request(vr::Undo());
    QVERIFY(other.stroke(top));
    other.port->request(vr::Undo());
    QVERIFY(other.stroke(front));
    QCOMPARE(other.worker.strokes().begun(), quint64(1));
    other.handle();
    other.wait();
    QCOMPARE(other.worker.strokes().begun(), quint64(3));
    QCOMPARE(other.document.history().stack().count(), 1);
    QCOMPARE(other.stateHash(), expected);
}

void TestHeadsetPort::strokesAfterARestore_comeAfterIt()
{
    Visit one, other;
    QVERIFY(one.stroke(top));
    one.wait();
    const quint64 expected = one.document.modelInfo().faces;
    QVERIFY(other.stroke(right));
    other.port->request(vr::RestoreModel());
    QVERIFY(other.stroke(top));
    other.handle();
    QTRY_COMPARE(other.document.history().stack().count(), 3);
    other.wait();
    QCOMPARE(other.document.modelInfo().faces, expected);
    const std::uint64_t now = other.stateHash();
    for (int i = 0; i < 3; ++i)
        other.document.history().undo();
    for (int i = 0; i < 3; ++i)
        other.document.history().redo();
    other.wait();
    QCOMPARE(other.stateHash(), now);
}

void TestHeadsetPort::heldStroke_goesOnWhereItWas()
{
    Visit visit;
    visit.port->request(vr::Undo());
    QVERIFY(visit.port->beginStroke(brush()));
    visit.port->addSample(sampleAt(right));
    visit.handle();
    QCOMPARE(visit.worker.strokes().begun(), quint64(1));
    QVERIFY(visit.worker.strokes().isOpen());
    visit.port->addSample(sampleAt({51, 0, 0}));
    visit.port->endStroke();
    QVERIFY(!visit.worker.strokes().isOpen());
    visit.wait();
    QCOMPARE(visit.worker.stats().samples, quint64(2));
    QCOMPARE(visit.document.history().stack().count(), 1);
}

void TestHeadsetPort::heldStroke_isThinned()
{
    Visit visit;
    visit.port->request(vr::Undo());
    QVERIFY(visit.port->beginStroke(brush(core::Tool::Smooth)));
    for (int i = 0; i <= 1000; ++i)
        visit.port->addSample(sampleAt({50, 0.01 * i, 0}));
    visit.port->endStroke();
    visit.handle();
    visit.wait();
    const WorkerStats stats = visit.worker.stats();
    QVERIFY(stats.samples >= JobQueue::maxWaitingSamples / 2);
    QVERIFY(stats.samples + stats.droppedSamples <= JobQueue::maxWaitingSamples);
}

void TestHeadsetPort::brushRequests_holdNoStroke()
{
    Visit visit;
    visit.port->request(vr::ChooseBrush());
    visit.port->request(vr::HeadsetSettings());
    QVERIFY(visit.stroke(right));
    QCOMPARE(visit.worker.strokes().begun(), quint64(1));
    visit.wait();
}

void TestHeadsetPort::stroke_isRefusedWhileTheDesktopDraws()
{
    Visit visit;
    visit.document.strokes().beginStroke(brush());
    QVERIFY(!visit.stroke(right));
    QCOMPARE(visit.port->takeEffect().refusals, 1);
    QCOMPARE(visit.port->takeEffect().refusals, 0);
    visit.document.strokes().addSample(sampleAt(top));
    visit.document.strokes().endStroke();
    visit.wait();
    QCOMPARE(visit.worker.stats().samples, quint64(1));
    QVERIFY(visit.stroke(right));
    visit.wait();
    QCOMPARE(visit.document.history().stack().count(), 2);
}

void TestHeadsetPort::desktop_isRefusedWhileTheHeadsetDraws()
{
    Visit visit;
    QVERIFY(visit.port->beginStroke(brush()));
    visit.document.strokes().beginStroke(brush());
    visit.document.strokes().addSample(sampleAt(top));
    visit.document.strokes().endStroke();
    visit.port->addSample(sampleAt(right));
    visit.port->endStroke();
    visit.wait();
    QCOMPARE(visit.document.history().stack().count(), 1);
    QCOMPARE(visit.worker.stats().samples, quint64(1));
}

void TestHeadsetPort::heldStroke_isRefusedWhileTheDesktopDraws()
{
    Visit visit;
    visit.port->request(vr::Undo());
    QVERIFY(visit.stroke(right));
    visit.worker.strokes().beginStroke(Source::Desktop, brush());
    visit.port->requestDone();
    QCOMPARE(visit.port->takeEffect().refusals, 1);
    visit.worker.strokes().endStroke(Source::Desktop);
    visit.wait();
    QCOMPARE(visit.worker.strokes().begun(), quint64(1));
}

/// Adds a ball beside the clay, then pulls a horn that fuses with it.
void TestHeadsetPort::effects_tellFusions()
{
    Visit visit;
    core::StrokeSettings adding = brush();
    adding.add = true;
    QVERIFY(visit.port->beginStroke(adding));
    visit.port->addSample(sampleAt({80, 0, 0}));
    visit.port->endStroke();
    visit.wait();
    vr::StrokeEffect effect = visit.port->takeEffect();
    QVERIFY(effect.fusions == 0 && effect.refusals == 0);
    int fusions = 0;
    QVERIFY(visit.port->beginStroke(brush()));
    for (int i = 0; i < 40 && fusions == 0; ++i) {
        visit.port->addSample(sampleAt({50 + 0.7 * i, 0, 0}));
        visit.meshRests();
        fusions = visit.port->takeEffect().fusions;
    }
    visit.port->endStroke();
    QVERIFY(fusions > 0);
    visit.wait();
}

void TestHeadsetPort::effects_tellRefusals()
{
    Visit visit;
    core::StrokeSettings adding = brush();
    adding.add = true;
    QVERIFY(visit.port->beginStroke(adding));
    visit.port->addSample(sampleAt({0, 0, 0}));
    visit.port->endStroke();
    visit.wait();
    QCOMPARE(visit.port->takeEffect().refusals, 1);
    QCOMPARE(visit.document.history().stack().count(), 0);
}

void TestHeadsetPort::answers_ofARay()
{
    Visit visit;
    core::StrokeSettings ray = brush();
    ray.brush = core::BrushShape::Ray;
    const auto answer = [&](const vr::SurfaceQuery& question) {
        visit.port->querySurface(question);
        visit.meshRests();
        return visit.port->takeQueryResult();
    };
    const core::Ray at{{0, 0, 200}, {0, 0, -1}};
    const auto hit = answer({at, ray});
    QVERIFY(hit && hit->hit && hit->footprint && !hit->footprint->slots.empty());
    QVERIFY((hit->hit->position - front).norm() < 1);
    QVERIFY(!visit.port->takeQueryResult());
    const auto plain = answer({at, ray, false});
    QVERIFY(plain && plain->hit && !plain->footprint);
    QCOMPARE(plain->hit->face, hit->hit->face);
    const auto missed = answer({{at.origin, -at.direction}, ray});
    QVERIFY(missed && !missed->hit && !missed->footprint);
}

void TestHeadsetPort::answers_ofABall()
{
    Visit visit;
    const auto answer = [&](const core::Vec3& origin) {
        visit.port->querySurface({{origin, {1, 0, 0}}, brush()});
        visit.meshRests();
        return visit.port->takeQueryResult();
    };
    const auto outside = answer({0, 0, 60});
    QVERIFY(outside && outside->hit && !outside->footprint);
    QVERIFY((outside->hit->position - front).norm() < 1);
    QVERIFY(std::abs(outside->hit->distance - 10) < 0.5);
    const auto inside = answer({0, 0, 40});
    QVERIFY(inside && inside->hit);
    const auto far = answer({0, 0, 70});
    QVERIFY(far && !far->hit);
}

void TestHeadsetPort::patches_areWholeThenChanges()
{
    Visit visit;
    visit.meshRests();
    const auto whole = visit.port->takePatch();
    QVERIFY(whole && whole->whole);
    Viewer seen = viewerOf(*whole);
    QVERIFY(seen.drawsLike(visit.mesh()));
    QVERIFY(!visit.port->takePatch());
    QVERIFY(visit.stroke(right));
    visit.wait();
    visit.document.history().undo();
    visit.document.strokes().beginStroke(brush());
    visit.document.strokes().addSample(sampleAt(top));
    visit.document.strokes().endStroke();
    visit.wait();
    const auto changes = visit.port->takePatch();
    QVERIFY(changes && !changes->whole);
    seen.apply(*changes);
    QVERIFY(seen.drawsLike(visit.mesh()));
}

void TestHeadsetPort::end_keepsTheOpenStroke()
{
    Visit visit;
    QVERIFY(visit.port->beginStroke(brush()));
    visit.port->addSample(sampleAt(right));
    visit.port->end();
    QVERIFY(!visit.worker.strokes().isOpen());
    visit.wait();
    QCOMPARE(visit.document.history().stack().count(), 1);
}

void TestHeadsetPort::end_keepsWhatIsHeld()
{
    Visit visit;
    QVERIFY(visit.stroke(top));
    visit.port->request(vr::Undo());
    QVERIFY(visit.stroke(right));
    QVERIFY(visit.port->beginStroke(brush()));
    visit.port->addSample(sampleAt(front));
    visit.port->end();
    visit.handle();
    visit.wait();
    QCOMPARE(visit.worker.strokes().begun(), quint64(3));
    QVERIFY(!visit.worker.strokes().isOpen());
    QCOMPARE(visit.document.history().stack().count(), 2);
}

/// After the port has ended, further strokes and requests of an abandoned visit have no effect.
void TestHeadsetPort::end_isTheHeadsetsEnd()
{
    Visit visit;
    QVERIFY(visit.port->beginStroke(brush()));
    visit.port->addSample(sampleAt(right));
    visit.port->end();
    visit.wait();
    QCOMPARE(visit.document.history().stack().count(), 1);
    const std::uint64_t hash = visit.stateHash();
    QSignalSpy rings(visit.port.get(), &HeadsetPort::messagesArrived),
        refusals(&visit.worker.strokes(), &StrokeGate::refused);
    visit.port->addSample(sampleAt(top));
    visit.port->endStroke();
    QVERIFY(!visit.stroke(top));
    QVERIFY(!visit.worker.strokes().isOpen());
    visit.port->request(vr::Undo());
    QVERIFY(!visit.stroke(top));
    visit.port->show({});
    visit.port->querySurface({{{0, 0, 200}, {0, 0, -1}}, brush()});
    visit.handle();
    visit.wait();
    QCOMPARE(rings.size(), 0);
    QCOMPARE(refusals.size(), 0);
    QVERIFY(!visit.port->takeQueryResult());
    QCOMPARE(visit.worker.strokes().begun(), quint64(1));
    QCOMPARE(visit.document.history().stack().count(), 1);
    QCOMPARE(visit.stateHash(), hash);
    visit.document.strokes().beginStroke(brush());
    visit.document.strokes().addSample(sampleAt(top));
    visit.document.strokes().endStroke();
    visit.wait();
    QCOMPARE(visit.document.history().stack().count(), 2);
}

/// An abandoned visit may still use its port after everything else is gone.
void TestHeadsetPort::end_isBeforeTheWorkers()
{
    std::shared_ptr<HeadsetPort> port;
    {
        Visit visit;
        port = visit.port;
        QVERIFY(port->beginStroke(brush()));
    }
    std::thread headset([port = std::exchange(port, nullptr)] {
        port->addSample(sampleAt(right));
        port->endStroke();
        port->beginStroke(brush());
        port->querySurface({{{0, 0, 200}, {0, 0, -1}}, brush()});
        port->request(vr::Undo());
        port->show({});
        port->takePatch();
        port->takeUpdate();
        port->takeEffect();
    });
    headset.join();
}

void TestHeadsetPort::nothingIsSculptedWhileAnotherModelComes()
{
    Visit visit;
    visit.port->setRefusing(true);
    QVERIFY(!visit.stroke(right));
    QCOMPARE(visit.port->takeEffect().refusals, 1);
    visit.port->setRefusing(false);
    QVERIFY(visit.stroke(right));
    visit.wait();
    QCOMPARE(visit.document.history().stack().count(), 1);
}

void TestHeadsetPort::anotherModel_comesWhole()
{
    Visit visit;
    visit.meshRests();
    QVERIFY(visit.port->takePatch());
    visit.document.opener().openStarter(core::Starter::Cube);
    visit.wait();
    const auto whole = visit.port->takePatch();
    QVERIFY(whole && whole->whole);
    QVERIFY(viewerOf(*whole).drawsLike(visit.mesh()));
}

void TestHeadsetPort::update_latestWins()
{
    Visit visit;
    QVERIFY(!visit.port->takeUpdate());
    vr::DocumentUpdate update;
    for (quint64 i = 1; i <= 3; ++i) {
        update.model = i;
        visit.port->setUpdate(update);
    }
    QCOMPARE(visit.port->takeUpdate()->model, quint64(3));
    QVERIFY(!visit.port->takeUpdate());
}

void TestHeadsetPort::messages_areAnnouncedOnce()
{
    Visit visit;
    QSignalSpy rings(visit.port.get(), &HeadsetPort::messagesArrived);
    vr::AvatarState presence;
    for (int i = 1; i <= 100; ++i) {
        presence.model.translation().x() = i;
        visit.port->show(presence);
    }
    visit.port->request(vr::ChooseBrush());
    QCOMPARE(rings.size(), 1);
    const HeadsetMessages messages = visit.port->takeMessages();
    QCOMPARE(messages.requests.size(), std::size_t(1));
    QCOMPARE(messages.avatar->model.translation().x(), 100.0);
    QVERIFY(!visit.port->takeMessages().avatar);
    visit.port->show(presence);
    QCOMPARE(rings.size(), 2);
}

/// A port may end and be destroyed while answers to it are in progress.
void TestHeadsetPort::port_outlivesItsVisit()
{
    Visit visit;
    for (int i = 0; i < 200; ++i) {
        auto port = std::make_shared<HeadsetPort>(&visit.worker);
        port->begin();
        port->querySurface({{{0, 0, 200}, {0, 0, -1}}, brush()});
        port->beginStroke(brush(core::Tool::Smooth));
        port->addSample(sampleAt(right));
        port->end();
    }
    visit.wait();
    QVERIFY(!visit.worker.strokes().isOpen());
}

/// A headset makes strokes and requests quickly while the GUI thread is slow. No stroke may be lost, and the order must
/// be kept.
void TestHeadsetPort::twoThreads_getAlong()
{
    Visit visit;
    std::atomic<bool> isOver = false;
    int begun = 0;
    std::thread headset([&] {
        for (int i = 0; i < 60; ++i) {
            if (i % 5 == 4)
                visit.port->request(vr::Undo());
            const double angle = 0.1 * i;
            begun += visit.stroke({50 * std::cos(angle), 50 * std::sin(angle), 0}, static_cast<core::Tool>(i % 4));
            visit.port->querySurface({{{0, 0, 200}, {0, 0, -1}}, brush()});
            visit.port->takeQueryResult();
            visit.port->takePatch();
            visit.port->show({});
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        isOver = true;
    });
    while (!isOver) {
        visit.handle();
        QTest::qWait(7);
    }
    headset.join();
    visit.handle();
    visit.wait();
    QCOMPARE(begun, 60);
    QCOMPARE(visit.worker.strokes().begun(), quint64(60));
    QVERIFY(visit.turns.empty());
}

FETTLE_TEST(TestHeadsetPort, QCoreApplication)
#include "tst_headset_port.moc"
