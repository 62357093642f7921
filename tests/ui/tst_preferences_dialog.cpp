#include "ui/preferences_dialog.h"

#include "ui_test.h"

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>

using ui::Preferences;
using ui::PreferencesDialog;

class TestPreferencesDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsWhatHolds()
    {
        for (const auto& theme : ui::themeChoices)
            for (const auto& language : ui::languages) {
                const PreferencesDialog dialog({.theme = theme.value, .language = language.value, .hand = {}}, nullptr);
                QCOMPARE(child<QComboBox>(dialog, "theme")->currentData().toInt(), static_cast<int>(theme.value));
                QCOMPARE(child<QComboBox>(dialog, "language")->currentData().toInt(), static_cast<int>(language.value));
            }
    }

    void choicesAreMadeByKeys()
    {
        PreferencesDialog dialog({}, nullptr);
        dialog.show();
        QSignalSpy changed(&dialog, &PreferencesDialog::changed);
        QTest::keyClick(child<QComboBox>(dialog, "theme"), Qt::Key_Down);
        QTest::keyClick(child<QComboBox>(dialog, "language"), Qt::Key_End);
        QCOMPARE(changed.count(), 2);
        QCOMPARE(dialog.preferences().theme, ui::ThemeChoice::Light);
        QCOMPARE(dialog.preferences().language, ui::Language::Chinese);
    }

    void habitsAreSwitched()
    {
        PreferencesDialog dialog({}, nullptr);
        for (const char* name : {"pressureToStrength", "pressureToRadius", "altMovesView"})
            QTest::keyClick(child<QCheckBox>(dialog, name), Qt::Key_Space);
        QCOMPARE(dialog.preferences().hand, (ui::HandHabits{false, true, false}));
    }

    void resettingGivesTheDefaults()
    {
        PreferencesDialog dialog({.theme = ui::ThemeChoice::Dark, .language = ui::Language::German, .hand = {false, true, false}}, nullptr);
        QSignalSpy changed(&dialog, &PreferencesDialog::changed);
        child<QPushButton>(dialog, "reset")->click();
        QCOMPARE(changed.count(), 1);
        QCOMPARE(dialog.preferences(), Preferences());
        QCOMPARE(child<QComboBox>(dialog, "theme")->currentIndex(), 0);
        child<QPushButton>(dialog, "reset")->click();
        QCOMPARE(changed.count(), 1);
    }

    void everyControlHasANameAndATip()
    {
        const PreferencesDialog dialog({}, nullptr);
        const auto* pages = child<QTabWidget>(dialog, "pages");
        int controls = 0;
        for (const QWidget* widget : pages->findChildren<QWidget*>()) {
            const bool isQts = widget->objectName().startsWith(QLatin1StringView("qt_")) || qobject_cast<QTabBar*>(widget->parentWidget());
            if (widget->focusPolicy() == Qt::NoFocus || widget->objectName().isEmpty() || isQts)
                continue;
            ++controls;
            QVERIFY2(!widget->accessibleName().isEmpty(), qPrintable(widget->objectName()));
            QVERIFY2(widget->toolTip().endsWith(u'.'), qPrintable(widget->objectName()));
        }
        QVERIFY(controls >= 5);
    }

private:
    template <class Widget> static Widget* child(const PreferencesDialog& dialog, const char* name)
    {
        auto* found = dialog.findChild<Widget*>(QLatin1StringView(name));
        Q_ASSERT(found);
        return found;
    }
};

UI_TEST_MAIN(TestPreferencesDialog)
#include "tst_preferences_dialog.moc"
