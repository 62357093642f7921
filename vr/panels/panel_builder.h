#pragma once

#include "vr/panels/panel_layout.h"

#include <initializer_list>
#include <vector>

namespace vr
{
/// One of several alternatives, of which one is chosen.
struct PanelChoice
{
    QString text;
    QString icon;
    PanelAction action;
    bool isChosen = false;
};

struct SwitchRow
{
    QString name;
    SwitchLook look;
    PanelAction action;
    bool isEnabled = true;
};

struct SliderRow
{
    QString name;
    QString value; ///< the value as text
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
    double textWidth = 0; ///< width of `text` if there is a note, dmm
};

/// Builds a panel row by row from the top. Every row is as wide as the panel without its margins.
class PanelBuilder
{
public:
    explicit PanelBuilder(PanelKind kind, double width, double distance);

    /// Returns the panel, which ends below its last row.
    PanelLayout finished() const;

    QRectF nextRow(double height);
    void skip(double height) { m_y += height; }
    double innerWidth() const;

    void add(const QRectF& area, const TextLook& look) { m_layout.items.push_back({area, look, {}, true, false}); }
    void add(const QRectF& area, const WellLook& look) { m_layout.items.push_back({area, look, {}, true, false}); }
    void add(const QRectF& area, const PanelButton& button);
    void add(const PanelItem& item) { m_layout.items.push_back(item); }

    /// Adds the title with its note on the right, and after these the buttons, which have icons.
    void addTitle(const PanelTitle& title, const std::vector<PanelButton>& buttons = {});
    /// Adds a name of width `nameWidth`, and the alternatives to its right. Without a name they fill the row.
    void addChoice(const QString& name, double nameWidth, const std::vector<PanelChoice>& choices);
    void addChoice(const QRectF& row, const std::vector<PanelChoice>& choices);
    // Each of these adds a name of width `nameWidth`, and the switch or the slider to its right.
    void addSwitch(const SwitchRow& row, double nameWidth);
    void addSlider(const SliderRow& row, double nameWidth);

private:
    PanelLayout m_layout;
    double m_y;
};

/// Divides a row into cells side by side with theme::gap between them. Cells of width 0 share the remaining width
/// evenly.
std::vector<QRectF> cells(const QRectF& row, const std::vector<double>& widths);
std::vector<QRectF> evenCells(const QRectF& row, std::size_t count);
} // namespace vr
