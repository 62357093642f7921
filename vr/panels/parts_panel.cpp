#include "vr/panels/panel_builder.h"
#include "vr/panels/panel_content.h"
#include "vr/panels/panel_theme.h"

#include <algorithm>
#include <array>

namespace vr
{
namespace
{
constexpr double partsWidth = 980, rowHeight = 80, buttonHeight = 84, arrowWidth = 84, pageWidth = 120, iconWidth = 84,
                 tagWidth = 44, titleWidth = 340, intersectWidth = 350, groupGap = 8, hintHeight = 124,
                 shapeHeight = 110, noTagWidth = 240;
constexpr double partsDistance = 0.6; ///< metres from which the panel is read: arm's length
constexpr std::size_t namesPerRow = 4, shapesPerRow = 4;
/// Colours of which the user can choose one to mark a part
constexpr std::array tags{core::Rgb{204, 52, 44},  core::Rgb{236, 156, 40}, core::Rgb{244, 216, 84},
                          core::Rgb{96, 160, 72},  core::Rgb{52, 124, 190}, core::Rgb{70, 62, 140},
                          core::Rgb{190, 90, 150}, core::Rgb{140, 74, 46}};
} // namespace

int PartsPanel::pageCount() const
{
    return std::max(1, static_cast<int>((parts.size() + rowsPerPage - 1) / rowsPerPage));
}

int PartsPanel::shownPage() const
{
    return std::clamp(page, 0, pageCount() - 1);
}

HandTask PartsPanel::task() const
{
    switch (shown) {
    case PartsPage::List:
    case PartsPage::Name:
        return HandTask::ChoosePart;
    case PartsPage::Shapes:
        return shape == core::Primitive::Kind::Tube ? HandTask::DrawTube : HandTask::PlaceShape;
    case PartsPage::Cut:
        return HandTask::Cut;
    }
    return HandTask::ChoosePart;
}

PartsPanel PartsPanel::after(const PanelAction& action) const
{
    PartsPanel panel = *this;
    if (const auto* turned = std::get_if<ShowPartsPage>(&action)) {
        panel.page = turned->page;
    } else if (const auto* mark = std::get_if<MarkPart>(&action)) {
        panel.marked.removeAll(mark->part);
        if (mark->isMarked)
            panel.marked << mark->part;
    } else if (const auto* made = std::get_if<MakePart>(&action)) {
        panel.makesPart = made->isOn;
    } else if (const auto* opened = std::get_if<PartsPage>(&action)) {
        panel.shown = *opened;
    } else if (const auto* kind = std::get_if<core::Primitive::Kind>(&action)) {
        panel.shape = *kind;
    }
    return panel;
}

const PartRow* PartsPanel::find(core::PartId part) const
{
    const auto found = std::ranges::find_if(parts, [&](const PartRow& row) { return row.part.id == part; });
    return found == parts.end() ? nullptr : &*found;
}

std::vector<core::PartId> PartsPanel::others() const
{
    std::vector<core::PartId> ids;
    for (const PartRow& row : parts)
        if (row.part.id != active && marked.contains(row.part.id))
            ids.push_back(row.part.id);
    return ids;
}

QString PartsPanel::nameOfCopy() const
{
    const PartRow* row = find(active);
    return row ? tr("%1 copy", "name of a copied part").arg(row->name) : QString();
}

/// Adds a row: mark, colour, name, eye and lock. `row`: null for an empty row.
void PartsPanel::addRow(PanelBuilder& builder, const PartRow* row) const
{
    const QRectF area = builder.nextRow(rowHeight);
    if (!row)
        return;
    const core::Part& part = row->part;
    const bool isActive = part.id == active, isMarked = !isActive && marked.contains(part.id);
    std::vector<double> widths{iconWidth, 0, iconWidth, iconWidth};
    if (part.tag)
        widths.insert(widths.begin() + 1, tagWidth);
    const std::vector<QRectF> places = cells(area, widths);
    const std::size_t name = part.tag ? 2 : 1;
    builder.add(places[0], {{.icon = QStringLiteral("plus"), .isChosen = isMarked, .isFlat = true},
                            MarkPart{part.id, !isMarked},
                            !isActive});
    if (part.tag)
        builder.add({places[1], SwatchLook{*part.tag}});
    builder.add(places[name], {{.text = row->name, .isChosen = isActive}, ChoosePart{part.id}});
    const QString eye = part.isVisible ? QStringLiteral("part-shown") : QStringLiteral("part-hidden");
    builder.add(places[name + 1],
                {{.icon = eye, .isFlat = part.isVisible}, ShowPart{part.id, !part.isVisible}, !isBusy});
    const QString lock = part.isLocked ? QStringLiteral("part-locked") : QStringLiteral("part-unlocked");
    builder.add(places[name + 2],
                {{.icon = lock, .isFlat = !part.isLocked}, LockPart{part.id, !part.isLocked}, !isBusy});
}

/// Adds the buttons that turn pages, and those that show and hide parts.
void PartsPanel::addListButtons(PanelBuilder& builder) const
{
    const int present = shownPage();
    const bool isAlone = std::ranges::all_of(
        parts, [this](const PartRow& row) { return row.part.isVisible == (row.part.id == active); });
    const std::vector<QRectF> places = cells(builder.nextRow(buttonHeight), {arrowWidth, pageWidth, arrowWidth, 0, 0});
    builder.add(places[0], {{.icon = QStringLiteral("previous")}, ShowPartsPage{present - 1}, present > 0});
    builder.add(places[1],
                TextLook{tr("%1 / %2").arg(present + 1).arg(pageCount()), TextRole::Number, Qt::AlignCenter});
    builder.add(places[2], {{.icon = QStringLiteral("next")}, ShowPartsPage{present + 1}, present + 1 < pageCount()});
    builder.add(
        places[3],
        {{.text = tr("Isolate"), .icon = QStringLiteral("part-isolate"), .isChosen = isAlone && parts.size() > 1},
         PanelCommand::IsolatePart,
         !isBusy && parts.size() > 1});
    builder.add(places[4],
                {{.text = tr("Show all"), .icon = QStringLiteral("part-shown")}, PanelCommand::ShowAllParts, !isBusy});
}

/// Adds the buttons that copy and delete.
void PartsPanel::addPartButtons(PanelBuilder& builder) const
{
    const std::vector<QRectF> places = evenCells(builder.nextRow(buttonHeight), 2);
    builder.add(places[0],
                {{.text = tr("Duplicate"), .icon = QStringLiteral("duplicate")}, PanelCommand::DuplicatePart, !isBusy});
    builder.add(places[1], {{.text = tr("Hold to delete"), .icon = QStringLiteral("trash")},
                            PanelCommand::DeletePart,
                            !isBusy && parts.size() > 1,
                            true});
}

/// Adds the buttons that combine; during a preview, the choice of what it shows.
void PartsPanel::addCombinations(PanelBuilder& builder) const
{
    using core::SetOperation;
    const bool isEnabled = preview || (!isBusy && !others().empty());
    const std::vector<QRectF> places = cells(builder.nextRow(buttonHeight), {0, 0, intersectWidth});
    const auto add = [&](const QRectF& place, const QString& text, const QString& icon, SetOperation operation) {
        builder.add(
            place,
            {{.text = text, .icon = icon, .isChosen = preview == operation}, CombineMarked{operation}, isEnabled});
    };
    add(places[0], tr("Join"), QStringLiteral("part-union"), SetOperation::Union);
    add(places[1], tr("Subtract"), QStringLiteral("part-subtract"), SetOperation::Difference);
    add(places[2], tr("Intersect"), QStringLiteral("part-intersect"), SetOperation::Intersection);
}

QString PartsPanel::nameOf(core::Primitive::Kind kind)
{
    using Kind = core::Primitive::Kind;
    switch (kind) {
    case Kind::Cuboid:
        return tr("Box");
    case Kind::Ball:
        return tr("Ball");
    case Kind::Cylinder:
        return tr("Cylinder");
    case Kind::Cone:
        return tr("Cone");
    case Kind::Capsule:
        return tr("Capsule");
    case Kind::Torus:
        return tr("Torus");
    case Kind::Tube:
        return tr("Tube");
    case Kind::Lathe:
        break; // has no measures, so it is not on the panel
    }
    return {};
}

void PartsPanel::addList(PanelBuilder& builder) const
{
    for (qsizetype i = 0; i < rowsPerPage; ++i) {
        const qsizetype row = shownPage() * rowsPerPage + i;
        addRow(builder, row < parts.size() ? &parts[row] : nullptr);
    }
    builder.skip(groupGap);
    addListButtons(builder);
    addPartButtons(builder);
    addCombinations(builder);
    if (preview) { // ended by buttons where no other button is before and after
        const std::vector<QRectF> places = evenCells(builder.nextRow(hintHeight), 2);
        builder.add(places[0], {{.text = tr("Apply")}, PanelCommand::ApplyPreview});
        builder.add(places[1], {{.text = tr("Cancel")}, PanelCommand::CancelPreview});
        return;
    }
    const QString hint = tr("Trigger: chooses the part that you point at. Side button: moves the chosen part. Mark "
                            "others to combine them with it.");
    builder.add(builder.nextRow(hintHeight), TextLook{.text = hint, .role = TextRole::Faint, .lines = 3});
}

/// Returns the names to choose from: a headset has no keyboard.
QStringList PartsPanel::readyNames()
{
    return {tr("Body"), tr("Head"), tr("Hair"), tr("Eye"),  tr("Ear"),   tr("Arm"),
            tr("Hand"), tr("Leg"),  tr("Wing"), tr("Tail"), tr("Wheel"), tr("Base")};
}

void PartsPanel::addNames(PanelBuilder& builder) const
{
    const PartRow* present = find(active);
    const QStringList names = readyNames();
    std::vector<QRectF> places;
    for (qsizetype i = 0; i < names.size(); ++i) {
        const std::size_t column = static_cast<std::size_t>(i) % namesPerRow;
        if (column == 0)
            places = evenCells(builder.nextRow(buttonHeight), namesPerRow);
        builder.add(places[column], {{.text = names[i], .isChosen = present && present->name == names[i]},
                                     NamePart{names[i]},
                                     present && !isBusy});
    }
    builder.skip(groupGap);
    std::vector<double> widths(tags.size() + 1, 0);
    widths.front() = noTagWidth;
    places = cells(builder.nextRow(buttonHeight), widths);
    builder.add(places[0],
                {{.text = tr("No colour"), .isChosen = present && !present->part.tag}, TagPart{}, present && !isBusy});
    for (std::size_t i = 0; i < tags.size(); ++i)
        builder.add({places[i + 1], SwatchLook{tags[i], present && present->part.tag == tags[i]}, TagPart{tags[i]},
                     present && !isBusy});
    const QString hint = tr("Name and colour go to the chosen part. Trigger: chooses the part that you point at. Side "
                            "button: moves it.");
    builder.add(builder.nextRow(hintHeight), TextLook{.text = hint, .role = TextRole::Faint, .lines = 3});
}

void PartsPanel::addShapes(PanelBuilder& builder) const
{
    using Kind = core::Primitive::Kind;
    constexpr std::array kinds{Kind::Cuboid,  Kind::Ball,  Kind::Cylinder, Kind::Cone,
                               Kind::Capsule, Kind::Torus, Kind::Tube};
    std::vector<QRectF> places;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const std::size_t column = i % shapesPerRow;
        if (column == 0)
            places = evenCells(builder.nextRow(shapeHeight), shapesPerRow);
        builder.add(places[column], {{.text = nameOf(kinds[i]), .isChosen = kinds[i] == shape}, kinds[i]});
    }
    builder.addChoice({}, 0,
                      {{tr("Join with the part"), {}, MakePart{false}, !makesPart},
                       {tr("Part of its own"), {}, MakePart{true}, makesPart}});
    const QString hint = shape == Kind::Tube
                             ? tr("Trigger: hold it and move your hand to draw a tube, as thick as the brush. Side "
                                  "button: moves the chosen part.")
                             : tr("Trigger: puts the shape at the tip, as large as the brush. Side button: moves the "
                                  "chosen part.");
    builder.add(builder.nextRow(hintHeight), TextLook{.text = hint, .role = TextRole::Faint, .lines = 3});
}

void PartsPanel::addCut(PanelBuilder& builder) const
{
    builder.addChoice(
        {}, 0, {{tr("Cut away"), {}, MakePart{false}, !makesPart}, {tr("Keep both"), {}, MakePart{true}, makesPart}});
    const QString hint =
        makesPart ? tr("Trigger: cuts the chosen part at the disc. What lies beyond the disc, away from your hand, "
                       "becomes a part of its own. Side button: moves the part.")
                  : tr("Trigger: cuts the chosen part at the disc. What lies beyond the disc, away from your hand, "
                       "is removed. Side button: moves the part.");
    builder.add(builder.nextRow(hintHeight), TextLook{.text = hint, .role = TextRole::Faint, .lines = 3});
}

PanelLayout PartsPanel::layout() const
{
    PanelBuilder builder(PanelKind::Parts, partsWidth, partsDistance);
    const PartRow* present = find(active);
    builder.addTitle({tr("Parts"), present ? present->name : QString(), titleWidth},
                     {{{.icon = QStringLiteral("undo")}, PanelCommand::Undo, canUndo},
                      {{.icon = QStringLiteral("redo")}, PanelCommand::Redo, canRedo},
                      {{.icon = QStringLiteral("panel-close"), .isFlat = true}, ShowPanel{PanelKind::Parts, false}}});
    builder.addChoice({}, 0,
                      {{tr("Parts"), {}, PartsPage::List, shown == PartsPage::List},
                       {tr("Name"), {}, PartsPage::Name, shown == PartsPage::Name},
                       {tr("Shapes"), {}, PartsPage::Shapes, shown == PartsPage::Shapes},
                       {tr("Cut"), {}, PartsPage::Cut, shown == PartsPage::Cut}});
    switch (shown) {
    case PartsPage::List:
        addList(builder);
        break;
    case PartsPage::Name:
        addNames(builder);
        break;
    case PartsPage::Shapes:
        addShapes(builder);
        break;
    case PartsPage::Cut:
        addCut(builder);
        break;
    }
    return builder.finished();
}
} // namespace vr
