#include "ui/widgets/portal_color_scheme_posix.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QDBusVariant>

#include <utility>

namespace ui
{
namespace
{
const QString service = QStringLiteral("org.freedesktop.portal.Desktop");
const QString path = QStringLiteral("/org/freedesktop/portal/desktop");
const QString interface = QStringLiteral("org.freedesktop.portal.Settings");
const QString appearance = QStringLiteral("org.freedesktop.appearance");
const QString colorScheme = QStringLiteral("color-scheme");

/// Values of color-scheme in the portal; 0 means no preference.
constexpr uint preferDark = 1, preferLight = 2;

/// Returns the value inside nested variants: the portal's Read wraps its answer in two.
QVariant unwrapped(QVariant value)
{
    while (value.userType() == qMetaTypeId<QDBusVariant>())
        value = value.value<QDBusVariant>().variant();
    return value;
}
} // namespace

std::unique_ptr<QObject> watchColorScheme(std::function<void(SystemColorScheme::Scheme)> report)
{
    return std::make_unique<PortalColorScheme>(std::move(report));
}

PortalColorScheme::PortalColorScheme(Report report) : m_report(std::move(report))
{
    QDBusConnection bus = QDBusConnection::sessionBus();
    if (!bus.isConnected())
        return;
    qRegisterMetaType<QDBusVariant>(); // otherwise the slot below is not found
    bus.connect(service, path, interface, QStringLiteral("SettingChanged"), this,
                SLOT(settingChanged(QString, QString, QDBusVariant)));
    QDBusMessage question = QDBusMessage::createMethodCall(service, path, interface, QStringLiteral("Read"));
    question << appearance << colorScheme;
    connect(new QDBusPendingCallWatcher(bus.asyncCall(question), this), &QDBusPendingCallWatcher::finished, this,
            &PortalColorScheme::answered);
}

void PortalColorScheme::answered(QDBusPendingCallWatcher* call)
{
    const QDBusPendingReply<QDBusVariant> reply = *call;
    if (reply.isValid())
        set(reply.value().variant());
    call->deleteLater();
}

void PortalColorScheme::settingChanged(const QString& group, const QString& key, const QDBusVariant& value)
{
    if (group == appearance && key == colorScheme)
        set(value.variant());
}

void PortalColorScheme::set(const QVariant& value)
{
    bool ok = false;
    const uint number = unwrapped(value).toUInt(&ok);
    m_report(ok && number == preferDark    ? SystemColorScheme::Scheme::Dark
             : ok && number == preferLight ? SystemColorScheme::Scheme::Light
                                           : SystemColorScheme::Scheme::Unknown);
}
} // namespace ui
