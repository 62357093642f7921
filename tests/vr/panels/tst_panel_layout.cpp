#include "vr/panels/panel_layout.h"

#include "tests/support/test_main.h"
#include "tests/vr/panels/example_panels.h"
#include "vr/panels/panel_theme.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using vr::PanelAction;
using vr::PanelCommand;
using vr::PanelItem;
using vr::PanelLayout;

namespace
{
/// Converts a point of the panel in dmm to metres from the panel's middle. (1 dmm is 1 mm at a distance of 1 m.)
Eigen::Vector2d inRoom(const PanelLayout& layout, const QPointF& point)
{
    return Eigen::Vector2d(point.x() - layout.size.width() / 2, layout.size.height() / 2 - point.y()) *
           layout.distance / 1000;
}

/// Returns true if the rectangles share more than an edge.
bool overlap(const QRectF& a, const QRectF& b)
{
    const QRectF shared = a & b;
    return shared.width() > 1e-6 && shared.height() > 1e-6;
}

/// Returns all actions that the example panels offer.
std::vector<PanelAction> offered()
{
    std::vector<PanelAction> all;
    for (const ExamplePanel& example : examplePanels())
        for (const PanelItem& item : vr::layoutOf(example.content).items)
            if (item.isInteractive())
                all.push_back(*item.action);
    return all;
}

std::vector<PanelAction> wanted()
{
    std::vector<PanelAction> all{PanelCommand::Undo,
                                 PanelCommand::Redo,
                                 PanelCommand::RestoreModel,
                                 PanelCommand::InvertMask,
                                 PanelCommand::ClearMask,
                                 PanelCommand::SaveModel,
                                 PanelCommand::Recentre,
                                 PanelCommand::LeaveVr,
                                 core::BrushShape::Sphere,
                                 core::BrushShape::Ray,
                                 core::Topology::Adaptive,
                                 core::Topology::Uniform,
                                 vr::ButtonPreset::Paper,
                                 vr::ButtonPreset::Studio,
                                 vr::SettingsPage::General,
                                 vr::SettingsPage::Haptics,
                                 vr::ChooseHand{vr::Side::Left},
                                 vr::ChooseHand{vr::Side::Right},
                                 vr::ShowPage{0},
                                 vr::ShowPage{1},
                                 vr::ShowLessonPage{0},
                                 vr::LessonRequest::Play,
                                 vr::LessonRequest::TryIt,
                                 vr::LessonRequest::Back,
                                 vr::LessonRequest::Next,
                                 PanelCommand::IsolatePart,
                                 PanelCommand::ShowAllParts,
                                 PanelCommand::DuplicatePart,
                                 PanelCommand::DeletePart,
                                 PanelCommand::ApplyPreview,
                                 PanelCommand::CancelPreview,
                                 vr::PartsPage::List,
                                 vr::PartsPage::Name,
                                 vr::NamePart{QStringLiteral("Wheel")},
                                 vr::TagPart{},
                                 vr::TagPart{core::Rgb{204, 52, 44}},
                                 vr::PartsPage::Shapes,
                                 vr::PartsPage::Cut,
                                 vr::ShowPartsPage{0},
                                 vr::ShowPartsPage{1}};
    for (std::size_t i = 0; i < core::toolNames().size(); ++i)
        all.push_back(static_cast<core::Tool>(i));
    for (const auto kind : {vr::PanelKind::Files, vr::PanelKind::Settings, vr::PanelKind::Parts})
        for (const bool isShown : {false, true})
            all.push_back(vr::ShowPanel{kind, isShown});
    for (const bool isOn : {false, true}) {
        all.push_back(vr::ChooseSymmetry{isOn});
        all.push_back(vr::AddNext{isOn});
        all.push_back(vr::MakePart{isOn});
        all.push_back(vr::ShowPerformance{isOn});
        all.push_back(vr::ShowFloor{isOn});
    }
    for (const int count : {1, 2, 4, 6})
        all.push_back(vr::ChooseRadial{count});
    for (core::PartId part = 0; part < 7; ++part)
        all.push_back(vr::ChoosePart{part});
    for (const bool isOn : {false, true}) {
        all.push_back(vr::MarkPart{2, isOn});
        all.push_back(vr::ShowPart{static_cast<core::PartId>(isOn ? 2 : 1), isOn});
        all.push_back(vr::LockPart{static_cast<core::PartId>(isOn ? 1 : 2), isOn});
    }
    for (const auto kind : {core::Primitive::Kind::Cuboid, core::Primitive::Kind::Ball, core::Primitive::Kind::Cylinder,
                            core::Primitive::Kind::Cone, core::Primitive::Kind::Capsule, core::Primitive::Kind::Torus,
                            core::Primitive::Kind::Tube})
        all.push_back(kind);
    for (const auto operation :
         {core::SetOperation::Union, core::SetOperation::Difference, core::SetOperation::Intersection})
        all.push_back(vr::CombineMarked{operation});
    for (int i = 0; i < 3; ++i)
        all.push_back(vr::ChooseChannel{i});
    for (int i = 0; i <= static_cast<int>(vr::PanelSlider::Hold); ++i)
        all.push_back(vr::Slide{static_cast<vr::PanelSlider>(i), 0});
    return all;
}
} // namespace

class TestPanelLayout : public QObject
{
    Q_OBJECT

public:
    static void initMain() { qputenv("QT_QPA_PLATFORM", "offscreen"); }

private Q_SLOTS:
    void aPart_isHitAllOverAndNowhereElse_data() { addExamples(); }
    void aPart_isHitAllOverAndNowhereElse();
    void parts_keepApartAndWithinThePanel_data() { addExamples(); }
    void parts_keepApartAndWithinThePanel();
    void everythingCanBeWanted();
    void whatCannotBe_isNotHit();
    void aSlider_takesTheValueUnderThePoint_data() { addExamples(); }
    void aSlider_takesTheValueUnderThePoint();
    void aPanel_isAsLargeAsItLooks_data() { addExamples(); }
    void aPanel_isAsLargeAsItLooks();
    void theRadius_hasItsWholeRange();
    void everyFile_isOnOnePage();
    void manyMarks_beginWithThoseToBeMet();
    void aPageThatIsNot_isTheNearest();
    void aChoice_staysOnItsPanel();
    void openingUnsaved_mustBeHeld();
    void aPart_isOnOnePage();
    void partsAreCombined_ifOthersAreMarked();
    void aNotice_isReadBeforeItFades();

private:
    static void addExamples();
};

void TestPanelLayout::addExamples()
{
    QTest::addColumn<int>("index");
    const std::vector<ExamplePanel> examples = examplePanels();
    for (std::size_t i = 0; i < examples.size(); ++i)
        QTest::newRow(examples[i].name) << static_cast<int>(i);
}

/// Checks random points, also outside the panel: an item is hit within its area and nowhere else.
void TestPanelLayout::aPart_isHitAllOverAndNowhereElse()
{
    QFETCH(int, index);
    const PanelLayout layout = exampleLayout(index);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x(-50, layout.size.width() + 50), y(-50, layout.size.height() + 50);
    std::size_t hits = 0;
    for (int i = 0; i < 20'000; ++i) {
        const QPointF point(x(random), y(random));
        const auto item = std::ranges::find_if(
            layout.items, [&](const PanelItem& p) { return p.isInteractive() && p.area.contains(point); });
        const std::optional<PanelAction> hit = layout.hit(inRoom(layout, point));
        QCOMPARE(hit.has_value(), item != layout.items.end());
        if (!hit)
            continue;
        ++hits;
        QVERIFY(vr::isSameItem(*hit, *item->action));
        QVERIFY(layout.contains(inRoom(layout, point)));
        QCOMPARE(layout.itemAt(inRoom(layout, point)), &*item);
    }
    const bool acts = std::ranges::any_of(layout.items, [](const PanelItem& item) { return item.isInteractive(); });
    QCOMPARE(hits > 0, acts);
}

void TestPanelLayout::parts_keepApartAndWithinThePanel()
{
    QFETCH(int, index);
    const PanelLayout layout = exampleLayout(index);
    const QRectF inside = QRectF(QPointF(), layout.size).adjusted(20, 20, -20, -20);
    for (std::size_t i = 0; i < layout.items.size(); ++i) {
        const PanelItem& item = layout.items[i];
        QVERIFY(inside.contains(item.area));
        if (item.action)
            // 60 dmm, seen at 3.4 degrees: large enough for trembling hands
            QVERIFY(item.area.width() >= 60 && item.area.height() >= 60);
        for (std::size_t j = 0; j < i && !std::holds_alternative<vr::WellLook>(item.look); ++j)
            QVERIFY(std::holds_alternative<vr::WellLook>(layout.items[j].look) ||
                    !overlap(item.area, layout.items[j].area));
    }
}

void TestPanelLayout::everythingCanBeWanted()
{
    const std::vector<PanelAction> all = offered();
    for (const PanelAction& action : wanted())
        QVERIFY2(std::ranges::any_of(all, [&](const PanelAction& a) { return vr::isSameItem(a, action); }),
                 qPrintable(QString::number(action.index())));
    QVERIFY(std::ranges::any_of(all, [](const PanelAction& a) { return std::holds_alternative<vr::OpenFile>(a); }));
    QVERIFY(std::ranges::any_of(all, [](const PanelAction& a) { return std::holds_alternative<vr::ChooseColor>(a); }));
}

void TestPanelLayout::whatCannotBe_isNotHit()
{
    vr::ToolPanel panel;
    const auto isHit = [&](const PanelAction& action) { return panel.layout().itemFor(action) != nullptr; };
    QVERIFY(!isHit(PanelCommand::Undo) && !isHit(PanelCommand::Redo));
    panel.canUndo = true;
    QVERIFY(isHit(PanelCommand::Undo) && !isHit(PanelCommand::Redo));
    panel.canChange = false;
    QVERIFY(!isHit(PanelCommand::RestoreModel) && !isHit(PanelCommand::InvertMask) && !isHit(PanelCommand::ClearMask));

    vr::FilesPanel files;
    files.files << vr::FileTile{QStringLiteral("a"), QStringLiteral("a"), {}, true};
    QVERIFY(!files.layout().itemFor(vr::ChooseFile{QStringLiteral("a")}));
    QVERIFY(!files.layout().itemFor(vr::OpenFile{}));
    for (const char* path : {"a", "b"}) { // one broken, one deleted
        files.chosen = QString::fromLatin1(path);
        QVERIFY(!files.layout().itemFor(vr::OpenFile{files.chosen}));
    }
    files.files.first().isBroken = false;
    files.chosen = QStringLiteral("a");
    QVERIFY(files.layout().itemFor(vr::OpenFile{files.chosen}));
    files.isBusy = true;
    QVERIFY(!files.layout().itemFor(PanelCommand::SaveModel) && !files.layout().itemFor(vr::OpenFile{files.chosen}));
}

/// Checks that a slider takes the value under the point, in steps, and its end values beyond the ends. The place of a
/// value must give that value.
void TestPanelLayout::aSlider_takesTheValueUnderThePoint()
{
    QFETCH(int, index);
    for (const PanelItem& item : exampleLayout(index).items) {
        if (!item.isSlider())
            continue;
        const auto& look = std::get<vr::SliderLook>(item.look);
        const auto valueAt = [&](double x) {
            return std::get<vr::Slide>(vr::actionAt(item, {x, item.area.center().y()})).value;
        };
        double before = look.min;
        for (double x = item.area.left() - 40; x < item.area.right() + 40; x += 0.7) {
            const double value = valueAt(x), steps = (value - look.min) / look.step;
            QVERIFY(value >= before && value <= look.max);
            QVERIFY(std::abs(steps - std::round(steps)) < 1e-6);
            before = value;
        }
        QCOMPARE(valueAt(item.area.left()), look.min);
        QCOMPARE(valueAt(item.area.right()), look.max);
        for (double value = look.min; value <= look.max; value += look.step)
            QVERIFY(std::abs(valueAt(vr::sliderTrack(item.area).pointAt(vr::sliderShare(look, value)).x()) - value) <
                    look.step / 100);
    }
}

/// Checks the panel's size in metres: from the reading distance, 1 dmm is a thousandth of the distance, so text looks
/// equally large on every panel.
void TestPanelLayout::aPanel_isAsLargeAsItLooks()
{
    QFETCH(int, index);
    const PanelLayout layout = exampleLayout(index);
    const Eigen::Vector2d half = layout.metres() / 2;
    QVERIFY(half.x() > 0.02 && half.x() < 0.35 && half.y() > 0.02 && half.y() < 0.35);
    QVERIFY((inRoom(layout, {0, 0}) - Eigen::Vector2d(-half.x(), half.y())).norm() < 1e-12);
    QVERIFY((layout.toPanel(half) - QPointF(layout.size.width(), 0)).manhattanLength() < 1e-9);
    QVERIFY(layout.contains(0.99 * half) && !layout.contains(1.01 * half));
    const auto degreesAt = [](double dmm) { return 2 * std::atan(dmm / 2000) * 180 / std::numbers::pi; };
    QVERIFY(degreesAt(vr::theme::titleHeight) > 3.45 && degreesAt(vr::theme::minHeight) > 3.45 / 2);
}

/// Checks that the slider of the tools shows the radius, and that its ends are those of the radius.
void TestPanelLayout::theRadius_hasItsWholeRange()
{
    const vr::Slide any{vr::PanelSlider::Radius, 0};
    for (const double radius : {vr::minRadius, vr::defaultRadius, vr::maxRadius}) {
        vr::ToolPanel panel;
        panel.radius = radius;
        const PanelLayout layout = panel.layout();
        const PanelItem* item = layout.itemFor(any);
        QVERIFY(item && item->isSlider());
        const auto& look = std::get<vr::SliderLook>(item->look);
        const double shown = std::get<vr::Slide>(*item->action).value;
        QCOMPARE(vr::minRadius * std::exp2(shown), radius);
        QVERIFY(shown >= look.min && shown <= look.max);
        QVERIFY(look.min == 0 && vr::minRadius * std::exp2(look.max - look.step) < vr::maxRadius);
        const QString text = QString::number(std::lround(radius * 1000)) + " mm";
        QVERIFY(std::ranges::any_of(layout.items, [&](const PanelItem& i) {
            const auto* words = std::get_if<vr::TextLook>(&i.look);
            return words && words->text == text;
        }));
    }
}

void TestPanelLayout::everyFile_isOnOnePage()
{
    for (int count = 0; count < 20; ++count) {
        vr::FilesPanel panel;
        for (int i = 0; i < count; ++i)
            panel.files << vr::FileTile{QString::number(i), QString::number(i), {}, false};
        QStringList seen;
        for (panel.page = 0; panel.page < panel.pageCount(); ++panel.page)
            for (const PanelItem& item : panel.layout().items)
                if (item.action && std::holds_alternative<vr::ChooseFile>(*item.action))
                    seen << std::get<vr::ChooseFile>(*item.action).path;
        QCOMPARE(seen.size(), count);
        for (int i = 0; i < count; ++i)
            QCOMPARE(seen[i], QString::number(i));
    }
}

void TestPanelLayout::manyMarks_beginWithThoseToBeMet()
{
    vr::LessonPanel panel;
    panel.title = panel.text = QStringLiteral("A");
    for (int i = 0; i < 9; ++i)
        panel.marks.append({QStringLiteral("mark %1").arg(i), i % 3 != 2});
    QStringList seen;
    for (const PanelItem& item : panel.layout().items)
        if (const auto* const look = std::get_if<vr::TextLook>(&item.look); look && look->text.startsWith(u'm'))
            seen << look->text;
    QVERIFY(seen.size() >= 4);
    QCOMPARE(seen.mid(0, 4), (QStringList{QStringLiteral("mark 2"), QStringLiteral("mark 5"), QStringLiteral("mark 8"),
                                          QStringLiteral("mark 0")}));
}

void TestPanelLayout::aPageThatIsNot_isTheNearest()
{
    vr::FilesPanel panel = std::get<vr::FilesPanel>(examplePanels()[4].content);
    QCOMPARE(panel.pageCount(), 2);
    const auto shown = [](vr::FilesPanel files, int page) {
        files.page = page;
        return files.layout().itemFor(vr::ChooseFile{files.files[8].path}) != nullptr;
    };
    QVERIFY(shown(panel, 1) && shown(panel, 7));
    QVERIFY(!shown(panel, 0) && !shown(panel, -3));
}

void TestPanelLayout::aChoice_staysOnItsPanel()
{
    const vr::FilesPanel files = std::get<vr::FilesPanel>(examplePanels()[4].content);
    QCOMPARE(files.after(vr::ShowPage{1}).page, 1);
    QCOMPARE(files.after(vr::ChooseFile{QStringLiteral("x")}).chosen, QStringLiteral("x"));
    QVERIFY(files.after(PanelCommand::SaveModel) == files);
}

void TestPanelLayout::openingUnsaved_mustBeHeld()
{
    vr::FilesPanel panel = std::get<vr::FilesPanel>(examplePanels()[4].content);
    for (const bool loses : {true, false}) {
        panel.hasUnsavedChanges = loses;
        const PanelItem* open = panel.layout().itemFor(vr::OpenFile{panel.chosen, loses});
        QVERIFY(open && open->mustHold == loses);
        QVERIFY(!panel.layout().itemFor(vr::OpenFile{panel.chosen, !loses}));
    }
    QVERIFY(vr::ToolPanel().layout().itemFor(PanelCommand::RestoreModel)->mustHold);
}

/// Checks that each part has its row on one page, whatever their number, and that a page that is not shows the nearest.
void TestPanelLayout::aPart_isOnOnePage()
{
    for (const int count : {1, 4, 5, 6, 23, 1000}) {
        vr::PartsPanel panel;
        for (int i = 0; i < count; ++i)
            panel.parts << vr::PartRow{{static_cast<core::PartId>(i), {}, true, false, {}}, QString::number(i)};
        std::vector<int> seen(static_cast<std::size_t>(count));
        for (panel.page = 0; panel.page < panel.pageCount(); ++panel.page)
            for (int i = 0; i < count; ++i)
                seen[static_cast<std::size_t>(i)] +=
                    panel.layout().itemFor(vr::ChoosePart{static_cast<core::PartId>(i)}) != nullptr;
        QVERIFY(std::ranges::all_of(seen, [](int pages) { return pages == 1; }));
        QVERIFY(panel.layout().itemFor(vr::ChoosePart{static_cast<core::PartId>(count - 1)}));
        panel.page = -3;
        QVERIFY(panel.layout().itemFor(vr::ChoosePart{0}));
    }
}

/// Checks that only marked parts other than the active one are combined with it, and that marks of parts that are gone
/// do not count.
void TestPanelLayout::partsAreCombined_ifOthersAreMarked()
{
    vr::PartsPanel panel;
    for (const core::PartId id : std::initializer_list<core::PartId>{4, 2, 7})
        panel.parts << vr::PartRow{{id, {}, true, false, {}}, QString::number(id)};
    panel.active = 2;
    const auto canCombine = [&] {
        return panel.layout().itemFor(vr::CombineMarked{core::SetOperation::Union}) != nullptr;
    };
    QVERIFY(panel.others().empty() && !canCombine());
    panel = panel.after(vr::MarkPart{2, true}).after(vr::MarkPart{9, true});
    QVERIFY(panel.others().empty() && !canCombine());
    panel = panel.after(vr::MarkPart{7, true}).after(vr::MarkPart{4, true}).after(vr::MarkPart{7, true});
    QVERIFY((panel.others() == std::vector<core::PartId>{4, 7}) && canCombine());
    panel.active = 4;
    QVERIFY((panel.others() == std::vector<core::PartId>{2, 7}));
    panel = panel.after(vr::MarkPart{7, false}).after(vr::MarkPart{2, false});
    QVERIFY(panel.others().empty() && !canCombine());
    panel.isBusy = true;
    panel.preview = core::SetOperation::Difference;
    QVERIFY(canCombine());
    QVERIFY(panel.layout().itemFor(PanelCommand::ApplyPreview) && panel.layout().itemFor(PanelCommand::CancelPreview));
    QVERIFY(!panel.layout().itemFor(PanelCommand::DuplicatePart));
}

void TestPanelLayout::aNotice_isReadBeforeItFades()
{
    const vr::NoticePanel brief{QStringLiteral("Saved.")}, wordy{QString(120, QLatin1Char('a'))},
        chinese{QString(40, QChar(0x6a21))};
    const auto readable = [](const vr::NoticePanel& notice) {
        double seconds = 0;
        for (double age = -1; age < 30; age += 0.01) {
            const double opacity = vr::noticeOpacity(notice, age);
            if (opacity < 0 || opacity > 1)
                return -1.0;
            seconds += opacity == 1 ? 0.01 : 0;
        }
        return seconds;
    };
    QVERIFY(readable(brief) > 2 && readable(brief) < 4);
    QVERIFY(readable(wordy) > 120 * 0.05 && readable(wordy) < 12);
    QVERIFY(readable(chinese) > 40 / 5.0 && readable(chinese) < 12);
    for (const double age : {-1.0, 0.0, 60.0})
        QCOMPARE(vr::noticeOpacity(wordy, age), 0.0);
}

FETTLE_TEST(TestPanelLayout, QGuiApplication)
#include "tst_panel_layout.moc"
