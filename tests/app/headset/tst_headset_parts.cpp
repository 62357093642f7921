// Tests the parts of a model in the headset: the parts panel, pointing at parts, and strokes on one of several parts.
// FETTLE_HEADSET_PICTURES=<folder> saves pictures of a tube that is being drawn and of a preview.
#include "tests/app/headset/headset_visit.h"
#include "tests/support/mirror_asserts.h"
#include "tests/support/test_main.h"
#include "tests/vr/vr_test.h"

#include "core/analysis/mesh_check.h"
#include "core/operations/detached_part.h"
#include "ui/util/part_name.h"
#include "vr/sculpt/brush_state.h"

#include <numbers>

using namespace app;
using core::PartId;
using core::Vec3;
using vr::PanelCommand;
using vr::PanelKind;
using vr::Side;

namespace
{
/// A visit as Alone, with the parts panel open beside the model.
struct AtParts : Alone
{
    explicit AtParts(const QSize& pixels = HeadsetHand::few) : Alone({}, pixels)
    {
        vr::ToolPanel tools;
        hand.put(Side::Left, {-0.35, 1.25, -0.3});
        hand.press(Side::Left, "menu");
        for (const core::Tool tool : {core::Tool::Flatten, core::Tool::Pull})
            hand.choose(tools, tool, [&] { return brush().tool == tool; });
        hand.openFromTools(tools, PanelKind::Parts);
        hand.waitForPanels();
    }

    DocumentParts& parts() { return program.document.parts(); }
    /// Returns the content of the panel, with the marks set by mark().
    vr::PartsPanel panel()
    {
        vr::PartsPanel panel;
        for (const core::Part& part : parts().list().all())
            panel.parts << vr::PartRow{part, ui::partName(part)};
        panel.active = parts().active();
        panel.marked = marked;
        panel.shown = shown;
        panel.canUndo = program.document.history().canUndo();
        panel.canRedo = program.document.history().canRedo();
        panel.preview = preview;
        panel.isBusy = preview.has_value();
        return panel;
    }
    /// Combines the active part with the marked ones as a preview, or shows another operation in its place. Waits until
    /// it is shown.
    bool showCombined(core::SetOperation operation)
    {
        ModelChanger& changer = program.document.changer();
        std::optional<core::SetOperation> result;
        const auto connection = QObject::connect(&changer, &ModelChanger::previewed, &program.window,
                                                 [&](core::SetOperation what, const auto&) { result = what; });
        const bool isAsked = choose(vr::CombineMarked{operation}, [&] {
            return QTest::qWaitFor([&] { return result == operation; }, waitForPreview);
        });
        QObject::disconnect(connection);
        preview = result;
        hand.waitForPanels();
        return isAsked;
    }
    /// Ends the preview by the panel.
    bool endPreview(PanelCommand command)
    {
        const bool hasEnded = choose(command, [&] {
            return QTest::qWaitFor([&] { return !program.document.changer().isPreviewing(); }, waitForPreview);
        });
        preview.reset();
        hand.settle();
        hand.waitForPanels();
        return hasEnded;
    }
    template <class Happened> bool choose(const vr::PanelAction& item, const Happened& happened, int count = 2)
    {
        return hand.choose(panel(), item, happened, count);
    }
    void mark(PartId part)
    {
        hand.waitForPanels(); // until the row of a new part is painted
        hand.click(panel(), vr::MarkPart{part, true});
        marked << part;
        hand.waitForPanels();
    }
    /// Adds a copy of the active part by the panel, moves it, and makes the first part active again.
    void addCopy(const Vec3& by)
    {
        const std::size_t before = parts().list().size();
        QVERIFY(choose(PanelCommand::DuplicatePart, [&] { return parts().list().size() == before + 1; }));
        QTRY_COMPARE(parts().active(), static_cast<PartId>(before));
        program.document.changer().applyTo(static_cast<PartId>(before), core::Move{by});
        hand.settle();
        parts().activate(0);
        hand.waitForPanels();
    }
    /// Pulls the trigger while the wand points at a place of the model from the front.
    void pointAt(const Vec3& place, double distance = 0.1)
    {
        hand.put(Side::Right, hand.place(place) + Vec3(0, 0, distance));
        hand.frames(2);
        hand.press(Side::Right, "trigger", 2);
        hand.settle();
    }
    std::uint64_t hashOf(PartId part)
    {
        return hand.ask([part](core::Sculptor& sculptor) {
            return core::Mesh(core::surfaceOf(sculptor.mesh(), part), sculptor.mesh().lattice()).meshHash();
        });
    }
    core::Box boxOf(PartId part)
    {
        return hand.ask([part](core::Sculptor& sculptor) {
            core::Box box;
            for (const core::Vec3f& point : core::surfaceOf(sculptor.mesh(), part).points)
                box.extend(point.cast<double>());
            return box;
        });
    }
    QString complaints() { return hand.headset().complaints(); }

    static constexpr int waitForPreview = 5000; // ms; then the item is pressed again
    QList<PartId> marked;
    std::optional<core::SetOperation> preview;
    vr::PartsPage shown = vr::PartsPage::List;
};
} // namespace

class TestHeadsetParts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GLX(); }

    void pointing_choosesThePart();
    void rows_chooseHideAndLock();
    void names_areChosenInTheHeadset();
    void isolate_andBack();
    void stroke_changesTheActivePart();
    void combine_joinsTheMarked();
    void combine_isShownBefore();
    void combine_isEndedByUndo();
    void delete_isHeld();
    void window_showsInTheHeadset();
    void takenOver_partsStay();
    void shape_isPlacedAtTheTip();
    void tube_isDrawnWithTheHand();
    void tube_isShownWhileItIsDrawn();
    void grip_movesTheActivePart();
    void grip_movesThePartThoughTheEngineIsBusy();
    void grip_showsThePartBeforeItMoves();
    void blade_cutsAwayWhatIsBeyond();
    void blade_cutsBothSides();
    void blade_isShownWhereItCuts();
};

/// Points at parts from afar and from within, and beside all of them. No trigger sculpts while the panel is open.
void TestHeadsetParts::pointing_choosesThePart()
{
    AtParts v;
    v.addCopy({120, 0, 0});
    const int changes = v.changes();
    QCOMPARE(v.parts().active(), PartId(0));
    v.pointAt({120, 0, 50});
    QCOMPARE(v.parts().active(), PartId(1));
    v.pointAt({0, 0, 50}, -0.02); // the tip is in the clay
    QCOMPARE(v.parts().active(), PartId(0));
    v.pointAt({120, 0, 50}, 1);
    QCOMPARE(v.parts().active(), PartId(1));
    v.pointAt({60, 90, 50});
    QCOMPARE(v.parts().active(), PartId(1));
    QCOMPARE(v.changes(), changes);
    QCOMPARE(v.complaints(), QString());
}

void TestHeadsetParts::rows_chooseHideAndLock()
{
    AtParts v;
    v.addCopy({120, 0, 0});
    QVERIFY(v.choose(vr::ChoosePart{1}, [&] { return v.parts().active() == 1; }));
    QVERIFY(v.choose(vr::ShowPart{0, false}, [&] { return !v.parts().list().isVisible(0); }));
    QVERIFY(v.parts().list().isVisible(1));
    v.pointAt({0, 0, 50}); // a hidden part is not there
    QCOMPARE(v.parts().active(), PartId(1));
    QVERIFY(v.choose(PanelCommand::ShowAllParts, [&] { return v.parts().list().isVisible(0); }));
    QVERIFY(v.choose(vr::LockPart{0, true}, [&] { return v.parts().list().find(0)->isLocked; }));
    QVERIFY(!v.parts().list().find(1)->isLocked);
    QVERIFY(v.choose(PanelCommand::Undo, [&] { return !v.parts().list().find(0)->isLocked; }));
    QCOMPARE(v.complaints(), QString());
}

/// Names and marks two parts by the panel. Each choice is one step.
void TestHeadsetParts::names_areChosenInTheHeadset()
{
    AtParts v;
    v.addCopy({120, 0, 0});
    const int changes = v.changes();
    v.hand.click(v.panel(), vr::PartsPage::Name);
    v.shown = vr::PartsPage::Name;
    v.hand.waitForPanels();
    const auto part = [&](PartId id) { return *v.parts().list().find(id); };
    const vr::NamePart wheel{QStringLiteral("Wheel")};
    QVERIFY(v.choose(wheel, [&] { return part(0).name == "Wheel"; }));
    QVERIFY(part(1).name != "Wheel");
    v.pointAt({120, 0, 50}); // chooses the other part
    QCOMPARE(v.parts().active(), PartId(1));
    QVERIFY(v.choose(wheel, [&] { return part(1).name == "Wheel 2"; }));
    const vr::TagPart red{core::Rgb{204, 52, 44}};
    QVERIFY(v.choose(red, [&] { return part(1).tag == red.tag; }));
    QVERIFY(!part(0).tag);
    QCOMPARE(v.changes(), changes + 3);
    QVERIFY(v.choose(PanelCommand::Undo, [&] { return !part(1).tag; }));
    QVERIFY(v.choose(vr::TagPart{red}, [&] { return part(1).tag == red.tag; }));
    QVERIFY(v.choose(vr::TagPart{}, [&] { return !part(1).tag && part(1).name == "Wheel 2"; }));
    QCOMPARE(v.complaints(), QString());
}

void TestHeadsetParts::isolate_andBack()
{
    AtParts v;
    v.addCopy({120, 0, 0});
    v.addCopy({-120, 0, 0});
    QVERIFY(v.choose(vr::ShowPart{2, false}, [&] { return !v.parts().list().isVisible(2); }));
    const auto shown = [&] {
        std::vector<PartId> ids;
        for (const core::Part& part : v.parts().list().all())
            if (part.isVisible)
                ids.push_back(part.id);
        return ids;
    };
    QVERIFY(v.choose(PanelCommand::IsolatePart, [&] { return shown() == std::vector<PartId>{0}; }));
    QVERIFY(v.choose(PanelCommand::IsolatePart, [&] { return shown() == std::vector<PartId>{0, 1}; }));
    QCOMPARE(v.complaints(), QString());
}

/// Closes the panel and sculpts where two parts overlap: only the active one changes.
void TestHeadsetParts::stroke_changesTheActivePart()
{
    AtParts v;
    v.addCopy({10, 0, 0});
    QVERIFY(v.choose(vr::ChoosePart{1}, [&] { return v.parts().active() == 1; }));
    const int changes = v.changes();
    const std::uint64_t first = v.hashOf(0), second = v.hashOf(1);
    v.hand.click(v.panel(), vr::ShowPanel{PanelKind::Parts, false});
    v.hand.waitForPanels();
    v.pull();
    QCOMPARE(v.changes(), changes + 1);
    QCOMPARE(v.hashOf(0), first);
    QVERIFY(v.hashOf(1) != second);
    v.hand.pressPad(Side::Right, -0.8, 0); // undo
    v.hand.settle();
    QCOMPARE(v.hashOf(1), second);
    QCOMPARE(v.complaints(), QString());
}

void TestHeadsetParts::combine_joinsTheMarked()
{
    AtParts v;
    v.addCopy({60, 0, 0});
    v.addCopy({-60, 0, 0});
    v.mark(2);
    QVERIFY(v.showCombined(core::SetOperation::Difference) && v.endPreview(PanelCommand::ApplyPreview));
    QVERIFY(v.parts().list().find(0) && v.parts().list().find(1) && !v.parts().list().find(2));
    const core::Box cut = v.box();
    QVERIFY(cut.min().x() > -40 && cut.max().x() > 109); // the left side is gone
    QVERIFY(v.choose(PanelCommand::Undo, [&] { return v.parts().list().size() == 3; }));
    v.mark(1);
    QVERIFY(v.showCombined(core::SetOperation::Union) && v.endPreview(PanelCommand::ApplyPreview));
    QCOMPARE(v.parts().list().size(), std::size_t(1));
    QVERIFY(v.box().sizes().x() > 219);
    QCOMPARE(v.complaints(), QString());
}

/// Shows a combination, another one in its place, and takes it back. What it takes away is seen as glass. Neither a
/// stroke nor a request to save is done during the preview, or after it. Applied it is one step.
void TestHeadsetParts::combine_isShownBefore()
{
    const QString folder = qEnvironmentVariable("FETTLE_HEADSET_PICTURES");
    AtParts v(folder.isEmpty() ? HeadsetHand::enough : QSize(540, 600));
    v.addCopy({60, 0, 0});
    v.mark(1);
    const int changes = v.changes();
    const std::uint64_t before = v.hash();
    QVERIFY(v.showCombined(core::SetOperation::Difference));
    const std::uint64_t shown = v.hash();
    QVERIFY(shown != before);
    QCOMPARE(v.changes(), changes);
    v.hand.put(Side::Right, {0.5, 1.1, -0.1});
    v.hand.frames(4);
    const QImage picture = v.hand.picture();
    if (!folder.isEmpty())
        QVERIFY(picture.save(folder + QStringLiteral("/preview.png")));
    const Look look{picture, *v.hand.seen().head};
    const auto blueness = [&](const Vec3& place) {
        const QColor color = picture.pixelColor(look.at(v.hand.place(place)));
        return 2 * color.blue() - color.red() - color.green();
    };
    const int glass = blueness({108, 0, 0}), clay = blueness({-30, 0, 40}), nothing = blueness({60, -80, 0});
    QVERIFY2(glass > clay + 10 && glass > nothing + 10,
             qPrintable(QStringLiteral("%1 %2 %3").arg(glass).arg(clay).arg(nothing)));
    v.pointAt({-30, 0, 40}, 0);
    QCOMPARE(v.hash(), shown);
    const QStringList files = v.files();
    v.hand.hold(Side::Left, "squeeze"); // saves, if nothing is previewed
    v.hand.settle();

    QVERIFY(v.showCombined(core::SetOperation::Intersection));
    QVERIFY(v.box().min().x() > 9 && v.box().max().x() < 51);
    QVERIFY(v.endPreview(PanelCommand::CancelPreview));
    QCOMPARE(v.hash(), before);
    QCOMPARE(v.changes(), changes);
    QCOMPARE(v.parts().list().size(), std::size_t(2));

    QVERIFY(v.showCombined(core::SetOperation::Difference) && v.endPreview(PanelCommand::ApplyPreview));
    QCOMPARE(v.hash(), shown);
    QCOMPARE(v.changes(), changes + 1);
    QCOMPARE(v.files(), files);
    v.hand.hold(Side::Left, "squeeze");
    QTRY_VERIFY(v.files().size() > files.size());
    QCOMPARE(v.complaints(), QString());
}

/// Undoes while a preview is shown: it is taken back, and the step before it stays. One that the window begins opens
/// the panel in the headset.
void TestHeadsetParts::combine_isEndedByUndo()
{
    AtParts v;
    v.addCopy({60, 0, 0});
    v.mark(1);
    const int changes = v.changes();
    const std::uint64_t before = v.hash();
    QVERIFY(v.showCombined(core::SetOperation::Difference));
    QVERIFY(v.endPreview(PanelCommand::Undo));
    QCOMPARE(v.hash(), before);
    QCOMPARE(v.changes(), changes);

    const auto isPanelOpen = [&] {
        v.hand.frames(2);
        return std::ranges::any_of(v.hand.seen().panels,
                                   [](const vr::PanelTarget& panel) { return panel.kind == PanelKind::Parts; });
    };
    QVERIFY(v.choose(vr::ShowPanel{PanelKind::Parts, false}, [&] { return !isPanelOpen(); }));
    v.program.document.changer().preview(0, core::CombineParts{core::SetOperation::Difference, {1}});
    QTRY_VERIFY(isPanelOpen());
    v.program.document.changer().dropPreview();
    v.hand.settle();
    QCOMPARE(v.hash(), before);
    QCOMPARE(v.complaints(), QString());
}

void TestHeadsetParts::delete_isHeld()
{
    AtParts v;
    v.addCopy({120, 0, 0});
    QVERIFY(v.choose(vr::ChoosePart{1}, [&] { return v.parts().active() == 1; }));
    v.hand.click(v.panel(), PanelCommand::DeletePart);
    QCOMPARE(v.parts().list().size(), std::size_t(2));
    v.hand.setSlow(true);
    const bool isDeleted = v.choose(
        PanelCommand::DeletePart, [&] { return v.parts().list().size() == 1; }, HeadsetHand::longPress);
    v.hand.setSlow(false);
    QVERIFY(isDeleted);
    QCOMPARE(v.parts().active(), PartId(0));
    QVERIFY(v.choose(PanelCommand::Undo, [&] { return v.parts().list().size() == 2; }));
    QCOMPARE(v.complaints(), QString());
}

/// Chooses and renames a part at the window; the panel in the headset shows it.
void TestHeadsetParts::window_showsInTheHeadset()
{
    AtParts v(HeadsetHand::enough);
    v.addCopy({120, 0, 0});
    const auto look = [&] {
        v.hand.waitForPanels();
        return v.hand.picture();
    };
    v.hand.put(Side::Right, {0.5, 1.1, -0.1});
    // turns to the panel, which is left of the model
    v.hand.headset().step("{'head': {'yaw_pitch_roll': [40, 0, 0]}}");
    const QImage before = look();
    QCOMPARE(look(), before);
    v.parts().activate(1);
    v.hand.settle();
    const QImage chosen = look();
    QVERIFY(chosen != before);
    v.program.document.changer().applyTo(1, core::EditPart{"wheel", false, {}, 1});
    v.hand.settle();
    QVERIFY(look() != chosen);
    QCOMPARE(v.complaints(), QString());
}

/// While the window has taken over, the headset changes neither the parts nor which one is active.
void TestHeadsetParts::takenOver_partsStay()
{
    AtParts v;
    v.addCopy({120, 0, 0});
    v.trigger("vr.takeOver");
    v.hand.settle();
    const int changes = v.changes();
    v.pointAt({120, 0, 50});
    v.hand.click(v.panel(), vr::ChoosePart{1});
    v.hand.click(v.panel(), vr::ShowPart{0, false});
    v.hand.click(v.panel(), PanelCommand::IsolatePart);
    QCOMPARE(v.parts().active(), PartId(0));
    QCOMPARE(v.changes(), changes);
    v.trigger("vr.takeOver");
    v.hand.settle();
    QVERIFY(v.choose(vr::ChoosePart{1}, [&] { return v.parts().active() == 1; }));
    QCOMPARE(v.complaints(), QString());
}

/// Places a box on top of the ball: it is joined with the active part as one step, which undo takes back.
void TestHeadsetParts::shape_isPlacedAtTheTip()
{
    AtParts v;
    v.addCopy({120, 0, 0});
    v.hand.click(v.panel(), vr::PartsPage::Shapes);
    v.shown = vr::PartsPage::Shapes;
    v.hand.waitForPanels();
    v.hand.click(v.panel(), core::Primitive::Kind::Cuboid);
    v.hand.waitForPanels();
    const int changes = v.changes();
    const std::uint64_t other = v.hashOf(1);
    const double half = v.hand.room().lengthToModel(vr::defaultRadius);
    v.hand.put(Side::Right, v.hand.place({0, 50, 0}));
    v.hand.frames(2);
    v.hand.press(Side::Right, "trigger", 2);
    v.hand.settle();
    QCOMPARE(v.changes(), changes + 1);
    QCOMPARE(v.parts().list().size(), std::size_t(2));
    QCOMPARE(v.hashOf(1), other);
    const double top = v.box().max().y();
    QVERIFY2(std::abs(top - (50 + half)) < 0.01, qPrintable(QString::number(top - 50)));
    const auto report =
        v.hand.ask([](core::Sculptor& sculptor) { return core::checkMesh(core::extractMesh(sculptor.mesh())); });
    QVERIFY(report.printReady());
    v.hand.pressPad(Side::Right, -0.8, 0); // undo
    v.hand.settle();
    QVERIFY(std::abs(v.box().max().y() - 50) < 0.1);
    QCOMPARE(v.complaints(), QString());
}

/// Draws a tube out of the ball and back into it, like a handle: it is joined with the ball in one step, and undo takes
/// it back. Then one of its own beside the ball, and a pull of the trigger in one place, which makes nothing.
void TestHeadsetParts::tube_isDrawnWithTheHand()
{
    AtParts v;
    v.hand.click(v.panel(), vr::PartsPage::Shapes);
    v.shown = vr::PartsPage::Shapes;
    v.hand.waitForPanels();
    v.hand.click(v.panel(), core::Primitive::Kind::Tube);
    v.hand.waitForPanels();
    const int changes = v.changes();
    const std::uint64_t before = v.hashOf(0);
    const double radius = v.hand.room().lengthToModel(vr::defaultRadius);
    const auto draw = [&](const auto& placeAt) {
        v.hand.put(Side::Right, v.hand.place(placeAt(0.0)));
        v.hand.frames(2);
        v.hand.set(Side::Right, "trigger", 1);
        for (int i = 0; i <= 30; ++i) {
            v.hand.put(Side::Right, v.hand.place(placeAt(i / 30.0)));
            v.hand.frame();
        }
        QCOMPARE(v.parts().list().size(), std::size_t(1));
        v.hand.set(Side::Right, "trigger", 0);
        v.hand.settle();
    };
    const auto handle = [](double share) {
        const double angle = std::numbers::pi * (share - 0.5);
        return Vec3(40 + 30 * std::cos(angle), 30 * std::sin(angle), 0);
    };
    draw(handle);
    QCOMPARE(v.changes(), changes + 1);
    QCOMPARE(v.parts().list().size(), std::size_t(1));
    const double right = v.box().max().x();
    QVERIFY2(std::abs(right - 70 - radius) < 0.15 * radius, qPrintable(QString::number((right - 70) / radius)));
    const auto report =
        v.hand.ask([](core::Sculptor& sculptor) { return core::checkMesh(core::extractMesh(sculptor.mesh())); });
    QVERIFY(report.printReady());
    v.hand.pressPad(Side::Right, -0.8, 0); // undo
    v.hand.settle();
    QCOMPARE(v.hashOf(0), before);

    draw([](double) { return Vec3(0, 90, 0); });
    QCOMPARE(v.changes(), changes);
    v.hand.click(v.panel(), vr::MakePart{true});
    v.hand.waitForPanels();
    draw([](double share) { return Vec3(-40 + 80 * share, 90, 0); });
    QCOMPARE(v.changes(), changes + 1);
    QCOMPARE(v.parts().list().size(), std::size_t(2));
    QCOMPARE(v.hashOf(0), before);
    QCOMPARE(v.parts().list().all().back().name, std::string("Tube"));
    const core::Box tube = v.boxOf(v.parts().list().all().back().id);
    QVERIFY((tube.center() - Vec3(0, 90, 0)).norm() < 0.1 * radius);
    QVERIFY(std::abs(tube.sizes().x() - 80 - 2 * radius) < 0.1 * radius);
    QCOMPARE(v.complaints(), QString());
}

/// Compares pictures: the path and the thickness of the tube are seen before the trigger is released.
void TestHeadsetParts::tube_isShownWhileItIsDrawn()
{
    const QString folder = qEnvironmentVariable("FETTLE_HEADSET_PICTURES");
    AtParts v(folder.isEmpty() ? HeadsetHand::enough : QSize(540, 600));
    v.hand.click(v.panel(), vr::PartsPage::Shapes);
    v.shown = vr::PartsPage::Shapes;
    v.hand.waitForPanels();
    v.hand.click(v.panel(), core::Primitive::Kind::Tube);
    const Vec3 from(-30, 75, 0), to(30, 75, 0);
    v.hand.put(Side::Right, v.hand.place(from));
    v.hand.frames(4);
    v.hand.set(Side::Right, "trigger", 1);
    v.hand.frames(2);
    const QImage before = v.hand.picture();
    for (int i = 1; i <= 20; ++i) {
        v.hand.put(Side::Right, v.hand.place(from + (to - from) * i / 20));
        v.hand.frame();
    }
    const QImage drawn = v.hand.picture();
    if (!folder.isEmpty())
        QVERIFY(drawn.save(folder + QStringLiteral("/tube.png")));
    const Look look{drawn, *v.hand.seen().head};
    const auto differs = [&](const Vec3& place) {
        const QPoint at = look.at(v.hand.place(place));
        int pixels = 0;
        for (int x = -3; x <= 3; ++x)
            for (int y = -3; y <= 3; ++y)
                pixels += before.pixelColor(at + QPoint(x, y)) != drawn.pixelColor(at + QPoint(x, y));
        return pixels;
    };
    for (const double x : {-15.0, 0.0, 15.0})
        QVERIFY2(differs({x, 75, 0}) >= 3, qPrintable(QString::number(differs({x, 75, 0}))));
    QCOMPARE(differs({0, -75, 0}), 0);
    QCOMPARE(v.changes(), 0);
    v.hand.set(Side::Right, "trigger", 0);
    v.hand.settle();
    QCOMPARE(v.changes(), 1);
    QCOMPARE(v.complaints(), QString());
}

/// Moves one of two parts by the grip. It follows the hand, and is changed once, when the hand lets go.
void TestHeadsetParts::grip_movesTheActivePart()
{
    AtParts v;
    v.addCopy({120, 0, 0});
    QVERIFY(v.choose(vr::ChoosePart{1}, [&] { return v.parts().active() == 1; }));
    const int changes = v.changes();
    const std::uint64_t other = v.hashOf(0), before = v.hashOf(1);
    const core::Box start = v.boxOf(1);
    const double scale = v.scale();
    const Vec3 from(120, 0, 60), by(15, 25, -10);
    v.hand.put(Side::Right, v.hand.place(from));
    v.hand.frames(2);
    v.hand.set(Side::Right, "squeeze", 1);
    v.hand.frames(3);
    for (int i = 1; i <= 10; ++i) {
        v.hand.put(Side::Right, v.hand.place(from + by * i / 10));
        v.hand.frame();
    }
    QCOMPARE(v.changes(), changes);
    QCOMPARE(v.hashOf(1), before);
    v.hand.set(Side::Right, "squeeze", 0);
    v.hand.settle();
    QCOMPARE(v.changes(), changes + 1);
    QCOMPARE(v.hashOf(0), other);
    const double error = (v.boxOf(1).center() - start.center() - by).norm();
    QVERIFY2(error < 0.01, qPrintable(QString::number(error)));
    QVERIFY(std::abs(v.scale() - scale) < 1e-9); // the model stays where it is
    v.hand.pressPad(Side::Right, -0.8, 0);       // undo
    v.hand.settle();
    QCOMPARE(v.hashOf(1), before);
    QCOMPARE(v.complaints(), QString());
}

/// Grabs the part, moves it and lets it go while the mesh thread is busy: it moves when the thread is free again.
void TestHeadsetParts::grip_movesThePartThoughTheEngineIsBusy()
{
    AtParts v;
    const int changes = v.changes();
    const Vec3 from(0, 0, 60), by(-20, 10, 5), start = v.boxOf(0).center();
    v.hand.put(Side::Right, v.hand.place(from));
    v.hand.frames(2);
    std::promise<void> free;
    v.program.worker.post([until = free.get_future().share()](core::Sculptor&) { until.wait(); });
    v.hand.setStalled(true);
    v.hand.set(Side::Right, "squeeze", 1);
    v.hand.frames(3);
    v.hand.put(Side::Right, v.hand.place(from + by));
    v.hand.frames(2);
    v.hand.set(Side::Right, "squeeze", 0);
    v.hand.frames(3);
    free.set_value();
    v.hand.setStalled(false);
    v.hand.frames(2);
    v.hand.settle();
    QCOMPARE(v.changes(), changes + 1);
    const double error = (v.boxOf(0).center() - start - by).norm();
    QVERIFY2(error < 0.01, qPrintable(QString::number(error)));
    QCOMPARE(v.complaints(), QString());
}

/// Compares pictures: while the hand holds the part, it is drawn where it will be when the hand has let go.
void TestHeadsetParts::grip_showsThePartBeforeItMoves()
{
    AtParts v(HeadsetHand::enough);
    const auto picture = [&] {
        v.hand.frames(3);
        return v.hand.picture();
    };
    const Vec3 from(0, 0, 60);
    v.hand.put(Side::Right, v.hand.place(from));
    const QImage before = picture();
    v.hand.set(Side::Right, "squeeze", 1);
    v.hand.frames(3);
    v.hand.put(Side::Right, v.hand.place(from + Vec3(0, 30, 0)));
    const QImage held = picture();
    v.hand.set(Side::Right, "squeeze", 0);
    v.hand.settle();
    QCOMPARE(v.changes(), 1);
    const QImage after = picture();
    const QPoint top = Look{before, *v.hand.seen().head}.at(v.hand.place({0, 70, 0}));
    const auto difference = [&](const QImage& a, const QImage& b) {
        const QColor x = a.pixelColor(top), y = b.pixelColor(top);
        return std::abs(x.red() - y.red()) + std::abs(x.green() - y.green()) + std::abs(x.blue() - y.blue());
    };
    QVERIFY(difference(before, held) > 60);
    QVERIFY(difference(held, after) < difference(before, held) / 4); // the lights turn with the model's middle
    QCOMPARE(v.complaints(), QString());
}

/// Cuts the active part of two, obliquely: what is beyond the blade is gone, the rest is a sound solid, and undo brings
/// everything back.
void TestHeadsetParts::blade_cutsAwayWhatIsBeyond()
{
    AtParts v;
    v.addCopy({120, 0, 0});
    v.hand.click(v.panel(), vr::PartsPage::Cut);
    v.shown = vr::PartsPage::Cut;
    v.hand.waitForPanels();
    const std::uint64_t other = v.hashOf(1), before = v.hashOf(0);
    const int changes = v.changes();
    const Vec3 tip(0, 20, 0), forward = Vec3(0.2, 1, -0.3).normalized();
    v.hand.put(Side::Right, v.hand.place(tip), forward);
    v.hand.frames(2);
    v.hand.press(Side::Right, "trigger", 2);
    v.hand.settle();
    QCOMPARE(v.changes(), changes + 1);
    QCOMPARE(v.hashOf(1), other);
    double beyond = -1e9, volume = 0;
    v.hand.ask([&](core::Sculptor& sculptor) {
        const core::TriangleMesh mesh = core::surfaceOf(sculptor.mesh(), 0);
        for (const core::Vec3f& point : mesh.points)
            beyond = std::max(beyond, (point.cast<double>() - tip).dot(forward));
        const core::MeshReport report = core::checkMesh(mesh);
        volume = report.printReady() ? *report.volume : 0;
        return true;
    });
    QVERIFY2(std::abs(beyond) < 0.01, qPrintable(QString::number(beyond)));
    const double cap = 50 - tip.dot(forward), whole = 4 * std::numbers::pi / 3 * 125000;
    const double kept = whole - std::numbers::pi * cap * cap * (50 - cap / 3);
    QVERIFY2(std::abs(volume / kept - 1) < 0.02, qPrintable(QString::number(volume / kept)));
    v.hand.pressPad(Side::Right, -0.8, 0); // undo
    v.hand.settle();
    QCOMPARE(v.hashOf(0), before);
    QCOMPARE(v.complaints(), QString());
}

/// With symmetry the clay beyond the blade and beyond its mirror image is tinted beforehand. The cut takes both, and
/// what is left is symmetric bit for bit.
void TestHeadsetParts::blade_cutsBothSides()
{
    AtParts v(HeadsetHand::enough);
    v.hand.pressPad(Side::Right, 0, -0.8);
    QTRY_COMPARE(v.brush().symmetry, core::Symmetry::Y);
    const Vec3 tip(0, 10, 0), forward = Vec3(0.2, 1, 0).normalized();
    const auto hold = [&] {
        v.hand.put(Side::Right, v.hand.place(tip), forward);
        v.hand.frames(4);
        return v.hand.picture();
    };
    const QImage before = hold();
    v.hand.click(v.panel(), vr::PartsPage::Cut);
    const QImage cut = hold();
    const Look look{cut, *v.hand.seen().head};
    const auto redness = [](const QColor& color) { return 2 * color.red() - color.green() - color.blue(); };
    const auto change = [&](const Vec3& place) {
        const QPoint at = look.at(v.hand.place(place));
        return redness(cut.pixelColor(at)) - redness(before.pixelColor(at));
    };
    for (const double side : {1.0, -1.0})
        QVERIFY2(change({-20, 30 * side, 34}) > 30, qPrintable(QString::number(change({-20, 30 * side, 34}))));
    QVERIFY2(std::abs(change({-20, 6, 45})) < 12, qPrintable(QString::number(change({-20, 6, 45}))));
    const int changes = v.changes();
    v.hand.press(Side::Right, "trigger", 2);
    v.hand.settle();
    QCOMPARE(v.changes(), changes + 1);
    std::string asymmetry;
    double beyond = -1e9;
    v.hand.ask([&](core::Sculptor& sculptor) {
        asymmetry = mirror_asserts::asymmetry(sculptor.mesh(), core::Symmetry::Y);
        for (const core::Slot vertex : sculptor.mesh().vertices()) {
            const Vec3 point = sculptor.mesh().point(vertex).cast<double>(), image(point.x(), -point.y(), point.z());
            beyond = std::max({beyond, (point - tip).dot(forward), (image - tip).dot(forward)});
        }
        return true;
    });
    QVERIFY2(asymmetry.empty(), asymmetry.c_str());
    QVERIFY2(std::abs(beyond) < 0.01, qPrintable(QString::number(beyond)));
    QCOMPARE(v.complaints(), QString());
}

/// Compares pictures: with the blade in the hand the clay beyond it is tinted, and the clay behind it is not.
void TestHeadsetParts::blade_isShownWhereItCuts()
{
    AtParts v(HeadsetHand::enough);
    v.hand.put(Side::Right, v.hand.place({0, 10, 0}), Vec3::UnitY());
    v.hand.frames(4);
    const QImage before = v.hand.picture();
    v.hand.click(v.panel(), vr::PartsPage::Cut);
    v.hand.put(Side::Right, v.hand.place({0, 10, 0}), Vec3::UnitY());
    v.hand.frames(4);
    const QImage cut = v.hand.picture();
    const Look look{cut, *v.hand.seen().head};
    const auto redness = [](const QColor& color) { return 2 * color.red() - color.green() - color.blue(); };
    const auto change = [&](const Vec3& place) {
        const QPoint at = look.at(v.hand.place(place));
        return redness(cut.pixelColor(at)) - redness(before.pixelColor(at));
    };
    QVERIFY2(change({-20, 30, 34}) > 30, qPrintable(QString::number(change({-20, 30, 34}))));
    QVERIFY2(std::abs(change({-20, -20, 40})) < 12, qPrintable(QString::number(change({-20, -20, 40}))));
    QCOMPARE(v.complaints(), QString());
}

FETTLE_TEST(TestHeadsetParts, app::OnScreen)
#include "tst_headset_parts.moc"
