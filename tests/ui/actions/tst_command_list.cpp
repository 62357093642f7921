// Words that a newcomer may search for in the list of commands, in each language.
#include "ui/actions/actions.h"
#include "ui/actions/command_list.h"

#include "tests/support/test_main.h"
#include "tests/support/translation_file.h"
#include "tests/ui/ui_test.h"

#include <QAction>
#include <QMainWindow>

#include <algorithm>

class TestCommandList : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The intended command is selected, or is one of at most three visible commands.
    void newcomersWords_findWhatIsMeant_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("word");
        QTest::addColumn<QString>("meant"); ///< ids of acceptable commands, separated by spaces
        const auto add = [](const char* language, std::initializer_list<std::pair<const char*, const char*>> wishes) {
            for (const auto& [word, meant] : wishes)
                QTest::addRow("%s %s", language, word)
                    << QString::fromUtf8(language) << QString::fromUtf8(word) << QString::fromUtf8(meant);
        };
        add("en", {{"bigger", "model.scale brush.larger"},
                   {"eraser", "mask.clear edit.undo"},
                   {"mirror", "symmetry.on model.mirror"},
                   {"hollow", "tool.push tool.stamp"},
                   {"carve", "tool.push"},
                   {"zoom", "view.frame view.nearer"},
                   {"stl", "file.exportFor"},
                   {"print", "model.printCheck file.exportFor"},
                   {"undo", "edit.undo"},
                   {"mask", "tool.mask"},
                   {"color", "tool.paint brush.color"},
                   {"colour", "tool.paint brush.color"},
                   {"cut", "area.trim model.flattenBase"},
                   {"hole", "tool.push"},
                   {"thick", "model.printCheck"},
                   {"base", "model.flattenBase"},
                   {"stand", "model.flattenBase model.placeOnBed"},
                   {"support", "model.printCheck"},
                   {"scale", "model.scale"},
                   {"rotate", "model.transform"},
                   {"move", "model.transform"},
                   {"wireframe", "view.wireframe"},
                   {"shadow", "view.cavity"},
                   {"light", "background.light"},
                   {"dark", "background.dark edit.preferences"},
                   {"language", "edit.preferences"},
                   {"pen", "edit.preferences"},
                   {"pressure", "edit.preferences"},
                   {"vr", "vr.enter"},
                   {"recover", "file.revert"}});
        add("de", {{"größer", "model.scale brush.larger"},
                   {"Radiergummi", "mask.clear edit.undo"},
                   {"spiegeln", "symmetry.on model.mirror"},
                   {"aushöhlen", "tool.push tool.stamp"},
                   {"schnitzen", "tool.push"},
                   {"zoomen", "view.frame view.nearer"},
                   {"drucken", "model.printCheck file.exportFor"},
                   {"rückgängig", "edit.undo"},
                   {"Farbe", "tool.paint brush.color"},
                   {"schneiden", "area.trim model.flattenBase"},
                   {"Loch", "tool.push"},
                   {"dick", "model.printCheck"},
                   {"drehen", "model.transform"},
                   {"verschieben", "model.transform"},
                   {"Stift", "edit.preferences"},
                   {"Sprache", "edit.preferences"},
                   {"Licht", "background.light"},
                   {"Schatten", "view.cavity"},
                   {"Stütze", "model.printCheck"},
                   {"wiederherstellen", "file.revert"}});
        add("zh_CN", {{"放大", "model.scale brush.larger view.nearer"},
                      {"橡皮擦", "mask.clear edit.undo"},
                      {"镜像", "symmetry.on model.mirror"},
                      {"掏空", "tool.push tool.stamp"},
                      {"雕刻", "tool.push"},
                      {"缩放", "view.frame view.nearer model.scale"},
                      {"打印", "model.printCheck file.exportFor"},
                      {"撤销", "edit.undo"},
                      {"遮罩", "tool.mask"},
                      {"颜色", "tool.paint brush.color"},
                      {"切", "area.trim model.flattenBase"},
                      {"洞", "tool.push"},
                      {"厚", "model.printCheck"},
                      {"旋转", "model.transform"},
                      {"移动", "model.transform"},
                      {"语言", "edit.preferences"},
                      {"压感", "edit.preferences"},
                      {"支撑", "model.printCheck"},
                      {"阴影", "view.cavity"},
                      {"恢复", "file.revert"}});
    }
    void newcomersWords_findWhatIsMeant()
    {
        QFETCH(QString, language);
        QFETCH(QString, word);
        QFETCH(QString, meant);
        TranslationFile catalogue(QStringLiteral(FETTLE_SOURCE_DIR "/translations/fettle_%1.ts").arg(language));
        QVERIFY(!catalogue.isEmpty());
        if (language != QStringLiteral("en"))
            QVERIFY(QCoreApplication::installTranslator(&catalogue));
        QMainWindow window;
        const ui::Actions actions(&window);
        ui::CommandList list(actions);
        list.filter(word);
        QStringList found;
        for (const ui::ActionInfo& row : ui::actionTable())
            if (!list.itemOf(QLatin1StringView(row.id))->isHidden())
                found << QLatin1StringView(row.id);
        const QAction* const first = ui::CommandList::actionOf(list.currentItem());
        const QStringList ids = meant.split(u' ');
        const bool isAmongFew =
            found.size() <= 3 && std::ranges::any_of(ids, [&](const QString& id) { return found.contains(id); });
        QVERIFY2(first && (ids.contains(first->objectName()) || isAmongFew), qPrintable(found.join(u' ')));
        QCoreApplication::removeTranslator(&catalogue);
    }
};

FETTLE_TEST(TestCommandList, ui::TestApplication)
#include "tst_command_list.moc"
