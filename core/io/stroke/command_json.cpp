// The stroke file's commands for the whole model: which keys each has, and its words.
#include "core/io/stroke/stroke_json_reader.h"

namespace core
{
namespace
{
struct CommandKeys
{
    std::string_view name;
    KeySet required, optional;
};
enum CommandName {
    MoveName,
    RotateName,
    ScaleName,
    MirrorName,
    RecentreName,
    InsertName,
    FillName,
    RemeshName,
    SymmetrizeName,
    ResetName,
    PlaceOnBedName,
    FlattenBaseName,
    MaskName
};
constexpr std::array<CommandKeys, 13> commandTable{{
    {"move", bit(ByKey), 0},
    {"rotate", bit(TurnKey), 0},
    {"scale", bit(FactorKey), 0},
    {"mirror", bit(PlaneKey), 0},
    {"recentre", 0, 0},
    {"insert", bit(ModelKey), bit(WhereKey) | bit(CentreKey)},
    {"fill", bit(ColorKey), 0},
    {"remesh", 0, bit(DetailLengthKey)},
    {"symmetrize", bit(PlaneKey), bit(KeepKey)},
    {"reset", 0, 0},
    {"place_on_bed", 0, 0},
    {"flatten_base", bit(HeightKey), 0},
    {"mask", bit(HowKey), bit(ColorKey)},
}};
constexpr std::array<std::string_view, 2> keepTable{"positive", "negative"};
constexpr std::array<std::string_view, 3> whereTable{"beside", "as_it_is", "centre"};

/// Its place in the table; its size if it is not there.
template <class Table, class Name> std::size_t placeIn(const Table& table, std::string_view word, Name nameOf)
{
    return static_cast<std::size_t>(std::ranges::find(table, word, nameOf) - table.begin());
}

ModelCommand commandOf(CommandName name, const CommandDraft& draft, const StrokeSettings& settings)
{
    const int axis = static_cast<int>(draft.plane) - static_cast<int>(Symmetry::X);
    switch (name) {
    case MoveName:
        return Move{draft.by};
    case RotateName:
        return Rotate{draft.rotation};
    case ScaleName:
        return Scale{draft.factor};
    case MirrorName:
        return Mirror{axis};
    case RecentreName:
        return Recentre{};
    case InsertName:
        return Insert{{}, draft.where, draft.centre};
    case FillName:
        return Fill{settings.color};
    case RemeshName:
        return RemeshUniformly{settings.detailLength};
    case SymmetrizeName:
        return Symmetrize{draft.plane, draft.keep};
    case PlaceOnBedName:
        return PlaceOnBed{};
    case FlattenBaseName:
        return FlattenBase{draft.height};
    case MaskName:
        return MaskOperation{draft.how, settings.color};
    case ResetName:
        break;
    }
    return Reset{};
}
} // namespace

/// False if the key does not have that word.
bool StrokeJsonReader::commandWord(const std::string& word)
{
    switch (m_key) {
    case CommandKey:
        m_command.name = word;
        return placeIn(commandTable, word, &CommandKeys::name) < commandTable.size();
    case PlaneKey:
        m_command.plane = symmetryNamed(word).value_or(Symmetry::None);
        return m_command.plane != Symmetry::None;
    case KeepKey: {
        const std::size_t keep = placeIn(keepTable, word, std::identity());
        m_command.keep = static_cast<Half>(keep);
        return keep < keepTable.size();
    }
    case WhereKey: {
        const std::size_t where = placeIn(whereTable, word, std::identity());
        m_command.where = static_cast<Insert::Place>(where);
        return where < whereTable.size();
    }
    case HowKey: {
        const std::size_t how = placeIn(maskChangeNames, word, std::identity());
        m_command.how = static_cast<MaskOperation::Kind>(how);
        return how < maskChangeNames.size();
    }
    case ModelKey:
        m_command.file = word;
        return !word.empty();
    default:
        refuse(Kind::WrongType);
    }
}

/// Known to the format, but not where they stand.
void StrokeJsonReader::requireNoneOf(KeySet keys)
{
    for (std::size_t i = 0; i < strokeKeys.names.size(); ++i) {
        if (m_seen & keys & bit(i))
            throw errorHere(Kind::UnknownKey, std::string(strokeKeys.names[i]));
    }
}

/// The keys of a command may come in any order, and before "command": only now is it known which belong to it.
void StrokeJsonReader::endCommand()
{
    const std::size_t name = placeIn(commandTable, m_command.name, &CommandKeys::name);
    const CommandKeys& keys = commandTable[name];
    const bool wantsCentre = name == InsertName && m_command.where == Insert::Place::Centre;
    const bool wantsColor = name == MaskName && m_command.how == MaskOperation::Kind::Color;
    const KeySet wanted = (wantsCentre ? bit(CentreKey) : 0) | (wantsColor ? bit(ColorKey) : 0);
    const KeySet required = keys.required | wanted,
                 known = bit(CommandKey) | required | (keys.optional & ~(bit(CentreKey) | bit(ColorKey)));
    requireNoneOf(~known);
    for (std::size_t i = 0; i < strokeKeys.names.size(); ++i) {
        m_key = static_cast<int>(i);
        if (required & ~m_seen & bit(i))
            refuse(Kind::MissingKey);
    }
    m_entries.back() =
        FileCommand{commandOf(static_cast<CommandName>(name), m_command, stroke().settings), m_command.file};
}
} // namespace core
