// Tests the correction of rotations in binary and text FBX files for Assimp, and files whose structure cannot be
// parsed.

#include "app/import/fbx_models.h"
#include "app/import/fbx_records.h"
#include "core/util/file_error.h"
#include "tests/support/effort.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <Eigen/Geometry>

#include <array>
#include <numbers>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace
{
using core::FileError;
using Eigen::Vector3d;

constexpr unsigned fbxSeed = 20261127;

/// A record to write. Its values are texts, floating-point numbers or integers.
struct Record
{
    using Value = std::variant<std::string, double, std::int64_t>;
    std::string name;
    std::vector<Value> values;
    std::vector<Record> records = {};
};

enum class Form { Text, Binary, WideBinary };

std::string textOf(std::span<const Record> records)
{
    std::string text;
    for (const Record& record : records) {
        text += "\t" + record.name + ": ";
        for (std::size_t i = 0; i < record.values.size(); ++i) {
            text += i == 0 ? "" : ", ";
            if (const auto* const word = std::get_if<std::string>(&record.values[i]))
                text += '"' + *word + '"';
            else if (const auto* const whole = std::get_if<std::int64_t>(&record.values[i]))
                text += std::to_string(*whole);
            else
                text += QByteArray::number(std::get<double>(record.values[i]), 'g', 17).toStdString();
        }
        if (!record.records.empty())
            text += " {\n ; a brace } in a comment\n" + textOf(record.records) + "}";
        text += '\n';
    }
    return text;
}

template <class Number> std::string rawBytes(Number number)
{
    return {reinterpret_cast<const char*>(&number), sizeof number}; // works on little-endian machines only
}

std::string sizeField(std::size_t size, bool isWide)
{
    return isWide ? rawBytes(static_cast<std::uint64_t>(size)) : rawBytes(static_cast<std::uint32_t>(size));
}

/// Returns the records in binary form. `at`: byte offset in the file at which they begin.
std::string binaryOf(std::span<const Record> records, std::size_t at, bool isWide)
{
    const std::size_t width = isWide ? 8 : 4;
    std::string bytes;
    for (const Record& record : records) {
        std::string values;
        for (const Record::Value& value : record.values) {
            if (const auto* const word = std::get_if<std::string>(&value))
                values += 'S' + rawBytes(static_cast<std::uint32_t>(word->size())) + *word;
            else if (const auto* const whole = std::get_if<std::int64_t>(&value))
                values += *whole > 100 ? 'L' + rawBytes(*whole) : 'I' + rawBytes(static_cast<std::int32_t>(*whole));
            else
                values += 'D' + rawBytes(std::get<double>(value));
        }
        const std::size_t head = 3 * width + 1 + record.name.size(), inner = at + bytes.size() + head + values.size();
        std::string below;
        if (!record.records.empty())
            below = binaryOf(record.records, inner, isWide) + std::string(3 * width + 1, '\0');
        bytes += sizeField(inner + below.size(), isWide) + sizeField(record.values.size(), isWide) +
                 sizeField(values.size(), isWide) + static_cast<char>(record.name.size()) + record.name + values +
                 below;
    }
    return bytes;
}

std::string fileOf(std::span<const Record> records, Form form)
{
    if (form == Form::Text)
        return "; FBX 7.4.0 project file\n" + textOf(records);
    const bool isWide = form == Form::WideBinary;
    const std::string head = std::string("Kaydara FBX Binary  \0\x1a\0", 23) + rawBytes(isWide ? 7500 : 7400);
    return head + binaryOf(records, head.size(), isWide) + std::string(isWide ? 25 : 13, '\0') + "footer";
}

Record vectorProperty(const char* name, const Vector3d& v)
{
    return {"P",
            {std::string(name), std::string("Vector3D"), std::string("Vector"), std::string(), v.x(), v.y(), v.z()}};
}

Record numberProperty(const char* name, std::int64_t value)
{
    return {"P", {std::string(name), std::string("int"), std::string(), std::string(), value}};
}

Record modelRecord(std::int64_t id, const std::vector<Record>& properties)
{
    return {"Model",
            {id, std::string("Model::m") + std::to_string(id), std::string("Mesh")},
            {{"Properties70", {}, properties}}};
}

std::vector<Record> sceneOf(const std::vector<Record>& models, const std::vector<Record>& connections,
                            const std::vector<Record>& usual = {})
{
    std::vector<Record> objects{{"Geometry", {std::int64_t(1000)}, {{"Vertices", {1.5}}}}};
    objects.insert(objects.end(), models.begin(), models.end());
    std::vector<Record> records{{"Creator", {std::string("a { brace")}}};
    if (!usual.empty())
        records.push_back({"Definitions",
                           {},
                           {{"ObjectType", {std::string("Geometry")}, {{"Count", {std::int64_t(1)}}}},
                            {"ObjectType",
                             {std::string("Model")},
                             {{"PropertyTemplate", {std::string("FbxNode")}, {{"Properties70", {}, usual}}}}}}});
    records.push_back({"Objects", {}, objects});
    records.push_back({"Connections", {}, connections});
    return records;
}

Record connection(std::int64_t child, std::int64_t parent)
{
    return {"C", {std::string("OO"), child, parent}};
}

std::string righted(const std::string& bytes)
{
    return app::fbxForAssimp("a.fbx", bytes).changed.value_or(bytes);
}

/// Returns a property of the records at `path`, each nested in the previous one.
std::optional<Vector3d> propertyIn(const std::string& bytes, std::initializer_list<std::string_view> path,
                                   std::string_view name)
{
    const auto records = app::fbxModelRecords(bytes);
    const std::vector<app::FbxRecord>* within = records ? &*records : nullptr;
    const app::FbxRecord* properties = nullptr;
    for (const std::string_view step : path) {
        properties = within ? app::recordIn(*within, step) : nullptr;
        within = properties ? &properties->records : nullptr;
    }
    if (!properties)
        return std::nullopt;
    for (const app::FbxRecord& p : properties->records)
        if (p.values.front().bytes == name)
            return Vector3d(p.values[4].number().value_or(0),
                            p.values.size() > 5 ? p.values[5].number().value_or(0) : 0,
                            p.values.size() > 6 ? p.values[6].number().value_or(0) : 0);
    return std::nullopt;
}

/// Returns a property of the first model in the file.
std::optional<Vector3d> propertyOf(const std::string& bytes, std::string_view name)
{
    return propertyIn(bytes, {"Objects", "Model", "Properties70"}, name);
}

constexpr std::array<const char*, 6> orderNames{"xyz", "xzy", "yzx", "yxz", "zxy", "zyx"};

/// Returns the rotation by the angles in degrees, in this order: "xyz" rotates about x first.
Eigen::Matrix3d turnBy(const Vector3d& degrees, const char* order)
{
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    for (const char* axis = order; *axis; ++axis)
        turn = Eigen::AngleAxisd(degrees[*axis - 'x'] * std::numbers::pi / 180, Vector3d::Unit(*axis - 'x')) * turn;
    return turn;
}

const std::array<Vector3d, 4> anglesTried{Vector3d(20, 40, 60), Vector3d(0, 90, 0), Vector3d(30, -90, 45),
                                          Vector3d(180, 10, -200)};
} // namespace

class TestFbxModels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void rotations_areRighted_data();
    void rotations_areRighted();
    void rotationsOfTheTemplate_areRighted();
    void rightFiles_areLeft();
    void models_areHandedOn();
    void connections_countOnce();
    void carelessText_isFollowed_data();
    void carelessText_isFollowed();
    void valuesWithoutComma_areFollowed();
    void nullRecords_arePassedOver();
    void byteTypes_areNamedAsKnown();
    void spheric_isRefusedWhereItTurns();
    void cycles_areRefused_data();
    void cycles_areRefused();
    void brokenFiles_areLeft();
};

void TestFbxModels::rotations_areRighted_data()
{
    QTest::addColumn<int>("form");
    QTest::addColumn<int>("order");
    for (const int form : {0, 1, 2})
        for (int order = 0; order < 6; ++order)
            QTest::addRow("%d %s", form, orderNames[static_cast<std::size_t>(order)]) << form << order;
}

/// The corrected geometric rotation, read in the model's order, must equal the original about x, y, z. With inactive
/// rotations the same applies to the model's own rotation.
void TestFbxModels::rotations_areRighted()
{
    QFETCH(int, form);
    QFETCH(int, order);
    const char* const name = orderNames[static_cast<std::size_t>(order)];
    enum Inactive { No, Own, ForLimits, ByTemplate };
    for (const Vector3d& angles : anglesTried)
        for (const Inactive inactive : {No, Own, ForLimits, ByTemplate}) {
            std::vector<Record> properties{
                vectorProperty("Lcl Rotation", angles), vectorProperty("PreRotation", {1, 2, 3}),
                vectorProperty("PostRotation", {4, 5, 6}), numberProperty("RotationOrder", order),
                vectorProperty("GeometricRotation", angles)};
            if (inactive == Own)
                properties.push_back(numberProperty("RotationActive", 0));
            if (inactive == ForLimits)
                properties.push_back(numberProperty("RotationSpaceForLimitOnly", 1));
            const std::vector<Record> usual{numberProperty("RotationActive", inactive == ByTemplate ? 0 : 1)};
            const std::string before =
                fileOf(sceneOf({modelRecord(500, properties)}, {connection(500, 0)}, usual), static_cast<Form>(form));
            const std::string after = righted(before);
            QVERIFY(app::fbxModelRecords(after));
            const auto is = [&](const char* property) { return propertyOf(after, property).value(); };
            QVERIFY(turnBy(is("GeometricRotation"), name).isApprox(turnBy(angles, "xyz"), 1e-9));
            if (inactive == No) {
                QVERIFY(is("Lcl Rotation") == angles && is("PreRotation") == Vector3d(1, 2, 3));
                QVERIFY(is("PostRotation") == Vector3d(4, 5, 6));
            } else {
                QVERIFY(turnBy(is("Lcl Rotation"), name).isApprox(turnBy(angles, "xyz"), 1e-9));
                QVERIFY(!app::fbxForAssimp("a.fbx", before).models[1].hasActiveRotations);
            }
            if (form != 0)
                // offsets in binary files are absolute, so the length must not change
                QCOMPARE(after.size(), before.size());
        }
}

/// Models without a property of their own share the template's value. It can be corrected if all need the same value.
void TestFbxModels::rotationsOfTheTemplate_areRighted()
{
    const auto rightedOf = [&](const std::vector<Record>& models, const std::vector<Record>& usual, Form form) {
        std::vector<Record> records = sceneOf(models, {connection(500, 0)}, usual);
        records[1].records.erase(records[1].records.begin()); // removes the template of geometry
        return righted(fileOf(records, form));
    };
    const auto usualIn = [](const std::string& bytes, const char* name) {
        return propertyIn(bytes, {"Definitions", "ObjectType", "PropertyTemplate", "Properties70"}, name).value();
    };
    const auto wordsOf = [&](const std::vector<Record>& models, const std::vector<Record>& usual) {
        try {
            rightedOf(models, usual, Form::Binary);
        } catch (const FileError& error) {
            return error.token;
        }
        return std::string();
    };
    for (const Form form : {Form::Text, Form::Binary, Form::WideBinary})
        for (const Vector3d& angles : anglesTried)
            for (const char* name : {"GeometricRotation", "Lcl Rotation"}) {
                const Record own = vectorProperty(name, {1, 2, 3}), usual = vectorProperty(name, angles),
                             off = numberProperty("RotationActive", 0), order = numberProperty("RotationOrder", 2);
                const std::string byModels =
                    rightedOf({modelRecord(500, {order}), modelRecord(501, {own}), modelRecord(502, {order})},
                              {usual, off}, form);
                QVERIFY(turnBy(usualIn(byModels, name), "yzx").isApprox(turnBy(angles, "xyz"), 1e-9));
                const std::string byTemplate = rightedOf({modelRecord(500, {})}, {usual, off, order}, form);
                QVERIFY(turnBy(usualIn(byTemplate, name), "yzx").isApprox(turnBy(angles, "xyz"), 1e-9));
                const std::string words = wordsOf({modelRecord(500, {order}), modelRecord(501, {})}, {usual, off});
                QVERIFY(turnBy(angles, "yzx").isApprox(turnBy(angles, "xyz"), 1e-9) ||
                        words.starts_with("a rotation of the template"));
            }
    std::vector<Record> all;
    for (int order = 0; order < 6; ++order)
        all.push_back(modelRecord(500 + order, {numberProperty("RotationOrder", order)}));
    QCOMPARE(wordsOf(all, {vectorProperty("GeometricRotation", Vector3d::Zero())}), std::string());
    const Record spheric = numberProperty("RotationOrder", 6);
    const std::string plain =
        rightedOf({modelRecord(500, {vectorProperty("GeometricRotation", {1, 2, 3})})}, {spheric}, Form::Binary);
    QVERIFY(usualIn(plain, "RotationOrder").isZero(0) && propertyOf(plain, "GeometricRotation") == Vector3d(1, 2, 3));
    QCOMPARE(wordsOf({modelRecord(500, {vectorProperty("Lcl Rotation", {1, 2, 3})})}, {spheric}),
             std::string("the rotation order SphericXYZ is not read"));
    QCOMPARE(wordsOf({}, {vectorProperty("GeometricRotation", Vector3d(0, NAN, 0))}), std::string("GeometricRotation"));
}

void TestFbxModels::rightFiles_areLeft()
{
    for (const Form form : {Form::Text, Form::Binary, Form::WideBinary}) {
        const std::vector<Record> properties{vectorProperty("Lcl Rotation", {1, 2, 3}),
                                             vectorProperty("GeometricRotation", {4, 5, 6}),
                                             vectorProperty("PreRotation", {7, 8, 9})};
        std::vector<Record> ordered{vectorProperty("Lcl Rotation", {1, 2, 3}), numberProperty("RotationOrder", 4)};
        const auto isRight = [form](const std::vector<Record>& records) {
            const app::FbxForAssimp fbx = app::fbxForAssimp("a.fbx", fileOf(records, form));
            return fbx.isFollowed && !fbx.changed;
        };
        QVERIFY(isRight(sceneOf({modelRecord(500, properties), modelRecord(501, ordered)},
                                {connection(500, 0), connection(501, 500)})));
        ordered.push_back(numberProperty("RotationOrder", 3)); // a repeated property has no effect
        QVERIFY(isRight(sceneOf({modelRecord(500, ordered)}, {connection(500, 0)})));
    }
    for (const char* text :
         {"", ";", "x", "Objects: {\n}\n", "Objects: {\n", "}", "a: \"", "Objects: 1, {\nModel: {\n}\n}\n"})
        QVERIFY(!app::fbxForAssimp("a.fbx", text).changed);
}

/// Missing properties of a model come from the template of its type. The scene is the first model, and children are in
/// the order of connections.
void TestFbxModels::models_areHandedOn()
{
    using Inherit = app::FbxModel::Inherit;
    const std::vector<Record> usual{numberProperty("InheritType", 0), numberProperty("RotationActive", 0),
                                    vectorProperty("Lcl Scaling", {4, 5, -6})},
        own{numberProperty("InheritType", 2), numberProperty("RotationActive", 1),
            vectorProperty("Lcl Scaling", {-1, 2, 3})};
    for (const Form form : {Form::Text, Form::Binary, Form::WideBinary}) {
        const std::vector<app::FbxModel> models =
            app::fbxForAssimp("a.fbx",
                              fileOf(sceneOf({modelRecord(500, {}), modelRecord(501, own)},
                                             {connection(501, 0), connection(500, 0), connection(500, 501)}, usual),
                                     form))
                .models;
        QCOMPARE(models.size(), std::size_t(3));
        QVERIFY(models[0].below == std::vector<std::size_t>({2, 1}) && models[0].name.empty());
        QVERIFY(models[1].below.empty() && models[2].below == std::vector<std::size_t>{1});
        QVERIFY(models[1].scale == Vector3d(4, 5, -6) && models[2].scale == Vector3d(-1, 2, 3));
        QVERIFY(models[1].inherit == Inherit::ComponentWise && models[2].inherit == Inherit::WithoutParents);
        QVERIFY(!models[1].hasActiveRotations && models[2].hasActiveRotations);
        QVERIFY(models[1].name == "m500" && models[2].name == "m501");
        const auto bare =
            app::fbxForAssimp("a.fbx", fileOf(sceneOf({modelRecord(500, {})}, {connection(500, 0)}), form)).models[1];
        QVERIFY(bare.scale == Vector3d::Ones() && bare.inherit == Inherit::Usual && bare.hasActiveRotations);
    }
    // two connections to properties, one of them without a property name
    Record nameless = connection(500, 0), named = nameless;
    nameless.values[0] = named.values[0] = std::string("OP");
    nameless.values.emplace_back(std::string());
    named.values.emplace_back(std::string("Visibility"));
    const std::vector<Record> scene = sceneOf({modelRecord(500, {}), modelRecord(501, {})}, {nameless, named});
    for (const Form form : {Form::Text, Form::Binary, Form::WideBinary})
        QVERIFY(app::fbxForAssimp("a.fbx", fileOf(scene, form)).models[0].below == std::vector<std::size_t>{1});
    for (const auto& [is, wanted] : {std::pair(std::string("a\0\1Model", 8), "a"),
                                     {std::string("a::b\0\1Model", 11), "a::b"},
                                     {std::string("a\0\1Null", 7), "Null::a"}}) {
        Record model = modelRecord(500, {});
        model.values[1] = is;
        QCOMPARE(app::fbxForAssimp("a.fbx", fileOf(sceneOf({model}, {}), Form::Binary)).models[1].name,
                 std::string(wanted));
    }
}

/// Repeated connections and connections of unknown kinds are changed so that Assimp ignores them.
void TestFbxModels::connections_countOnce()
{
    const auto as = [](const char* kind, Record connection, std::vector<std::string> more = {}) {
        connection.values[0] = std::string(kind);
        connection.values.insert(connection.values.end(), more.begin(), more.end());
        return connection;
    };
    const Record geometry{"Geometry",
                          {std::int64_t(700), std::string("Geometry::g"), std::string("Mesh")},
                          {{"PolygonVertexIndex", {std::string("*3")}}}};
    const std::vector<Record> objects{geometry, modelRecord(500, {}), modelRecord(501, {})},
        once{connection(500, 0), as("OP", connection(501, 500), {""}), connection(700, 501),
             as("OP", connection(500, 501), {"Look"})};
    for (const Form form : {Form::Text, Form::Binary, Form::WideBinary}) {
        std::vector<Record> lines = once, wanted = once;
        for (const Record& again : {as("OP", connection(500, 0), {""}), connection(501, 500), connection(700, 501),
                                    as("PO", connection(500, 501), {"x"}), as("ab", connection(700, 500))}) {
            lines.push_back(again);
            wanted.push_back(again);
            wanted.back().values[0] = std::string("PP");
        }
        const app::FbxForAssimp fbx = app::fbxForAssimp("a.fbx", fileOf(sceneOf(objects, lines), form));
        QVERIFY(fbx.changed == fileOf(sceneOf(objects, wanted), form));
        QCOMPARE(fbx.models.size(), std::size_t(3));
        QVERIFY(fbx.models[0].below == std::vector<std::size_t>{1} && fbx.models[2].meshes == 1);
        QVERIFY(fbx.models[1].below == std::vector<std::size_t>{2} && fbx.models[1].meshes == 0);
        QVERIFY(!app::fbxForAssimp("a.fbx", fileOf(sceneOf(objects, once), form)).changed);
    }
}

/// Tests unusual text files that Assimp accepts.
void TestFbxModels::carelessText_isFollowed_data()
{
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::newRow("as it is") << QByteArray("\n") << QByteArray("\n");
    QTest::newRow("CR") << QByteArray("\n") << QByteArray("\r");
    QTest::newRow("CRLF") << QByteArray("\n") << QByteArray("\r\n");
    QTest::newRow("form feed") << QByteArray("\n") << QByteArray("\f");
    QTest::newRow("comments") << QByteArray(",") << QByteArray(",;{\"}:\n");
    QTest::newRow("a comma too many") << QByteArray(",") << QByteArray(" ,,");
    QTest::newRow("lines within") << QByteArray(",") << QByteArray("\n,\n");
    QTest::newRow("a brace too many") << QByteArray("Connections: ") << QByteArray("Connections: 1, ");
}

void TestFbxModels::carelessText_isFollowed()
{
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    const std::vector<Record> properties{numberProperty("RotationOrder", 5),
                                         vectorProperty("GeometricRotation", {10, 20, 30})};
    const QByteArray text =
        QByteArray::fromStdString(fileOf(sceneOf({modelRecord(500, properties)}, {connection(500, 0)}), Form::Text));
    const QByteArray careless = QByteArray(text).replace(from, to) + "}\nObjects: {";
    const app::FbxForAssimp fbx = app::fbxForAssimp("a.fbx", careless.toStdString());
    QVERIFY(fbx.isFollowed && fbx.changed);
    const auto turn = propertyOf(*fbx.changed, "GeometricRotation");
    QVERIFY(turn && turnBy(*turn, "zyx").isApprox(turnBy({10, 20, 30}, "xyz"), 1e-9));
    // A cycle of the models must be refused.
    const QByteArray cycle = QByteArray(text).replace(
        R"(C: "OO", 500, 0)", "C: \"OO\", 500, 0\n\tC: \"OO\", 501, 500\n\tC: \"OO\", 500, 500");
    QVERIFY_THROWS_EXCEPTION(FileError,
                             app::fbxForAssimp("a.fbx", (QByteArray(cycle).replace(from, to) + "}").toStdString()));
}

/// Tests values without commas across lines, and text that Assimp refuses.
void TestFbxModels::valuesWithoutComma_areFollowed()
{
    const auto isFollowed = [](const char* text) { return app::fbxModelRecords(text).has_value(); };
    QVERIFY(isFollowed("Objects: {\nModel: 1,\n2\n3\n {\n}\n}\n"));
    QVERIFY(isFollowed("Objects: {\nModel: 1\n2\n {\n}\n}\n"));
    QVERIFY(isFollowed("Objects: {\n}\n\0Model \"{"));
    for (const char* text :
         {"Objects: {\nModel: 1,\n2\n3 {\n}\n}\n", "Objects: {\nModel: 1 2 {\n}\n}\n",
          "Objects: {\nModel : 1, {\n}\n}\n", "Objects: 1", "Objects: {\n", "Objects: {\nModel: a\"b\" {\n}\n}\n",
          "Objects: {} {}", "1: {} 2\n", "{", "Objects: {\nModel: {\n}\n", "Objects: \"{\n"})
        QVERIFY2(!isFollowed(text), text);
}

/// Tests binary null records, which only Assimp's reader would accept.
void TestFbxModels::nullRecords_arePassedOver()
{
    const std::vector<Record> properties{numberProperty("RotationOrder", 5),
                                         vectorProperty("GeometricRotation", {10, 20, 30})};
    for (const Form form : {Form::Binary, Form::WideBinary}) {
        const bool isWide = form == Form::WideBinary;
        const std::size_t width = isWide ? 8 : 4;
        const std::vector<Record> below{modelRecord(500, properties)};
        const std::string head = std::string("Kaydara FBX Binary..\0\x1a\0", 23) + rawBytes(isWide ? 7500 : 7400);
        const std::size_t inner = head.size() + 3 * width + 1 + 7;
        const std::string within =
            std::string(width, '\0') + binaryOf(below, inner + width, isWide) + std::string(3 * width + 1, '\0');
        const std::string bytes = head + sizeField(inner + within.size(), isWide) + sizeField(0, isWide) +
                                  sizeField(0, isWide) + "\7Objects" + within + std::string(width, '\0');
        const app::FbxForAssimp fbx = app::fbxForAssimp("a.fbx", bytes);
        QVERIFY(fbx.isFollowed && fbx.changed);
    }
}

/// Maya writes the byte type "Z" deep in its sounds. A "Z" in a text is not a type.
void TestFbxModels::byteTypes_areNamedAsKnown()
{
    const std::int64_t marker = 1717986918; // a 64-bit integer whose bytes are then overwritten by further values
    std::vector<Record> records = sceneOf({modelRecord(500, {vectorProperty("Z", {1, 2, 3})})}, {connection(500, 0)});
    records.push_back({"Sound", {std::string("Z")}, {{"Z", {std::string("ZZ")}, {{"Mute", {marker, marker}}}}}});
    for (const Form form : {Form::Binary, Form::WideBinary}) {
        std::string bytes = fileOf(records, form);
        QVERIFY(app::fbxByteTypes(bytes).empty() && !app::fbxForAssimp("a.fbx", bytes).changed);
        const std::size_t at = bytes.find('L' + rawBytes(marker) + 'L' + rawBytes(marker));
        QVERIFY(at != std::string::npos);
        bytes.replace(at, 9, std::string("S\4\0\0\0four", 9)).replace(at + 9, 9, std::string("S\4\0\0\0four", 9));
        QVERIFY(!app::fbxForAssimp("a.fbx", bytes).changed);
        bytes.replace(at, 9, std::string("S\2\0\0\0ZZZ\1", 9)); // a text of two letters, then a value of type Z
        QVERIFY(app::fbxForAssimp("a.fbx", bytes).isFollowed);
        QVERIFY(app::fbxByteTypes(bytes) == std::vector<std::size_t>{at + 7});
        QCOMPARE(righted(bytes), std::string(bytes).replace(at + 7, 1, "C"));
    }
    QVERIFY(app::fbxByteTypes(fileOf(records, Form::Text)).empty());
}

void TestFbxModels::spheric_isRefusedWhereItTurns()
{
    const auto tried = [](const std::vector<Record>& properties) -> std::string {
        try {
            return righted(fileOf(sceneOf({modelRecord(500, properties)}, {connection(500, 0)}), Form::Binary));
        } catch (const FileError& error) {
            return error.kind == core::FileErrorKind::ReaderRefused ? error.token : "?";
        }
    };
    const Record spheric = numberProperty("RotationOrder", 6), turn = vectorProperty("Lcl Rotation", {10, 0, 0});
    QCOMPARE(tried({spheric, turn}), std::string("the rotation order SphericXYZ is not read"));
    for (const std::vector<Record>& properties : {std::vector{spheric},
                                                  {spheric, vectorProperty("Lcl Rotation", Vector3d::Zero())},
                                                  {spheric, turn, numberProperty("RotationActive", 0)}}) {
        const auto order = propertyOf(tried(properties), "RotationOrder");
        QVERIFY(order && order->isZero(0));
    }
    // Assimp treats order 7 as XYZ
    QVERIFY(propertyOf(tried({numberProperty("RotationOrder", 7), turn}), "RotationOrder")->x() == 7);
}

void TestFbxModels::cycles_areRefused_data()
{
    QTest::addColumn<QList<QPair<int, int>>>("connections"); // pairs of child id and parent id
    QTest::addColumn<QByteArray>("token");                   // token of the refusal; empty: the file is read
    using Pairs = QList<QPair<int, int>>;
    QTest::newRow("itself") << Pairs{{500, 0}, {500, 500}} << QByteArray("models below m500");
    QTest::newRow("two") << Pairs{{500, 0}, {501, 500}, {500, 501}} << QByteArray("models below m500");
    QTest::newRow("three, below") << Pairs{{500, 0}, {501, 500}, {502, 501}, {503, 502}, {501, 503}}
                                  << QByteArray("models below m501");
    QTest::newRow("not in the scene") << Pairs{{500, 0}, {501, 502}, {502, 501}} << QByteArray();
    QTest::newRow("two parents") << Pairs{{500, 0}, {501, 500}, {502, 500}, {503, 501}, {503, 502}} << QByteArray();
    QTest::newRow("unknown models") << Pairs{{7, 0}, {500, 7}, {7, 500}, {0, 0}} << QByteArray();
    Pairs deep{{500, 0}}, tooDeep{{500, 0}};
    for (int i = 1; i < 6000; ++i)
        (i < 4000 ? deep : tooDeep).append({500 + i, 500 + i - 1});
    QTest::newRow("deep") << deep << QByteArray();
    QTest::newRow("too deep") << deep + tooDeep << QByteArray("models below m4596");
    // The end of a long chain is first reached by a short path, then by the long one.
    Pairs shortcut{{500, 0}}, allowed{{500, 0}};
    for (const auto& [pairs, length] : {std::pair(&shortcut, 4100), std::pair(&allowed, 4095)}) {
        pairs->append({500 + length / 2, 500});
        for (int i = 1; i < length; ++i)
            pairs->append({500 + i, 500 + i - 1});
    }
    QTest::newRow("too deep by the longer way") << shortcut << QByteArray("models below m2550");
    QTest::newRow("deep by the longer way") << allowed << QByteArray();
    Pairs many;
    for (int i = 0; i < 40; ++i)
        many << qMakePair(500 + i, i == 0 ? 0 : 499 + i) << qMakePair(500 + i, i == 0 ? 0 : 499 + i);
    QTest::newRow("doubled 40 times") << many << QByteArray(); // must end in time; the memory limit is tested elsewhere
}

void TestFbxModels::cycles_areRefused()
{
    using Pairs = QList<QPair<int, int>>;
    QFETCH(Pairs, connections);
    QFETCH(QByteArray, token);
    std::vector<Record> models, lines;
    for (int i = 0; i < (connections.size() > 1000 ? 6000 : 50); ++i)
        models.push_back(modelRecord(500 + i, {}));
    for (const auto& [child, parent] : connections)
        lines.push_back(connection(child, parent));
    for (const Form form : {Form::Text, Form::Binary, Form::WideBinary}) {
        std::string problem;
        try {
            app::fbxForAssimp("a.fbx", fileOf(sceneOf(models, lines), form));
        } catch (const FileError& error) {
            QVERIFY(error.kind == core::FileErrorKind::Malformed && error.fault == core::FileFault::TooDeep);
            problem = error.token;
        }
        QCOMPARE(problem, token.toStdString());
    }
}

/// Truncated or corrupted files that cannot be parsed are left unchanged, so that Assimp refuses them.
void TestFbxModels::brokenFiles_areLeft()
{
    std::mt19937 engine(fbxSeed);
    const std::vector<Record> properties{vectorProperty("Lcl Rotation", {1, 2, 3}), numberProperty("RotationOrder", 4),
                                         vectorProperty("GeometricRotation", {4, 5, 6})};
    for (const Form form : {Form::Text, Form::Binary, Form::WideBinary}) {
        const std::string whole = fileOf(
            sceneOf({modelRecord(500, properties)}, {connection(500, 0)}, {numberProperty("RotationActive", 0)}), form);
        for (std::size_t size = 0; size < whole.size(); ++size) {
            const std::vector<char> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
            app::fbxModelRecords({cut.data(), cut.size()});
        }
        for (int round = byEffort(2000, 20000, 200000); round > 0; --round) {
            std::string bytes = whole;
            for (auto edits = 1 + engine() % 4; edits != 0; --edits)
                bytes[engine() % bytes.size()] = static_cast<char>(engine() % 3 == 0 ? 0 : engine());
            try {
                app::fbxForAssimp("a.fbx", bytes);
            } catch (const FileError&) {
            }
        }
    }
}

FETTLE_TEST(TestFbxModels)
#include "tst_fbx_models.moc"
