#include "ui/widgets/theme.h"

#include "ui/widgets/themed_icon.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QCheckBox>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusVariant>
#include <QDBusVirtualObject>
#include <QPainter>
#include <QProcess>
#include <QPushButton>
#include <QRadioButton>
#include <QStyleOptionButton>
#include <QTabBar>
#include <QToolBar>
#include <QToolButton>

#include <cmath>

using ui::SystemColorScheme;
using ui::ThemeChoice;

namespace
{
/// A fake desktop portal that reports a preferred colour scheme over D-Bus.
class Portal : public QDBusVirtualObject
{
public:
    explicit Portal(const QString& address) : m_bus(QDBusConnection::connectToBus(address, QStringLiteral("portal")))
    {
        m_bus.registerVirtualObject(QStringLiteral("/org/freedesktop/portal/desktop"), this);
        m_bus.registerService(QStringLiteral("org.freedesktop.portal.Desktop"));
    }

    QString introspect(const QString&) const override { return {}; }

    bool handleMessage(const QDBusMessage& message, const QDBusConnection& bus) override
    {
        if (message.member() != QLatin1StringView("Read"))
            return false;
        const QVariant inner = QVariant::fromValue(QDBusVariant(scheme));
        return bus.send(message.createReply(QVariant::fromValue(QDBusVariant(inner))));
    }

    void tell(const QVariant& value)
    {
        scheme = value;
        QDBusMessage signal = QDBusMessage::createSignal(QStringLiteral("/org/freedesktop/portal/desktop"),
                                                         QStringLiteral("org.freedesktop.portal.Settings"),
                                                         QStringLiteral("SettingChanged"));
        signal << QStringLiteral("org.freedesktop.appearance") << QStringLiteral("color-scheme")
               << QVariant::fromValue(QDBusVariant(value));
        m_bus.send(signal);
    }

    QVariant scheme = 1U;

private:
    QDBusConnection m_bus;
};

/// A private session bus for the test. Must exist before the application, which may connect to the session bus at once.
class Bus
{
public:
    Bus()
    {
        m_daemon.start(QStringLiteral("dbus-daemon"),
                       {QStringLiteral("--session"), QStringLiteral("--nofork"), QStringLiteral("--print-address")});
        QByteArray address;
        if (m_daemon.waitForStarted() && m_daemon.waitForReadyRead())
            address = m_daemon.readLine().trimmed();
        qputenv(addressVariable, address);
    }
    ~Bus()
    {
        m_daemon.kill();
        m_daemon.waitForFinished();
    }

    static QString address() { return qEnvironmentVariable(addressVariable); }

private:
    static constexpr const char* addressVariable = "DBUS_SESSION_BUS_ADDRESS";

    QProcess m_daemon;
};

double luminance(const QColor& color)
{
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

/// Returns the contrast ratio of WCAG, 1 to 21.
double contrast(const QColor& a, const QColor& b)
{
    const double la = luminance(a), lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

bool applicationIsDark()
{
    return QApplication::palette().window().color().lightness() < 128;
}
} // namespace

class TestTheme : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aToolThatIsOnIsMarked()
    {
        for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
            const ui::Theme theme(choice);
            QToolButton tool;
            tool.setAutoRaise(true);
            tool.setCheckable(true);
            tool.resize(32, 32);
            const auto blueness = [&] {
                const QColor inside = tool.grab().toImage().pixelColor(6, 6);
                return inside.blue() - inside.red();
            };
            const int off = blueness();
            tool.setChecked(true);
            QVERIFY(blueness() > off + 15);
        }
    }

    void anIconOfASelectedRowHasTheColourOfItsText()
    {
        for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
            const ui::Theme theme(choice);
            const QIcon icon = ui::themedIcon(QStringLiteral("part-locked"));
            const auto inkOf = [&icon](QIcon::Mode mode) {
                const QImage image = icon.pixmap(QSize(48, 48), 1.0, mode).toImage();
                QColor ink;
                for (int i = 0; i < 48 * 48; ++i)
                    if (const QColor pixel = image.pixelColor(i % 48, i / 48); pixel.alpha() == 255)
                        ink = pixel;
                return ink;
            };
            QCOMPARE(inkOf(QIcon::Selected), QApplication::palette().color(QPalette::HighlightedText));
            QCOMPARE(inkOf(QIcon::Normal), QApplication::palette().color(QPalette::ButtonText));
        }
    }

    void theChosenTabIsMarked()
    {
        for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
            const ui::Theme theme(choice);
            QTabBar tabs;
            tabs.addTab(QStringLiteral("one"));
            tabs.addTab(QStringLiteral("two"));
            tabs.resize(tabs.sizeHint());
            tabs.setCurrentIndex(1);
            const QImage image = tabs.grab().toImage();
            const auto marked = [&](int tab) {
                const QRect rect = tabs.tabRect(tab);
                int count = 0;
                for (int y = rect.top(); y <= rect.bottom(); ++y)
                    for (int x = rect.left(); x <= rect.right(); ++x)
                        count += image.pixelColor(x, y) == tabs.palette().color(QPalette::Highlight);
                return count;
            };
            QVERIFY(marked(1) >= tabs.tabRect(1).width());
            QCOMPARE(marked(0), 0);
        }
    }

    /// Check boxes and radio buttons have visible outlines, focused or not.
    void boxesHaveOutlines_data()
    {
        QTest::addColumn<bool>("isRadio");
        QTest::addColumn<bool>("isFocused");
        QTest::newRow("to tick") << false << false;
        QTest::newRow("to tick, clicked") << false << true;
        QTest::newRow("to choose") << true << false;
        QTest::newRow("to choose, clicked") << true << true;
    }

    void boxesHaveOutlines()
    {
        QFETCH(bool, isRadio);
        QFETCH(bool, isFocused);
        for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
            const ui::Theme theme(choice);
            const std::unique_ptr<QAbstractButton> box(isRadio ? static_cast<QAbstractButton*>(new QRadioButton)
                                                               : new QCheckBox);
            QStyleOptionButton option;
            option.initFrom(box.get());
            option.state =
                QStyle::State_Enabled | QStyle::State_Off | (isFocused ? QStyle::State_HasFocus : QStyle::State_None);
            option.rect = QRect(0, 0, 14, 14);
            QImage image(option.rect.size(), QImage::Format_RGB32);
            image.fill(option.palette.color(QPalette::Window));
            QPainter painter(&image);
            box->style()->drawPrimitive(isRadio ? QStyle::PE_IndicatorRadioButton : QStyle::PE_IndicatorCheckBox,
                                        &option, &painter, box.get());
            painter.end();
            double most = 0; // largest contrast of the edge's pixels along the middle row
            for (int x = 0; x < 3; ++x)
                most = std::max(most, contrast(image.pixelColor(x, 7), option.palette.color(QPalette::Window)));
            QVERIFY2(most > 1.5, qPrintable(QString::number(most)));
        }
    }

    void wordsKeepAwayFromTheFrame()
    {
        const ui::Theme theme(ThemeChoice::Light);
        const QPushButton button(QStringLiteral("Set all of it back to the defaults"));
        QVERIFY(button.sizeHint().width() >= button.fontMetrics().horizontalAdvance(button.text()) + 24);
    }

    void everythingCanBeRead()
    {
        for (const QPalette& palette : {ui::lightPalette(), ui::darkPalette()}) {
            QVERIFY(contrast(palette.windowText().color(), palette.window().color()) > 7);
            QVERIFY(contrast(palette.text().color(), palette.base().color()) > 7);
            QVERIFY(contrast(palette.text().color(), palette.alternateBase().color()) > 7);
            QVERIFY(contrast(palette.buttonText().color(), palette.button().color()) > 7);
            QVERIFY(contrast(palette.toolTipText().color(), palette.toolTipBase().color()) > 7);
            QVERIFY(contrast(palette.highlightedText().color(), palette.highlight().color()) > 4.5);
            QVERIFY(contrast(palette.placeholderText().color(), palette.base().color()) > 4.5);
            QVERIFY(contrast(palette.placeholderText().color(), palette.window().color()) > 4.5);
            QVERIFY(contrast(palette.link().color(), palette.window().color()) > 4.5);
            QVERIFY(contrast(palette.link().color(), palette.base().color()) > 4.5);
            QVERIFY(contrast(palette.color(QPalette::Disabled, QPalette::WindowText), palette.window().color()) > 2.5);
        }
    }

    /// The button that opens the hidden part of a tool bar is visible.
    void theArrowOfMoreCanBeSeen()
    {
        for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
            const ui::Theme theme(choice);
            QToolBar bar;
            for (int i = 0; i < 9; ++i)
                bar.addAction(QStringLiteral("A command"));
            bar.resize(200, bar.sizeHint().height());
            bar.show();
            auto* more = bar.findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
            QTRY_VERIFY(more && more->isVisible());
            const QImage image = more->grab().toImage();
            double most = 1;
            for (int y = 2; y < image.height() - 2; ++y)
                for (int x = 2; x < image.width() - 2; ++x)
                    most = std::max(most, contrast(image.pixelColor(x, y), bar.palette().window().color()));
            QVERIFY2(most > 4.5, qPrintable(QString::number(most)));
        }
    }

    void theChoiceHolds()
    {
        ui::Theme theme(ThemeChoice::Dark);
        QVERIFY(theme.isDark() && applicationIsDark());
        theme.choose(ThemeChoice::Light);
        QVERIFY(!theme.isDark() && !applicationIsDark());
    }

    void theSystemIsFollowed()
    {
        QVERIFY2(!Bus::address().isEmpty(), "dbus-daemon is not installed");
        Portal portal(Bus::address());
        ui::Theme theme(ThemeChoice::System);
        QTRY_VERIFY(theme.isDark() && applicationIsDark());
        portal.tell(2U);
        QTRY_VERIFY(!theme.isDark() && !applicationIsDark());
        portal.tell(1U);
        QTRY_VERIFY(applicationIsDark());
        theme.choose(ThemeChoice::Light);
        QVERIFY(!applicationIsDark());
        portal.tell(2U);
        portal.tell(1U);
        QTest::qWait(50);
        QVERIFY(!applicationIsDark());
        theme.choose(ThemeChoice::System);
        QVERIFY(applicationIsDark());
    }

    void nonsenseIsNoPreference_data()
    {
        QTest::addColumn<QVariant>("value");
        QTest::newRow("none") << QVariant(0U);
        QTest::newRow("unknown") << QVariant(77U);
        QTest::newRow("word") << QVariant(QStringLiteral("dark"));
        QTest::newRow("list") << QVariant(QStringList{QStringLiteral("1")});
    }

    void nonsenseIsNoPreference()
    {
        QVERIFY2(!Bus::address().isEmpty(), "dbus-daemon is not installed");
        QFETCH(QVariant, value);
        Portal portal(Bus::address());
        const SystemColorScheme system;
        QTRY_COMPARE(system.scheme(), SystemColorScheme::Scheme::Dark);
        portal.tell(value);
        QTRY_COMPARE(system.scheme(), SystemColorScheme::Scheme::Unknown);
    }
};

static int themeMain(int argc, char* argv[])
{
    const Bus bus;
    return test::run<TestTheme, ui::TestApplication>(argc, argv);
}

FETTLE_TEST_MAIN(TestTheme, themeMain)
#include "tst_theme.moc"
