#pragma once

#include "vr/panels/panel_layout.h"

#include <initializer_list>
#include <vector>

namespace vr
{
/// One of several, of which one is chosen.
struct PanelChoice
{
    QString text;
    QString icon;
    PanelAction action;
    bool isChosen = false;
};

struct SliderRow
{
    QString name;
    QString value; ///< as text
    SliderLook look;
    Slide slide;
};

struct PanelButton
{
    ButtonLook look;
    PanelAction action;
    bool isEnabled = true;
    bool mustHold = false;
};

struct PanelTitle
{
    QString text;
    QString note{};
    double textWidth = 0; ///< of the text if there is a note
};

/// Puts a panel together row by row, from the top. All rows are as wide as the panel but for its margins.
class PanelBuilder
{
public:
    explicit PanelBuilder(PanelKind kind, double width, double distance);

    /// The panel ends below its last row.
    PanelLayout finished() const;

    QRectF nextRow(double height);
    void skip(double height) { m_y += height; }
    double innerWidth() const;

    void add(const QRectF& area, const TextLook& look) { m_layout.items.push_back({area, look, {}, true, false}); }
    void add(const QRectF& area, const WellLook& look) { m_layout.items.push_back({area, look, {}, true, false}); }
    void add(const QRectF& area, const PanelButton& button);
    void add(const PanelItem& item) { m_layout.items.push_back(item); }

    /// A note at its right, and after that buttons with icons.
    void addTitle(const PanelTitle& title, const std::vector<PanelButton>& buttons = {});
    /// A name, and after `nameWidth` what may be chosen; without a name, all the row.
    void addChoice(const QString& name, double nameWidth, const std::vector<PanelChoice>& choices);
    void addChoice(const QRectF& row, const std::vector<PanelChoice>& choices);
    /// A name, and after `nameWidth` the switch.
    void addSwitch(const QString& name, double nameWidth, const SwitchLook& look, const PanelAction& action);
    void addSlider(const SliderRow& row, double nameWidth);

private:
    PanelLayout m_layout;
    double m_y;
};

/// Side by side, with the gap between them. A width of 0 is the rest, shared evenly among those.
std::vector<QRectF> cells(const QRectF& row, const std::vector<double>& widths);
std::vector<QRectF> evenCells(const QRectF& row, std::size_t count);
} // namespace vr
