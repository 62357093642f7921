#include "vr/panels/panel_painter.h"

#include "tests/support/test_main.h"
#include "tests/vr/panels/example_panels.h"
#include "vr/panels/panel_icons.h"

#include <QDir>
#include <QPainter>
#include <QTest>
#include <QTranslator>

#include <algorithm>
#include <cmath>
#include <thread>

using vr::PanelItem;
using vr::PanelLayout;
using vr::PanelTouch;
using vr::PanelTouches;

namespace
{
constexpr double sharpness = vr::panelSharpness;

/// Returns the rectangle that contains all pixels that differ; null: none.
QRect difference(const QImage& a, const QImage& b)
{
    QRect all;
    for (int y = 0; y < a.height(); ++y) {
        const auto *rowA = reinterpret_cast<const QRgb*>(a.constScanLine(y)),
                   *rowB = reinterpret_cast<const QRgb*>(b.constScanLine(y));
        if (std::equal(rowA, rowA + a.width(), rowB)) // for most rows, and faster than std::mismatch
            continue;
        const auto first = std::mismatch(rowA, rowA + a.width(), rowB).first - rowA;
        auto last = static_cast<std::ptrdiff_t>(a.width()) - 1;
        while (rowA[last] == rowB[last])
            --last;
        all |= QRect(QPoint(static_cast<int>(first), y), QPoint(static_cast<int>(last), y));
    }
    return all;
}

/// Returns the pixels that the area, in dmm, touches.
QRect pixels(const QRectF& area)
{
    return QRectF(area.topLeft() * sharpness, area.size() * sharpness)
        .adjusted(-0.01, -0.01, 0.01, 0.01)
        .toAlignedRect();
}

QString textOf(const PanelItem& item)
{
    if (const auto* text = std::get_if<vr::TextLook>(&item.look))
        return text->text;
    if (const auto* button = std::get_if<vr::ButtonLook>(&item.look))
        return button->text;
    const auto* onOff = std::get_if<vr::SwitchLook>(&item.look);
    return onOff ? onOff->text : QString();
}

QStringList iconsOf(const PanelLayout& layout)
{
    QStringList names;
    for (const PanelItem& item : layout.items) {
        if (const auto* button = std::get_if<vr::ButtonLook>(&item.look); button && !button->icon.isEmpty())
            names << button->icon;
        if (const auto* tile = std::get_if<vr::TileLook>(&item.look))
            names << tile->icon;
    }
    return names;
}

/// Returns the panel with this item alone, without most of what lies to the right and below, which is painted faster.
PanelLayout only(const PanelLayout& layout, const PanelItem& item)
{
    constexpr double margin = 40; // dmm
    PanelLayout one = layout;
    one.items = {item};
    one.size = layout.size.boundedTo(QSizeF(item.area.right() + margin, item.area.bottom() + margin));
    return one;
}

PanelItem withText(PanelItem item, const QString& text)
{
    std::visit(
        [&](auto& look) {
            if constexpr (requires { look.text; })
                look.text = text;
        },
        item.look);
    return item;
}

/// Returns true if the item's text is not cut off. Letters appended to a cut text are invisible, so the image does not
/// change.
bool isWhole(const PanelLayout& layout, const PanelItem& item)
{
    const PanelItem more = withText(item, textOf(item) + QStringLiteral("WWW"));
    return !difference(vr::paint(only(layout, item)), vr::paint(only(layout, more))).isNull();
}

PanelTouches touching(const PanelItem& item, bool isPressed, double held = 0)
{
    return {PanelTouch{*item.action, isPressed, held}, std::nullopt};
}
} // namespace

class TestPanelPainter : public QObject
{
    Q_OBJECT

public:
    static void initMain() { qputenv("QT_QPA_PLATFORM", "offscreen"); }

private Q_SLOTS:
    void whatIsPointedAt_isLitWhereItIsHit_data() { addExamples(); }
    void whatIsPointedAt_isLitWhereItIsHit();
    void whatDoesNotAnswer_isNotLit();
    void aHold_fillsItsRing();
    void texts_keepWithinTheirParts_data() { addExamples(); }
    void texts_keepWithinTheirParts();
    void noTranslation_isCut_data();
    void noTranslation_isCut();
    void aChosenTool_isNotCut_data() { noTranslation_isCut_data(); }
    void aChosenTool_isNotCut();
    void everyIcon_isThere();
    void aValue_isSeen_data();
    void aValue_isSeen();
    void anotherThread_paintsTheSame();
    void corners_areRoundAndPremultiplied();
    void pictures_ofThemAll_data();
    void pictures_ofThemAll();

private:
    static void addExamples();
    static void addLanguages();
};

void TestPanelPainter::addExamples()
{
    QTest::addColumn<int>("index");
    const std::vector<ExamplePanel> examples = examplePanels();
    for (std::size_t i = 0; i < examples.size(); ++i)
        QTest::newRow(examples[i].name) << static_cast<int>(i);
}

/// Checks that highlighting an item changes pixels from edge to edge of its area, and none outside it.
void TestPanelPainter::whatIsPointedAt_isLitWhereItIsHit()
{
    QFETCH(int, index);
    const PanelLayout layout = exampleLayout(index);
    const QImage plain = vr::paint(layout);
    QVERIFY(difference(plain, vr::paint(layout)).isNull());
    for (const PanelItem& item : layout.items) {
        if (!item.isInteractive())
            continue;
        const QRect area = pixels(item.area), changed = difference(plain, vr::paint(layout, touching(item, false)));
        QVERIFY(area.contains(changed));
        QVERIFY(changed.width() >= area.width() - 8 && changed.height() >= area.height() - 8);
        const PanelLayout one = only(layout, item);
        const QImage lit = vr::paint(one, touching(item, false)), pressed = vr::paint(one, touching(item, true));
        QVERIFY(area.contains(difference(vr::paint(one), pressed)));
        QVERIFY(!difference(lit, pressed).isNull());
        QVERIFY(difference(lit, vr::paint(one, {std::nullopt, PanelTouch{*item.action, false, 0}})).isNull());
    }
}

void TestPanelPainter::whatDoesNotAnswer_isNotLit()
{
    const PanelLayout layout = vr::ToolPanel().layout();
    QVERIFY(
        difference(vr::paint(layout), vr::paint(layout, {PanelTouch{vr::PanelCommand::Undo, false, 0}, std::nullopt}))
            .isNull());
}

void TestPanelPainter::aHold_fillsItsRing()
{
    const PanelLayout layout = vr::ToolPanel().layout();
    const PanelItem& restore = *layout.itemFor(vr::PanelCommand::RestoreModel);
    QImage before = vr::paint(layout, touching(restore, true, 0));
    for (const double held : {0.25, 0.5, 0.75, 1.0}) {
        const QImage now = vr::paint(layout, touching(restore, true, held));
        QVERIFY(!difference(before, now).isNull());
        QVERIFY(pixels(restore.area).contains(difference(before, now)));
        before = now;
    }
}

/// Checks that a text of any length changes nothing outside its item and is not cut off by the item's lower edge: the
/// last row of pixels stays unchanged.
void TestPanelPainter::texts_keepWithinTheirParts()
{
    QFETCH(int, index);
    const PanelLayout layout = exampleLayout(index);
    for (const PanelItem& item : layout.items) {
        if (textOf(item).isEmpty())
            continue;
        const QImage plain = vr::paint(only(layout, item));
        for (const QString& text : {QStringLiteral("Åg"), QStringLiteral("Ågjp ") + QString(60, QLatin1Char('W')),
                                    QStringLiteral("jÅg gÅp ").repeated(12)}) {
            const QImage other = vr::paint(only(layout, withText(item, text)));
            const QRect area = pixels(item.area), changed = difference(plain, other);
            QVERIFY2(area.contains(changed), qPrintable(textOf(item)));
            QVERIFY2(changed.top() > area.top() && changed.bottom() < area.bottom(),
                     qPrintable(textOf(item) + QLatin1Char('|') + text));
        }
    }
}

void TestPanelPainter::addLanguages()
{
    QTest::addColumn<QString>("language");
    for (const QString& language : {QStringLiteral("de"), QStringLiteral("zh_CN")})
        QTest::newRow(qPrintable(language)) << language;
}

void TestPanelPainter::noTranslation_isCut_data()
{
    addLanguages();
    QTest::newRow("en") << QString();
}

void TestPanelPainter::noTranslation_isCut()
{
    QFETCH(QString, language);
    const std::vector<ExamplePanel> examples = examplePanels();
    std::optional<TestTranslation> words;
    if (!language.isEmpty())
        words.emplace(TestTranslation::ofLanguage(language));
    for (const ExamplePanel& example : examples) {
        const PanelLayout layout = vr::layoutOf(example.content);
        for (const PanelItem& item : layout.items)
            QVERIFY2(textOf(item).isEmpty() || isWhole(layout, item), qPrintable(textOf(item)));
    }
}

/// Checks that the name of a selected tool is not cut off. Its letters are wider than those of other tools.
void TestPanelPainter::aChosenTool_isNotCut()
{
    QFETCH(QString, language);
    std::optional<TestTranslation> words;
    if (!language.isEmpty())
        words.emplace(TestTranslation::ofLanguage(language));
    for (std::size_t tool = 0; tool < core::toolNames().size(); ++tool) {
        vr::ToolPanel panel;
        panel.tool = static_cast<core::Tool>(tool);
        const PanelLayout layout = panel.layout();
        const auto item = std::ranges::find_if(
            layout.items, [&](const PanelItem& p) { return p.action && vr::isSameItem(*p.action, panel.tool); });
        QVERIFY(item != layout.items.end());
        QVERIFY2(isWhole(layout, *item), qPrintable(textOf(*item)));
    }
}

void TestPanelPainter::everyIcon_isThere()
{
    QStringList names;
    for (const ExamplePanel& example : examplePanels())
        names << iconsOf(vr::layoutOf(example.content));
    names.removeDuplicates();
    QVERIFY(names.size() > 15);
    for (const QString& name : names) {
        const QImage icon = vr::iconPicture(name, Qt::red, 60);
        QVERIFY2(icon.size() == QSize(60, 60), qPrintable(name));
        int inked = 0;
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 60; ++x) {
                const QColor pixel = icon.pixelColor(x, y);
                inked += pixel.alpha() > 64 ? 1 : 0; // an icon of what is off may be faint
                QVERIFY2(pixel.alpha() < 128 || pixel.rgb() == QColor(Qt::red).rgb(),
                         qPrintable(name)); // edges are antialiased
            }
        QVERIFY2(inked > 60, qPrintable(name));
    }
    QVERIFY(vr::iconPicture(QStringLiteral("no such icon"), Qt::red, 60).isNull());
}

void TestPanelPainter::aValue_isSeen_data()
{
    QTest::addColumn<int>("before");
    QTest::addColumn<vr::PanelContent>("after");
    const std::vector<ExamplePanel> examples = examplePanels();
    const auto row = [&](const char* name, int before, const auto& change) {
        vr::PanelContent after = examples[static_cast<std::size_t>(before)].content;
        std::visit(
            [&](auto& panel) {
                if constexpr (requires { change(panel); })
                    change(panel);
            },
            after);
        QTest::newRow(name) << before << after;
    };
    row("tool", 0, [](vr::ToolPanel& panel) { panel.tool = core::Tool::Smooth; });
    row("brush", 0, [](vr::ToolPanel& panel) { panel.brush = core::BrushShape::Ray; });
    row("radius", 0, [](vr::ToolPanel& panel) { panel.radius = 0.06; });
    row("topology", 0, [](vr::ToolPanel& panel) { panel.topology = core::Topology::Uniform; });
    row("symmetry", 0, [](vr::ToolPanel& panel) { panel.isSymmetric = true; });
    row("sectors", 0, [](vr::ToolPanel& panel) { panel.radial = 6; });
    row("inverse", 0, [](vr::ToolPanel& panel) { panel.isInverse = true; });
    row("adding", 0, [](vr::ToolPanel& panel) { panel.addsNext = true; });
    row("undo", 0, [](vr::ToolPanel& panel) { panel.canUndo = true; });
    row("redo", 0, [](vr::ToolPanel& panel) { panel.canRedo = true; });
    row("cannot change", 0, [](vr::ToolPanel& panel) { panel.canChange = false; });
    row("red", 2, [](vr::ColorPanel& panel) { panel.color.r = 10; });
    row("channel", 2, [](vr::ColorPanel& panel) { panel.channel = 2; });
    row("swatch", 2, [](vr::ColorPanel& panel) { panel.swatches[2] = {}; });
    row("folder", 4, [](vr::FilesPanel& panel) { panel.folder += QLatin1Char('s'); });
    row("chosen", 4, [](vr::FilesPanel& panel) { panel.chosen = panel.files[2].path; });
    row("page", 4, [](vr::FilesPanel& panel) { panel.page = 1; });
    row("unsaved", 4, [](vr::FilesPanel& panel) { panel.hasUnsavedChanges = false; });
    row("busy", 4, [](vr::FilesPanel& panel) { panel.isBusy = true; });
    row("saved", 5, [](vr::FilesPanel& panel) { panel.saved += QLatin1Char('x'); });
    row("picture", 4, [](vr::FilesPanel& panel) { panel.files[4].picture = panel.files[0].picture; });
    row("name", 4, [](vr::FilesPanel& panel) { panel.files[4].name = QStringLiteral("other"); });
    row("preset", 8, [](vr::SettingsPanel& panel) { panel.settings.wands.preset = vr::ButtonPreset::Studio; });
    row("hand", 8, [](vr::SettingsPanel& panel) { panel.settings.wands.sculpting = vr::Side::Left; });
    row("height", 8, [](vr::SettingsPanel& panel) { panel.settings.heightOffset = -0.2; });
    row("turning", 8, [](vr::SettingsPanel& panel) { panel.settings.turnRate = 90; });
    row("floor", 8, [](vr::SettingsPanel& panel) { panel.settings.showsFloor = false; });
    row("room", 8, [](vr::SettingsPanel& panel) { panel.settings.hasPassthrough = true; });
    row("no room", 8, [](vr::SettingsPanel& panel) { panel.offersPassthrough = false; });
    row("numbers", 8, [](vr::SettingsPanel& panel) { panel.settings.showsPerformance = true; });
    row("vibration", 8, [](vr::SettingsPanel& panel) { panel.page = vr::SettingsPage::Haptics; });
    row("level", 10, [](vr::SettingsPanel& panel) { panel.settings.hapticLevels.of[2] = 0.55; });
    row("frames", 11, [](vr::PerformancePanel& panel) { panel.framesPerSecond = 45; });
    row("phase", 11, [](vr::PerformancePanel& panel) { panel.cpuMs[3] = 1.5; });
    row("total", 11, [](vr::PerformancePanel& panel) { panel.totalMs = 2; });
    row("draw calls", 11, [](vr::PerformancePanel& panel) { panel.drawCallMs = 2; });
    row("dropped", 11, [](vr::PerformancePanel& panel) { panel.dropped = 12; });
    row("notice", 12, [](vr::NoticePanel& notice) { notice.text = QStringLiteral("Opened."); });
}

/// Checks that different values give different images.
void TestPanelPainter::aValue_isSeen()
{
    QFETCH(int, before);
    QFETCH(vr::PanelContent, after);
    const vr::PanelContent content = examplePanels()[static_cast<std::size_t>(before)].content;
    QVERIFY(content != after);
    const QImage a = vr::paint(vr::layoutOf(content)), b = vr::paint(vr::layoutOf(after));
    QVERIFY(a.size() != b.size() || !difference(a, b).isNull());
}

void TestPanelPainter::anotherThread_paintsTheSame()
{
    for (const ExamplePanel& example : examplePanels()) {
        const QImage here = vr::paint(vr::layoutOf(example.content));
        QImage there;
        std::thread([&] { there = vr::paint(vr::layoutOf(example.content)); }).join();
        QCOMPARE(there.size(), here.size());
        QVERIFY(difference(here, there).isNull());
    }
}

void TestPanelPainter::corners_areRoundAndPremultiplied()
{
    for (const ExamplePanel& example : examplePanels()) {
        const PanelLayout layout = vr::layoutOf(example.content);
        const QImage picture = vr::paint(layout);
        QVERIFY(picture.pixelFormat().premultiplied() == QPixelFormat::Premultiplied);
        const QSizeF exact = layout.size * sharpness - QSizeF(picture.size());
        QVERIFY(std::abs(exact.width()) <= 0.5 && std::abs(exact.height()) <= 0.5);
        for (const QPoint corner : {picture.rect().topLeft(), picture.rect().topRight(), picture.rect().bottomLeft(),
                                    picture.rect().bottomRight()})
            QCOMPARE(picture.pixelColor(corner).alpha(), 0);
        QVERIFY(picture.pixelColor(picture.width() / 2, 12).alpha() > 230);
    }
}

void TestPanelPainter::pictures_ofThemAll_data()
{
    addLanguages();
    QTest::newRow("en") << QString();
    QTest::newRow("longer") << QString();
}

/// Writes images of all panels for inspection, on a dark background, to the folder "panels" beside the test. One item
/// is pressed and another one is pointed at.
void TestPanelPainter::pictures_ofThemAll()
{
    QFETCH(QString, language);
    const QString name = QString::fromLatin1(QTest::currentDataTag());
    const QDir folder(QStringLiteral("panels/") + name);
    QVERIFY(folder.mkpath(QStringLiteral(".")));
    std::optional<TestTranslation> words;
    if (!language.isEmpty())
        words.emplace(TestTranslation::ofLanguage(language));
    else if (name == QStringLiteral("longer"))
        words.emplace(TestTranslation::longer());
    for (const ExamplePanel& example : examplePanels()) {
        const PanelLayout layout = vr::layoutOf(example.content);
        std::vector<vr::PanelAction> items;
        for (const PanelItem& item : layout.items)
            if (item.isInteractive())
                items.push_back(*item.action);
        PanelTouches touches;
        if (items.size() > 4)
            touches = {PanelTouch{items[items.size() / 2], false, 0}, PanelTouch{items.back(), true, 0.6}};
        const QImage panel = vr::paint(layout, touches);
        QImage room(panel.size() + QSize(80, 80), QImage::Format_RGB32);
        room.fill(QColor(58, 62, 70));
        QPainter(&room).drawImage(40, 40, panel);
        QVERIFY(room.save(folder.filePath(QString::fromLatin1(example.name) + QStringLiteral(".png"))));
    }
}

FETTLE_TEST(TestPanelPainter, QGuiApplication)
#include "tst_panel_painter.moc"
