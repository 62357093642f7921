#include "ui/actions/actions.h"
#include "ui/preferences/preferences_dialog.h"
#include "ui/preferences/pressure_curve.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QCheckBox>
#include <QComboBox>
#include <QMainWindow>
#include <QMessageBox>
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
                const PreferencesDialog dialog({.theme = theme.value, .language = language.value, .input = {}},
                                               m_actions, nullptr);
                QCOMPARE(child<QComboBox>(dialog, "theme")->currentData().toInt(), static_cast<int>(theme.value));
                QCOMPARE(child<QComboBox>(dialog, "language")->currentData().toInt(), static_cast<int>(language.value));
            }
    }

    void choicesAreMadeByKeys()
    {
        PreferencesDialog dialog({}, m_actions, nullptr);
        dialog.show();
        QSignalSpy changed(&dialog, &PreferencesDialog::changed);
        QTest::keyClick(child<QComboBox>(dialog, "theme"), Qt::Key_Down);
        QTest::keyClick(child<QComboBox>(dialog, "language"), Qt::Key_End);
        QTest::keyClick(child<QComboBox>(dialog, "textSize"), Qt::Key_Down);
        QTest::keyClick(child<QCheckBox>(dialog, "calm"), Qt::Key_Space);
        QCOMPARE(changed.count(), 4);
        QCOMPARE(dialog.preferences().theme, ui::ThemeChoice::Light);
        QCOMPARE(dialog.preferences().language, ui::Language::Chinese);
        QVERIFY(dialog.preferences().textSize == ui::TextSize::Larger && dialog.preferences().reducesMotion);
    }

    void habitsAreSwitched()
    {
        PreferencesDialog dialog({}, m_actions, nullptr);
        for (const char* name : {"pressureToStrength", "pressureToRadius", "altMovesView"})
            QTest::keyClick(child<QCheckBox>(dialog, name), Qt::Key_Space);
        QCOMPARE(dialog.preferences().input, (ui::InputPreferences{false, true, false}));
    }

    void earlierVersionsAreAskedFor()
    {
        PreferencesDialog dialog({}, m_actions, nullptr);
        QVERIFY(!dialog.preferences().keepsBackups);
        QTest::keyClick(child<QCheckBox>(dialog, "keepsVersions"), Qt::Key_Space);
        QVERIFY(dialog.preferences().keepsBackups);
        dialog.setPreferences({});
        QVERIFY(!child<QCheckBox>(dialog, "keepsVersions")->isChecked());
    }

    void thePensCurveIsBent()
    {
        PreferencesDialog dialog({}, m_actions, nullptr);
        auto* curve = child<ui::PressureCurve>(dialog, "penCurve");
        QTest::keyClick(curve, Qt::Key_Up);
        QVERIFY(dialog.preferences().input.penExponent < 1);
        QCOMPARE(dialog.preferences().input.penExponent, curve->exponent());
        dialog.setPreferences({});
        QCOMPARE(curve->exponent(), 1);
    }

    void keysAreChanged()
    {
        PreferencesDialog dialog({}, m_actions, nullptr);
        QTest::keyClick(child<QComboBox>(dialog, "keyPreset"), Qt::Key_End);
        QCOMPARE(dialog.preferences().keys.preset, ui::ShortcutPreset::ZBrush);
        QCOMPARE(dialog.preferences().effectiveInput().modifiers, ui::mouseModifiers(ui::ShortcutPreset::ZBrush));
    }

    void resettingIsAskedAbout()
    {
        const Preferences all{
            .theme = ui::ThemeChoice::Dark, .language = ui::Language::German, .input = {false, true, false}};
        PreferencesDialog dialog(all, m_actions, nullptr);
        dialog.show();
        const QSignalSpy changed(&dialog, &PreferencesDialog::changed),
            requested(&dialog, &PreferencesDialog::resetRequested);
        const auto answer = [&dialog](QMessageBox::ButtonRole role) {
            child<QPushButton>(dialog, "reset")->click();
            auto* question = child<QMessageBox>(dialog, "resetQuestion");
            for (QAbstractButton* button : question->buttons())
                if (question->buttonRole(button) == role)
                    button->click();
            QTRY_VERIFY(!dialog.findChild<QMessageBox*>());
        };
        answer(QMessageBox::RejectRole);
        QCOMPARE(requested.count(), 0);
        answer(QMessageBox::AcceptRole);
        QCOMPARE(requested.count(), 1);
        dialog.setPreferences({});
        QCOMPARE(dialog.preferences(), Preferences());
        QCOMPARE(child<QComboBox>(dialog, "theme")->currentIndex(), 0);
        QCOMPARE(changed.count(), 0);
    }

    void everyControlHasANameAndATip()
    {
        const PreferencesDialog dialog({}, m_actions, nullptr);
        const auto* pages = child<QTabWidget>(dialog, "pages");
        int controls = 0;
        for (const QWidget* widget : pages->findChildren<QWidget*>()) {
            const bool isQts = widget->objectName().startsWith(QLatin1StringView("qt_")) ||
                               qobject_cast<QTabBar*>(widget->parentWidget());
            if (widget->focusPolicy() == Qt::NoFocus || widget->objectName().isEmpty() || isQts)
                continue;
            ++controls;
            QVERIFY2(!widget->accessibleName().isEmpty(), qPrintable(widget->objectName()));
            QVERIFY2(widget->toolTip().endsWith(u'.'), qPrintable(widget->objectName()));
        }
        QVERIFY(controls >= 12);
    }

private:
    QMainWindow m_window;
    ui::Actions m_actions{&m_window};

    template <class Widget> static Widget* child(const PreferencesDialog& dialog, const char* name)
    {
        auto* found = dialog.findChild<Widget*>(QLatin1StringView(name));
        Q_ASSERT(found);
        return found;
    }
};

FETTLE_TEST(TestPreferencesDialog, ui::TestApplication)
#include "tst_preferences_dialog.moc"
