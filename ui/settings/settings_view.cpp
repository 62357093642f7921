// How the model is shown, and what stands beside it.

#include "ui/settings/settings.h"

#include "ui/settings/stored_values.h"
#include "ui/util/color_convert.h"

namespace ui
{
namespace
{
const QString drawnSidesKey = QStringLiteral("drawing/sides");
const QString drawnShadedKey = QStringLiteral("drawing/shaded");
const QString drawnDimensionsKey = QStringLiteral("drawing/dimensions");
const QString materialKey = QStringLiteral("view/material");
const QString backgroundKey = QStringLiteral("view/background");
const QString showsReferencesKey = QStringLiteral("view/references");

/// Clay, earth, slip, white, grey, black, and what children paint with.
const QList<core::Rgb> firstSwatches = {{200, 110, 80},  {138, 90, 60},  {242, 227, 204}, {255, 255, 255},
                                        {128, 128, 128}, {32, 32, 32},   {216, 58, 52},   {240, 180, 41},
                                        {76, 154, 74},   {47, 111, 181}, {122, 79, 160}};

struct AppearanceSwitch
{
    QString key;
    bool ViewAppearance::*what;
};
const AppearanceSwitch appearanceSwitches[] = {{QStringLiteral("view/wireframe"), &ViewAppearance::wireframe},
                                               {QStringLiteral("view/flat"), &ViewAppearance::flat},
                                               {QStringLiteral("view/ground"), &ViewAppearance::ground},
                                               {QStringLiteral("view/scaleBar"), &ViewAppearance::scaleBar},
                                               {QStringLiteral("view/caption"), &ViewAppearance::caption}};
} // namespace

ViewAppearance Settings::appearance() const
{
    ViewAppearance appearance;
    appearance.material = stored::choice(m_settings, materialKey, materials, appearance.material);
    appearance.background = stored::choice(m_settings, backgroundKey, backgrounds, appearance.background);
    for (const AppearanceSwitch& row : appearanceSwitches)
        appearance.*row.what = stored::yesNo(m_settings, row.key, appearance.*row.what);
    return appearance;
}

void Settings::setAppearance(const ViewAppearance& appearance)
{
    m_settings.setValue(materialKey, stored::wordFor(appearance.material, materials));
    m_settings.setValue(backgroundKey, stored::wordFor(appearance.background, backgrounds));
    for (const AppearanceSwitch& row : appearanceSwitches)
        m_settings.setValue(row.key, appearance.*row.what);
}

DrawingSettings Settings::drawing() const
{
    const double sides = stored::number(m_settings, drawnSidesKey, 0, static_cast<int>(DrawnSides::Top), 0);
    return {static_cast<DrawnSides>(static_cast<int>(sides)), m_settings.value(drawnShadedKey, false).toBool(),
            m_settings.value(drawnDimensionsKey, true).toBool()};
}

void Settings::setDrawing(const DrawingSettings& options)
{
    m_settings.setValue(drawnSidesKey, static_cast<int>(options.sides));
    m_settings.setValue(drawnShadedKey, options.shaded);
    m_settings.setValue(drawnDimensionsKey, options.dimensions);
}

QList<core::Rgb> Settings::swatches() const
{
    if (!m_settings.contains(stored::swatchesKey))
        return firstSwatches;
    QList<core::Rgb> swatches;
    for (const QString& name : m_settings.value(stored::swatchesKey).toStringList())
        if (const QColor color(name); color.isValid())
            swatches << toRgb(color);
    return swatches;
}

void Settings::setSwatches(const QList<core::Rgb>& swatches)
{
    QStringList names;
    for (const core::Rgb& color : swatches)
        names << toQt(color).name();
    m_settings.setValue(stored::swatchesKey, names);
}

StoredReference Settings::reference(ViewSide side) const
{
    const QString key = stored::referenceKeys + stored::wordFor(side, viewSides) + u'/';
    const ReferencePlacement defaults;
    StoredReference stored;
    stored.path = m_settings.value(key + QStringLiteral("path")).toString();
    stored.placement = {
        stored::number(m_settings, key + QStringLiteral("width"), minReferenceWidth, maxReferenceWidth, defaults.width),
        stored::number(m_settings, key + QStringLiteral("x"), -maxReferenceOffset, maxReferenceOffset, defaults.x),
        stored::number(m_settings, key + QStringLiteral("y"), -maxReferenceOffset, maxReferenceOffset, defaults.y),
        stored::number(m_settings, key + QStringLiteral("opacity"), minReferenceOpacity, 1, defaults.opacity),
        stored::yesNo(m_settings, key + QStringLiteral("inFront"), defaults.inFront)};
    return stored;
}

void Settings::setReference(ViewSide side, const StoredReference& reference)
{
    const QString key = stored::referenceKeys + stored::wordFor(side, viewSides);
    m_settings.remove(key);
    if (reference.path.isEmpty())
        return;
    m_settings.setValue(key + QStringLiteral("/path"), reference.path);
    m_settings.setValue(key + QStringLiteral("/width"), reference.placement.width);
    m_settings.setValue(key + QStringLiteral("/x"), reference.placement.x);
    m_settings.setValue(key + QStringLiteral("/y"), reference.placement.y);
    m_settings.setValue(key + QStringLiteral("/opacity"), reference.placement.opacity);
    m_settings.setValue(key + QStringLiteral("/inFront"), reference.placement.inFront);
}

bool Settings::showsReferences() const
{
    return stored::yesNo(m_settings, showsReferencesKey, true);
}

void Settings::setShowsReferences(bool shows)
{
    m_settings.setValue(showsReferencesKey, shows);
}
} // namespace ui
