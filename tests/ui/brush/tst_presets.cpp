// Brush presets of the program and of the user, faulty files, and the list that shows presets.
#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include "tests/support/effort.h"
#include "ui/brush/brush_shapes.h"
#include "ui/brush/preset_choice.h"
#include "ui/brush/preset_library.h"
#include "ui/brush/preset_list.h"
#include "ui/widgets/side_panel.h"
#include "ui/window/main_window.h"

#include <QDir>
#include <QListWidget>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QToolButton>

#include <set>

using core::Tool;

namespace
{
constexpr std::size_t oursCount = 16;

bool writeText(const QString& path, const QByteArray& text)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
}

/// A library whose presets have been read.
struct LoadedLibrary
{
    ui::PresetLibrary library;
    QSignalSpy loaded{&library, &ui::PresetLibrary::loaded}, refused{&library, &ui::PresetLibrary::refused};

    LoadedLibrary() { reload(); }

    bool reload()
    {
        library.load();
        return next();
    }
    bool next()
    {
        const bool came = !loaded.isEmpty() || loaded.wait(longestWait);
        loaded.clear();
        return came;
    }
    const ui::PresetLibrary::Entry& last() const { return library.entries().back(); }
};

QListWidget* listOf(const ui::MainWindow& window)
{
    return window.findChild<QListWidget*>(QStringLiteral("presets"));
}

QListWidgetItem* itemNamed(const ui::MainWindow& window, const QString& name)
{
    const QList<QListWidgetItem*> found = listOf(window)->findItems(name, Qt::MatchExactly);
    return found.isEmpty() ? nullptr : found.constFirst();
}

void showPresets(ui::MainWindow& window)
{
    window.show();
    auto* panel = window.findChild<ui::SidePanel*>(QStringLiteral("presetPanel"));
    panel->bringForward();
}

void click(const QListWidgetItem* item)
{
    QListWidget* list = item->listWidget();
    list->scrollToItem(item);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(item).center());
}
} // namespace

class TestPresets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QVERIFY(m_folder.isValid());
    }

    void init()
    {
        QSettings().clear();
        QDir(ui::PresetLibrary::folder()).removeRecursively();
        QVERIFY(QDir().mkpath(ui::PresetLibrary::folder()));
    }

    void cleanupTestCase() { QDir(ui::PresetLibrary::folder()).removeRecursively(); }

    /// Each bundled preset has a different name, tip, set of values and picture.
    void ours_areAllDifferent()
    {
        LoadedLibrary loaded;
        QCOMPARE(loaded.refused.count(), 0);
        QCOMPARE(loaded.library.entries().size(), oursCount);
        std::set<QString> names, tips;
        std::set<QByteArray> pictures;
        for (const ui::PresetLibrary::Entry& entry : loaded.library.entries()) {
            QVERIFY(entry.isOurs && entry.name == QString::fromStdString(entry.file.preset->name));
            QVERIFY(!entry.tip.isEmpty());
            names.insert(entry.name);
            tips.insert(entry.tip);
            const QImage picture = ui::presetImage(entry.file, 64, {});
            if (pictures.empty() || effort() != Effort::Small)
                QVERIFY(picture == ui::presetImage(entry.file, 64, {}));
            pictures.insert(QByteArray(reinterpret_cast<const char*>(picture.constBits()), picture.sizeInBytes()));
        }
        QVERIFY(names.size() == oursCount && tips.size() == oursCount && pictures.size() == oursCount);
    }

    void aBrush_isKeptAndComesBack()
    {
        ui::MainWindow window;
        auto* shapes = window.findChild<ui::BrushShapes*>();
        ui::BrushSettings& brush = *window.brush();
        brush.setTool(Tool::Clay);
        brush.setValue(core::Parameter::Strength, 1.75);
        brush.setValue(core::Parameter::Falloff, 7);
        brush.setValue(core::Parameter::Spacing, 0.5);
        brush.setValue(core::Parameter::Detail, 0.5);
        brush.set(&core::StrokeSettings::brush, core::BrushShape::Ray);
        brush.set(&core::StrokeSettings::alphaFollows, true);
        brush.set(&core::StrokeSettings::anchored, true);
        brush.tools()->setAirbrush(Tool::Clay, false);
        brush.setInverted(true);
        shapes->chooseAlpha(QStringLiteral("scales"));
        const core::StrokeSettings kept = brush.stroke();

        LoadedLibrary loaded;
        const QString path = loaded.library.add(ui::presetOf(brush), QStringLiteral("Mein Ton"));
        QVERIFY(!path.isEmpty() && loaded.next());
        QCOMPARE(loaded.library.entries().size(), oursCount + 1);
        QCOMPARE(loaded.last().name, QStringLiteral("Mein Ton"));
        brush.reset();
        brush.setTool(Tool::Pull);
        QVERIFY(!ui::isInHand(*loaded.last().file.preset, brush));
        QCOMPARE(ui::takePreset(loaded.last().file, &brush, shapes), QString());
        QVERIFY(ui::isInHand(*loaded.last().file.preset, brush));
        const core::StrokeSettings& now = brush.stroke();
        QVERIFY(now.tool == kept.tool && now.strength == kept.strength && now.falloff == kept.falloff);
        QVERIFY(now.spacing == kept.spacing && now.detail == kept.detail && now.brush == kept.brush);
        QVERIFY(now.alpha == kept.alpha && now.alphaFollows && now.anchored && brush.isInverted());
        QVERIFY(!brush.tools()->isAirbrush(Tool::Clay));
        brush.setTool(Tool::Pull); // Pull keeps its own values
        QVERIFY(brush.stroke().strength == 1 && !brush.stroke().alpha);
    }

    /// A preset changes the radius only if each tool has a radius of its own.
    void theRadius_onlyComesWhereEachToolHasItsOwn()
    {
        ui::MainWindow window;
        ui::BrushSettings& brush = *window.brush();
        LoadedLibrary loaded;
        const auto& entries = loaded.library.entries();
        const auto bigMove = std::ranges::find(entries, QStringLiteral("Big Move"), &ui::PresetLibrary::Entry::name);
        QVERIFY(bigMove != entries.end());
        const double share = brush.radiusShare();
        ui::takePreset(bigMove->file, &brush, window.findChild<ui::BrushShapes*>());
        QCOMPARE(brush.radiusShare(), share);
        brush.tools()->setSharesRadius(false);
        ui::takePreset(bigMove->file, &brush, window.findChild<ui::BrushShapes*>());
        QVERIFY(qFuzzyCompare(brush.radiusShare(), *bigMove->file.preset->radiusShare));
    }

    void aBadFile_isLeftOut_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("words");
        QTest::newRow("broken") << QByteArray("{\"format\":\"fettle-brush\"") << "JSON";
        QTest::newRow("newer") << QByteArray(R"({"format":"fettle-brush","version":2,"glow":{}})") << "newer version";
        QTest::newRow("value")
            << QByteArray(R"({"format":"fettle-brush","version":1,"name":"A","stroke":{"tool":"clay","airbrush":999}})")
            << "airbrush";
        QTest::newRow("empty") << QByteArray() << "JSON";
        QTest::newRow("binary") << QByteArray::fromHex("89504e470d0a1a0a00ff") << "JSON";
    }

    void aBadFile_isLeftOut()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, words);
        const QDir folder(ui::PresetLibrary::folder());
        QVERIFY(writeText(folder.filePath(QStringLiteral("a.json")), text));
        QVERIFY(writeText(folder.filePath(QStringLiteral("b.json")),
                          R"({"format":"fettle-brush","version":1,"name":"B","stroke":{"tool":"clay"}})"));
        LoadedLibrary loaded;
        QCOMPARE(loaded.refused.count(), 1);
        const QString sentence = loaded.refused[0][0].toString();
        QVERIFY2(sentence.contains(words) && sentence.contains(QStringLiteral("a.json")) && sentence.endsWith(u'.') &&
                     !sentence.contains(u'\n'),
                 qPrintable(sentence));
        QCOMPARE(loaded.library.entries().size(), oursCount + 1);
        QCOMPARE(loaded.last().name, QStringLiteral("B"));
        QVERIFY(loaded.reload());
        QCOMPARE(loaded.refused.count(), 1); // not reported again
        QVERIFY(QFile::exists(folder.filePath(QStringLiteral("a.json"))));
        QVERIFY(loaded.library.import(folder.filePath(QStringLiteral("a.json"))).isEmpty());
        QCOMPARE(loaded.refused.count(), 2);
    }

    void names_areKeptApart()
    {
        LoadedLibrary loaded;
        core::BrushPreset preset;
        for (int i = 0; i < 3; ++i) {
            loaded.library.add(preset, QStringLiteral("My brush"));
            QVERIFY(loaded.next());
        }
        QCOMPARE(loaded.last().name, QStringLiteral("My brush 3"));
        loaded.library.rename(ui::PresetLibrary::Entry(loaded.last()), QStringLiteral("  My   brush "));
        QVERIFY(loaded.next());
        QCOMPARE(loaded.last().name, QStringLiteral("My brush 4"));
        loaded.library.rename(ui::PresetLibrary::Entry(loaded.last()), QStringLiteral(" "));
        QVERIFY(loaded.next());
        QCOMPARE(loaded.last().name, QStringLiteral("My brush 4"));
        loaded.library.rename(ui::PresetLibrary::Entry(loaded.last()), QString(300, QChar(0x76ae)));
        QVERIFY(loaded.next());
        QCOMPARE(loaded.library.entries().size(), oursCount + 3); // the shortened name is readable
        QCOMPARE(loaded.refused.count(), 0);
    }

    /// An exported preset contains the image of its alpha and works where the alpha's file does not exist.
    void anExportedPreset_needsNoOtherFile()
    {
        QImage image(8, 8, QImage::Format_Grayscale8);
        image.fill(77);
        image.setPixel(3, 4, qRgb(255, 255, 255));
        const QString skin = m_folder.filePath(QStringLiteral("skin.png"));
        QVERIFY(image.save(skin));
        ui::MainWindow window;
        auto* shapes = window.findChild<ui::BrushShapes*>();
        shapes->chooseAlpha(skin);
        QTRY_VERIFY(window.brush()->stroke().alpha);
        const std::string print = window.brush()->stroke().alpha->fingerprint();
        LoadedLibrary loaded;
        QVERIFY(!loaded.library.add(ui::presetOf(*window.brush()), QStringLiteral("Skin")).isEmpty() && loaded.next());
        const QString exported = m_folder.filePath(QStringLiteral("out.json"));
        loaded.library.exportTo(loaded.last(), exported);
        QVERIFY(QFile::exists(exported) && QFile::remove(skin));
        QVERIFY(!loaded.library.import(exported).isEmpty() && loaded.next());
        QCOMPARE(loaded.last().name, QStringLiteral("Skin 2"));
        QVERIFY(!ui::presetImage(loaded.last().file, 64, {}).isNull());
        shapes->chooseAlpha({});
        QCOMPARE(ui::takePreset(loaded.last().file, window.brush(), shapes), QString());
        QTRY_VERIFY(window.brush()->stroke().alpha);
        QCOMPARE(window.brush()->stroke().alpha->fingerprint(), print);
        // Extracted to a file, because strokes name a file
        QVERIFY(QFile::exists(QString::fromStdString(window.brush()->stroke().alpha->source())));
        QCOMPARE(loaded.refused.count(), 0);
    }

    void aPresetFromElsewhere_takesItsAlphaWithIt()
    {
        const QString path = m_folder.filePath(QStringLiteral("other.json"));
        QVERIFY(writeText(path, R"({"format":"fettle-brush","version":1,"name":"O","stroke":{"tool":"clay",)"
                                R"("alpha":"not-there.png"}})"));
        LoadedLibrary loaded;
        QVERIFY(loaded.library.import(path).isEmpty());
        QCOMPARE(loaded.refused.count(), 1);
        QVERIFY(loaded.refused[0][0].toString().contains(QStringLiteral("not-there.png")));
        QImage image(4, 4, QImage::Format_Grayscale8);
        image.fill(200);
        QVERIFY(image.save(m_folder.filePath(QStringLiteral("not-there.png"))));
        QVERIFY(!loaded.library.import(path).isEmpty() && loaded.next());
        QVERIFY(!loaded.last().file.preset->alphaImage.empty());
    }

    void theFolderCannotBeWritten()
    {
        QDir(ui::PresetLibrary::folder()).removeRecursively();
        // A file in place of the folder, because permissions would not stop root
        QVERIFY(writeText(ui::PresetLibrary::folder(), "a file"));
        LoadedLibrary loaded;
        QVERIFY(loaded.library.add({}, QStringLiteral("A")).isEmpty());
        QCOMPARE(loaded.refused.count(), 1);
        QVERIFY(QFile::remove(ui::PresetLibrary::folder()));
    }

    void theList_showsAndGivesPresets()
    {
        ui::MainWindow window;
        showPresets(window);
        QTRY_COMPARE(listOf(window)->count(), static_cast<int>(oursCount));
        click(itemNamed(window, QStringLiteral("Scales")));
        QCOMPARE(window.brush()->tool(), Tool::Pull);
        QCOMPARE(window.brush()->stroke().alpha, core::builtInAlpha("scales"));
        listOf(window)->setCurrentRow(0);
        listOf(window)->setFocus();
        QTest::keyClick(listOf(window), Qt::Key_Return);
        QCOMPARE(window.brush()->tool(), Tool::Clay);
        const auto hasPicture = [&](int i) {
            return listOf(window)->item(i)->icon().pixmap(64).toImage().pixelColor(32, 32).alpha() > 0;
        };
        for (int i = 0; i < static_cast<int>(oursCount); ++i)
            QTRY_VERIFY(hasPicture(i));
    }

    void theList_offersWhatTheToolsAre()
    {
        ui::MainWindow window;
        showPresets(window);
        QTRY_COMPARE(listOf(window)->count(), static_cast<int>(oursCount));
        window.brush()->offerTools({Tool::Grab, Tool::Smooth});
        int shown = 0;
        for (int i = 0; i < listOf(window)->count(); ++i)
            shown += listOf(window)->item(i)->isHidden() ? 0 : 1;
        QCOMPARE(shown, 1);
        QVERIFY(!itemNamed(window, QStringLiteral("Big Move"))->isHidden());
        Q_EMIT listOf(window)->itemActivated(itemNamed(window, QStringLiteral("Carve")));
        QCOMPARE(window.brush()->tool(), Tool::Grab);
        window.brush()->offerTools({});
        QVERIFY(!itemNamed(window, QStringLiteral("Carve"))->isHidden());
    }

    void theList_keepsRenamesAndDeletes()
    {
        ui::MainWindow window;
        showPresets(window);
        QTRY_COMPARE(listOf(window)->count(), static_cast<int>(oursCount));
        const auto button = [&](const char* name) { return window.findChild<QToolButton*>(QString::fromLatin1(name)); };
        listOf(window)->setCurrentItem(itemNamed(window, QStringLiteral("Carve")));
        QVERIFY(!button("presets.rename")->isEnabled() && !button("presets.delete")->isEnabled());
        QVERIFY(button("presets.export")->isEnabled());
        button("presets.new")->click();
        QTRY_COMPARE(listOf(window)->count(), static_cast<int>(oursCount + 1));
        QVERIFY(button("presets.rename")->isEnabled() && button("presets.delete")->isEnabled());
        QListWidgetItem* mine = listOf(window)->item(static_cast<int>(oursCount));
        mine->setText(QStringLiteral("Mine"));
        QTRY_VERIFY(QFile::exists(QDir(ui::PresetLibrary::folder()).filePath(QStringLiteral("my-brush.json"))));
        QTRY_VERIFY(itemNamed(window, QStringLiteral("Mine")));
        LoadedLibrary loaded;
        QTRY_VERIFY(loaded.reload() && loaded.last().name == QStringLiteral("Mine"));
        window.findChild<ui::BrushShapes*>()->setMayLoad(false); // as during a class
        for (const char* name : {"presets.new", "presets.rename", "presets.delete", "presets.import", "presets.export"})
            QVERIFY(button(name)->isHidden());
    }

private:
    QTemporaryDir m_folder;
};

FETTLE_TEST(TestPresets, ui::TestApplication)
#include "tst_presets.moc"
