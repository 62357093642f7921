// Makes the bunch of grapes of the paper's Figure 20. It is sculpted and painted as a user would, by a stroke file that
// `fettle replay` plays on the starter Tablet.
// The number of handles is counted by hand, stage by stage:
//
//   stage     what is done                                           components  genus
//   leaf      the tablet's rim becomes lobes, veins are cut, painted 1           0
//   body      balls beside it, each joined to the one before         2           0
//   berries   balls, each with its centre in the body                2           0   see below
//   stem      pulled out of the body, and two arms out of the stem   2           0
//   petiole   pulled out of the stem, a knot joins it to the leaf    1           0
//   tendril   pulled out of the stem, a knot joins it to an arm      1           1   stem, tendril and arm form a ring
//   colors                                                           1           1
//
// The body is nearly convex. The overlap of several berries begins between their centres, and thus inside the body, so
// berries leave no tunnel between them.
#include "core/primitives/starter_models.h"
#include "tests/app/commands/played_strokes.h"
#include "tests/support/effort.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <ranges>

using Json = nlohmann::json;

namespace
{
using core::Rgb;
using core::Vec3;
using played_strokes::Brush;
using played_strokes::Hand;

/// A ground colour and a lighter colour that is painted over it softly.
struct Paint
{
    Rgb ground, light;
};

constexpr Rgb bare = {}; ///< colour of unpainted parts
constexpr Rgb leafGreen = {74, 128, 48}, veinGreen = {158, 186, 92}, petioleGreen = {126, 150, 70},
              tendrilGreen = {140, 170, 84}, shade = {52, 26, 58};
constexpr Rgb wood = {112, 78, 44}, darkWood = {84, 56, 32}, lightWood = {142, 106, 66};
constexpr Rgb ripe[] = {{70, 26, 94}, {88, 34, 108}, {58, 24, 86}, {104, 38, 104}, {78, 32, 112}, {66, 22, 80}};
constexpr Rgb turning[] = {{126, 52, 88}, {140, 72, 84}};
constexpr Rgb unripe[] = {{160, 178, 84}, {176, 190, 104}, {146, 168, 76}};
constexpr Rgb bloom = {196, 184, 224}, unripeBloom = {226, 234, 170}; ///< colour of the wax on berries

enum class Ripeness { Ripe, Turning, Unripe };

struct Berry
{
    Vec3 middle;
    double radius;
    Ripeness ripeness;
    Paint paint;

    /// Returns the unit direction away from the bunch's axis; for the lowest berry: down.
    Vec3 outwards() const
    {
        const Vec3 across = {middle.x(), 0, middle.z()};
        return across.norm() > 1 ? Vec3(across.normalized()) : Vec3(0, -1, 0);
    }
};

struct Ball
{
    Vec3 middle;
    double radius;
};

/// Balls that form the body, from top to bottom.
const Ball bodyBalls[] = {
    {{0, -22, 0}, 41}, {{0, -56, 0}, 40}, {{0, -90, 0}, 29.5}, {{0, -113, 0}, 18}, {{0, -130, 0}, 10}};

/// Returns the i-th number of a sequence that covers the range evenly without a visible pattern.
double uneven(int i, double least, double most)
{
    return least + (most - least) * std::fmod(i / std::numbers::phi, 1);
}

/// Returns the berries, row by row from the top.
std::vector<Berry> bunch()
{
    constexpr struct
    {
        double height, radius;
        int berries;
        double turn; ///< rotation of the row as a share of the angle between two berries
    } rows[] = {{5, 28, 7, 0},     {-17, 38, 9, 0.5},    {-39, 37, 9, 0},      {-61, 36, 8, 0.5},
                {-83, 28.5, 7, 0}, {-104, 19.5, 5, 0.3}, {-121, 10.5, 3, 0.1}, {-138, 0, 1, 0}};
    std::vector<Berry> berries;
    for (std::size_t row = 0; row < std::size(rows); ++row) {
        const auto& r = rows[row];
        for (int i = 0; i < r.berries; ++i) {
            const auto index = static_cast<int>(berries.size()), count = index + 1;
            const double degrees = 360 * (i + r.turn) / r.berries + uneven(3 * count, -2.5, 2.5);
            const double angle = degrees * std::numbers::pi / 180;
            const double radius = r.radius > 0 ? r.radius - uneven(2 * count, 0, 2.5) : 0;
            Berry berry;
            berry.middle = {radius * std::cos(angle), r.height + uneven(5 * count, -2, 2), radius * std::sin(angle)};
            berry.radius = uneven(count, 13.6, 15.4);
            berry.ripeness = row > 5 || (row == 5 && i % 5 == 1)    ? Ripeness::Unripe
                             : row == 5 || (row == 4 && i % 3 == 0) ? Ripeness::Turning
                                                                    : Ripeness::Ripe;
            const Rgb ground = berry.ripeness == Ripeness::Ripe      ? ripe[(5 * index + index / 7) % 6]
                               : berry.ripeness == Ripeness::Turning ? turning[index % 2]
                                                                     : unripe[index % 3];
            berry.paint = {ground, core::mixed(ground, berry.ripeness == Ripeness::Unripe ? unripeBloom : bloom, 0.6)};
            berries.push_back(berry);
        }
    }
    return berries;
}

/// Placement of the leaf, which is modelled flat with its tip up and its face towards +z.
struct LeafPlace
{
    static constexpr double scale = 0.72;
    static constexpr double notch = -36; ///< y of the notch in the rim, in the flat leaf
    Vec3 position = {27, 64, 27};        ///< position of the notch
    Vec3 tip = Vec3(0.82, -0.2, 0.36).normalized();
    Vec3 side = tip.cross(Vec3(0.05, 0.7, 0.75)).normalized();
    Vec3 face = side.cross(tip);

    /// Returns the position of a point of the flat leaf.
    Vec3 operator()(double x, double y) const { return position + scale * (x * side + (y - notch) * tip); }
    Eigen::Quaterniond rotation() const
    {
        Eigen::Matrix3d axes;
        axes << side, tip, face;
        return Eigen::Quaterniond(axes);
    }
};

const LeafPlace leafPlace;
const std::vector<Vec3> stemPath = {{0, 18, 0}, {1, 32, 0}, {0, 52, 0}, {-6, 70, 0}, {-9, 88, 0}};
const std::vector<Vec3> armPaths[] = {{{-9, 89, 0}, {8, 94, -2}, {28, 97, -8}},
                                      {{-9, 89, 0}, {-32, 90, 3}, {-54, 95, 8}}};
const Vec3 petioleJoint = leafPlace(0, -24); ///< point inside the leaf at which the petiole ends
const std::vector<Vec3> petiolePath = {{4, 43, 7}, {13, 42, 11}, {25, 43, 15}, petioleJoint - 8 * leafPlace.face};
const Ball petioleKnot = {petioleJoint - 5.5 * leafPlace.face, 6}, tendrilKnot = {{-40, 84, 7}, 5.5};

/// Returns a spiral that leads away from the stem and ends below an arm.
std::vector<Vec3> tendrilPath()
{
    std::vector<Vec3> path = {{-10, 57, 3}};
    constexpr int parts = 12;
    for (int i = 1; i < parts; ++i) {
        const double share = double(i) / parts, angle = 4.5 * std::numbers::pi * share;
        const double radius = 9 * std::min({1.0, 6 * share, 8 * (1 - share)});
        path.emplace_back(-10 - 27 * share, 58 + 13 * share + radius * std::sin(angle),
                          6 + radius * (1 - std::cos(angle)));
    }
    path.emplace_back(-39, 74, 7);
    path.emplace_back(-40, 80, 7);
    return path;
}

Json json(Rgb color)
{
    return {color.r, color.g, color.b};
}

/// Generates the strokes of the bunch in stroke file format.
class Vintner
{
public:
    Json file() const { return played_strokes::fileOf(m_strokes); }

    void leaf();
    void body();
    void berries();
    void stem();
    void petiole();
    void tendril();
    void colors();

private:
    void command(const char* name, Json with);
    void drag(const Brush& brush, const std::vector<Vec3>& path, const Json& settings);
    void lobes();
    void veins();
    void hang();
    void onLeaf(const Brush& brush, const std::vector<Vec3>& path, bool front, const Json& settings);
    void ball(const Ball& part, bool join = true);
    void paint(double radius, Rgb color, const std::vector<Vec3>& path);
    void paint(const Berry& berry);
    void bark();

    Json m_strokes = Json::array();
};

void Vintner::command(const char* name, Json with)
{
    with["command"] = name;
    m_strokes.push_back(std::move(with));
}

void Vintner::drag(const Brush& brush, const std::vector<Vec3>& path, const Json& settings)
{
    m_strokes.push_back(played_strokes::strokeOf(brush, played_strokes::samplesAt(path), settings));
}

/// Moves the tablet's rim to the leaf's outline in small steps, going all around in each, then pulls out the tips and
/// bends them down.
void Vintner::lobes()
{
    struct Way
    {
        Vec3 from, to;
        Vec3 at(double share) const { return from + share * (to - from); }
        const char* symmetry() const { return from.x() > 0 ? "x" : "none"; }
    };
    const Way rim[] = {{{0, 50, 0}, {0, 72, 0}},     {{8, 50, 0}, {12, 60, 0}},    {{16, 50, 0}, {19, 52, 0}},
                       {{25, 50, 0}, {25, 44, 0}},   {{32, 50, 0}, {36, 45, 0}},   {{37, 46, 0}, {54, 43, 0}},
                       {{37, 34, 0}, {54, 28, 0}},   {{37, 20, 0}, {45, 10, 0}},   {{37, 8, 0}, {40, -4, 0}},
                       {{37, -4, 0}, {50, -12, 0}},  {{37, -18, 0}, {64, -22, 0}}, {{37, -34, 0}, {60, -40, 0}},
                       {{37, -48, 0}, {45, -56, 0}}, {{24, -50, 0}, {28, -63, 0}}, {{14, -50, 0}, {13, -60, 0}},
                       {{7, -50, 0}, {8, -54, 0}},   {{0, -50, 0}, {0, -30, 0}}};
    const Way tips[] = {{{0, 71, 0}, {0, 82, 0}},     {{53, 40, 0}, {62, 46, 0}}, {{62, -24, 0}, {72, -26, 0}},
                        {{27, -62, 0}, {30, -70, 0}}, {{24, 37, 0}, {27, 47, 0}}, {{39, -2, 0}, {45, -2, 0}}};
    const Way droops[] = {{{0, 78, 0}, {0, 78, -30}},
                          {{58, 44, 0}, {58, 44, -14}},
                          {{70, -26, 0}, {70, -26, -20}},
                          {{28, -66, 0}, {28, -66, -10}}};
    constexpr double droopRadii[] = {95, 56, 68, 28};
    const auto smoothRim = [&] {
        for (std::size_t i = 0; i + 1 < std::size(rim); ++i)
            drag({"smooth", 9, 0.6}, {rim[i].to, rim[i + 1].to},
                 {{"symmetry", "x"}, {"spacing", 0.7}, {"detail", 1.5}});
    };
    constexpr int steps = 5;
    for (int step = 0; step < steps; ++step) {
        for (const Way& way : rim)
            drag({"grab", 16}, {way.at(double(step) / steps), way.at((step + 1.0) / steps)},
                 {{"symmetry", way.symmetry()}, {"detail", 0.85}});
    }
    smoothRim();
    for (const Way& way : tips)
        drag({"grab", 15}, {way.from, way.at(0.5), way.to}, {{"symmetry", way.symmetry()}, {"detail", 0.85}});
    smoothRim();
    for (std::size_t i = 0; i < std::size(droops); ++i)
        drag({"grab", droopRadii[i]}, {droops[i].from, droops[i].at(0.5), droops[i].to},
             {{"symmetry", droops[i].symmetry()}, {"topology", "keep"}});
}

/// Sculpts a path on both halves of the flat leaf, from its front or its back.
void Vintner::onLeaf(const Brush& brush, const std::vector<Vec3>& path, bool front, const Json& settings)
{
    const Vec3 towards = {0, 0, front ? -1.0 : 1.0};
    std::vector<Hand> hands;
    for (const Vec3& point : path)
        hands.push_back({point - 150 * towards, towards});
    Json stroke = played_strokes::strokeOf(brush, played_strokes::samplesOf(hands), settings);
    stroke["place"] = "ray";
    stroke["symmetry"] = "x";
    m_strokes.push_back(std::move(stroke));
}

/// Cuts furrows, raises ridges behind the main ones, and paints all of them while the leaf is still flat.
void Vintner::veins()
{
    const std::vector<Vec3> ways[] = {
        {{0, -30, 0}, {0, 21, 0}, {0, 74, 0}},        {{0, -28, 0}, {29, 9, 0}, {57, 42, 0}},
        {{0, -30, 0}, {33.5, -27, 0}, {66, -25, 0}},  {{0, -33, 0}, {15, -47, 0}, {28, -66, 0}},
        {{0, 8, 0}, {12, 22.5, 0}, {19, 34, 0}},      {{0, 30, 0}, {7.5, 42, 0}, {12, 54, 0}},
        {{26, 5, 0}, {35, 4, 0}, {42, 2, 0}},         {{30, 11, 0}, {29, 23, 0}, {28, 36, 0}},
        {{32, -26, 0}, {43, -35.5, 0}, {52, -44, 0}}, {{32, -26, 0}, {41, -19, 0}, {48, -13, 0}}};
    constexpr int mainVeins = 4;
    const Json cut = {{"spacing", 0.3}, {"detail", 2}};
    Json raise = cut;
    raise["invert"] = true;
    const Json colored = {{"spacing", 0.4}, {"falloff", 0}, {"color", json(veinGreen)}};
    command("fill", {{"color", json(leafGreen)}});
    for (int i = 0; const auto& way : ways) {
        const bool isMain = i++ < mainVeins;
        onLeaf({"crease", isMain ? 5.0 : 4.0, isMain ? 0.8 : 0.5}, way, true, cut);
        if (isMain)
            onLeaf({"crease", 5, 0.5}, way, false, raise);
    }
    for (int i = 0; const auto& way : ways) {
        const bool isMain = i++ < mainVeins;
        onLeaf({"paint", isMain ? 1.9 : 1.3}, way, true, colored);
        if (isMain)
            onLeaf({"paint", 1.8}, way, false, colored);
    }
}

void Vintner::hang()
{
    const Eigen::Quaterniond rotation = leafPlace.rotation();
    command("move", {{"by", Vec3(0, -LeafPlace::notch, 0)}});
    command("scale", {{"factor", LeafPlace::scale}});
    command("rotate", {{"rotation", {rotation.x(), rotation.y(), rotation.z(), rotation.w()}}});
    command("move", {{"by", leafPlace.position}});
}

void Vintner::leaf()
{
    lobes();
    veins();
    hang();
}

void Vintner::ball(const Ball& part, bool join)
{
    drag({"pull", part.radius}, {part.middle}, {{"add", true}, {"join", join}});
}

void Vintner::body()
{
    for (bool isFirst = true; const Ball& part : bodyBalls)
        ball(part, !std::exchange(isFirst, false));
}

void Vintner::berries()
{
    for (const Berry& berry : bunch())
        ball({berry.middle, berry.radius});
    // Refines the mesh where berries meet, so that the border between colours is sharp.
    for (const Berry& berry : bunch())
        drag({"smooth", 1.02 * berry.radius, 0.4}, {berry.middle},
             {{"falloff", 0}, {"detail", 0.65}, {"topology", "refine"}});
}

void Vintner::stem()
{
    drag({"snake", 15}, stemPath, {{"spacing", 0.1}, {"detail", 0.7}});
    for (const auto& path : armPaths)
        drag({"snake", 13}, path, {{"spacing", 0.1}, {"detail", 0.8}});
    const Vec3 root = {0, 22, 0};
    drag({"smooth", 20, 0.3}, {root, root}, {{"detail", 0.35}, {"topology", "refine"}});
}

void Vintner::petiole()
{
    drag({"snake", 8}, petiolePath, {{"spacing", 0.1}});
    ball(petioleKnot);
}

void Vintner::tendril()
{
    drag({"snake", 5.5}, tendrilPath(), {{"spacing", 0.1}});
    ball(tendrilKnot);
}

/// Paints with a sharp border.
void Vintner::paint(double radius, Rgb color, const std::vector<Vec3>& path)
{
    drag({"paint", radius}, path, {{"spacing", 0.25}, {"falloff", 0}, {"color", json(color)}});
}

/// Paints the berry, then its highlight with a soft border. A brush that follows the surface stays on the berry.
void Vintner::paint(const Berry& berry)
{
    paint(1.03 * berry.radius, berry.paint.ground, {berry.middle});
    const Vec3 towards = -(berry.outwards() + Vec3(0, 0.3, 0)).normalized();
    const Hand hand = {berry.middle - 1.5 * berry.radius * towards, towards};
    m_strokes.push_back(
        played_strokes::strokeOf({"paint", 0.7 * berry.radius, 0.75}, played_strokes::samplesOf({hand}),
                                 {{"brush", "ray"}, {"falloff", 3}, {"color", json(berry.paint.light)}}));
}

/// Paints stem and arms with darker and lighter spots.
void Vintner::bark()
{
    paint(14, wood, {{0, 23, 0}, stemPath[1], stemPath[2], stemPath[3], stemPath[4]});
    for (const auto& path : armPaths)
        paint(15, wood, path);
    int i = 0;
    const auto spots = [&](const std::vector<Vec3>& path) {
        for (std::size_t part = 0; part + 1 < path.size(); ++part) {
            for (double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
                const Vec3 aside = {std::sin(2.4 * i), 0, std::cos(2.4 * i)};
                drag({"paint", 5, 0.6}, {path[part] + share * (path[part + 1] - path[part]) + 7 * aside},
                     {{"color", json(i % 2 == 0 ? lightWood : darkWood)}});
                ++i;
            }
        }
    };
    spots({stemPath.begin() + 1, stemPath.end()});
    for (const auto& path : armPaths)
        spots(path);
}

/// Paints with wide brushes first, so that later strokes cover their rims.
void Vintner::colors()
{
    constexpr struct
    {
        double height, radius;
    } shades[] = {{-6, 48}, {-28, 58}, {-62, 58}, {-96, 50}, {-126, 40}};
    for (const auto& part : shades)
        paint(part.radius, shade, {{0, part.height, 0}});
    std::vector<Vec3> path = tendrilPath();
    paint(7, tendrilGreen, path);
    bark();
    const Vec3 afterRoot = 0.7 * petiolePath[0] + 0.3 * petiolePath[1];
    paint(8, petioleGreen, {afterRoot, petiolePath[1], petiolePath[2], petiolePath[3]});
    paint(7, petioleGreen, {petioleKnot.middle});
    path.erase(path.begin(), path.begin() + 2);
    paint(6, tendrilGreen, path);
    paint(6.5, wood, {tendrilKnot.middle});
    const std::vector<Berry> berries = bunch();
    // from bottom to top, so that the highlight covers the upper rim
    for (const Berry& berry : berries | std::views::reverse)
        paint(berry);
}
constexpr struct
{
    const char* name;
    void (Vintner::*work)();
    int components, genus;
} steps[] = {{"leaf", &Vintner::leaf, 1, 0},       {"body", &Vintner::body, 2, 0},
             {"berries", &Vintner::berries, 2, 0}, {"stem", &Vintner::stem, 2, 0},
             {"petiole", &Vintner::petiole, 1, 0}, {"tendril", &Vintner::tendril, 1, 1},
             {"colors", &Vintner::colors, 1, 1}};

std::optional<played_strokes::Played> played(const Vintner& vintner)
{
    const core::TriangleMesh tablet = core::starterModel(core::Starter::Tablet);
    return played_strokes::replay(vintner.file(), &tablet);
}

std::optional<played_strokes::Played> playedWhole()
{
    Vintner vintner;
    for (const auto& step : steps)
        (vintner.*step.work)();
    return played(vintner);
}

/// Returns whether a colour is a mixture of the paint's ground and its highlight.
bool isOf(const Paint& paint, Rgb color)
{
    const auto vector = [](Rgb c) { return Vec3(c.r, c.g, c.b); };
    const Vec3 way = vector(paint.light) - vector(paint.ground), seen = vector(color) - vector(paint.ground);
    const double length = way.squaredNorm();
    const double share = length > 0 ? std::clamp(seen.dot(way) / length, 0.0, 1.0) : 0;
    constexpr double rounding = 6; // per colour component (0 to 255), for several coats
    return (seen - share * way).norm() < rounding;
}

/// Returns the share of the counted vertices whose colour belongs to one of the paints.
double shareOf(const std::vector<Paint>& paints, const core::TriangleMesh& mesh,
               const std::function<bool(const Vec3&)>& counts)
{
    int all = 0, painted = 0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        if (!counts(mesh.points[v].cast<double>()))
            continue;
        ++all;
        painted += std::ranges::any_of(paints, [&](const Paint& p) { return isOf(p, mesh.colors[v]); });
    }
    return all > 0 ? double(painted) / all : 0;
}

/// Returns whether a point is on, in or next to another berry.
bool isNearOther(const Berry& berry, const Vec3& point, const std::vector<Berry>& berries)
{
    return std::ranges::any_of(berries, [&](const Berry& other) {
        return other.middle != berry.middle && (point - other.middle).norm() < 1.04 * other.radius;
    });
}

std::vector<Paint> paintsOf(Ripeness ripeness)
{
    std::vector<Paint> paints;
    for (const Berry& berry : bunch()) {
        if (berry.ripeness == ripeness)
            paints.push_back(berry.paint);
    }
    return paints;
}

const std::vector<Paint> leafPaints = {{leafGreen, leafGreen}}, veinPaints = {{veinGreen, veinGreen}},
                         stalkPaints = {{petioleGreen, petioleGreen}, {tendrilGreen, tendrilGreen}},
                         shadePaints = {{shade, shade}},
                         woodPaints = {{wood, darkWood}, {wood, lightWood}, {darkWood, lightWood}};

std::vector<Paint> together(const std::vector<std::vector<Paint>>& parts)
{
    std::vector<Paint> all;
    for (const auto& part : parts)
        all.insert(all.end(), part.begin(), part.end());
    return all;
}
} // namespace

class TestGrapes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void eachStage_hasTheHandlesCounted();
    void sameFile_makesTheSameMesh();
    void berries_beginInTheBody();
    void berries_areRound();
    void berries_haveTheirColors();
    void leafAndStem_haveTheirColors();
    void colors_haveTheirShares_data();
    void colors_haveTheirShares();

private:
    core::TriangleMesh m_bunch;
};

void TestGrapes::initTestCase()
{
    auto whole = playedWhole();
    QVERIFY(whole);
    m_bunch = std::move(whole->mesh);
    QCOMPARE(m_bunch.colors.size(), m_bunch.points.size());
}

void TestGrapes::eachStage_hasTheHandlesCounted()
{
    Vintner vintner;
    std::size_t vertices = 0;
    for (std::size_t i = 0; i < std::size(steps); ++i) {
        const auto& step = steps[i];
        (vintner.*step.work)();
        if (effort() == Effort::Small && i % 3 != 2) // each stage repeats the strokes of all earlier ones
            continue;
        const auto grapes = played(vintner);
        QVERIFY2(grapes, step.name);
        const auto mesh = mesh_asserts::sculptable(grapes->mesh);
        VERIFY_VALID(*mesh);
        QCOMPARE(grapes->stats["components"].get<int>(), step.components);
        QCOMPARE(grapes->stats["genus"].get<int>(), step.genus);
        QCOMPARE(mesh_asserts::eulerNumber(*mesh), 2 * (step.components - step.genus));
        vertices = grapes->mesh.points.size();
    }
    QVERIFY2(vertices >= 10'000 && vertices <= 100'000, qPrintable(QString::number(vertices)));
}

void TestGrapes::sameFile_makesTheSameMesh()
{
    const auto again = playedWhole();
    QVERIFY(again);
    QVERIFY(again->mesh.points == m_bunch.points);
    QVERIFY(again->mesh.triangles == m_bunch.triangles);
    QVERIFY(again->mesh.colors == m_bunch.colors);
}

/// Checks the assumption of the handle count: each berry's centre is in the body.
void TestGrapes::berries_beginInTheBody()
{
    for (const Berry& berry : bunch())
        QVERIFY(std::ranges::any_of(
            bodyBalls, [&](const Ball& part) { return (berry.middle - part.middle).norm() < part.radius; }));
}

/// Checks the roundness of each berry up to 37 degrees from its outward direction, except where another berry is near.
void TestGrapes::berries_areRound()
{
    const std::vector<Berry> berries = bunch();
    for (const Berry& berry : berries) {
        int vertices = 0;
        for (const core::Vec3f& vertex : m_bunch.points) {
            const Vec3 point = vertex.cast<double>(), way = point - berry.middle;
            const double distance = way.norm();
            if (distance > 1.1 * berry.radius || way.dot(berry.outwards()) < 0.8 * distance ||
                isNearOther(berry, point, berries))
                continue;
            ++vertices;
            QVERIFY2(std::abs(distance - berry.radius) < 0.02 * berry.radius, qPrintable(QString::number(distance)));
        }
        QVERIFY2(vertices > 100, qPrintable(QString::number(vertices)));
    }
}

void TestGrapes::berries_haveTheirColors()
{
    const std::vector<Berry> berries = bunch();
    for (const Berry& berry : berries) {
        const double share = shareOf({berry.paint}, m_bunch, [&](const Vec3& point) {
            return std::abs((point - berry.middle).norm() - berry.radius) < 0.02 * berry.radius &&
                   !isNearOther(berry, point, berries);
        });
        QVERIFY2(share > 0.95, qPrintable(QString::number(share)));
    }
}

void TestGrapes::leafAndStem_haveTheirColors()
{
    const Vec3 blade = leafPlace(0, 10);
    const auto inBlade = [&](const Vec3& point) { return (point - blade).norm() < 20; };
    QVERIFY(shareOf(together({leafPaints, veinPaints}), m_bunch, inBlade) > 0.95);
    QVERIFY(shareOf(leafPaints, m_bunch, inBlade) > 0.5);

    // The stem is uncovered between the berries and the petiole, and above the tendril.
    const auto inStem = [](double from, double to) {
        return [=](const Vec3& point) {
            return point.y() > from && point.y() < to && std::hypot(point.x(), point.z()) < 12;
        };
    };
    QVERIFY(shareOf(woodPaints, m_bunch, inStem(24, 34)) > 0.95);
    QVERIFY(shareOf(woodPaints, m_bunch, inStem(66, 100)) > 0.9);
}

void TestGrapes::colors_haveTheirShares_data()
{
    QTest::addColumn<std::vector<Paint>>("paints");
    QTest::addColumn<double>("least");
    QTest::addColumn<double>("most");
    const std::vector<Paint> berries =
        together({paintsOf(Ripeness::Ripe), paintsOf(Ripeness::Turning), paintsOf(Ripeness::Unripe)});
    QTest::newRow("leaf") << leafPaints << 0.2 << 0.6;
    QTest::newRow("veins") << veinPaints << 0.05 << 0.25;
    QTest::newRow("petiole and tendril") << stalkPaints << 0.02 << 0.15;
    QTest::newRow("wood") << woodPaints << 0.03 << 0.15;
    QTest::newRow("ripe berries") << paintsOf(Ripeness::Ripe) << 0.15 << 0.6;
    QTest::newRow("turning berries") << paintsOf(Ripeness::Turning) << 0.02 << 0.15;
    QTest::newRow("unripe berries") << paintsOf(Ripeness::Unripe) << 0.02 << 0.15;
    QTest::newRow("shade") << shadePaints << 0.005 << 0.1;
    QTest::newRow("any of these") << together({leafPaints, veinPaints, stalkPaints, woodPaints, berries, shadePaints})
                                  << 0.97 << 1.0;
    QTest::newRow("bare") << std::vector<Paint>{{bare, bare}} << 0.0 << 0.001;
}

void TestGrapes::colors_haveTheirShares()
{
    QFETCH(const std::vector<Paint>, paints);
    QFETCH(const double, least);
    QFETCH(const double, most);
    const double share = shareOf(paints, m_bunch, [](const Vec3&) { return true; });
    QVERIFY2(share >= least && share <= most, qPrintable(QString::number(share)));
}

FETTLE_TEST(TestGrapes, QCoreApplication)
#include "tst_grapes.moc"
