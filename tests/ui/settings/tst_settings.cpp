#include "ui/settings/settings.h"
#include "ui/settings/stored_brush.h"

#include "tests/support/test_main.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

class TestSettings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_home.isValid());
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_home.path());
        QCoreApplication::setOrganizationName(QStringLiteral("FettleTest"));
        QCoreApplication::setApplicationName(QStringLiteral("Settings"));
    }

    void init() { QSettings().clear(); }

    void nothingStoredGivesDefaults()
    {
        const ui::Settings settings;
        for (const core::Parameter parameter :
             {core::Parameter::Strength, core::Parameter::Falloff, core::Parameter::Detail})
            QCOMPARE(settings.value(parameter), core::info(parameter).defaultValue);
        QCOMPARE(settings.value(core::Parameter::Spacing), ui::defaultSpacing);
        QVERIFY(settings.get(&ui::Setting::radiusShare) > ui::minRadiusShare &&
                settings.get(&ui::Setting::radiusShare) < ui::maxRadiusShare);
        QCOMPARE(settings.lastFolder(), QDir::homePath());
        QVERIFY(settings.get(&ui::Setting::windowGeometry).isEmpty() &&
                settings.get(&ui::Setting::windowState).isEmpty());
    }

    void whatIsStoredComesBack()
    {
        {
            ui::Settings settings;
            for (const core::Parameter parameter : ui::storedParameters)
                settings.setValue(parameter, 3);
            settings.set(&ui::Setting::radiusShare, 0.2);
            settings.set(&ui::Setting::lastFolder, m_home.path());
            settings.set(&ui::Setting::windowState, "state");
        }
        const ui::Settings settings;
        for (const core::Parameter parameter : ui::storedParameters)
            QCOMPARE(settings.value(parameter), 3.0);
        QCOMPARE(settings.get(&ui::Setting::radiusShare), 0.2);
        QCOMPARE(settings.lastFolder(), m_home.path());
        QCOMPARE(settings.get(&ui::Setting::windowState), QByteArray("state"));
    }

    void theValuesOfAllToolsComeBack()
    {
        for (const bool shares : {true, false}) {
            {
                ui::BrushSettings brush;
                brush.tools()->setSharesRadius(shares);
                for (const auto& [tool, strength] :
                     {std::pair(core::Tool::Clay, 2.0), std::pair(core::Tool::Smooth, 0.5)}) {
                    brush.setTool(tool);
                    brush.setValue(core::Parameter::Strength, strength);
                    brush.setValue(core::Parameter::Falloff, 8 * strength);
                    brush.setValue(core::Parameter::Spacing, strength / 4);
                    brush.setValue(core::Parameter::Radius, 4 * strength);
                }
                ui::ToolValues pull = brush.tools()->of(core::Tool::Pull);
                pull.airbrush = 25;
                pull.anchored = true;
                brush.tools()->set(core::Tool::Pull, pull);
                ui::Settings settings;
                ui::storeBrush(brush, &settings);
            }
            ui::BrushSettings brush;
            ui::restoreBrush(ui::Settings(), &brush);
            QCOMPARE(brush.tools()->sharesRadius(), shares);
            QCOMPARE(brush.tools()->airbrush(core::Tool::Pull), 25.0);
            QVERIFY(brush.tools()->of(core::Tool::Pull).anchored && !brush.tools()->of(core::Tool::Clay).anchored);
            for (const auto& [tool, strength] :
                 {std::pair(core::Tool::Clay, 2.0), std::pair(core::Tool::Smooth, 0.5)}) {
                brush.setTool(tool);
                QCOMPARE(brush.stroke().strength, strength);
                QCOMPARE(brush.stroke().falloff, static_cast<int>(8 * strength));
                QCOMPARE(brush.stroke().spacing, strength / 4);
                if (!shares)
                    QVERIFY(qFuzzyCompare(brush.stroke().radius, 4 * strength));
            }
            brush.setTool(core::Tool::Crease);
            QCOMPARE(brush.stroke().strength, 1.0);
        }
    }

    /// Settings of older versions have one strength for all tools, which becomes the strength of each tool.
    void whatWasStoredForAllToolsIsReadForEach()
    {
        ui::Settings settings;
        settings.setValue(core::Parameter::Strength, 0.3);
        settings.setValue(core::Parameter::Falloff, 7);
        settings.setValue(core::Parameter::Spacing, 0.5);
        settings.set(&ui::Setting::withoutAirbrush, QStringList(QStringLiteral("clay")));
        ui::BrushSettings brush;
        ui::restoreBrush(settings, &brush);
        for (std::size_t i = 0; i < core::toolNames().size(); ++i) {
            const auto tool = static_cast<core::Tool>(i);
            brush.setTool(tool);
            QVERIFY(brush.stroke().strength == 0.3 && brush.stroke().falloff == 7 && brush.stroke().spacing == 0.5);
            QCOMPARE(brush.tools()->isAirbrush(tool), core::canAirbrush(tool) && tool != core::Tool::Clay);
        }
        QSettings raw;
        raw.setValue(QStringLiteral("tool/clay/strength"), QStringLiteral("much"));
        raw.setValue(QStringLiteral("tool/clay/falloff"), 1);
        raw.setValue(QStringLiteral("tool/clay/radiusShare"), 17);
        raw.sync();
        ui::BrushSettings other;
        ui::restoreBrush(ui::Settings(), &other);
        QCOMPARE(other.tools()->of(core::Tool::Clay).strength, 0.3);
        QVERIFY(core::isFalloff(other.tools()->of(core::Tool::Clay).falloff));
        QVERIFY(!other.tools()->of(core::Tool::Clay).radiusShare);
    }

    void preferencesComeBack()
    {
        QCOMPARE(ui::Settings().get<ui::Preferences>(), ui::Preferences());
        for (const auto& theme : ui::themeChoices)
            for (const auto& language : ui::languages) {
                const ui::Preferences preferences{.theme = theme.value,
                                                  .language = language.value,
                                                  .textSize = ui::TextSize::Large,
                                                  .reducesMotion = true,
                                                  .input = {false, true, false, 2.5},
                                                  .keepsBackups = true};
                ui::Settings().set(preferences);
                QCOMPARE(ui::Settings().get<ui::Preferences>(), preferences);
            }
    }

    void exportsComeBack()
    {
        QCOMPARE(ui::Settings().get<ui::ExportSettings>(), ui::ExportSettings());
        for (const auto& use : ui::exportUses)
            for (const quint64 triangles :
                 {quint64(0), quint64(ui::minExportTriangles), quint64(ui::maxExportTriangles)})
                for (const bool slices : {false, true}) {
                    const ui::ExportSettings choice{use.value, triangles, slices};
                    ui::Settings().set(choice);
                    QCOMPARE(ui::Settings().get<ui::ExportSettings>(), choice);
                }
        QSettings().setValue(QStringLiteral("export/mostTriangles"), 3);
        QSettings().setValue(QStringLiteral("export/use"), QStringLiteral("gcode"));
        QCOMPARE(ui::Settings().get<ui::ExportSettings>(), (ui::ExportSettings{ui::ExportUse::Print, 0, true}));
        ui::Settings().reset();
        QCOMPARE(ui::Settings().get<ui::ExportSettings>(), ui::ExportSettings());
    }

    void keysComeBack()
    {
        ui::Preferences preferences;
        preferences.keys = {
            ui::ShortcutPreset::Blender,
            {{QStringLiteral("tool.pull"), QStringLiteral("Q; Ctrl+,")}, {QStringLiteral("tool.push"), {}}}};
        ui::Settings().set(preferences);
        QCOMPARE(ui::Settings().get<ui::Preferences>(), preferences);
        preferences.keys.custom.remove(QStringLiteral("tool.push"));
        ui::Settings().set(preferences);
        QCOMPARE(ui::Settings().get<ui::Preferences>(), preferences);
    }

    void resettingKeepsWhatAPersonMade()
    {
        ui::Settings settings;
        settings.set(
            ui::ViewAppearance{ui::Material::Wax, ui::Background::Sky, true, true, false, false, false, false, true});
        settings.set(&ui::Setting::historyMegabytes, 99);
        settings.set(&ui::Setting::radiusShare, 0.3);
        settings.set(&ui::Setting::windowState, "state");
        settings.addRecentFile(QStringLiteral("/a.stl"));
        settings.set(&ui::Setting::lastFolder, m_home.path());
        settings.set(&ui::Setting::swatches, {{1, 2, 3}});
        int told = 0;
        settings.onReset([&] { told += settings.get<ui::ViewAppearance>() == ui::ViewAppearance() ? 1 : 100; });
        settings.reset();
        QCOMPARE(told, 1);
        QCOMPARE(settings.get<ui::ViewAppearance>(), ui::ViewAppearance());
        QCOMPARE(settings.get(&ui::Setting::historyMegabytes), ui::defaultHistoryMegabytes);
        QVERIFY(settings.get(&ui::Setting::radiusShare) != 0.3 && settings.get(&ui::Setting::windowState).isEmpty());
        QCOMPARE(settings.recentFiles(), QStringList{QStringLiteral("/a.stl")});
        QCOMPARE(settings.lastFolder(), m_home.path());
        QCOMPARE(settings.get(&ui::Setting::swatches), (QList<core::Rgb>{{1, 2, 3}}));
    }

    void theAppearanceComesBack()
    {
        QCOMPARE(ui::Settings().get<ui::ViewAppearance>(), ui::ViewAppearance());
        for (const auto& material : ui::materials)
            for (const auto& background : ui::backgrounds) {
                const ui::ViewAppearance appearance{
                    material.value, background.value, true, true, false, false, false, false, true};
                ui::Settings().set(appearance);
                QCOMPARE(ui::Settings().get<ui::ViewAppearance>(), appearance);
            }
    }

    void swatchesComeBackWithoutTheBrokenOnes()
    {
        QVERIFY(!ui::Settings().get(&ui::Setting::swatches).isEmpty());
        ui::Settings().set(&ui::Setting::swatches, {{1, 2, 3}, {255, 254, 253}});
        QCOMPARE(ui::Settings().get(&ui::Setting::swatches), (QList<core::Rgb>{{1, 2, 3}, {255, 254, 253}}));
        QSettings().setValue(QStringLiteral("color/swatches"),
                             QStringList{QStringLiteral("loud"), QStringLiteral("#040506")});
        QCOMPARE(ui::Settings().get(&ui::Setting::swatches), (QList<core::Rgb>{{4, 5, 6}}));
        ui::Settings().set(&ui::Setting::swatches, {});
        QVERIFY(ui::Settings().get(&ui::Setting::swatches).isEmpty());
    }

    void brokenEntriesGiveDefaults_data()
    {
        QTest::addColumn<QVariant>("stored");
        QTest::newRow("word") << QVariant(QStringLiteral("loud"));
        QTest::newRow("nan") << QVariant(QStringLiteral("nan"));
        QTest::newRow("huge") << QVariant(1e300);
        QTest::newRow("negative") << QVariant(-1);
        QTest::newRow("list") << QVariant(QStringList{QStringLiteral("1"), QStringLiteral("2")});
    }

    void brokenEntriesGiveDefaults()
    {
        QFETCH(QVariant, stored);
        QSettings raw;
        for (const char* key :
             {"brush/strength", "brush/falloff", "brush/radiusShare", "files/lastFolder", "window/geometry",
              "view/material", "view/background", "preferences/theme", "preferences/language",
              "preferences/altMovesView", "preferences/keepsVersions", "preferences/textSize", "preferences/calm",
              "keys/preset", "view/ground", "view/wireframe"})
            raw.setValue(QLatin1StringView(key), stored);
        raw.sync();
        const ui::Settings settings;
        for (const core::Parameter parameter : {core::Parameter::Strength, core::Parameter::Falloff})
            QCOMPARE(settings.value(parameter), core::info(parameter).defaultValue);
        QVERIFY(settings.get(&ui::Setting::radiusShare) <= ui::maxRadiusShare &&
                settings.get(&ui::Setting::radiusShare) >= ui::minRadiusShare);
        QCOMPARE(settings.lastFolder(), QDir::homePath());
        QCOMPARE(settings.get<ui::ViewAppearance>(), ui::ViewAppearance());
        QCOMPARE(settings.get<ui::Preferences>(), ui::Preferences());
    }

    void aFolderThatIsGoneIsForgotten()
    {
        ui::Settings settings;
        settings.set(&ui::Setting::lastFolder, m_home.filePath(QStringLiteral("gone")));
        QCOMPARE(settings.lastFolder(), QDir::homePath());
    }

private:
    QTemporaryDir m_home;
};

FETTLE_TEST(TestSettings, QCoreApplication)
#include "tst_settings.moc"
