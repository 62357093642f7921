#include "vr/sculpt/part_requests.h"

#include "tests/support/test_main.h"

#include <QTest>

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
} // namespace

class TestPartRequests : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void parts_areShownAndHiddenOneByOne();
    void lock_keepsEverythingElse();
    void combine_takesTheMarked();
    void others_requestNothing();
    void pick_beginsAtThePalm();
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
    QCOMPARE(shown(PanelCommand::ShowAllParts, 7), (std::vector<PartId>{3, 0, 7}));
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

void TestPartRequests::combine_takesTheMarked()
{
    vr::PartsPanel panel = threeParts();
    panel.marked = {7, 0, 3, 8}; // the active part and one that is gone do not count
    const auto request = vr::requestOf(panel, vr::CombineMarked{core::SetOperation::Intersection});
    const auto* change = request ? std::get_if<vr::ChangePart>(&*request) : nullptr;
    const auto* combine = change ? std::get_if<core::CombineParts>(&change->command) : nullptr;
    QVERIFY(combine && change->part == 7 && combine->operation == core::SetOperation::Intersection);
    QCOMPARE(combine->others, (std::vector<PartId>{3, 0}));
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
    vr::ModelPlacement placement(core::Box(core::Vec3(-20, -20, -20), core::Vec3(20, 20, 20)));
    placement.place({Eigen::Quaterniond::Identity(), {0, 1.6, 0}});
    placement.turn(0.7);
    placement.scale(2);
    const vr::Pose tip{Eigen::Quaterniond(Eigen::AngleAxisd(0.4, core::Vec3::UnitY())), placement.middle()};
    const core::Ray ray = vr::pickAt(tip, placement).ray;
    QVERIFY((ray.direction - placement.directionToModel(tip.forward())).norm() < 1e-12);
    const core::Vec3 way = placement.toRoom(core::Vec3::Zero()) - placement.toRoom(ray.origin);
    QVERIFY(std::abs(way.norm() - vr::tipReach) < 1e-9 && way.normalized().dot(tip.forward()) > 1 - 1e-9);
}

FETTLE_TEST(TestPartRequests, QCoreApplication)
#include "tst_part_requests.moc"
