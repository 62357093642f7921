#include "settings.h"

#include <QDir>

#include <cmath>

namespace ui
{
namespace
{
constexpr double defaultRadiusShare = 0.1;

// The key is what this version understands; a later one that stores something else takes another key.
const QString geometryKey = QStringLiteral("window/geometry");
const QString stateKey = QStringLiteral("window/state");
const QString folderKey = QStringLiteral("files/lastFolder");
const QString radiusShareKey = QStringLiteral("brush/radiusShare");

QString keyOf(core::Parameter parameter)
{
    const std::string_view key = core::info(parameter).key;
    return QStringLiteral("brush/") + QLatin1StringView(key.data(), static_cast<qsizetype>(key.size()));
}

double defaultOf(core::Parameter parameter)
{
    return parameter == core::Parameter::Spacing ? handSpacing : core::info(parameter).defaultValue;
}

/// The default where nothing, or nothing sensible, is stored.
double number(const QSettings& settings, const QString& key, double least, double most, double otherwise)
{
    bool ok = false;
    const double stored = settings.value(key).toDouble(&ok);
    return ok && std::isfinite(stored) && stored >= least && stored <= most ? stored : otherwise;
}
} // namespace

QByteArray Settings::windowGeometry() const
{
    return m_settings.value(geometryKey).toByteArray();
}

void Settings::setWindowGeometry(const QByteArray& geometry)
{
    m_settings.setValue(geometryKey, geometry);
}

QByteArray Settings::windowState() const
{
    return m_settings.value(stateKey).toByteArray();
}

void Settings::setWindowState(const QByteArray& state)
{
    m_settings.setValue(stateKey, state);
}

QString Settings::lastFolder() const
{
    const QString folder = m_settings.value(folderKey).toString();
    return !folder.isEmpty() && QDir(folder).exists() ? folder : QDir::homePath();
}

void Settings::setLastFolder(const QString& folder)
{
    m_settings.setValue(folderKey, folder);
}

double Settings::value(core::Parameter parameter) const
{
    const core::ParameterInfo& row = core::info(parameter);
    return number(m_settings, keyOf(parameter), row.min, row.max, defaultOf(parameter));
}

void Settings::setValue(core::Parameter parameter, double value)
{
    m_settings.setValue(keyOf(parameter), value);
}

double Settings::radiusShare() const
{
    return number(m_settings, radiusShareKey, minRadiusShare, maxRadiusShare, defaultRadiusShare);
}

void Settings::setRadiusShare(double share)
{
    m_settings.setValue(radiusShareKey, share);
}
} // namespace ui
