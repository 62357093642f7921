// Tests that drawings updated by patches equal drawings of the whole model, line by line and pixel by pixel.

#include "core/drawing/incremental_line_drawing.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

using core::IncrementalLineDrawing;
using core::LineDrawing;

namespace
{
constexpr std::size_t anyEdges = 1'000'000;

bool isSame(const core::DrawnView& one, const core::DrawnView& other)
{
    return one.outlines == other.outlines && one.creases == other.creases && one.shaded.pixels == other.shaded.pixels &&
           one.shaded.topLeft == other.shaded.topLeft && one.box.isApprox(other.box, 0);
}

bool isSame(const LineDrawing& one, const LineDrawing& other)
{
    return std::ranges::equal(one.views, other.views, [](const auto& a, const auto& b) { return isSame(a, b); }) &&
           one.box.isApprox(other.box, 0) && one.volume == other.volume && one.pixel == other.pixel &&
           one.hasCreases == other.hasCreases;
}

/// Two drawings of one model: the first is updated by patches, the second gets the whole model each time.
class Pair
{
public:
    Pair(const core::Sculptor& sculptor, std::size_t maxEdges) : m_following(200, maxEdges), m_anew(200, maxEdges)
    {
        m_following.apply(sculptor.wholePatch());
    }

    bool drawTheSame(core::Sculptor& sculptor, bool shaded)
    {
        m_following.apply(sculptor.takePatch());
        m_anew.apply(sculptor.wholePatch());
        last = m_following.draw(shaded, {}).value();
        return isSame(last, m_anew.draw(shaded, {}).value());
    }

    /// Cancels a drawing, so that its partial result is discarded.
    void stopADrawing(core::Sculptor& sculptor)
    {
        m_following.apply(sculptor.takePatch());
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!m_following.draw(true, stop.get_token()));
    }

    LineDrawing last;

private:
    IncrementalLineDrawing m_following, m_anew;
};

void pull(core::Sculptor& sculptor, const core::Vec3& at, double radius, double strength = 1)
{
    core::StrokeSettings settings;
    settings.radius = radius;
    settings.strength = strength;
    sculptor.beginStroke(settings);
    core::StrokeSample sample;
    sample.position = at;
    sample.direction = -at.normalized();
    for (int i = 0; i < 4; ++i)
        sculptor.addSample(sample);
    sculptor.endStroke();
}
} // namespace

class TestIncrementalLineDrawing : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void strokesAndUndos_drawWhatTheWholeModelDraws_data()
    {
        QTest::addColumn<std::uint64_t>("seed");
        for (std::uint64_t seed = 1; seed <= 6; ++seed)
            QTest::addRow("seed %d", static_cast<int>(seed)) << seed;
    }

    void strokesAndUndos_drawWhatTheWholeModelDraws()
    {
        QFETCH(std::uint64_t, seed);
        const core::TriangleMesh shape = seed % 2 == 0 ? shapes::torus({30, 10, 96, 48}) : core::icosphere(5, 50);
        core::Sculptor sculptor(mesh_asserts::sculptable(shape));
        StrokeFuzzer random(seed);
        Pair pair(sculptor, anyEdges);
        QVERIFY(pair.drawTheSame(sculptor, false));
        std::vector<core::MeshDelta> undo;
        for (int i = 0; i < 10; ++i) {
            const core::Stroke stroke = random.stroke(sculptor.mesh());
            sculptor.beginStroke(stroke.settings);
            for (const core::StrokeSample& sample : stroke.samples) {
                sculptor.addSample(sample);
                if (random.below(6) == 0)
                    pair.stopADrawing(sculptor);
                QVERIFY2(pair.drawTheSame(sculptor, random.below(2) == 0),
                         qPrintable(QStringLiteral("stroke %1").arg(i)));
            }
            undo.push_back(sculptor.endStroke());
            if (random.below(3) == 0) {
                sculptor.swap(undo.back());
                undo.pop_back();
                QVERIFY2(pair.drawTheSame(sculptor, true), qPrintable(QStringLiteral("undo %1").arg(i)));
            }
        }
    }

    void theModelMayGrowOutOfItsGrid()
    {
        core::Sculptor sculptor(mesh_asserts::sculptable(core::icosphere(5, 50)));
        Pair pair(sculptor, anyEdges);
        QVERIFY(pair.drawTheSame(sculptor, true));
        const float pixel = pair.last.pixel;
        for (int i = 0; i < 12; ++i) {
            pull(sculptor, {0, pair.last.box.max().y(), 0}, 12, 3);
            QVERIFY(pair.drawTheSame(sculptor, true));
        }
        QVERIFY(pair.last.box.sizes().y() > 130);
        QVERIFY(pair.last.pixel > pixel);
    }

    void creasesThatBecomeTooManyAreLeftOut()
    {
        core::Sculptor sculptor(mesh_asserts::sculptable(shapes::cube(40)));
        Pair pair(sculptor, 40);
        QVERIFY(pair.drawTheSame(sculptor, false));
        QVERIFY(pair.last.hasCreases);
        for (int i = 0; i < 6 && pair.last.hasCreases; ++i) {
            pull(sculptor, {0, 20, 0}, 15, 3);
            QVERIFY(pair.drawTheSame(sculptor, false));
        }
        QVERIFY(!pair.last.hasCreases);
    }

    void withoutAModelThereIsNothing()
    {
        IncrementalLineDrawing drawer(200, anyEdges);
        core::MeshPatch nothing;
        nothing.whole = true;
        drawer.apply(nothing);
        QVERIFY(drawer.draw(true, {})->box.isEmpty());
    }
};

FETTLE_TEST(TestIncrementalLineDrawing)
#include "tst_incremental_line_drawing.moc"
