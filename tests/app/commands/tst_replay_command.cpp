// Tests the content of stroke files: strokes with every tool and mode, and commands for the whole model.
#include "app/model/model_loader.h"
#include "core/analysis/mesh_check.h"
#include "core/analysis/surface_distance.h"
#include "core/geometry/face_geometry.h"
#include "core/io/mesh_io.h"
#include "core/operations/model_command.h"
#include "core/primitives/starter_models.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <nlohmann/json.hpp>

#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <functional>

using core::Vec3;
using Json = nlohmann::json;

namespace
{
const Json pullAtX = {{"tool", "pull"}, {"radius", 0.3}, {"samples", {{{"position", {1, 0, 0}}}}}};

/// Runs `fettle replay` as a script does.
class Replay
{
public:
    QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }

    /// Plays the entries on the model `in`, or on the paper's sphere if it is empty. Returns the exit status.
    int operator()(const Json& entries, const QString& in = {})
    {
        QFile file(path("strokes.json"));
        if (!file.open(QIODevice::WriteOnly))
            return -1;
        file.write(Json{{"format", "fettle-strokes"}, {"version", 1}, {"strokes", entries}}.dump().c_str());
        file.close();
        QProcess program;
        QStringList arguments{
            QStringLiteral("replay"), QStringLiteral("--strokes"), path("strokes.json"), QStringLiteral("--out"),
            path("out.ply"),          QStringLiteral("--stats"),   path("stats.json")};
        if (!in.isEmpty())
            arguments << QStringLiteral("--in") << in;
        program.start(QStringLiteral(FETTLE_PROGRAM), arguments);
        if (!program.waitForFinished(-1) || program.exitStatus() != QProcess::NormalExit)
            return -1;
        complaint = program.readAllStandardError();
        return program.exitCode();
    }

    Json stats() const
    {
        QFile file(path("stats.json"));
        return file.open(QIODevice::ReadOnly) ? Json::parse(file.readAll().toStdString()) : Json();
    }

    int on(const core::TriangleMesh& model, const std::vector<Json>& entries)
    {
        core::writeMesh(path("model.ply").toStdString(), model);
        return (*this)(Json(entries), path("model.ply"));
    }
    core::TriangleMesh result() const { return core::readMesh(path("out.ply").toStdString()); }
    core::Box box() const { return core::boxOf(result()); }

    QByteArray complaint;

private:
    QTemporaryDir m_folder;
};

/// Returns a ball deformed asymmetrically in all axes. Its coordinates are multiples of 2^-12, which files store
/// exactly at all places used here.
core::TriangleMesh potato(const Vec3& middle)
{
    core::TriangleMesh mesh = core::icosphere(4, 0.8);
    for (core::Vec3f& p : mesh.points) {
        const Vec3 q = p.cast<double>();
        const double r = 1 + 0.1 * q.x() + 0.06 * q.y() * q.x() - 0.08 * q.z() * q.y();
        p = core::Lattice(12).snap(r * q + middle);
    }
    return mesh;
}

using Turned = std::function<Vec3(const Vec3&)>;

/// Checks that `mesh`, moved by -`shift`, is at most 2e-3 from `other`: the precision of two lattices and of float32
/// far from the origin.
#define VERIFY_ALIKE(mesh, other, shift)                                                                               \
    do {                                                                                                               \
        core::TriangleMesh back = mesh;                                                                                \
        for (core::Vec3f & p : back.points)                                                                            \
            p = (p.cast<double>() - (shift)).cast<float>();                                                            \
        const double there = core::distanceFrom(back, other).largest, here = core::distanceFrom(other, back).largest;  \
        QVERIFY2(std::max(there, here) < 2e-3, qPrintable(QStringLiteral("%1, %2").arg(there).arg(here)));             \
    } while (false)

void sculpt(core::Sculptor& sculptor)
{
    core::StrokeSettings settings;
    settings.radius = 0.3;
    core::StrokeSample sample;
    sample.position = {1, 0, 0};
    sculptor.beginStroke(settings);
    sculptor.addSample(sample);
    sculptor.endStroke();
}
} // namespace

class TestReplayCommand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyToolAndMode_isPlayed();
    void commands_doWhatTheyDoInCore_data();
    void commands_doWhatTheyDoInCore();
    void inserted_isSoughtBesideTheStrokeFile();
    void primitives_areCombined();
    void shapes_areSoughtBesideTheStrokeFile();
    void badShapes_areBadInput_data();
    void badShapes_areBadInput();
    void refused_isTheAnswerNo();
    void strokesAfterACommand_areCheckedAgainstItsModel();
    void modelFarFromTheOrigin_isPlayedWhereItIs();
    void farModel_isTheNearOneShifted_data();
    void farModel_isTheNearOneShifted();
    void farModel_keepsTheFilesPlanes_data();
    void farModel_keepsTheFilesPlanes();
    void farModel_isToldInItsFilesCoordinates();
    void document_keepsItsOwnCoordinates();
    void check_saysWhatCanBeSculpted();
};

/// Plays each tool and mode at a separate place of the sphere, then adds a ball beside it.
void TestReplayCommand::everyToolAndMode_isPlayed()
{
    Json entries = Json::array();
    for (const std::string_view tool : core::toolNames()) {
        for (const char* brush : {"sphere", "ray"}) {
            for (const char* topology : {"adaptive", "uniform"}) {
                for (const char* symmetry : {"none", "x", "y", "z"}) {
                    const double angle = 0.4 * static_cast<double>(entries.size());
                    const Json sample = {{"position", {2 * std::cos(angle), 0.3, 2 * std::sin(angle)}},
                                         {"direction", {-std::cos(angle), -0.15, -std::sin(angle)}}};
                    entries.push_back({{"tool", tool},
                                       {"brush", brush},
                                       {"topology", topology},
                                       {"symmetry", symmetry},
                                       {"place", "ray"},
                                       {"radius", 0.25},
                                       {"strength", 0.5},
                                       {"color", {10, 20, 30}},
                                       {"samples", {sample}}});
                }
            }
        }
    }
    entries.push_back({{"tool", "pull"}, {"radius", 0.3}, {"add", true}, {"samples", {{{"position", {0, 2, 0}}}}}});
    std::array<Json, 2> stats;
    for (Json& each : stats) {
        Replay replay;
        QVERIFY2(replay(entries) == 0, replay.complaint.constData());
        each = replay.stats();
        // the sphere's lattice, which is finer than the one that suits the file's extent
        const core::Lattice lattice = core::Lattice::forExtent(1);
        const auto mesh = mesh_asserts::sculptable(core::readMesh(replay.path("out.ply").toStdString()), lattice);
        VERIFY_VALID(*mesh);
    }
    const Json& dabs = stats[0]["dabs"];
    QCOMPARE(dabs.size(), entries.size());
    for (std::size_t i = 0; i < dabs.size(); ++i) {
        // deep stamps across the results of earlier strokes may need fallback steps
        if (entries[i]["tool"] == "stamp" && dabs[i]["outcome"] != "committed") {
            QVERIFY2(dabs[i]["outcome"] == "careful" || dabs[i]["capped"] == true,
                     (entries[i].dump() + dabs[i].dump()).c_str());
            continue;
        }
        QVERIFY2(dabs[i]["outcome"] == (i + 1 < dabs.size() ? "committed" : "added"),
                 (entries[i].dump() + dabs[i].dump()).c_str());
    }
    QCOMPARE(stats[0]["components"].get<int>(), 2);
    QVERIFY(stats[0]["mesh_hash"] == stats[1]["mesh_hash"]);
}

void TestReplayCommand::commands_doWhatTheyDoInCore_data()
{
    QTest::addColumn<QByteArray>("entry");
    QTest::addColumn<core::ModelCommand>("command");
    const auto row = [](const Json& entry, const core::ModelCommand& command) {
        QTest::newRow(entry["command"].get<std::string>().c_str())
            << QByteArray::fromStdString(entry.dump()) << command;
    };
    row({{"command", "move"}, {"by", {0.5, 0.25, -1}}}, core::Move{{0.5, 0.25, -1}});
    row({{"command", "rotate"}, {"rotation", {0, 0.6, 0, 0.8}}}, core::Rotate{Eigen::Quaterniond(0.8, 0, 0.6, 0)});
    row({{"command", "scale"}, {"factor", 3}}, core::Scale{3});
    row({{"command", "transform"},
         {"centre", {1, 0, 0.5}},
         {"by", {0, 0.25, 0}},
         {"rotation", {0.6, 0, 0, 0.8}},
         {"scale", {1, 2, 0.5}},
         {"scale_axes", {0, 0.6, 0, 0.8}}},
        core::Transform{{1, 0, 0.5},
                        {0, 0.25, 0},
                        Eigen::Quaterniond(0.8, 0.6, 0, 0),
                        {1, 2, 0.5},
                        Eigen::Quaterniond(0.8, 0, 0.6, 0)});
    row({{"command", "mirror"}, {"plane", "x"}}, core::Mirror{0});
    row({{"command", "recentre"}}, core::Recentre{});
    row({{"command", "fill"}, {"color", {1, 2, 3}}}, core::Fill{{1, 2, 3}});
    row({{"command", "mask"}, {"how", "cavity"}}, core::MaskOperation{core::MaskOperation::Kind::Cavity});
    row({{"command", "remesh"}, {"detail_length", 0.2}}, core::RemeshUniformly{0.2});
    row({{"command", "symmetrize"}, {"plane", "x"}, {"keep", "negative"}},
        core::Symmetrize{core::Symmetry::X, core::Half::Negative});
    row({{"command", "reset"}}, core::Reset{});
}

/// Plays a command between two dabs, so that the engine sculpts the model that the command produced.
void TestReplayCommand::commands_doWhatTheyDoInCore()
{
    QFETCH(QByteArray, entry);
    QFETCH(core::ModelCommand, command);
    const app::LoadedModel model = app::ModelLoader::sphere(1);
    const auto& sculptor = model.sculptor;
    if (auto* const reset = std::get_if<core::Reset>(&command))
        reset->start = model.start;
    sculpt(*sculptor);
    core::ModelChange change = core::applyToCopy(sculptor->mesh(), command);
    QVERIFY(change.changes);
    sculptor->swap(change.delta);
    sculpt(*sculptor);
    VERIFY_VALID(sculptor->mesh());

    const Json entries = {pullAtX, Json::parse(entry.toStdString()), pullAtX};
    std::array<std::string, 2> hashes;
    for (std::string& hash : hashes) {
        Replay replay;
        QVERIFY2(replay(entries) == 0, replay.complaint.constData());
        hash = replay.stats()["mesh_hash"];
    }
    QCOMPARE(hashes[0], hashes[1]);
    QCOMPARE(QString::fromStdString(hashes[0]),
             QStringLiteral("%1").arg(sculptor->mesh().meshHash(), 16, 16, QLatin1Char('0')));
}

void TestReplayCommand::inserted_isSoughtBesideTheStrokeFile()
{
    Replay replay;
    core::writeMesh(replay.path("other.ply").toStdString(), core::icosphere(2, 0.5));
    QVERIFY2(replay(Json::array(
                 {{{"command", "insert"}, {"file", "other.ply"}, {"where", "centre"}, {"centre", {0, 3, 0}}}})) == 0,
             replay.complaint.constData());
    QCOMPARE(replay.stats()["components"].get<int>(), 2);
    const auto mesh = mesh_asserts::sculptable(core::readMesh(replay.path("out.ply").toStdString()));
    VERIFY_VALID(*mesh);
    QCOMPARE(replay(Json::array({{{"command", "insert"}, {"file", "missing.ply"}}})), 2);
    QVERIFY(replay.complaint.contains("missing.ply"));
}

void TestReplayCommand::primitives_areCombined()
{
    Replay replay;
    const Json middle = {{"where", "centre"}, {"centre", {0, 0, 0}}};
    Json hole = {{"command", "insert"}, {"primitive", "cylinder"}, {"radius", 0.3}, {"height", 3},
                 {"axis", "x"},         {"combine", "subtract"}};
    hole.update(middle);
    QVERIFY2(replay(Json::array({hole})) == 0, replay.complaint.constData());
    const core::MeshReport drilled = core::checkMesh(core::readMesh(replay.path("out.ply").toStdString()));
    QVERIFY(drilled.printReady());
    QCOMPARE(drilled.genus, 1);
    Json all = {{"command", "insert"}, {"primitive", "ball"}, {"radius", 5}, {"combine", "subtract"}};
    all.update(middle);
    QCOMPARE(replay(Json::array({all})), 1);
    QVERIFY2(replay.complaint.contains("nothing of it would be left"), replay.complaint.constData());
    const Json bad = {{"command", "insert"}, {"primitive", "torus"}, {"radius", 1}, {"tube_radius", 2}};
    QCOMPARE(replay(Json::array({bad})), 1);
    QVERIFY2(replay.complaint.contains("larger than the radius of its tube"), replay.complaint.constData());
    core::writeMesh(replay.path("other.ply").toStdString(), core::icosphere(2, 0.5));
    QCOMPARE(replay(Json::array({{{"command", "insert"},
                                  {"file", "other.ply"},
                                  {"where", "floor"},
                                  {"centre", {0, 0.5, 0}},
                                  {"combine", "join"}}})),
             0);
    const core::MeshReport joined = core::checkMesh(core::readMesh(replay.path("out.ply").toStdString()));
    QVERIFY(joined.printReady());
    QCOMPARE(joined.components, std::size_t(1));
    QVERIFY(std::abs(joined.size.y() - 2.5) < 0.01);
}

void TestReplayCommand::shapes_areSoughtBesideTheStrokeFile()
{
    Replay replay;
    QImage bright(8, 8, QImage::Format_Grayscale8), dim = bright;
    bright.fill(255), dim.fill(60);
    QVERIFY(bright.save(replay.path("bright.png")) && dim.save(replay.path("dim.png")));
    core::writeMesh(replay.path("brush.ply").toStdString(), core::starterModel(core::Starter::Torus));
    const auto hashWith = [&](const Json& more) {
        Json stroke = pullAtX;
        stroke.update(more);
        return replay(Json::array({stroke})) == 0 ? replay.stats()["mesh_hash"].get<std::string>() : std::string();
    };
    const std::string strong = hashWith({{"alpha", "bright.png"}}), weak = hashWith({{"alpha", "dim.png"}});
    QVERIFY2(!strong.empty() && !weak.empty() && strong != weak, replay.complaint.constData());
    QCOMPARE(hashWith({{"alpha", replay.path("bright.png").toStdString()}}), strong);
    const std::string ball = hashWith({{"tool", "stamp"}}),
                      torus = hashWith({{"tool", "stamp"}, {"model", "brush.ply"}});
    QVERIFY2(!ball.empty() && !torus.empty() && ball != torus, replay.complaint.constData());
    const auto mesh = mesh_asserts::sculptable(core::readMesh(replay.path("out.ply").toStdString()));
    VERIFY_VALID(*mesh);
    QCOMPARE(
        hashWith({{"tool", "stamp"}, {"model", "brush.ply"}, {"add", true}, {"samples", {{{"position", {0, 3, 0}}}}}})
            .size(),
        std::size_t(16));
    QCOMPARE(replay.stats()["genus"].get<int>(), 1);
}

void TestReplayCommand::badShapes_areBadInput_data()
{
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<QByteArray>("value");
    QTest::addColumn<QByteArray>("reason");
    QTest::newRow("no such alpha") << QByteArray("alpha") << QByteArray("spots")
                                   << QByteArray("none of pores, scales,");
    QTest::newRow("no image") << QByteArray("alpha") << QByteArray("text.png") << QByteArray("not an image");
    QTest::newRow("changed") << QByteArray("alpha") << QByteArray("white.png") << QByteArray("has changed since");
    QTest::newRow("no such model") << QByteArray("model") << QByteArray("none.stl") << QByteArray("none.stl");
    QTest::newRow("open model") << QByteArray("model") << QByteArray("open.ply") << QByteArray("open edges: 3");
    QTest::newRow("no model") << QByteArray("model") << QByteArray("text.png") << QByteArray("text.png");
}

/// Bad shapes are refused with status 2 and one line that names the stroke, and nothing is written.
void TestReplayCommand::badShapes_areBadInput()
{
    QFETCH(QByteArray, key);
    QFETCH(QByteArray, value);
    QFETCH(QByteArray, reason);
    Replay replay;
    QImage white(2, 2, QImage::Format_Grayscale8);
    white.fill(255);
    QVERIFY(white.save(replay.path("white.png")));
    QFile text(replay.path("text.png"));
    QVERIFY(text.open(QIODevice::WriteOnly) && text.write("no image") > 0);
    text.close();
    core::TriangleMesh open = core::icosphere(2, 1);
    open.triangles.pop_back();
    core::writeMesh(replay.path("open.ply").toStdString(), open);
    Json stroke = pullAtX;
    stroke[key.toStdString()] = value.toStdString();
    stroke[key.toStdString() + "_hash"] = "0000000000000000";
    QCOMPARE(replay(Json::array({pullAtX, stroke})), 2);
    QVERIFY2(replay.complaint.contains("strokes[1]") && replay.complaint.contains(reason) &&
                 replay.complaint.count('\n') == 1,
             replay.complaint.constData());
    QVERIFY(!QFile::exists(replay.path("out.ply")));
}

void TestReplayCommand::refused_isTheAnswerNo()
{
    Replay replay;
    core::writeMesh(replay.path("same.ply").toStdString(), core::icosphere(4, 1));
    QCOMPARE(replay(Json::array({pullAtX, {{"command", "insert"}, {"file", "same.ply"}, {"where", "as_it_is"}}})), 1);
    QVERIFY2(replay.complaint.contains("strokes[1]") && replay.complaint.contains("same.ply"),
             replay.complaint.constData());
    QVERIFY(!QFile::exists(replay.path("out.ply")) && !QFile::exists(replay.path("stats.json")));
}

void TestReplayCommand::strokesAfterACommand_areCheckedAgainstItsModel()
{
    Json far = pullAtX;
    far["samples"][0]["position"] = {50, 0, 0};
    far["radius"] = 0.2;
    Replay replay;
    QCOMPARE(replay(Json::array({far})), 2); // the stroke is beyond the working volume
    QVERIFY(replay.complaint.contains("strokes[0]"));
    QCOMPARE(replay(Json::array({{{"command", "scale"}, {"factor", 50}}, far})),
             2); // inside it after scaling, but the brush is then too fine
    QCOMPARE(replay(Json::array({pullAtX, {{"command", "recentre"}}, far})), 2);
    QVERIFY(replay.complaint.contains("strokes[2]"));
    QVERIFY(!QFile::exists(replay.path("out.ply")));
    far["radius"] = 15;
    QVERIFY2(replay(Json::array({{{"command", "scale"}, {"factor", 50}}, far})) == 0, replay.complaint.constData());
}

/// `check` reports that such a model can be sculpted. Strokes and the result use the file's coordinates.
void TestReplayCommand::modelFarFromTheOrigin_isPlayedWhereItIs()
{
    core::TriangleMesh far = core::icosphere(4, 1);
    for (core::Vec3f& p : far.points)
        p += core::Vec3f(12, 10, 0);
    Replay replay;
    core::writeMesh(replay.path("far.ply").toStdString(), far);
    Json pull = pullAtX;
    pull["samples"][0]["position"] = {13, 10, 0};
    QVERIFY2(replay(Json::array({pull}), replay.path("far.ply")) == 0, replay.complaint.constData());
    const core::Box box = core::boxOf(core::readMesh(replay.path("out.ply").toStdString()));
    QVERIFY(box.max().x() > 13.01 && std::abs(box.min().x() - 11) < 0.001 && std::abs(box.center().y() - 10) < 0.01);
}

void TestReplayCommand::farModel_isTheNearOneShifted_data()
{
    QTest::addColumn<QByteArray>("command");
    QTest::addColumn<Turned>("map"); ///< map of the file's coordinates that the command performs
    const auto row = [](const Json& command, const Turned& map) {
        QTest::newRow(command["command"].get<std::string>().c_str())
            << QByteArray::fromStdString(command.dump()) << map;
    };
    const Eigen::Quaterniond turn(0.8, 0, 0.6, 0);
    row({{"command", "move"}, {"by", {-0.5, 0.25, 0.125}}},
        [](const Vec3& p) { return Vec3(p + Vec3(-0.5, 0.25, 0.125)); });
    row({{"command", "rotate"}, {"rotation", {0, 0.6, 0, 0.8}}}, [=](const Vec3& p) { return Vec3(turn * p); });
    row({{"command", "scale"}, {"factor", 2}}, [](const Vec3& p) { return Vec3(2 * p); });
    row({{"command", "mirror"}, {"plane", "x"}}, [](const Vec3& p) { return Vec3(-p.x(), p.y(), p.z()); });
    row({{"command", "recentre"}}, {});
    row({{"command", "place_on_bed"}}, [](const Vec3& p) { return Vec3(p.x(), 0, p.z()); });
}

/// Plays a command and a stroke after it on a near and a far model. The stroke's position is in the file's coordinates
/// after the command.
void TestReplayCommand::farModel_isTheNearOneShifted()
{
    QFETCH(QByteArray, command);
    QFETCH(Turned, map);
    const Vec3 far(1000, 300, -500);
    const Vec3 shift = map ? Vec3(map(far) - map(Vec3::Zero())) : Vec3::Zero();
    // The stroke is placed on the near model after the command.
    Replay replay;
    QVERIFY2(replay.on(potato({0.125, 0.0625, 0}), {Json::parse(command.toStdString())}) == 0,
             replay.complaint.constData());
    const Vec3 at = replay.box().max().cwiseProduct(Vec3::UnitX()) + replay.box().center().cwiseProduct(Vec3(0, 1, 1));
    const auto entries = [&](const Vec3& by) {
        Json pull = pullAtX;
        pull["place"] = "nearest";
        pull["samples"][0]["position"] = {at.x() + by.x(), at.y() + by.y(), at.z() + by.z()};
        return Json::array({Json::parse(command.toStdString()), pull});
    };
    const core::Box plain = replay.box();
    QVERIFY2(replay.on(potato({0.125, 0.0625, 0}), entries(Vec3::Zero())) == 0, replay.complaint.constData());
    const core::TriangleMesh near = replay.result();
    QVERIFY(core::boxOf(near).max().x() > plain.max().x() + 0.01); // proves that the stroke changed the model
    QVERIFY2(replay.on(potato(Vec3(0.125, 0.0625, 0) + far), entries(shift)) == 0, replay.complaint.constData());
    VERIFY_ALIKE(replay.result(), near, shift);
}

void TestReplayCommand::farModel_keepsTheFilesPlanes_data()
{
    QTest::addColumn<QByteArray>("entry");
    Json pull = pullAtX;
    pull["samples"][0]["position"] = {0, 0.8, 0.3};
    pull["symmetry"] = "z";
    QTest::newRow("symmetry") << QByteArray::fromStdString(pull.dump());
    pull["symmetry"] = "x";
    pull["place"] = "nearest";
    QTest::newRow("symmetry by a plane beside it") << QByteArray::fromStdString(pull.dump());
    const Json symmetrize = {{"command", "symmetrize"}, {"plane", "z"}};
    QTest::newRow("symmetrize") << QByteArray::fromStdString(symmetrize.dump());
    const Json insert = {{"command", "insert"}, {"file", "other.ply"}, {"where", "centre"}, {"centre", {0, 2.5, 0.5}}};
    QTest::newRow("insert at a centre") << QByteArray::fromStdString(insert.dump());
    const Json tube = {{"command", "insert"},
                       {"primitive", "tube"},
                       {"path", {{0, 2, 0, 0.2}, {0.5, 2.5, 0, 0.1}}},
                       {"edge_length", 0.03},
                       {"where", "as_it_is"}};
    QTest::newRow("tube") << QByteArray::fromStdString(tube.dump());
}

/// The model is far away in x, so that the plane x = 0 does not meet it. The plane z = 0 cuts it.
void TestReplayCommand::farModel_keepsTheFilesPlanes()
{
    QFETCH(QByteArray, entry);
    constexpr double away = 1000;
    const Vec3 middle(0, 0, 0.25);
    Json near = Json::parse(entry.toStdString()), far = near;
    if (near.contains("samples"))
        far["samples"][0]["position"][0] = away;
    if (near.value("symmetry", "") == "x")
        near["symmetry"] = "none";
    if (near.contains("centre"))
        far["centre"][0] = away;
    if (near.contains("path"))
        for (Json& point : far["path"])
            point[0] = point[0].get<double>() + away;
    Replay replay;
    core::writeMesh(replay.path("other.ply").toStdString(), core::icosphere(2, 0.5));
    QVERIFY2(replay.on(potato(middle), {near}) == 0, replay.complaint.constData());
    const core::TriangleMesh expected = replay.result();
    QVERIFY2(replay.on(potato(middle + Vec3(away, 0, 0)), {far}) == 0, replay.complaint.constData());
    VERIFY_ALIKE(replay.result(), expected, Vec3(away, 0, 0));
}

void TestReplayCommand::farModel_isToldInItsFilesCoordinates()
{
    const core::TriangleMesh far = potato({1000, 0, 0});
    Json pull = pullAtX;
    pull["samples"][0]["position"] = {950, 0, 0};
    Replay replay;
    QCOMPARE(replay.on(far, {pull}), 2);
    QVERIFY2(replay.complaint.contains("\"position[0]\" is out of range, 99") &&
                 replay.complaint.contains(QStringLiteral("strokes[0]").toUtf8()),
             replay.complaint.constData());
    // the mirror image would be too far away
    QCOMPARE(replay.on(far, {{{"command", "symmetrize"}, {"plane", "x"}}}), 1);
    QCOMPARE(replay.on(far, {{{"command", "symmetrize"}, {"plane", "x"}, {"keep", "negative"}}}), 1);

    // Two parts of an assembly keep the distance that their files give.
    core::writeMesh(replay.path("other.ply").toStdString(), potato({1003, 0, 0}));
    QVERIFY2(replay.on(far, {{{"command", "insert"}, {"file", "other.ply"}, {"where", "as_it_is"}}}) == 0,
             replay.complaint.constData());
    const core::TriangleMesh both = replay.result();
    QCOMPARE(both.points.size(), 2 * far.points.size());
    QVERIFY((core::boxOf(both).min() - core::boxOf(far).min()).norm() < 1e-3 &&
            std::abs(core::boxOf(both).max().x() - core::boxOf(far).max().x() - 3) < 1e-3);
}

/// Strokes on a document use the coordinates of the window that wrote it, before and after commands.
void TestReplayCommand::document_keepsItsOwnCoordinates()
{
    Replay replay;
    core::writeMesh(replay.path("part.ply").toStdString(), core::icosphere(4, 1));
    core::TriangleMesh part = core::icosphere(4, 1);
    for (core::Vec3f& p : part.points)
        p = core::Lattice(10).snap(p.cast<double>() + Vec3(60, 0, 0));
    core::writeMesh(replay.path("part.ply").toStdString(), part);
    const app::LoadedModel opened = app::ModelLoader::load(replay.path("part.ply"));
    QVERIFY(opened.sculptor);
    core::DocumentMetadata metadata;
    metadata.frame = opened.sculptor->mesh().frame();
    QCOMPARE(app::ModelLoader::save(replay.path("part.glb"), opened.start->surface, metadata), QString());
    const Json mirror = {{"command", "mirror"}, {"plane", "x"}};
    QVERIFY2(replay(Json::array({pullAtX, mirror, pullAtX}), replay.path("part.glb")) == 0,
             replay.complaint.constData());
    const core::Box box = replay.box();
    QVERIFY(box.max().x() > 61.01 && box.min().x() < 58.99);
}

/// If `check` reports that a model can be sculpted, strokes are played and written at any distance from the origin.
/// Otherwise they are refused.
void TestReplayCommand::check_saysWhatCanBeSculpted()
{
    std::size_t played = 0, refused = 0;
    for (const double away : {0.0, 1e3, 5e3, 1e4, 2e4, 1e5, 1e6}) {
        const core::TriangleMesh model = potato({away, 0, 0});
        const core::MeshReport report = core::checkMesh(model);
        if (!report.printReady())
            continue;
        Json pull = pullAtX, smooth = pullAtX;
        pull["place"] = smooth["place"] = "nearest";
        pull["samples"] = Json::array();
        for (int i = 0; i < 8; ++i)
            pull["samples"].push_back({{"position", {away + 0.6, 0.1 * i, 0.05 * i}}});
        smooth["samples"] = pull["samples"];
        smooth["tool"] = "crease";
        Replay replay;
        const int status = replay.on(model, {pull, smooth});
        QCOMPARE(status, report.latticeOk.value_or(false) ? 0 : 2);
        if (status == 0) {
            ++played;
            QVERIFY(core::checkMesh(replay.result()).printReady());
        } else {
            ++refused;
            QVERIFY2(replay.complaint.contains("model.ply cannot be sculpted where it is"),
                     replay.complaint.constData());
            QVERIFY(!QFile::exists(replay.path("out.ply")));
        }
    }
    QVERIFY(played > 2 && refused > 0);
}

FETTLE_TEST(TestReplayCommand, QCoreApplication)
#include "tst_replay_command.moc"
