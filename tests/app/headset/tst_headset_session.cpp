// Tests a complete session in the headset against the scripted runtime, with Khronos' validation layer.
// FETTLE_HEADSET_PICTURES=<folder> saves the pictures of the left eye.
#include "tests/app/headset/headset_hand.h"
#include "tests/support/test_main.h"
#include "tests/vr/vr_test.h"

#include "core/analysis/mesh_check.h"
#include "core/io/mesh_io.h"
#include "core/mesh/mesh_builder.h"

#include <QDir>
#include <QSet>
#include <QTemporaryDir>

#include <algorithm>

using namespace app;
using core::Vec3;
using vr::Side;

namespace
{
/// Results of a session.
struct Played
{
    QStringList steps;     ///< name and mesh hash of each step
    QList<quint64> bodies; ///< number of parts after each step; 0: not a solid
    QStringList files;
    QString complaints;
};

class Session
{
public:
    Session() : m_pictures(qEnvironmentVariable("FETTLE_HEADSET_PICTURES"))
    {
        core::writeMesh(m_folder.filePath(QStringLiteral("clay.glb")).toStdU16String(), core::icosphere(4, 50));
        // small, because each frame of the headset repaints its avatar in the window
        program.window.viewport()->setMaximumSize(240, 180);
        openFile(program, m_folder.filePath(QStringLiteral("clay.glb")), {640, 480});
        if (!m_pictures.isEmpty())
            hand.load({540, 600});
    }
    /// Waits until all actions are done, and records the step.
    void note(const char* name)
    {
        hand.settle();
        const std::uint64_t hash = hand.ask([](core::Sculptor& sculptor) { return sculptor.mesh().meshHash(); });
        played.steps << QStringLiteral("%1 %2").arg(QLatin1StringView(name)).arg(hash, 16, 16, QLatin1Char('0'));
        const core::MeshReport report =
            core::checkMesh(hand.ask([](core::Sculptor& sculptor) { return core::extractMesh(sculptor.mesh()); }));
        played.bodies << (report.boundsSolid == true ? report.components : 0);
        if (m_pictures.isEmpty() || !hand.isIn())
            return;
        hand.waitForPanels();
        hand.picture().save(QStringLiteral("%1/%2-%3.png")
                                .arg(m_pictures)
                                .arg(played.steps.size(), 2, 10, QLatin1Char('0'))
                                .arg(QLatin1StringView(name)));
    }
    QStringList files() const { return QDir(m_folder.path()).entryList(QDir::Files, QDir::Name); }

    Program program;
    HeadsetHand hand{program};
    Played played;

private:
    QTemporaryDir m_folder;
    QString m_pictures;
};

/// Pulls a horn, paints it, undoes, redoes, turns while pulling, adds a ball and fuses it, saves, leaves, and continues
/// at the desktop.
Played play()
{
    Session s;
    HeadsetHand& hand = s.hand;
    const Vec3 out = Vec3(0.6, 0.8, 0);
    // repeated dabs of an airbrush would depend on the clock
    for (const core::Tool tool : {core::Tool::Pull, core::Tool::Paint})
        s.program.window.brush()->tools()->setAirbrush(tool, false);
    hand.enter();
    s.note("entered");

    hand.stroke(48 * out, 80 * out, 48);
    s.note("horn");

    hand.press(Side::Left, "menu");
    for (int i = 0; i < 4; ++i)
        hand.pressPad(Side::Left, 0.8, 0); // selects Paint, the fifth tool of the paper
    hand.press(Side::Right, "menu");
    hand.slide(Side::Right, {0, 1.2});
    s.note("painting-is-chosen");
    hand.press(Side::Right, "menu");
    hand.press(Side::Left, "menu");
    hand.stroke(80 * out, 60 * out, 24);
    s.note("painted");

    hand.pressPad(Side::Right, -0.8, 0);
    s.note("undone");
    hand.pressPad(Side::Right, 0.8, 0);
    s.note("redone");

    hand.press(Side::Left, "menu");
    for (int i = 0; i < 4; ++i)
        hand.pressPad(Side::Left, -0.8, 0);
    hand.press(Side::Left, "menu");
    hand.hover(48 * Vec3(-0.6, 0.8, 0));
    hand.set(Side::Left, "pad", QJsonArray{-0.8, 0});
    hand.set(Side::Left, "pad_touch", 1);
    hand.frame();
    hand.set(Side::Left, "pad_press", 1);
    hand.stroke(48 * Vec3(-0.6, 0.8, 0), 56 * Vec3(-0.6, 0.8, 0), 30);
    hand.set(Side::Left, "pad_press", 0);
    hand.frame();
    hand.set(Side::Left, "pad_touch", 0);
    s.note("turned-while-pulling");

    const Vec3 above(0, 63, 0); // on the vertical axis, about which the model turns
    hand.stroke(above, above, 1);
    s.note("ball");
    hand.stroke(above - Vec3(0, 5.5, 0), above - Vec3(0, 15, 0), 40);
    s.note("fused");

    hand.hold(Side::Left, "squeeze");
    s.note("saved");
    hand.leave();
    drag(s.program.window.viewport(), {30, 5});
    QTest::qWait(0);
    s.note("desktop");
    s.played.files = s.files();
    s.played.complaints = hand.headset().complaints();
    return s.played;
}
} // namespace

class TestHeadsetSession : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GLX(); }
    void endsTheSameEveryTime();
};

void TestHeadsetSession::endsTheSameEveryTime()
{
    const Played first = play();
    qInfo("%s", qPrintable(first.steps.join(QLatin1Char('\n'))));
    QCOMPARE(first.complaints, QString());
    const auto at = [&](const char* name) {
        const auto isIt = [&](const QString& step) {
            return step.startsWith(QLatin1StringView(name) + QLatin1Char(' '));
        };
        return std::ranges::find_if(first.steps, isIt) - first.steps.begin();
    };
    const auto hash = [&](const char* name) { return first.steps[at(name)].section(QLatin1Char(' '), -1); };
    QCOMPARE(hash("undone"), hash("horn"));
    QCOMPARE(hash("redone"), hash("painted"));
    const QSet<QString> shapes{hash("entered"), hash("horn"),  hash("painted"), hash("turned-while-pulling"),
                               hash("ball"),    hash("fused"), hash("desktop")};
    QCOMPARE(shapes.size(), 7);
    QCOMPARE(hash("saved"), hash("fused"));
    for (qsizetype step = 0; step < first.steps.size(); ++step)
        QCOMPARE(first.bodies[step], step == at("ball") ? 2U : 1U);
    QCOMPARE(first.files,
             (QStringList{QStringLiteral("clay-001.glb"), QStringLiteral("clay-001.stl"), QStringLiteral("clay.glb")}));
    QCOMPARE(play().steps, first.steps);
}

FETTLE_TEST(TestHeadsetSession, app::OnScreen)
#include "tst_headset_session.moc"
