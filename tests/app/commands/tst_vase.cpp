// Makes the vase of the paper's Figure 21 as a user would, by a stroke file that `fettle replay` plays.
// The number of handles is counted by hand, stage by stage:
//
//   stage      what is done                                       components  genus
//   body       the sphere becomes foot, belly and neck            1           0
//   hollow     a pit from the neck down to the foot, and a lip    1           0    a pit has no second opening
//   ring       a ball beside the body grows around to its image   2           1    the ring is a torus
//   holes      4 pushed through the ring, and their images        2           9    each hole adds one
//   bridges    3 and their images, 2 across the mirror plane      1           16   one joins, 7 are handles
//   handles    from the lip to the shoulder, and its image        1           18   each handle adds one
//   motifs     rotated waves and pearls                           1           18
#include "tests/app/commands/played_strokes.h"
#include "tests/support/effort.h"
#include "tests/support/mirror_asserts.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>
#include <numbers>

using Json = nlohmann::json;

namespace
{
using core::Vec3;
using played_strokes::Brush;
using played_strokes::Hand;

const Vec3 up = {0, 1, 0}, down = {0, -1, 0}, inwards = {-1, 0, 0}, outwards = {1, 0, 0};
constexpr double far = 4; ///< coordinate or distance from the axis that is outside of the model
constexpr double ringRadius = 1.5, ringHeight = -0.15;
constexpr double turnSpeed = 36; ///< degrees per second of the turntable

/// Returns a point on a circle around the y axis.
Vec3 around(double radius, double height, double degrees)
{
    const double angle = degrees * std::numbers::pi / 180;
    return {radius * std::cos(angle), height, radius * std::sin(angle)};
}

/// Generates the strokes of the vase in stroke file format. All are mirrored at x = 0.
class Potter
{
public:
    Json file() const { return played_strokes::fileOf(m_strokes); }

    void body();
    void hollow();
    void ring();
    void holes();
    void bridges();
    void handles();
    void motifs();

private:
    struct Turn
    {
        double step = 10; ///< degrees between dabs
        double turns = 1;
    };

    void stroke(const Brush& brush, Json samples, const Json& settings);
    void dabs(const Brush& brush, const std::vector<Hand>& hands, int times);
    void rest(const Brush& brush, const Vec3& position, int times);
    void turned(const Brush& brush, const Hand& hand, const Turn& turn);
    void turned(const Brush& brush, const Hand& hand) { turned(brush, hand, Turn()); }
    void drag(const Brush& brush, const std::vector<Vec3>& path);
    void wave(const Brush& brush, double height, double amplitude, double degreesPerSecond);

    static Hand fromOutside(double height) { return {{far, height, 0}, inwards}; }
    static Hand fromTheAxis(double height) { return {{0, height, 0}, outwards}; }
    static Hand fromAbove(double radius) { return {{radius, far, 0}, down}; }

    Json m_strokes = Json::array();
};

void Potter::stroke(const Brush& brush, Json samples, const Json& settings)
{
    Json stroke = played_strokes::strokeOf(brush, std::move(samples), settings);
    stroke["symmetry"] = "x";
    m_strokes.push_back(std::move(stroke));
}

/// Makes one dab at each sample, repeating the sequence `times` times.
void Potter::dabs(const Brush& brush, const std::vector<Hand>& hands, int times)
{
    std::vector<Hand> inTurns;
    for (int i = 0; i < times; ++i)
        inTurns.insert(inTurns.end(), hands.begin(), hands.end());
    stroke(brush, played_strokes::samplesOf(inTurns), {{"place", "ray"}});
}

void Potter::rest(const Brush& brush, const Vec3& position, int times)
{
    stroke(brush, Json(static_cast<std::size_t>(times), Json{{"position", position}}), Json::object());
}

/// Keeps the brush at rest while the model turns.
void Potter::turned(const Brush& brush, const Hand& hand, const Turn& turn)
{
    Json samples = Json::array();
    for (int i = 0; i < 360 * turn.turns / turn.step; ++i)
        samples.push_back(
            {{"position", hand.position}, {"direction", hand.direction}, {"t", i * turn.step / turnSpeed}});
    stroke(brush, samples, {{"place", "ray"}, {"turntable_deg_per_s", turnSpeed}});
}

void Potter::drag(const Brush& brush, const std::vector<Vec3>& path)
{
    stroke(brush, played_strokes::samplesAt(path), {{"spacing", 0.12}});
}

/// Sculpts a wave of six crests around the vase, symmetric about the mirror plane.
void Potter::wave(const Brush& brush, double height, double amplitude, double degreesPerSecond)
{
    Json samples = Json::array();
    for (double degrees = 0; degrees < 360; degrees += 2.5) {
        const double y = height + amplitude * std::cos(6 * degrees * std::numbers::pi / 180);
        samples.push_back(
            {{"position", {far, y, 0}}, {"direction", inwards}, {"t", degrees / std::abs(degreesPerSecond)}});
    }
    stroke(brush, samples, {{"place", "ray"}, {"turntable_deg_per_s", degreesPerSecond}});
}

void Potter::body()
{
    const Hand below = {{0, -far, 0}, up}, above = fromAbove(0);
    dabs({"push", 0.7}, {below}, 3);
    dabs({"flatten", 0.7}, {below}, 8);
    dabs({"pull", 0.7, 2}, {above}, 8);
    dabs({"flatten", 0.6}, {above}, 3);
    dabs({"pull", 0.6}, {above}, 2);
    for (double height : {1.3, 1.15})
        turned({"push", 0.35, 0.25}, fromOutside(height));
    for (double height : {-0.3, 0.0, 0.3, 0.6, 0.9, 1.2, 1.5})
        turned({"smooth", 0.4, 0.7}, fromOutside(height));
    dabs({"flatten", 0.6}, {above}, 8);
}

void Potter::hollow()
{
    dabs({"push", 0.45}, {fromAbove(0)}, 5);
    dabs({"push", 0.27}, {fromAbove(0)}, 75);
    for (double height : {0.4, 0.2, 0.0, -0.2, -0.4})
        turned({"push", 0.3, 0.35}, fromTheAxis(height));
    for (double height : {1.3, 1.1, 0.9, 0.7, 0.5, 0.3, 0.1, -0.1, -0.3})
        turned({"smooth", 0.25, 0.7}, fromTheAxis(height));
    turned({"pull", 0.2, 0.6}, fromOutside(1.62), {6, 2});
    for (double height : {1.75, 1.6, 1.45})
        turned({"smooth", 0.25}, fromOutside(height), {6});
    for (double radius : {0.3, 0.4, 0.5})
        turned({"smooth", 0.2}, fromAbove(radius), {6});
}

/// The brush rests beside the ball and pulls it while the model turns away, once in each direction. This makes half a
/// ring; its mirror image is the other half.
void Potter::ring()
{
    stroke({"pull", 0.13}, {{{"position", {ringRadius, ringHeight, 0}}}}, {{"add", true}});
    for (int side : {1, -1}) {
        const Vec3 hand = around(ringRadius, ringHeight, 14 * side);
        const Vec3 back = around(ringRadius, ringHeight, 2 * side) - hand;
        Json samples = Json::array();
        for (int i = 0; i < 190; ++i)
            samples.push_back({{"position", hand}, {"direction", back}, {"t", 0.05 * i}});
        stroke({"pull", 0.17, 1.5}, samples, {{"place", "ray"}, {"turntable_deg_per_s", 10 * side}});
    }
    for (double z : {1.0, -1.0}) { // places where the two halves met
        const double joint = ringRadius * z;
        dabs({"smooth", 0.2}, {{{0, far, joint}, down}, {{0, -far, joint}, up}, {{0, ringHeight, far * z}, {0, 0, -z}}},
             2);
    }
    turned({"pull", 0.2, 0.7}, fromOutside(ringHeight), {4, 2});
    turned({"smooth", 0.25, 0.5}, fromOutside(ringHeight), {5});
}

void Potter::holes()
{
    for (double degrees : {-67.5, -22.5, 22.5, 67.5})
        dabs({"push", 0.11}, {{around(ringRadius + 0.04, far, degrees), down}}, 40);
}

void Potter::bridges()
{
    for (double degrees : {-90, -45, 0, 45, 90}) {
        drag({"pull", 0.16, 1.5}, {around(0.98, ringHeight, degrees), around(ringRadius - 0.12, ringHeight, degrees)});
        rest({"smooth", 0.22}, around(ringRadius - 0.2, ringHeight, degrees), 6);
    }
}

void Potter::handles()
{
    std::vector<Vec3> path;
    constexpr int parts = 16;
    for (int i = 0; i <= parts; ++i) {
        const double share = double(i) / parts, angle = (95 - 190 * share) * std::numbers::pi / 180;
        path.push_back({0.55 + 0.55 * std::cos(angle) + 0.1 * share, 1.05 + 0.5 * std::sin(angle), 0});
    }
    drag({"pull", 0.17, 1.5}, path);
    rest({"smooth", 0.25}, {0.78, 0.6, 0}, 6);
}

void Potter::motifs()
{
    wave({"pull", 0.12, 0.5}, -0.55, 0.07, 25);
    wave({"pull", 0.12, 0.3}, 1.0, 0.04, -25);
    for (double degrees : {-75, -60, -45, -30, 30, 45, 60, 75})
        dabs({"pull", 0.09}, {{around(far, 0.42, degrees), -around(1, 0, degrees)}}, 4);
    turned({"smooth", 0.2, 0.4}, fromOutside(-0.55), {8});
}

constexpr struct
{
    const char* name;
    void (Potter::*work)();
    int components, genus;
} stages[] = {{"body", &Potter::body, 1, 0},        {"hollow", &Potter::hollow, 1, 0},
              {"ring", &Potter::ring, 2, 1},        {"holes", &Potter::holes, 2, 9},
              {"bridges", &Potter::bridges, 1, 16}, {"handles", &Potter::handles, 1, 18},
              {"motifs", &Potter::motifs, 1, 18}};
} // namespace

class TestVase : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachStage_hasTheHandlesCounted();
};

void TestVase::eachStage_hasTheHandlesCounted()
{
    Potter potter;
    std::size_t vertices = 0;
    for (std::size_t i = 0; i < std::size(stages); ++i) {
        const auto& stage = stages[i];
        (potter.*stage.work)();
        const bool isLast = i + 1 == std::size(stages);
        if (effort() == Effort::Small && i % 2 == 0 && !isLast) // each stage repeats the strokes of all earlier ones
            continue;
        const auto vase = played_strokes::replay(potter.file());
        QVERIFY2(vase, stage.name);
        const auto mesh = mesh_asserts::sculptable(vase->mesh);
        VERIFY_VALID(*mesh);
        VERIFY_SYMMETRIC(*mesh, core::Symmetry::X);
        QCOMPARE(vase->stats["components"].get<int>(), stage.components);
        QCOMPARE(vase->stats["genus"].get<int>(), stage.genus);
        QCOMPARE(mesh_asserts::eulerNumber(*mesh), 2 * (stage.components - stage.genus));
        vertices = vase->mesh.points.size();
    }
    QVERIFY2(vertices >= 10'000 && vertices <= 100'000, qPrintable(QString::number(vertices)));
}

FETTLE_TEST(TestVase, QCoreApplication)
#include "tst_vase.moc"
