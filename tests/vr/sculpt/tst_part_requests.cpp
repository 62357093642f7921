#include "vr/sculpt/part_requests.h"

#include "core/geometry/rotation.h"
#include "core/mesh/face_octree.h"
#include "core/mesh/mesh.h"
#include "core/mesh/surface_query.h"
#include "tests/support/test_main.h"
#include "vr/sculpt/part_hand.h"
#include "vr/sculpt/shape_tool.h"

#include <QTest>

#include <random>

using core::PartId;
using vr::PanelCommand;

namespace
{
vr::PartsPanel threeParts()
{
    vr::PartsPanel panel;
    for (const auto& [id, name] : {std::pair<PartId, const char*>{3, "body"}, {0, ""}, {7, "wheel"}})
        panel.parts << vr::PartRow{{id, name, id != 0, false, core::Rgb{1, 2, 3}}, QStringLiteral("row %1").arg(id)};
    panel.active = 7;
    return panel;
}

/// Returns the command that the action requests for `part`; none if it requests another thing.
template <class Command> std::optional<Command> requested(const vr::PanelAction& action, PartId part)
{
    const auto request = vr::requestOf(threeParts(), action);
    const auto* change = request ? std::get_if<vr::ChangePart>(&*request) : nullptr;
    const auto* command = change && change->part == part ? std::get_if<Command>(&change->command) : nullptr;
    return command ? std::optional(*command) : std::nullopt;
}

vr::ModelPlacement turnedPlacement()
{
    vr::ModelPlacement placement(core::Box(core::Vec3(-20, -20, -20), core::Vec3(20, 20, 20)));
    placement.place({Eigen::Quaterniond::Identity(), {0, 1.6, 0}});
    placement.turn(0.3);
    placement.scale(2);
    return placement;
}

/// A document that answers what moves, and records requests.
class HoldingPort : public vr::DocumentPort
{
public:
    std::optional<core::MeshPatch> takePatch() override { return {}; }
    std::optional<vr::DocumentUpdate> takeUpdate() override { return {}; }
    bool beginStroke(const core::StrokeSettings&) override { return false; }
    void addSample(const core::StrokeSample&) override {}
    void endStroke() override {}
    vr::StrokeEffect takeEffect() override { return {}; }
    void querySurface(const vr::SurfaceQuery&) override {}
    std::optional<vr::SurfaceQueryResult> takeQueryResult() override { return {}; }
    void queryPart() override { answers = ++queries; }
    std::optional<vr::MovablePart> takePart() override
    {
        return std::exchange(answers, 0) > 0 ? std::optional(movable) : std::nullopt;
    }
    void request(const vr::DocumentRequest& request) override { requests.push_back(request); }
    bool isSettled() override { return isDone; }
    void show(const vr::AvatarState&) override {}

    vr::MovablePart movable{{3, -4, 5}, std::make_shared<core::Footprint>()};
    int queries = 0, answers = 0;
    bool isDone = false;
    std::vector<vr::DocumentRequest> requests;
};
} // namespace

class TestPartRequests : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void parts_areShownAndHiddenOneByOne();
    void lock_keepsEverythingElse();
    void name_isTheActiveParts();
    void tag_isTheActiveParts();
    void combine_takesTheMarked();
    void others_requestNothing();
    void pick_beginsAtThePalm();
    void cut_hasTheSymmetry();
    void shape_isAsLargeAsTheBrush_data();
    void shape_isAsLargeAsTheBrush();
    void outline_isOnTheShape_data() { shape_isAsLargeAsTheBrush_data(); }
    void shape_isMirrored();
    void outline_isOnTheShape();
    void part_followsTheHand();
    void part_movesWhenTheAnswerComes();
    void part_staysIfTheHandDoes();
    void part_isDroppedWithItsModel();
};

void TestPartRequests::parts_areShownAndHiddenOneByOne()
{
    const auto shown = [](const vr::PanelAction& action, PartId part) {
        const auto command = requested<core::ShowParts>(action, part);
        return command ? command->visible : std::vector<PartId>{99};
    };
    QCOMPARE(shown(vr::ShowPart{0, true}, 0), (std::vector<PartId>{3, 0, 7}));
    QCOMPARE(shown(vr::ShowPart{3, false}, 3), (std::vector<PartId>{7}));
    QCOMPARE(shown(vr::ShowPart{3, true}, 3), (std::vector<PartId>{3, 7}));
    const auto all = requested<core::Hide>(PanelCommand::ShowAllParts, 7);
    QVERIFY(all && all->what == core::Hide::What::NoPart);
}

/// Checks that name, tag and place in the list stay, also of a part without a name of its own.
void TestPartRequests::lock_keepsEverythingElse()
{
    const vr::PartsPanel panel = threeParts();
    for (std::size_t i = 0; i < 3; ++i) {
        const core::Part& part = panel.parts[static_cast<qsizetype>(i)].part;
        const auto edit = requested<core::EditPart>(vr::LockPart{part.id, true}, part.id);
        QVERIFY(edit && edit->isLocked && edit->name == part.name && edit->tag == part.tag && edit->position == i);
    }
    QVERIFY(!vr::requestOf(panel, vr::LockPart{5, true}));
}

/// Checks that lock, tag and place in the list stay, that no other part gets the same name, and that the name which the
/// part has already requests nothing.
void TestPartRequests::name_isTheActiveParts()
{
    const auto edit = requested<core::EditPart>(vr::NamePart{QStringLiteral("Flügel")}, 7);
    QVERIFY(edit && edit->name == "Flügel" && !edit->isLocked && edit->position == 2U);
    QCOMPARE(edit->tag, (std::optional<core::Rgb>({1, 2, 3})));
    const auto second = requested<core::EditPart>(vr::NamePart{QStringLiteral("body")}, 7);
    QVERIFY(second && second->name == "body 2");
    QVERIFY(!vr::requestOf(threeParts(), vr::NamePart{QStringLiteral("wheel")}));
    vr::PartsPanel panel = threeParts();
    panel.active = 5; // is gone
    QVERIFY(!vr::requestOf(panel, vr::NamePart{QStringLiteral("body")}));
    QVERIFY(!vr::requestOf(vr::PartsPanel(), vr::NamePart{QStringLiteral("body")}));
}

void TestPartRequests::tag_isTheActiveParts()
{
    const auto edit = requested<core::EditPart>(vr::TagPart{core::Rgb{9, 8, 7}}, 7);
    QVERIFY(edit && edit->name == "wheel" && !edit->isLocked && edit->position == 2U);
    QCOMPARE(edit->tag, (std::optional<core::Rgb>({9, 8, 7})));
    const auto none = requested<core::EditPart>(vr::TagPart{}, 7);
    QVERIFY(none && none->name == "wheel" && !none->tag);
    QVERIFY(!vr::requestOf(threeParts(), vr::TagPart{core::Rgb{1, 2, 3}}));
}

void TestPartRequests::combine_takesTheMarked()
{
    vr::PartsPanel panel = threeParts();
    panel.marked = {7, 0, 3, 8}; // the active part and one that is gone do not count
    const auto request = vr::requestOf(panel, vr::CombineMarked{core::SetOperation::Intersection});
    const auto* shown = request ? std::get_if<vr::PreviewParts>(&*request) : nullptr;
    QVERIFY(shown && shown->part == 7 && shown->command.operation == core::SetOperation::Intersection);
    QCOMPARE(shown->command.others, (std::vector<PartId>{3, 0}));
    panel.preview = core::SetOperation::Intersection;
    const auto next = vr::requestOf(panel, vr::CombineMarked{core::SetOperation::Union});
    const auto* instead = next ? std::get_if<vr::PreviewInstead>(&*next) : nullptr;
    QVERIFY(instead && instead->operation == core::SetOperation::Union);
    for (const auto& [command, isApplied] :
         {std::pair(PanelCommand::ApplyPreview, true), {PanelCommand::CancelPreview, false}}) {
        const auto last = vr::requestOf(panel, command);
        const auto* end = last ? std::get_if<vr::EndPreview>(&*last) : nullptr;
        QVERIFY(end && end->isApplied == isApplied);
    }
    const auto copy = requested<core::DuplicatePart>(PanelCommand::DuplicatePart, 7);
    QVERIFY(copy && copy->name == "row 7 copy");
    QVERIFY(requested<core::DeletePart>(PanelCommand::DeletePart, 7));
}

void TestPartRequests::others_requestNothing()
{
    for (const vr::PanelAction& action :
         {vr::PanelAction(PanelCommand::Recentre), vr::PanelAction(vr::MarkPart{3, true}),
          vr::PanelAction(vr::ShowPartsPage{1}), vr::PanelAction(core::Tool::Pull)})
        QVERIFY(!vr::requestOf(threeParts(), action));
}

/// Checks that the ray of a wand whose tip is in a part begins before it, wherever the model is placed.
void TestPartRequests::pick_beginsAtThePalm()
{
    const vr::ModelPlacement placement = turnedPlacement();
    const vr::Pose tip{Eigen::Quaterniond(Eigen::AngleAxisd(0.4, core::Vec3::UnitY())), placement.middle()};
    const vr::DocumentRequest request = vr::requestAt({tip, vr::HandTask::ChoosePart, {}}, threeParts(), {}, placement);
    const auto* pick = std::get_if<vr::PickPart>(&request);
    QVERIFY(pick);
    const core::Ray ray = pick->ray;
    QVERIFY((ray.direction - placement.directionToModel(tip.forward())).norm() < 1e-12);
    const core::Vec3 way = placement.toRoom(core::Vec3::Zero()) - placement.toRoom(ray.origin);
    QVERIFY(std::abs(way.norm() - vr::tipReach) < 1e-9 && way.normalized().dot(tip.forward()) > 1 - 1e-9);
}

/// Checks what is cut with symmetry, and what is shown beforehand: the mirror image, too, unless the plane is its own
/// or that of symmetry. Rounding by the placement does not count.
void TestPartRequests::cut_hasTheSymmetry()
{
    const vr::ModelPlacement placement = turnedPlacement();
    const core::Box box(core::Vec3(-20, -20, -20), core::Vec3(20, 20, 20));
    vr::BrushState brush;
    const auto use = [&](const core::Vec3& point, const core::Vec3& forward) {
        const core::Vec3 inRoom = placement.toRoom(point + forward) - placement.toRoom(point);
        const vr::Pose tip{core::rotationBetween(vr::Pose().forward(), inRoom), placement.toRoom(point)};
        return vr::TipUse{tip, vr::HandTask::Cut, box};
    };
    const auto cutBy = [&](const vr::TipUse& of) {
        const auto request = vr::requestAt(of, threeParts(), brush, placement);
        return std::get<core::Trim>(std::get<vr::ChangePart>(request).command).area.symmetry;
    };
    const vr::TipUse oblique = use({5, 0, 3}, {1, 2, 0}), own = use({5, 0, 3}, {0, 1, 2}),
                     halving = use({0, 4, 4}, {1, 0, 0});
    for (const core::Symmetry symmetry : {core::Symmetry::None, core::Symmetry::X}) {
        brush.stroke.symmetry = symmetry;
        QVERIFY(cutBy(oblique) == symmetry && vr::imageOfCut(oblique, brush, placement) == symmetry);
        QVERIFY(cutBy(own) == symmetry && vr::imageOfCut(own, brush, placement) == core::Symmetry::None);
        QVERIFY(cutBy(halving) == core::Symmetry::None &&
                vr::imageOfCut(halving, brush, placement) == core::Symmetry::None);
    }
}

void TestPartRequests::shape_isAsLargeAsTheBrush_data()
{
    QTest::addColumn<int>("kind");
    for (int kind = 0; kind < static_cast<int>(core::Primitive::Kind::Lathe); ++kind)
        QTest::newRow(core::name(static_cast<core::Primitive::Kind>(kind)).data()) << kind;
}

/// Checks for every shape and several directions of the wand that the solid can be made, that its greatest measure is
/// the diameter of the brush on the model, and that its centre is the tip.
void TestPartRequests::shape_isAsLargeAsTheBrush()
{
    QFETCH(int, kind);
    const vr::ModelPlacement placement = turnedPlacement();
    vr::PartsPanel panel = threeParts();
    panel.shape = static_cast<core::Primitive::Kind>(kind);
    vr::BrushState brush;
    for (const double radius : {vr::minRadius, 0.03, vr::maxRadius})
        for (const double angle : {0.0, 1.4}) {
            brush.radius = radius;
            const vr::Pose tip{Eigen::Quaterniond(Eigen::AngleAxisd(angle, core::Vec3::UnitZ())), {0.1, 1.3, -0.5}};
            const auto request = vr::requestAt({tip, vr::HandTask::PlaceShape, {}}, panel, brush, placement);
            const auto* change = std::get_if<vr::ChangePart>(&request);
            QVERIFY(change && change->part == panel.active);
            const auto& insert = std::get<core::Insert>(change->command);
            QVERIFY((placement.toRoom(insert.centre) - tip.position).norm() < 1e-9);
            const core::PrimitiveResult made = core::makePrimitive(*insert.primitive);
            QVERIFY(made.mesh && insert.primitive->kind == panel.shape);
            core::Box box; // in the shape's own coordinates
            for (const core::Vec3f& point : made.mesh->points)
                box.extend(core::rotationOf(*insert.primitive).transpose() * point.cast<double>());
            const double most = box.sizes().maxCoeff(), asked = 2 * placement.lengthToModel(radius);
            QVERIFY2(std::abs(most - asked) < 0.02 * asked, qPrintable(QString::number(most / asked)));
            const core::Vec3 up = placement.directionToModel(tip.rotation * core::Vec3::UnitY()).normalized();
            QVERIFY(panel.shape == core::Primitive::Kind::Ball || insert.primitive->axis.normalized().dot(up) > 0.99);
        }
}

/// Checks that all points of the outline are on the surface of the solid that is placed.
void TestPartRequests::outline_isOnTheShape()
{
    QFETCH(int, kind);
    const vr::ModelPlacement placement = turnedPlacement();
    vr::BrushState brush;
    const vr::Pose tip{Eigen::Quaterniond(Eigen::AngleAxisd(1.4, core::Vec3::UnitZ())), {0.1, 1.3, -0.5}};
    const core::Insert insert = vr::shapeAt(static_cast<core::Primitive::Kind>(kind), tip, brush, placement);
    std::vector<vr::Segment> outline{{tip.position, tip.position}};
    vr::outlineOf(insert, placement, outline);
    QVERIFY(outline.size() >= 12);
    const core::PrimitiveResult made = core::makePrimitive(*insert.primitive);
    QVERIFY(made.mesh);
    const double size = 2 * placement.lengthToModel(brush.radius);
    const core::Mesh mesh(*made.mesh, core::Lattice::forExtent(size));
    const core::FaceOctree octree(mesh);
    for (const vr::Segment& edge : outline)
        for (const core::Vec3& end : {edge.from, edge.to})
            QVERIFY(core::nearestPoint(mesh, octree, placement.toModel(end) - insert.centre, 0.02 * size));
}

/// A shape has the plane of the brush's symmetry, and one near to it is on it; each line of the outline gets an image.
void TestPartRequests::shape_isMirrored()
{
    const vr::ModelPlacement placement = turnedPlacement();
    vr::BrushState brush;
    brush.stroke.symmetry = core::Symmetry::X;
    const double radius = placement.lengthToModel(brush.radius);
    for (const double share : {0.1, 2.0}) {
        const core::Vec3 at(share * radius, 3, 2);
        const vr::Pose tip{Eigen::Quaterniond(Eigen::AngleAxisd(0.5, core::Vec3::UnitZ())), placement.toRoom(at)};
        const core::Insert insert = vr::shapeAt(core::Primitive::Kind::Cone, tip, brush, placement);
        QVERIFY(insert.symmetry == core::Symmetry::X);
        QCOMPARE(insert.centre.x() == 0, share < 1);
        QCOMPARE(insert.primitive->axis.x() == 0, share < 1);
        const core::TubePoint point = vr::tubePointAt(tip, brush, placement);
        QCOMPARE(point.position.x() == 0, share < 1);
        std::vector<vr::Segment> outline;
        vr::outlineOf(insert, placement, outline);
        const std::size_t count = outline.size();
        vr::addMirrorImage(outline, core::Symmetry::X, placement);
        QCOMPARE(outline.size(), 2 * count);
        for (std::size_t i = 0; i < count; ++i) {
            core::Vec3 image = placement.toModel(outline[count + i].from);
            image.x() *= -1;
            QVERIFY((image - placement.toModel(outline[i].from)).norm() < 1e-6 * radius);
        }
    }
}

/// Moves and turns a hand at random: the part follows it exactly, about the centre that the document gives, and the
/// document is asked once.
void TestPartRequests::part_followsTheHand()
{
    const vr::ModelPlacement placement = turnedPlacement();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-0.2, 0.2);
    HoldingPort port;
    vr::PartHand hand(&port);
    vr::Pose at{Eigen::Quaterniond::Identity(), {0.2, 1.2, -0.4}};
    const vr::Pose first = at;
    for (int i = 0; i < 40; ++i) {
        vr::Pose next = at;
        next.position += core::Vec3(number(random), number(random), number(random));
        const core::Vec3 axis = core::Vec3(number(random), number(random), number(random)).normalized();
        next.rotation = Eigen::AngleAxisd(3 * number(random), axis) * at.rotation;
        hand.step();
        hand.move({at, next}, 7, placement);
        at = next;
    }
    QCOMPARE(port.queries, 1);
    QVERIFY(hand.shown() && hand.vertices() == port.movable.vertices);
    const core::Transform shown = *hand.shown();
    QCOMPARE(shown.centre, port.movable.centre);
    for (const core::Vec3& p : {core::Vec3(0, 0, 0), core::Vec3(10, 3, -7), core::Vec3(-4, 19, 2)}) {
        const core::Vec3 expected = placement.toModel(at * (first.inverse() * placement.toRoom(p)));
        QVERIFY((shown.placeOf(p, 1) - expected).norm() < 1e-6);
    }
    QVERIFY(port.requests.empty());
    hand.release();
    QCOMPARE(port.requests.size(), std::size_t(1));
    const auto* change = std::get_if<vr::ChangePart>(&port.requests[0]);
    QVERIFY(change && change->part == 7);
    const auto* transform = std::get_if<core::Transform>(&change->command);
    QVERIFY(transform && transform->by == shown.by && transform->rotation.coeffs() == shown.rotation.coeffs());

    // The preview stays until the change is made; a hold in between has no effect.
    hand.step();
    hand.move({first, at}, 7, placement);
    QVERIFY(hand.shown() && hand.shown()->by == shown.by);
    port.isDone = true;
    hand.step();
    QVERIFY(!hand.shown() && !hand.vertices());
    QCOMPARE(port.requests.size(), std::size_t(1));
}

/// Checks that a hold that ends before the document has answered moves the part when the answer comes. A hold in
/// between has no effect.
void TestPartRequests::part_movesWhenTheAnswerComes()
{
    const vr::ModelPlacement placement = turnedPlacement();
    const vr::Pose a{Eigen::Quaterniond::Identity(), {0.2, 1.2, -0.4}}, b{a.rotation, {0.3, 1.2, -0.4}};
    HoldingPort port;
    vr::PartHand hand(&port);
    hand.move({a, b}, 7, placement);
    const int answers = std::exchange(port.answers, 0);
    hand.step();
    hand.release();
    hand.step();
    hand.move({b, a}, 3, placement);
    hand.release();
    QVERIFY(!hand.shown() && port.requests.empty());
    port.answers = answers;
    hand.step();
    QCOMPARE(port.requests.size(), std::size_t(1));
    const auto* change = std::get_if<vr::ChangePart>(&port.requests[0]);
    QVERIFY(change && change->part == 7);
    const auto* transform = std::get_if<core::Transform>(&change->command);
    const core::Vec3 by = placement.toModel(b.position) - placement.toModel(a.position);
    QVERIFY(transform && (transform->by - by).norm() < 1e-9 && transform->centre == port.movable.centre);
    QVERIFY(hand.shown()); // until the change is made
    port.isDone = true;
    hand.step();
    QVERIFY(!hand.shown());
    QCOMPARE(port.queries, 1);
    QCOMPARE(port.requests.size(), std::size_t(1));
}

/// Checks that a hand that did not move changes nothing, whether it lets go before the document's answer or after it.
void TestPartRequests::part_staysIfTheHandDoes()
{
    const vr::ModelPlacement placement = turnedPlacement();
    const vr::Pose a{Eigen::Quaterniond::Identity(), {0.2, 1.2, -0.4}};
    HoldingPort port;
    vr::PartHand hand(&port);
    hand.move({a, a}, 7, placement);
    hand.release();
    hand.step();
    QVERIFY(!hand.shown());
    hand.move({a, a}, 7, placement);
    QCOMPARE(port.queries, 2);
    hand.step();
    QVERIFY(hand.shown());
    hand.release();
    QVERIFY(!hand.shown() && port.requests.empty());
}

/// Checks that a hold ends without a change when another model comes, before and after the hand has let go, and that
/// the hand has to let go before it holds the new model's part.
void TestPartRequests::part_isDroppedWithItsModel()
{
    const vr::ModelPlacement placement = turnedPlacement();
    const vr::Pose a{Eigen::Quaterniond::Identity(), {0.2, 1.2, -0.4}}, b{a.rotation, {0.3, 1.2, -0.4}};
    HoldingPort port;
    vr::PartHand hand(&port);
    hand.move({a, b}, 7, placement);
    hand.step();
    QVERIFY(hand.shown());
    hand.drop();
    QVERIFY(!hand.shown() && !hand.vertices());
    hand.move({a, b}, 7, placement);
    hand.step();
    hand.release();
    hand.step();
    QVERIFY(!hand.shown() && port.requests.empty());
    QCOMPARE(port.queries, 1);

    hand.move({a, b}, 7, placement);
    hand.release();
    hand.drop();
    hand.step();
    QVERIFY(!hand.shown() && port.requests.empty());

    hand.move({a, b}, 7, placement);
    hand.step();
    hand.release();
    QCOMPARE(port.requests.size(), std::size_t(1));
}

FETTLE_TEST(TestPartRequests, QCoreApplication)
#include "tst_part_requests.moc"
