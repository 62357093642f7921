// The stroke file's commands for the whole model: the keys of each command and the keywords of each key.
#include "core/io/stroke/stroke_json_reader.h"

#include <cassert>

namespace core
{
namespace
{
using Draft = const CommandDraft&;
// Settings read with the command's object: they contain its color and detail_length.
using Settings = const StrokeSettings&;
struct CommandRow
{
    std::string_view name;
    KeySet required, optional;
    ModelCommand (*make)(Draft, Settings);
};
constexpr KeySet areaKeys = bit(OutlineKey) | bit(AlongKey);
constexpr KeySet optionalAreaKeys = bit(EyeKey) | bit(SymmetryKey) | bit(FrontKey);

ViewArea areaOf(Draft draft, Settings settings)
{
    ViewArea area = draft.area;
    area.symmetry = settings.symmetry;
    if (draft.hasEye)
        area.eye = draft.eye;
    return area;
}

std::optional<Rgb> colorOf(Draft draft, Settings settings)
{
    return draft.hasColor ? std::optional(settings.color) : std::nullopt;
}

constexpr CommandRow commandTable[] = {
    {"move", bit(ByKey), 0, [](Draft d, Settings) -> ModelCommand { return Move{d.by}; }},
    {"rotate", bit(TurnKey), 0, [](Draft d, Settings) -> ModelCommand { return Rotate{d.rotation}; }},
    {"transform", bit(CentreKey), bit(ByKey) | bit(TurnKey) | bit(StretchKey) | bit(StretchAxesKey),
     [](Draft d, Settings) -> ModelCommand {
         return Transform{d.centre, d.by, d.rotation, d.scale, d.scaleAxes};
     }},
    {"scale", bit(FactorKey), 0, [](Draft d, Settings) -> ModelCommand { return Scale{d.factor}; }},
    {"mirror", bit(PlaneKey), 0,
     [](Draft d, Settings) -> ModelCommand {
         return Mirror{static_cast<int>(d.plane) - static_cast<int>(Symmetry::X)};
     }},
    {"recentre", 0, 0, [](Draft, Settings) -> ModelCommand { return Recentre{}; }},
    {"insert", 0, bit(WhereKey) | bit(CombineKey) | bit(NameKey) | bit(SymmetryKey), // and insertKeys()
     [](Draft d, Settings s) -> ModelCommand {
         Insert insert{{}, d.where, d.centre, d.combination, {}, d.partName, s.symmetry};
         if (d.file.empty())
             insert.primitive = d.primitive;
         return insert;
     }},
    {"fill", bit(ColorKey), 0, [](Draft, Settings s) -> ModelCommand { return Fill{s.color}; }},
    {"remesh", 0, bit(DetailLengthKey),
     [](Draft, Settings s) -> ModelCommand { return RemeshUniformly{s.detailLength}; }},
    {"symmetrize", bit(PlaneKey), bit(KeepKey),
     [](Draft d, Settings) -> ModelCommand {
         return Symmetrize{d.plane, d.keep};
     }},
    {"reset", 0, 0, [](Draft, Settings) -> ModelCommand { return Reset{}; }},
    {"place_on_bed", 0, 0, [](Draft, Settings) -> ModelCommand { return PlaceOnBed{}; }},
    {"flatten_base", bit(HeightKey), 0,
     [](Draft d, Settings) -> ModelCommand { return FlattenBase{d.primitive.length(Primitive::Measure::Height)}; }},
    {"mask", bit(HowKey), bit(ColorKey),
     [](Draft d, Settings s) -> ModelCommand {
         return MaskOperation{d.how, s.color};
     }},
    {"edit_part", bit(NameKey), bit(LockedKey) | bit(TagKey) | bit(ListPositionKey),
     [](Draft d, Settings) -> ModelCommand {
         return EditPart{d.partName, d.isLocked, d.tag, d.position};
     }},
    {"show_parts", bit(PartsKey), 0, [](Draft d, Settings) -> ModelCommand { return ShowParts{d.parts}; }},
    {"duplicate_part", 0, bit(NameKey), [](Draft d, Settings) -> ModelCommand { return DuplicatePart{d.partName}; }},
    {"delete_part", 0, 0, [](Draft, Settings) -> ModelCommand { return DeletePart{}; }},
    {"separate_part", 0, 0, [](Draft, Settings) -> ModelCommand { return SeparatePart{}; }},
    {"combine_parts", bit(OperationKey) | bit(PartsKey), 0,
     [](Draft d, Settings) -> ModelCommand {
         return CombineParts{d.operation, d.parts};
     }},
    {"hide", bit(WhatKey), 0, [](Draft d, Settings) -> ModelCommand { return Hide{d.hides}; }},
    {"trim", areaKeys, optionalAreaKeys | bit(RemoveKey) | bit(ColorKey),
     [](Draft d, Settings s) -> ModelCommand {
         return Trim{areaOf(d, s), colorOf(d, s)};
     }},
    {"mask_area", areaKeys, optionalAreaKeys | bit(SideKey) | bit(InvertKey),
     [](Draft d, Settings s) -> ModelCommand {
         return MaskArea{areaOf(d, s), s.inverted};
     }},
    {"hide_area", areaKeys, optionalAreaKeys | bit(SideKey),
     [](Draft d, Settings s) -> ModelCommand { return HideArea{areaOf(d, s)}; }},
    {"split_part", areaKeys, optionalAreaKeys | bit(SideKey) | bit(NameKey) | bit(ColorKey),
     [](Draft d, Settings s) -> ModelCommand {
         return SplitPart{areaOf(d, s), d.partName, colorOf(d, s)};
     }},
};
constexpr auto commandNames = [] {
    std::array<std::string_view, std::size(commandTable)> names;
    std::ranges::transform(commandTable, names.begin(), &CommandRow::name);
    return names;
}();
constexpr std::array<std::string_view, 2> keepTable{"positive", "negative"};
constexpr std::array<std::string_view, 4> hideTable{"masked", "unmasked", "none", "no_part"};
constexpr std::array<std::string_view, 3> operationTable{"union", "subtract", "intersect"};
constexpr std::array<std::string_view, 2> sideTable{"inside", "outside"};
const auto primitiveNames = [] {
    std::array<std::string_view, Primitive::kinds> names;
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = name(static_cast<Primitive::Kind>(i));
    return names;
}();

std::size_t keyOf(Primitive::Measure measure)
{
    return static_cast<std::size_t>(strokeKeys.indexOf(name(measure)));
}
} // namespace

/// Stores the keyword for the current key. Returns false if the key does not allow it.
bool StrokeJsonReader::commandWord(const std::string& typed)
{
    const std::string word = m_key == WhereKey && typed == "center" ? "centre" : typed;
    const auto take = [&](const auto& names, auto& value) {
        m_words = names;
        const auto place = std::ranges::find(names, word) - names.begin();
        value = static_cast<std::remove_reference_t<decltype(value)>>(place);
        return place < std::ssize(names);
    };
    switch (m_key) {
    case CommandKey:
        m_words = commandNames;
        m_command.name = word == "recenter" ? "recentre" : word;
        return std::ranges::find(commandNames, m_command.name) != commandNames.end();
    case PlaneKey:
        m_words = std::span(valueNames<Symmetry>).subspan(1); // all values except none
        m_command.plane = named<Symmetry>(word).value_or(Symmetry::None);
        return m_command.plane != Symmetry::None;
    case KeepKey:
        return take(keepTable, m_command.keep);
    case RemoveKey:
    case SideKey:
        return take(sideTable, m_command.area.side);
    case WhereKey:
        return take(placeNames, m_command.where);
    case CombineKey:
        return take(combinationNames, m_command.combination);
    case AxisKey: {
        int axis = 0;
        const bool isAxis = take(axisNames, axis);
        if (isAxis)
            m_command.primitive.axis = Vec3::Unit(axis);
        return isAxis;
    }
    case PrimitiveKey:
        return take(primitiveNames, m_command.primitive.kind);
    case HowKey:
        return take(maskChangeNames, m_command.how);
    case WhatKey:
        return take(hideTable, m_command.hides);
    case OperationKey:
        return take(operationTable, m_command.operation);
    case NameKey:
        m_command.partName = shortened(word);
        return true;
    case ModelKey:
        m_command.file = word;
        return !word.empty();
    default:
        refuse(Kind::WrongType);
    }
}

/// Throws UnknownKey if one of the keys was read: the format has them, but not in this object.
void StrokeJsonReader::requireNoneOf(KeySet keys)
{
    for (std::size_t i = 0; i < strokeKeys.names.size(); ++i) {
        if (m_seen & keys & bit(i))
            throw errorHere(Kind::UnknownKey, std::string(strokeKeys.names[i]));
    }
}

/// Returns the keys that this insertion needs, besides optional ones.
KeySet StrokeJsonReader::insertKeys() const
{
    const bool wantsCentre = m_command.where == Insert::Place::Centre || m_command.where == Insert::Place::Floor;
    const KeySet keys = wantsCentre ? bit(CentreKey) : 0;
    if (!(m_seen & bit(PrimitiveKey)))
        return keys | bit(ModelKey);
    KeySet measures = m_command.primitive.kind == Primitive::Kind::Lathe  ? bit(ProfileKey)
                      : m_command.primitive.kind == Primitive::Kind::Tube ? bit(PathKey)
                                                                          : 0;
    for (const Primitive::Measure measure : measuresOf(m_command.primitive.kind))
        measures |= bit(keyOf(measure));
    return keys | bit(PrimitiveKey) | measures;
}

/// Returns the optional keys of a primitive. Its axis is given once, and not if it would make no difference.
KeySet StrokeJsonReader::primitiveKeys() const
{
    const KeySet axis = bit(m_seen & bit(AlongKey) ? AlongKey : AxisKey);
    return bit(EdgeLengthKey) | (hasAxis(m_command.primitive.kind) ? axis : 0);
}

/// Builds the command. Its keys may precede "command" in the file, so only here are they checked against the command's
/// own keys.
void StrokeJsonReader::endCommand()
{
    const auto found = std::ranges::find(commandTable, m_command.name, &CommandRow::name);
    assert(found != std::end(commandTable)); // commandWord() has refused other names
    const CommandRow& row = *found;
    const bool wantsColor = row.name == "mask" && m_command.how == MaskOperation::Kind::Color;
    m_command.hasEye = m_seen & bit(EyeKey);
    m_command.hasColor = m_seen & bit(ColorKey);
    const KeySet wanted = (row.name == "insert" ? insertKeys() : 0) | (wantsColor ? bit(ColorKey) : 0);
    const bool isPrimitive = row.name == "insert" && wanted & bit(PrimitiveKey);
    const bool isNamed = row.name != "insert" || m_command.combination == Insert::Combination::Part;
    const KeySet conditional = (row.name == "mask" ? bit(ColorKey) : 0) | (isNamed ? 0 : bit(NameKey));
    const KeySet required = row.required | wanted;
    const KeySet known =
        bit(CommandKey) | bit(PartKey) | required | (row.optional & ~conditional) | (isPrimitive ? primitiveKeys() : 0);
    requireNoneOf(~known);
    for (std::size_t i = 0; i < strokeKeys.names.size(); ++i) {
        m_key = static_cast<int>(i);
        if (required & ~m_seen & bit(i))
            refuse(Kind::MissingKey);
    }
    const PartId part = stroke().settings.part;
    m_entries.back() = FileCommand{row.make(m_command, stroke().settings), m_command.file, part};
}
} // namespace core
