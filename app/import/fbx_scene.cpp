// Source: Autodesk, FBX SDK Help, "Computing transformation matrices":
//   world = parent's world * T * Roff * Rp * Rpre * R * Rpost^-1 * Rp^-1 * Soff * Sp * S * Sp^-1,
// and for the model's own mesh, but not for its children, OT * OR * OS behind it. Assimp (5.2 to 6.0) gives the factors
// that are not the identity as a chain of nodes, "name_$AssimpFbx$_PreRotation" and so on, that ends in the node of the
// model; OT, OR and OS are taken back by further nodes in front of its children.
#include "app/import/fbx_scene.h"

#include <assimp/scene.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace app
{
namespace
{
/// Returns the factor that a node of the chain stands for; empty for the node of a model, which alone has metadata.
std::string_view factorOf(const aiNode& node)
{
    constexpr std::string_view tag = "_$AssimpFbx$_";
    const std::string_view name(node.mName.C_Str(), node.mName.length);
    const std::size_t at = name.rfind(tag);
    return node.mMetaData || at == std::string_view::npos ? std::string_view() : name.substr(at + tag.size());
}

bool isGeometric(std::string_view factor)
{
    return factor.starts_with("Geometric");
}

bool isGeometricInverse(std::string_view factor)
{
    return isGeometric(factor) && factor.ends_with("Inverse");
}

template <class Value> std::optional<Value> valueOf(const aiMetadata* data, const char* key)
{
    Value value{};
    return data && data->Get(key, value) ? std::optional(value) : std::nullopt;
}

/// Names the ways in which a model follows its parent's scale.
enum class Inherit {
    ComponentWise, ///< by its own axes: RrSs
    Usual,         ///< as matrices do: RSrs
    WithoutParents ///< not at all; the place does: Rrs
};

/// A model's chain, put together.
struct Model
{
    const aiNode* node = nullptr;                           ///< which has the meshes
    Eigen::Matrix4d local = Eigen::Matrix4d::Identity();    ///< against its parent
    Eigen::Matrix4d ofMeshes = Eigen::Matrix4d::Identity(); ///< against itself
    Inherit inherit = Inherit::Usual;
};

Model modelOf(const aiNode& first)
{
    const aiNode* node = &first;
    while (!factorOf(*node).empty() && node->mNumChildren == 1)
        node = node->mChildren[0];
    Model model;
    for (const aiNode* part = &first;; part = part->mChildren[0]) {
        (isGeometric(factorOf(*part)) ? model.ofMeshes : model.local) *= matrixOf(*part);
        if (part == node)
            break;
    }
    model.node = node;
    const int inherit = valueOf<std::int32_t>(node->mMetaData, "InheritType").value_or(1);
    model.inherit = inherit == 0 ? Inherit::ComponentWise : inherit == 2 ? Inherit::WithoutParents : Inherit::Usual;
    return model;
}

/// A model's place in the world, and what its children inherit of it.
struct ModelPlace
{
    Eigen::Matrix4d world, withoutScale;
    Eigen::Vector3d scale = Eigen::Vector3d::Ones();       ///< of itself, and what it has inherited by its axes
    Eigen::Vector3d scaleBefore = Eigen::Vector3d::Ones(); ///< of those from which an Rrs child inherits
};

/// Returns the matrix without the lengths of its columns, which are `scale`.
Eigen::Matrix4d unscaled(Eigen::Matrix4d matrix, const Eigen::Vector3d& scale)
{
    for (int axis = 0; axis < 3; ++axis)
        if (scale[axis] > 0)
            matrix.col(axis) /= scale[axis];
    return matrix;
}

ModelPlace placeOf(const Model& model, const ModelPlace& parent)
{
    ModelPlace place;
    Eigen::Matrix4d local = model.local;
    if (model.inherit != Inherit::Usual) {
        place.scaleBefore = model.inherit == Inherit::ComponentWise ? parent.scale : parent.scaleBefore;
        for (int axis = 0; axis < 3; ++axis)
            local.col(axis) *= place.scaleBefore[axis];
        local.topRightCorner<3, 1>().array() *= parent.scale.array();
    }
    const Eigen::Matrix4d& above = model.inherit == Inherit::Usual ? parent.world : parent.withoutScale;
    place.scale = local.topLeftCorner<3, 3>().colwise().norm();
    place.world = above * local;
    place.withoutScale = above * unscaled(local, place.scale);
    return place;
}

void add(const aiNode& first, const ModelPlace& parent, SceneMesh& mesh)
{
    const Model model = modelOf(first);
    const ModelPlace place = placeOf(model, parent);
    mesh.addMeshesOf(*model.node, place.world * model.ofMeshes);
    const aiNode* above = model.node;
    while (above->mNumChildren == 1 && isGeometricInverse(factorOf(*above->mChildren[0])))
        above = above->mChildren[0];
    for (unsigned i = 0; i < above->mNumChildren; ++i)
        add(*above->mChildren[i], place, mesh);
}

/// Returns the turn, or the mirror, that makes the axis that the file has as its right one X, its up one Y, its front
/// one Z. Where the file's axes are none, up alone counts.
Eigen::Matrix3d axesOf(const aiMetadata* data)
{
    const auto number = [data](const char* key, std::int32_t usual) {
        return valueOf<std::int32_t>(data, key).value_or(usual);
    };
    const std::array axes{number("CoordAxis", 0), number("UpAxis", 1), number("FrontAxis", 2)};
    const std::array signs{number("CoordAxisSign", 1), number("UpAxisSign", 1), number("FrontAxisSign", 1)};
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    for (int row = 0; row < 3; ++row)
        if (const std::int32_t axis = axes[row]; axis >= 0 && axis < 3)
            matrix(row, axis) = signs[row] < 0 ? -1 : 1;
    if (matrix.determinant() != 0)
        return matrix;
    if (axes[1] == 2)
        return Eigen::Matrix3d{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    return Eigen::Matrix3d::Identity();
}
} // namespace

void addFbxScene(const aiScene& scene, SceneMesh& mesh)
{
    constexpr double millimetresInCentimetre = 10;
    const auto factor = static_cast<double>(valueOf<float>(scene.mMetaData, "UnitScaleFactor").value_or(1));
    if (!std::isfinite(factor) || factor <= 0)
        throw std::runtime_error("UnitScaleFactor is no positive number");
    const double unit = millimetresInCentimetre * factor;
    ModelPlace root{.world = Eigen::Matrix4d::Identity(), .withoutScale = Eigen::Matrix4d::Identity()};
    root.world.topLeftCorner<3, 3>() = unit * axesOf(scene.mMetaData);
    root.withoutScale = root.world;
    const aiNode& top = *scene.mRootNode; // from 5.4 on Assimp puts the axes into its transform, half of them wrongly
    mesh.addMeshesOf(top, root.world);
    for (unsigned i = 0; i < top.mNumChildren; ++i)
        add(*top.mChildren[i], root, mesh);
}
} // namespace app
