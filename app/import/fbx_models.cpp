// Source: Autodesk, FBX SDK Help, "Computing transformation matrices", and FbxNode::SetRotationActive(); ufbx, which
// treats inactive rotations as XYZ. Assimp (5.2 to 6.0) applies RotationOrder to geometric rotations, too, and ignores
// RotationActive. In text files it rejects negative ids, although FBX ids are signed 64-bit numbers.
#include "app/import/fbx_models.h"

#include "app/import/fbx_file.h"
#include "app/import/fbx_records.h"

#include "core/io/mesh/binary.h"
#include "core/io/mesh/format.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <set>

namespace app
{
namespace
{
using Records = std::vector<FbxRecord>;
using Eigen::Vector3d;

constexpr double radian = std::numbers::pi / 180;

/// Axes in the order of application, for each value of RotationOrder. The first entry, XYZ, turns about x first.
constexpr std::array<std::array<int, 3>, 6> orders{{{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {1, 0, 2}, {2, 0, 1}, {2, 1, 0}}};
constexpr double spheric = 6;

Eigen::Matrix3d turnOf(const Vector3d& degrees)
{
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    for (const int axis : orders[0])
        turn = Eigen::AngleAxisd(degrees[axis] * radian, Vector3d::Unit(axis)) * turn;
    return turn;
}

/// Returns the angles, in degrees, that produce the rotation when applied in this order.
Vector3d anglesOf(const Eigen::Matrix3d& turn, std::size_t order)
{
    const auto [first, second, third] = orders[order];
    const Vector3d backwards = turn.eulerAngles(third, second, first);
    Vector3d degrees;
    degrees[third] = backwards[0] / radian;
    degrees[second] = backwards[1] / radian;
    degrees[first] = backwards[2] / radian;
    return degrees;
}

/// Number of values before a property's numbers: name, type, second type name, flags.
constexpr std::size_t valuesBefore = 4;

const FbxRecord* propertyIn(const FbxRecord* properties, std::string_view name)
{
    if (!properties)
        return nullptr;
    const auto found = std::ranges::find_if(properties->records, [name](const FbxRecord& record) {
        return record.name == "P" && record.values.size() > valuesBefore && record.values[0].bytes == name;
    });
    return found == properties->records.end() ? nullptr : &*found;
}

/// Returns one of the numbers after a property's name, types and flags.
std::optional<double> valueOf(const FbxRecord* property, std::size_t index = 0)
{
    const std::size_t at = valuesBefore + index;
    return property && at < property->values.size() ? property->values[at].number() : std::nullopt;
}

bool isReal(const FbxValue& value)
{
    return value.type == 'F' || value.type == 'D' || value.type == 'T';
}

/// Returns three finite real numbers; nothing if one of them is missing, not finite or an integer, since Assimp ignores
/// such vectors.
std::optional<Vector3d> vectorOf(const FbxRecord* property)
{
    Vector3d vector;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto number = valueOf(property, axis);
        if (!number || !std::isfinite(*number) || !isReal(property->values[valuesBefore + axis]))
            return std::nullopt;
        vector[static_cast<Eigen::Index>(axis)] = *number;
    }
    return vector;
}

[[noreturn]] void refuse(const core::io::FileBytes& file, const FbxValue& word)
{
    throw errorAtLine(core::FileErrorKind::NotANumber, file, word.bytes.data(), word.bytes);
}

/// Throws FileError if a property of a transform, unit or axis is not a finite number. Assimp would ignore the
/// property.
void requireNumbers(const core::io::FileBytes& file, const FbxRecord* properties)
{
    constexpr std::array<std::string_view, 12> vectors{"Lcl Translation",   "Lcl Rotation",     "Lcl Scaling",
                                                       "PreRotation",       "PostRotation",     "RotationOffset",
                                                       "RotationPivot",     "ScalingOffset",    "ScalingPivot",
                                                       "GeometricRotation", "GeometricScaling", "GeometricTranslation"};
    constexpr std::array<std::string_view, 11> numbers{"RotationOrder", "RotationActive",  "RotationSpaceForLimitOnly",
                                                       "InheritType",   "UnitScaleFactor", "UpAxis",
                                                       "UpAxisSign",    "FrontAxis",       "FrontAxisSign",
                                                       "CoordAxis",     "CoordAxisSign"};
    const auto require = [&](std::string_view name, std::size_t count) {
        const FbxRecord* const property = propertyIn(properties, name);
        for (std::size_t i = 0; property && i < count && valuesBefore + i < property->values.size(); ++i) {
            const FbxValue& value = property->values[valuesBefore + i];
            if (std::isfinite(value.number().value_or(std::numeric_limits<double>::infinity())))
                continue;
            if (value.type == 'T' || value.type == 'S')
                refuse(file, value);
            throw errorWithToken(core::FileErrorKind::NotANumber, file, name);
        }
    };
    for (const std::string_view name : vectors)
        require(name, 3);
    for (const std::string_view name : numbers)
        require(name, 1);
}

bool isMesh(const FbxRecord& object)
{
    return object.name == "Geometry" && object.values.size() > 2 && object.values[2].bytes == "Mesh";
}

/// Throws FileError if a mesh point or corner in a text file is not a finite number. Assimp would use the digits that
/// it begins with.
void requireNumbersOf(const core::io::FileBytes& file, const FbxRecord& mesh)
{
    for (const FbxRecord& array : mesh.records)
        if (const FbxRecord* const words = recordIn(array.records, "a"); words && !words->values.empty())
            refuse(file, words->values.front());
}

bool hasFaces(const FbxRecord& mesh)
{
    const FbxRecord* const corners = recordIn(mesh.records, "PolygonVertexIndex");
    if (!corners || corners->values.empty())
        return false;
    const FbxValue& value = corners->values.front(); // in a text file, the number of values that follow, e.g. "*12"
    return value.type == 'T' ? value.bytes != "*0" : !value.bytes.empty();
}

/// Returns the model's name as Assimp gives it to the node. The file has "Model::name" in text, and "name", NUL, SOH,
/// "Model" in binary.
std::string nameOf(const FbxRecord& model)
{
    if (model.values.size() < 2)
        return {};
    std::string name(model.values[1].bytes);
    constexpr std::string_view gap("\0\1", 2), kind = "Model::";
    if (const std::size_t at = name.find(gap); at != std::string::npos)
        name = name.substr(at + gap.size()) + "::" + name.substr(0, at);
    return name.starts_with(kind) ? name.substr(kind.size()) : name;
}

/// Collects changes to the bytes of an FBX file.
class Changes
{
public:
    explicit Changes(std::string_view bytes) : m_bytes(bytes) {}

    void set(const FbxRecord& property, std::size_t index, double number)
    {
        const FbxValue& value = property.values[valuesBefore + index];
        if (value.number() != number)
            m_texts[value.at] = {value.bytes.size(), textOf(value.type, number)};
    }
    void setByte(std::size_t at, char byte) { m_texts[at] = {1, {byte}}; }
    /// Turns a connection into one between properties, which Assimp ignores. Changes nothing unless its kind has two
    /// letters.
    void ignore(const FbxRecord& connection)
    {
        constexpr std::string_view kind = "PP";
        if (const FbxValue& value = connection.values[0]; value.bytes.size() == kind.size())
            m_texts[value.at] = {kind.size(), std::string(kind)};
    }
    /// Replaces a negative id in a text file by the same id modulo 2^64, which Assimp accepts.
    void unsign(const FbxRecord& record, std::size_t index)
    {
        if (index >= record.values.size() || record.values[index].type != 'T')
            return;
        const FbxValue& value = record.values[index];
        if (const auto id = value.whole(); id && value.bytes.starts_with('-'))
            m_texts[value.at] = {value.bytes.size(), std::to_string(static_cast<std::uint64_t>(*id))};
    }
    /// Cuts the name of an object in a text file to its first 900 bytes. Assimp drops names of 1,024 bytes, with its
    /// additions, or more.
    void shortenName(const FbxRecord& object)
    {
        constexpr std::size_t kept = 900;
        if (object.values.size() > 1 && object.values[1].bytes.size() > kept)
            m_texts[object.values[1].at + kept] = {object.values[1].bytes.size() - kept, {}};
    }
    void set(const FbxRecord& property, const Vector3d& vector)
    {
        for (int axis = 0; axis < 3; ++axis)
            set(property, static_cast<std::size_t>(axis), vector[axis]);
    }

    std::optional<std::string> result() const
    {
        if (m_texts.empty())
            return std::nullopt;
        std::string result;
        result.reserve(m_bytes.size() + 32 * m_texts.size());
        std::size_t done = 0;
        for (const auto& [at, change] : m_texts) {
            result.append(m_bytes.substr(done, at - done)).append(change.second);
            done = at + change.first;
        }
        return result.append(m_bytes.substr(done));
    }

private:
    static std::string textOf(char type, double number)
    {
        std::string text;
        switch (type) {
        case 'D':
            core::io::append(text, number);
            return text;
        case 'F':
            core::io::append(text, static_cast<float>(number));
            return text;
        case 'L':
            core::io::append(text, static_cast<std::int64_t>(number));
            return text;
        case 'I':
            core::io::append(text, static_cast<std::int32_t>(number));
            return text;
        case 'Y':
            core::io::append(text, static_cast<std::int16_t>(number));
            return text;
        case 'C':
        case 'B':
            return {static_cast<char>(number)};
        default:
            std::array<char, 32> digits{};
            const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
            return {digits.data(), end};
        }
    }

    std::string_view m_bytes;
    /// length of the replaced text, and its replacement, by position in the file
    std::map<std::size_t, std::pair<std::size_t, std::string>> m_texts;
};

/// Properties of a model: its own and, for missing ones, the template's. Does not own them.
struct ModelProperties
{
    const FbxRecord* own = nullptr;   ///< the model's own properties; may be null
    const FbxRecord* usual = nullptr; ///< properties of the template; may be null

    const FbxRecord* find(std::string_view name) const
    {
        const FbxRecord* const property = propertyIn(own, name);
        return property ? property : propertyIn(usual, name);
    }
    double number(std::string_view name, double otherwise) const { return valueOf(find(name)).value_or(otherwise); }
    bool hasActiveRotations() const
    {
        return number("RotationActive", 1) != 0 && number("RotationSpaceForLimitOnly", 0) == 0;
    }
};

/// Rewrites the rotations of models so that Assimp applies them correctly.
class RotationFixer
{
public:
    RotationFixer(const std::filesystem::path& path, Changes& changes) : m_path(path), m_changes(changes) {}

    void fix(const ModelProperties& properties)
    {
        m_properties = properties;
        const bool isActive = properties.hasActiveRotations();
        const std::size_t order = orderOf(isActive);
        reorder("Lcl Rotation", isActive ? 0 : order);
        reorder("GeometricRotation", order);
    }

private:
    [[noreturn]] void refuse(std::string_view words) const
    {
        core::FileError error = core::io::errorWithToken(core::FileErrorKind::ReaderRefused, {m_path, {}}, {});
        error.token = words;
        throw error;
    }

    /// Returns the index in `orders` of the rotation order that Assimp applies to the model. SphericXYZ, unknown to
    /// Assimp, is changed to XYZ if the model has no rotation. Throws FileError if it has one.
    std::size_t orderOf(bool isActive)
    {
        const double number = m_properties.number("RotationOrder", 0);
        if (number >= 0 && number < spheric)
            return static_cast<std::size_t>(number);
        if (number != spheric)
            return 0; // not a valid rotation order
        if (isActive && !vectorOf(m_properties.find("Lcl Rotation")).value_or(Vector3d::Zero()).isZero(0))
            refuse("the rotation order SphericXYZ is not read");
        m_changes.set(*m_properties.find("RotationOrder"), 0, 0);
        return 0;
    }

    /// Rewrites a rotation about x, y, z as the equivalent angles in another order. The template's rotation is
    /// rewritten for all models that use it. Throws FileError if these models need different angles.
    void reorder(std::string_view name, std::size_t order)
    {
        const FbxRecord* const property = m_properties.find(name);
        const auto angles = vectorOf(property);
        if (!angles)
            return;
        const Vector3d righted = order == 0 ? *angles : anglesOf(turnOf(*angles), order);
        if (m_righted.try_emplace(property, righted).first->second != righted)
            refuse("a rotation of the template is not read where models of different orders have it");
        m_changes.set(*property, righted);
    }

    const std::filesystem::path& m_path;
    Changes& m_changes;
    ModelProperties m_properties;
    std::map<const FbxRecord*, Vector3d> m_righted; ///< rewritten angles of each property, degrees
};

const FbxRecord* modelTemplateIn(const Records& records)
{
    const FbxRecord* const definitions = recordIn(records, "Definitions");
    if (!definitions)
        return nullptr;
    for (const FbxRecord& type : definitions->records)
        if (type.name == "ObjectType" && !type.values.empty() && type.values[0].bytes == "Model")
            if (const FbxRecord* const properties = recordIn(type.records, "PropertyTemplate"))
                return recordIn(properties->records, "Properties70");
    return nullptr;
}

/// The hierarchy of models in an FBX file.
class ModelTree
{
public:
    ModelTree(const Records& objects, const Records& connections)
    {
        std::map<std::int64_t, const FbxRecord*> meshes;       // meshes with faces, by id
        std::set<std::pair<std::int64_t, std::int64_t>> known; // ids of child and parent
        for (const FbxRecord& object : objects)
            if (const auto id = idOf(object, 0); id && object.name == "Model")
                m_models[*id].record = &object;
            else if (id && isMesh(object) && hasFaces(object))
                meshes.emplace(*id, &object);
        for (const FbxRecord& c : connections) {
            const auto child = idOf(c, 1), parent = idOf(c, 2);
            if (!child || !parent || (!isModel(*child) && !(meshes.contains(*child) && isModel(*parent))))
                continue;
            const Kind kind = kindOf(c);
            if (kind == Kind::Other || (kind == Kind::Objects && !known.emplace(*child, *parent).second))
                m_ignored.push_back(&c);
            else if (kind == Kind::Objects && isModel(*child))
                m_models[*parent].below.push_back(*child);
            else if (kind == Kind::Objects)
                ++m_models[*parent].meshes;
        }
        m_firstMesh = meshes.empty() ? nullptr : meshes.begin()->second;
    }

    /// Returns the connections of models and meshes that Assimp must ignore: repeated ones, and ones of unknown kinds,
    /// which Assimp would treat as object connections. Not owned.
    const std::vector<const FbxRecord*>& ignored() const { return m_ignored; }

    /// Returns a model in the scene that contains itself or has too many generations above and below it; null if there
    /// is none. Cost: linear in models and connections.
    const FbxRecord* endless() { return endless(m_models[0]); }

    /// Returns why no mesh with faces is in the scene; nothing if one is, or if the file has none. Precondition:
    /// endless() has returned null.
    std::optional<core::FileError> whyEmpty(const std::filesystem::path& path)
    {
        const FbxRecord* first = m_firstMesh;
        for (const auto& [id, model] : m_models) {
            if (model.meshes > 0 && model.isDone)
                return std::nullopt;
            if (model.meshes > 0 && first == m_firstMesh)
                first = model.record;
        }
        if (!first)
            return std::nullopt;
        for (auto& [id, model] : m_models)
            if (const FbxRecord* const cyclic = model.isDone ? nullptr : endless(model))
                return tooDeep(path, *cyclic);
        return core::io::malformed(core::FileFault::NotInScene,
                                   core::io::errorWithToken({}, {path, {}}, nameOf(*first)));
    }

    static core::FileError tooDeep(const std::filesystem::path& path, const FbxRecord& model)
    {
        return core::io::malformed(core::FileFault::TooDeep,
                                   core::io::errorWithToken({}, {path, {}}, "models below " + nameOf(model)));
    }

    /// Returns all models; the first entry is the scene. `usual`: properties of the template, not owned; may be null.
    std::vector<FbxModel> models(const FbxRecord* usual) const
    {
        std::map<std::int64_t, std::size_t> indices{{0, 0}};
        for (const auto& [id, model] : m_models)
            if (id != 0)
                indices.emplace(id, indices.size());
        std::vector<FbxModel> models(indices.size());
        for (const auto& [id, model] : m_models) {
            FbxModel& to = models[indices[id]];
            if (model.record)
                to = modelOf(*model.record, usual);
            to.meshes = model.meshes;
            for (const std::int64_t child : model.below)
                to.below.push_back(indices[child]);
        }
        return models;
    }

private:
    static constexpr std::size_t maxDepth = 4096;

    struct Model
    {
        const FbxRecord* record = nullptr;
        std::vector<std::int64_t> below;
        bool isOnWay = false, isDone = false;
        std::size_t height = 0; ///< generations below this model; final once isDone is true
        std::size_t meshes = 0; ///< number of meshes with faces
    };

    /// Searches from this model down. The path has the model as its first entry.
    const FbxRecord* endless(Model& top)
    {
        struct Step
        {
            Model* model;
            std::size_t next = 0;
        };
        std::vector<Step> way{{&top}}; // path from the top; its length is the depth of the next model
        while (!way.empty()) {
            Step& step = way.back();
            step.model->isOnWay = true;
            if (step.next == step.model->below.size()) {
                const std::size_t above = step.model->height + 1;
                step.model->isOnWay = false;
                step.model->isDone = true;
                way.pop_back();
                if (!way.empty())
                    way.back().model->height = std::max(way.back().model->height, above);
                continue;
            }
            Model& child = m_models[step.model->below[step.next++]];
            if (child.isOnWay || way.size() + child.height > maxDepth)
                return child.record;
            if (!child.isDone)
                way.push_back({&child});
            else
                step.model->height = std::max(step.model->height, child.height + 1);
        }
        return nullptr;
    }

    static FbxModel modelOf(const FbxRecord& record, const FbxRecord* usual)
    {
        const ModelProperties properties{recordIn(record.records, "Properties70"), usual};
        FbxModel model;
        model.name = nameOf(record);
        model.scale = vectorOf(properties.find("Lcl Scaling")).value_or(model.scale);
        const double inherit = properties.number("InheritType", 1);
        model.inherit = inherit == 0   ? FbxModel::Inherit::ComponentWise
                        : inherit == 2 ? FbxModel::Inherit::WithoutParents
                                       : FbxModel::Inherit::Usual;
        model.hasActiveRotations = properties.hasActiveRotations();
        model.isLodGroup = record.values.size() > 2 && record.values[2].bytes == "LodGroup";
        model.isShown = properties.number("Show", 1) != 0;
        model.isVisible = properties.number("Visibility", 1) != 0;
        model.inheritsVisibility = properties.number("Visibility Inheritance", 1) != 0;
        return model;
    }

    enum class Kind { Objects, Properties, Other };

    /// Returns what a connection links. An object-to-property connection without a property name links objects.
    static Kind kindOf(const FbxRecord& connection)
    {
        const std::string_view kind = connection.values[0].bytes;
        if (kind == "OO" || (kind == "OP" && connection.values.size() > 3 && connection.values[3].bytes.empty()))
            return Kind::Objects;
        return kind == "OP" || kind == "PP" ? Kind::Properties : Kind::Other;
    }

    static std::optional<std::int64_t> idOf(const FbxRecord& record, std::size_t value)
    {
        return value < record.values.size() ? record.values[value].whole() : std::nullopt;
    }
    bool isModel(std::int64_t id) const
    {
        const auto found = m_models.find(id);
        return found != m_models.end() && found->second.record;
    }

    std::map<std::int64_t, Model> m_models;
    const FbxRecord* m_firstMesh = nullptr; ///< a mesh with faces, if there is one
    std::vector<const FbxRecord*> m_ignored;
};
} // namespace

FbxForAssimp fbxForAssimp(const std::filesystem::path& path, std::string_view bytes)
{
    const std::optional<Records> records = fbxModelRecords(bytes);
    if (!records)
        return {.isFollowed = false, .changed = {}, .models = {}};
    const FbxRecord* const objects = recordIn(*records, "Objects");
    if (!objects)
        return {.changed = {}, .models = {{}}};
    const Records none;
    const FbxRecord* const connections = recordIn(*records, "Connections");
    const Records& lines = connections ? connections->records : none;
    ModelTree tree(objects->records, lines);
    if (const FbxRecord* const model = tree.endless())
        throw ModelTree::tooDeep(path, *model);
    const FbxRecord* const usual = modelTemplateIn(*records);
    Changes changes(bytes);
    for (const std::size_t at : fbxByteTypes(bytes))
        changes.setByte(at, 'C');
    RotationFixer fixer(path, changes);
    const core::io::FileBytes file{path, bytes};
    if (const FbxRecord* const settings = recordIn(*records, "GlobalSettings"))
        requireNumbers(file, recordIn(settings->records, "Properties70"));
    requireNumbers(file, usual);
    for (const FbxRecord& line : lines) {
        changes.unsign(line, 1);
        changes.unsign(line, 2);
    }
    for (const FbxRecord* const connection : tree.ignored())
        changes.ignore(*connection);
    for (const FbxRecord& object : objects->records) {
        changes.unsign(object, 0);
        if (isMesh(object))
            requireNumbersOf(file, object);
        if (object.name != "Model")
            continue;
        if (!isBinaryFbx(bytes)) // in a binary file, the places of all later records would change
            changes.shortenName(object);
        const FbxRecord* const own = recordIn(object.records, "Properties70");
        requireNumbers(file, own);
        fixer.fix({own, usual});
    }
    return {.changed = changes.result(), .models = tree.models(usual), .whyEmpty = tree.whyEmpty(path)};
}
} // namespace app
