#include "ui/widgets/system_color_scheme.h"

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

SystemColorScheme::SystemColorScheme(QObject* parent) : QObject(parent)
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
            &SystemColorScheme::answered);
}

void SystemColorScheme::answered(QDBusPendingCallWatcher* call)
{
    const QDBusPendingReply<QDBusVariant> reply = *call;
    if (reply.isValid())
        set(reply.value().variant());
    call->deleteLater();
}

void SystemColorScheme::settingChanged(const QString& group, const QString& key, const QDBusVariant& value)
{
    if (group == appearance && key == colorScheme)
        set(value.variant());
}

void SystemColorScheme::set(const QVariant& value)
{
    bool ok = false;
    const uint number = unwrapped(value).toUInt(&ok);
    const Scheme scheme = ok && number == preferDark    ? Scheme::Dark
                          : ok && number == preferLight ? Scheme::Light
                                                        : Scheme::Unknown;
    if (std::exchange(m_scheme, scheme) != scheme)
        Q_EMIT changed();
}
} // namespace ui
