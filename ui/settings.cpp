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
const QString strengthKey = QStringLiteral("brush/strength");
const QString radiusShareKey = QStringLiteral("brush/radiusShare");

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

double Settings::strength() const
{
    const core::ParameterInfo& row = core::info(core::Parameter::Strength);
    return number(m_settings, strengthKey, row.min, row.max, row.defaultValue);
}

void Settings::setStrength(double strength)
{
    m_settings.setValue(strengthKey, strength);
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
