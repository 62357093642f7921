#include "vr/sculpt/brush_state.h"

#include "tests/support/test_main.h"
#include "tests/vr/input/hand_motion.h"

#include "core/stroke/stroke_path.h"

#include <QTest>

#include <algorithm>
#include <set>

using core::Vec3;
using vr::BrushState;
using vr::ButtonPreset;
using vr::ModelPlacement;

namespace
{
constexpr double tolerance = 1e-9;

BrushState after(BrushState brush, std::initializer_list<vr::WandAction> actions)
{
    for (const vr::WandAction& action : actions)
        brush = vr::changed(brush, action);
    return brush;
}

ModelPlacement somePlacement()
{
    ModelPlacement placement(core::Box(Vec3(-50, -50, -50), Vec3(50, 50, 50)));
    placement.place({Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Vec3::UnitY())), Vec3(0.3, 1.6, 0.1)});
    placement.scale(1.7);
    return placement;
}

/// Returns the dabs of a wand that moves straight for two seconds and rests before and after.
std::vector<Vec3> dabsAt(double rate, const BrushState& brush, const ModelPlacement& placement)
{
    core::StrokeSettings settings = vr::strokeSettings(brush, {}, placement);
    settings.airbrush = 0; // no airbrush dabs while resting
    core::StrokePath path(settings);
    std::vector<Vec3> dabs;
    for (const double time : frameTimes(3, rate)) {
        vr::StrokePoint point;
        point.time = time;
        const double share = std::clamp((time - 0.5) / 2, 0.0, 1.0);
        point.tip.position = Vec3(-0.2, 1.4, -0.5) + share * Vec3(0.4, 0.1, 0.05);
        path.add(vr::strokeSample(brush, point, placement));
        while (const auto due = path.next([](const Vec3& position, const Vec3&) { return std::optional(position); }))
            dabs.push_back(due->dab.position);
    }
    return dabs;
}
} // namespace

class TestBrushState : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theFirstIsThePapers()
    {
        const BrushState brush;
        QCOMPARE(brush.stroke.tool, core::Tool::Pull);
        QCOMPARE(brush.stroke.brush, core::BrushShape::Sphere);
        QCOMPARE(brush.stroke.topology, core::Topology::Adaptive);
        QCOMPARE(brush.stroke.symmetry, core::Symmetry::None);
        QCOMPARE(after(brush, {vr::ToggleSymmetry{}}).stroke.symmetry, core::Symmetry::Y);
        QVERIFY(brush.radius >= vr::minRadius && brush.radius <= vr::maxRadius);
    }

    /// Checks the first plane of symmetry: level for the paper's preset, left to right for the others. A chosen plane
    /// is kept.
    void theFirstPlaneIsThePresets()
    {
        const std::pair<ButtonPreset, core::Symmetry> firsts[] = {{ButtonPreset::Paper, core::Symmetry::Y},
                                                                  {ButtonPreset::Studio, core::Symmetry::X},
                                                                  {ButtonPreset::OneHand, core::Symmetry::X}};
        for (const auto& [preset, plane] : firsts) {
            BrushState brush;
            brush.preset = preset;
            QCOMPARE(after(brush, {vr::ToggleSymmetry{}}).stroke.symmetry, plane);
            QCOMPARE(changed(brush, vr::PanelAction(vr::ChooseSymmetry{true})).stroke.symmetry, plane);
            brush.plane = core::Symmetry::Z;
            QCOMPARE(after(brush, {vr::ToggleSymmetry{}}).stroke.symmetry, core::Symmetry::Z);
        }
    }

    void toolsComeRoundInOrder()
    {
        using enum vr::ButtonPreset;
        const std::size_t count = core::toolNames().size();
        for (const vr::ButtonPreset preset : {Paper, Studio, OneHand}) {
            const std::vector<core::Tool> order = vr::toolOrder(preset);
            QCOMPARE(std::set(order.begin(), order.end()).size(), count);
            BrushState brush = changed(BrushState(), vr::PanelAction(preset));
            for (std::size_t i = 1; i <= count; ++i) {
                brush = after(brush, {vr::StepTool{1}});
                QCOMPARE(brush.stroke.tool, order[i % count]);
            }
            for (std::size_t i = count; i-- > 0;) {
                brush = after(brush, {vr::StepTool{-1}});
                QCOMPARE(brush.stroke.tool, order[i]);
            }
        }
    }

    void thePapersToolsComeFirstInItsPreset()
    {
        using enum core::Tool;
        const std::vector<core::Tool> order = vr::toolOrder(vr::ButtonPreset::Paper);
        const std::vector<core::Tool> first(order.begin(), order.begin() + 5), others(order.begin() + 5, order.end());
        QCOMPARE(first, (std::vector{Pull, Push, Flatten, Smooth, Paint}));
        QVERIFY(std::ranges::is_sorted(others));
        QVERIFY(std::ranges::is_sorted(vr::toolOrder(vr::ButtonPreset::Studio))); // in the order of the palette
    }

    void whatIsToggledTwiceIsAsBefore()
    {
        BrushState brush;
        brush.plane = core::Symmetry::X;
        for (int i = 1; i <= 4; ++i) {
            brush =
                after(brush, {vr::ToggleBrushShape{}, vr::ToggleTopology{}, vr::ToggleSymmetry{}, vr::ToggleInverse{}});
            const bool isOn = i % 2 == 1;
            QCOMPARE(brush.stroke.brush == core::BrushShape::Ray, isOn);
            QCOMPARE(brush.stroke.topology == core::Topology::Uniform, isOn);
            QCOMPARE(brush.stroke.symmetry, isOn ? core::Symmetry::X : core::Symmetry::None);
            QCOMPARE(brush.isInverse, isOn);
        }
    }

    void theRadiusStaysInItsRange()
    {
        const BrushState brush;
        QCOMPARE(after(brush, {vr::ScaleRadius{1.5}}).radius, 1.5 * vr::defaultRadius);
        QCOMPARE(after(brush, {vr::ScaleRadius{1e9}}).radius, vr::maxRadius);
        QCOMPARE(after(brush, {vr::ScaleRadius{1e-9}}).radius, vr::minRadius);
    }

    /// Checks that each step of a panel's slider multiplies the radius by the same factor, within its range.
    void theRadiusFollowsItsSlider()
    {
        const auto radiusAt = [](double value) {
            return vr::changed(BrushState(), vr::PanelAction(vr::Slide{vr::PanelSlider::Radius, value})).radius;
        };
        QCOMPARE(radiusAt(0), vr::minRadius);
        QCOMPARE(radiusAt(3), 8 * vr::minRadius);
        QCOMPARE(radiusAt(100), vr::maxRadius);
        QCOMPARE(radiusAt(-1), vr::minRadius);
        const BrushState painted = vr::changed(BrushState(), vr::PanelAction(vr::Slide{vr::PanelSlider::Radius, 5}));
        QVERIFY(painted.stroke.color == BrushState().stroke.color);
    }

    void channelsGoFrom0To255()
    {
        BrushState brush;
        brush.stroke.color = {10, 20, 30};
        QVERIFY((after(brush, {vr::ChangeChannel{0, 5}}).stroke.color == core::Rgb{15, 20, 30}));
        QVERIFY((after(brush, {vr::ChangeChannel{1, -25}}).stroke.color == core::Rgb{10, 0, 30}));
        QVERIFY((after(brush, {vr::ChangeChannel{2, 10000}, vr::ChangeChannel{2, -1}}).stroke.color ==
                 core::Rgb{10, 20, 254}));
    }

    void whatIsNotTheBrushsLeavesItAlone()
    {
        const BrushState brush;
        const BrushState same =
            after(brush, {vr::Undo{}, vr::Redo{}, vr::SaveModel{}, vr::RestoreModel{}, vr::TurnModel{1},
                          vr::ScaleModel{2}, vr::MoveModel{}, vr::StretchModel{}, vr::SelectChannel{2},
                          vr::OpenToolMenu{}, vr::OpenColorPanel{}, vr::PressPanel{}, vr::ReleasePanel{}, vr::Refuse{},
                          vr::BeginStroke{true}, vr::StrokePoint{}, vr::EndStroke{}});
        QVERIFY(same.stroke.tool == brush.stroke.tool && same.stroke.brush == brush.stroke.brush &&
                same.stroke.color == brush.stroke.color && same.stroke.topology == brush.stroke.topology &&
                same.stroke.symmetry == brush.stroke.symmetry && same.radius == brush.radius &&
                same.isInverse == brush.isInverse);
    }

    void theOtherHandSmoothsAsStronglyAsSmooth()
    {
        BrushState brush;
        brush.stroke.strength = 2;
        brush.smoothStrength = 0.25;
        const core::StrokeSettings smooth = vr::strokeSettings(brush, {.smooths = true}, somePlacement());
        QVERIFY(smooth.tool == core::Tool::Smooth && smooth.strength == 0.25);
        QCOMPARE(vr::strokeSettings(brush, {}, somePlacement()).strength, 2.0);
    }

    /// Checks that only a new stroke of the spherical brush may add a ball, and only if it pulls: Pull, or inverted
    /// Push. The ball is added where such a stroke begins in empty space.
    void onlyAPullThatBeginsMayAdd()
    {
        BrushState brush;
        QVERIFY(vr::strokeSettings(brush, {}, somePlacement()).add);
        QVERIFY(!vr::strokeSettings(brush, {.smooths = false, .continues = true}, somePlacement()).add);
        QVERIFY(!vr::strokeSettings(brush, {.smooths = true}, somePlacement()).add);
        brush.isInverse = true;
        QVERIFY(!vr::strokeSettings(brush, {}, somePlacement()).add);
        brush.stroke.tool = core::Tool::Push;
        QVERIFY(vr::strokeSettings(brush, {}, somePlacement()).add);
        brush.stroke.brush = core::BrushShape::Ray;
        QVERIFY(!vr::strokeSettings(brush, {}, somePlacement()).add);
    }

    /// Checks that the next stroke adds a ball and joins it with what it crosses. Smoothing strokes and continued
    /// strokes do not use up the ball.
    void theNextStrokeAddsABall()
    {
        BrushState brush = vr::changed(BrushState(), vr::PanelAction(core::Tool::Flatten));
        brush.isInverse = true;
        brush = vr::changed(brush, vr::PanelAction(vr::AddNext{true}));
        const core::StrokeSettings adding = vr::strokeSettings(brush, {}, somePlacement());
        QVERIFY(adding.add && adding.join && adding.tool == core::Tool::Pull);
        QVERIFY(!vr::strokeSettings(brush, {.smooths = true}, somePlacement()).join);
        QVERIFY(!vr::strokeSettings(brush, {.smooths = false, .continues = true}, somePlacement()).join);
        QVERIFY(!vr::changed(brush, vr::PanelAction(vr::AddNext{false})).addsNext);
        QVERIFY(!vr::changed(brush, vr::PanelAction(core::Tool::Pull)).addsNext);
    }

    void aStrokeIsWhatTheHandMeans()
    {
        using core::Tool;
        BrushState brush;
        brush.stroke.falloff = 6;
        brush.stroke.detail = 0.5;
        brush.stroke.fusion = false;
        const core::StrokeSettings settings = vr::strokeSettings(brush, {}, somePlacement());
        QVERIFY(settings.falloff == 6 && settings.detail == 0.5 && !settings.fusion);
        QCOMPARE(settings.place, core::Placement::Point);
        for (std::size_t i = 0; i < core::toolNames().size(); ++i) {
            const auto tool = static_cast<Tool>(i);
            brush.stroke.tool = tool;
            brush.isInverse = false;
            QCOMPARE(vr::strokeSettings(brush, {}, somePlacement()).tool, tool);
            QCOMPARE(vr::strokeSettings(brush, {true}, somePlacement()).tool, Tool::Smooth);
            QVERIFY(!vr::strokeSettings(brush, {}, somePlacement()).inverted);
            QCOMPARE(vr::strokeSettings(brush, {}, somePlacement()).spacing,
                     core::isDragTool(tool) ? 0 : vr::wandSpacing);
            QCOMPARE(vr::strokeSettings(brush, {true}, somePlacement()).spacing, vr::wandSpacing);
            brush.isInverse = true;
            const Tool inverse = tool == Tool::Pull ? Tool::Push : tool == Tool::Push ? Tool::Pull : tool;
            QCOMPARE(vr::strokeSettings(brush, {}, somePlacement()).tool, inverse);
            QCOMPARE(vr::strokeSettings(brush, {}, somePlacement()).inverted, core::hasInverse(tool));
            QCOMPARE(vr::strokeSettings(brush, {true}, somePlacement()).tool, Tool::Smooth);
            QVERIFY(!vr::strokeSettings(brush, {true}, somePlacement()).inverted);
        }
    }

    /// Checks that samples are in model space: a model shown twice as large gets a brush half as large, and the wand's
    /// pose is converted.
    void samplesAreInTheModelsSpace()
    {
        const BrushState brush;
        ModelPlacement placement = somePlacement();
        vr::StrokePoint point;
        point.time = 3;
        point.pressure = 0.4;
        point.tip = {Eigen::Quaterniond(Eigen::AngleAxisd(1, Vec3::UnitX())), Vec3(0.1, 1.5, -0.4)};
        const core::StrokeSample sample = vr::strokeSample(brush, point, placement);
        QVERIFY((placement.toRoom(sample.position) - point.tip.position).norm() < tolerance);
        QVERIFY((placement.directionToRoom(sample.direction) - point.tip.forward()).norm() < tolerance);
        QVERIFY((placement.directionToRoom(*sample.up) - point.tip.rotation * Vec3::UnitY()).norm() < tolerance);
        QCOMPARE(sample.time, 3.0);
        QCOMPARE(sample.pressure, 0.4);
        QVERIFY(core::isUsable(vr::strokeSettings(brush, {}, placement), sample));
        QCOMPARE(*sample.radius, vr::strokeSettings(brush, {}, placement).radius);
        QVERIFY(std::abs(placement.lengthToRoom(*sample.radius) - brush.radius) < tolerance);
        placement.scale(2);
        QVERIFY(std::abs(*vr::strokeSample(brush, point, placement).radius - *sample.radius / 2) < tolerance);
    }

    void toolsThatCanGoOnWhereTheHandRests()
    {
        for (const core::Tool tool : {core::Tool::Pull, core::Tool::Smooth, core::Tool::Paint, core::Tool::Grab}) {
            BrushState brush;
            brush.stroke.tool = tool;
            QCOMPARE(vr::strokeSettings(brush, {}, somePlacement()).airbrush > 0, core::canAirbrush(tool));
            brush.airbrush.fill(0);
            QCOMPARE(vr::strokeSettings(brush, {}, somePlacement()).airbrush, 0.0);
        }
    }

    /// Checks the topology: the preset Paper adapts the mesh, the others keep its detail. Panel and pad choose another
    /// topology, and Uniform can be left again.
    void topologyIsThePresetsUntilItIsChosen()
    {
        using core::Topology;
        BrushState brush;
        brush = vr::changed(brush, vr::PanelAction(vr::ButtonPreset::Studio));
        QCOMPARE(brush.stroke.topology, Topology::Refine);
        brush = vr::changed(brush, vr::PanelAction(Topology::Keep));
        brush = after(brush, {vr::ToggleTopology{}});
        QCOMPARE(brush.stroke.topology, Topology::Uniform);
        brush = vr::changed(brush, vr::PanelAction(vr::ButtonPreset::Paper));
        QCOMPARE(brush.stroke.topology, Topology::Uniform);
        brush = after(brush, {vr::ToggleTopology{}});
        QCOMPARE(brush.stroke.topology, Topology::Adaptive);
    }

    /// Checks that dabs are evenly spaced at any frame rate.
    void dabsStandEvenly()
    {
        const BrushState brush;
        const ModelPlacement placement = somePlacement();
        const std::vector<Vec3> fast = dabsAt(144, brush, placement);
        const double step = vr::wandSpacing * vr::strokeSettings(brush, {}, placement).radius;
        QVERIFY(fast.size() > 100);
        for (const double rate : frameRates) {
            const std::vector<Vec3> dabs = dabsAt(rate, brush, placement);
            QCOMPARE(dabs.size(), fast.size());
            for (std::size_t i = 0; i < dabs.size(); ++i) {
                QVERIFY((dabs[i] - fast[i]).norm() < 1e-6 * step);
                QVERIFY(i == 0 || std::abs((dabs[i] - dabs[i - 1]).norm() - step) < 1e-6 * step);
            }
        }
    }
};

FETTLE_TEST(TestBrushState, QCoreApplication)
#include "tst_brush_state.moc"
