// Source: Autodesk, FBX SDK Help, "Computing transformation matrices":
//   world = parent's world * T * Roff * Rp * Rpre * R * Rpost^-1 * Rp^-1 * Soff * Sp * S * Sp^-1,
// followed by OT * OR * OS for the model's own mesh, but not for its children. Assimp (5.2 to 6.0) gives the factors
// that are not the identity as a chain of nodes, "name_$AssimpFbx$_PreRotation" and so on, which ends in the model's
// node. Further nodes before its children undo OT, OR and OS.
#include "app/import/fbx_scene.h"

#include <assimp/scene.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace app
{
namespace
{
using Inherit = FbxModel::Inherit;

/// Returns the name of the transform factor in this node; empty for a model's node, which alone has metadata.
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

/// Returns the last node of a model's chain, which has the model's name, metadata and meshes.
const aiNode& endOf(const aiNode& first)
{
    const aiNode* node = &first;
    while (!factorOf(*node).empty() && node->mNumChildren == 1)
        node = node->mChildren[0];
    return *node;
}

/// The products of the transform factors in a model's chain of nodes.
struct Transforms
{
    Eigen::Matrix4d local = Eigen::Matrix4d::Identity();    ///< model space to parent space
    Eigen::Matrix4d ofMeshes = Eigen::Matrix4d::Identity(); ///< mesh space to model space
};

Transforms transformsOf(const aiNode& first, const FbxModel& model)
{
    const aiNode* const end = &endOf(first);
    Transforms transforms;
    for (const aiNode* part = &first;; part = part->mChildren[0]) {
        const std::string_view factor = factorOf(*part);
        if (model.hasActiveRotations || (factor != "PreRotation" && factor != "PostRotation"))
            (isGeometric(factor) ? transforms.ofMeshes : transforms.local) *= matrixOf(*part);
        if (part == end)
            return transforms;
    }
}

/// A model's transform in the world, and the values that its children inherit.
struct ModelPlace
{
    Eigen::Matrix4d world, withoutScale;
    /// own scale times the scale inherited along the model's axes, with signs
    Eigen::Vector3d scale = Eigen::Vector3d::Ones();
    Eigen::Vector3d scaleBefore = Eigen::Vector3d::Ones(); ///< scale of the ancestors that an Rrs child inherits
    bool isVisible = true;
};

/// Returns the matrix without its scale and mirroring. A scale of 0 cannot be undone and is left as it is.
Eigen::Matrix4d unscaled(Eigen::Matrix4d matrix, const Eigen::Vector3d& scale)
{
    for (int axis = 0; axis < 3; ++axis)
        if (scale[axis] != 0)
            matrix.col(axis) /= scale[axis];
    return matrix;
}

ModelPlace placeOf(const FbxModel& model, Eigen::Matrix4d local, const ModelPlace& parent)
{
    ModelPlace place;
    if (model.inherit != Inherit::Usual) {
        place.scaleBefore = model.inherit == Inherit::ComponentWise ? parent.scale : parent.scaleBefore;
        for (int axis = 0; axis < 3; ++axis)
            local.col(axis) *= place.scaleBefore[axis];
        local.topRightCorner<3, 1>().array() *= parent.scale.array();
    }
    const Eigen::Matrix4d& above = model.inherit == Inherit::Usual ? parent.world : parent.withoutScale;
    place.scale = model.scale.cwiseProduct(place.scaleBefore);
    place.world = above * local;
    place.withoutScale = above * unscaled(local, place.scale);
    place.isVisible = model.isVisible && (parent.isVisible || !model.inheritsVisibility);
    return place;
}

/// Traverses the models and Assimp's nodes together, and adds the meshes of visible models.
class SceneWalk
{
public:
    SceneWalk(const std::vector<FbxModel>& models, SceneMesh& mesh) : m_models(models), m_mesh(mesh) {}

    /// Adds the children of a model; of levels of detail, only the first that shows anything. `above`: Assimp's node
    /// whose children they are.
    void addBelow(const aiNode& above, const FbxModel& model, const ModelPlace& place)
    {
        auto next = model.below.begin();
        const std::size_t before = m_mesh.faces();
        for (unsigned i = 0; i < above.mNumChildren && !(model.isLodGroup && m_mesh.faces() > before); ++i) {
            const aiNode& first = *above.mChildren[i];
            next = std::find_if(next, model.below.end(),
                                [&](std::size_t index) { return isNamed(endOf(first), m_models[index].name); });
            if (next == model.below.end())
                throw std::runtime_error("the records of its models cannot be followed");
            add(first, m_models[*next++], place);
        }
    }

    const FbxLeftOut& leftOut() const { return m_left; }

private:
    /// Returns whether the node's name begins with the first 800 bytes of `name`; Assimp appends numbers to equal
    /// names. Nodes are matched by name because Assimp skips models that it cannot read. In a binary file, names of
    /// 1,024 bytes or more, with Assimp's additions, may be missing from the node; such a file is refused.
    static bool isNamed(const aiNode& node, std::string_view name)
    {
        constexpr std::size_t kept = 800;
        return std::string_view(node.mName.C_Str(), node.mName.length).starts_with(name.substr(0, kept));
    }

    void add(const aiNode& first, const FbxModel& model, const ModelPlace& parent)
    {
        const Transforms transforms = transformsOf(first, model);
        const ModelPlace place = placeOf(model, transforms.local, parent);
        const aiNode* above = &endOf(first);
        if (place.isVisible && model.isShown) {
            m_mesh.addMeshesOf(*above, place.world * transforms.ofMeshes, model.name, model.meshes > 0);
            m_left.missing += std::max<std::size_t>(model.meshes, above->mNumMeshes) - above->mNumMeshes;
        } else {
            m_left.hidden += model.meshes > 0 ? 1 : 0;
        }
        while (above->mNumChildren == 1 && isGeometricInverse(factorOf(*above->mChildren[0])))
            above = above->mChildren[0];
        addBelow(*above, model, place);
    }

    const std::vector<FbxModel>& m_models;
    SceneMesh& m_mesh;
    FbxLeftOut m_left;
};

/// Returns the number of models with meshes that are not connected to the first model, the scene.
std::size_t unconnected(const std::vector<FbxModel>& models)
{
    std::vector<bool> isConnected(models.size(), false);
    std::vector<std::size_t> way{0};
    while (!way.empty()) {
        const std::size_t at = way.back();
        way.pop_back();
        if (!isConnected[at])
            way.insert(way.end(), models[at].below.begin(), models[at].below.end());
        isConnected[at] = true;
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < models.size(); ++i)
        count += !isConnected[i] && models[i].meshes > 0 ? 1 : 0;
    return count;
}

/// Returns the rotation or mirroring that maps the file's right, up and front axes to X, Y and Z. If the file's axes
/// are invalid, only its up axis is used.
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

FbxLeftOut addFbxScene(const aiScene& scene, const std::vector<FbxModel>& models, SceneMesh& mesh)
{
    constexpr double millimetresInCentimetre = 10;
    const auto factor = static_cast<double>(valueOf<float>(scene.mMetaData, "UnitScaleFactor").value_or(1));
    if (!std::isfinite(factor) || factor <= 0)
        throw std::runtime_error("UnitScaleFactor is no positive number");
    const double unit = millimetresInCentimetre * factor;
    ModelPlace root{.world = Eigen::Matrix4d::Identity(), .withoutScale = Eigen::Matrix4d::Identity()};
    root.world.topLeftCorner<3, 3>() = unit * axesOf(scene.mMetaData);
    root.withoutScale = root.world;
    // since 5.4 Assimp puts the axes into this node's transform, partly wrong, so it is ignored
    const aiNode& top = *scene.mRootNode;
    mesh.addMeshesOf(top, root.world, {});
    SceneWalk walk(models, mesh);
    walk.addBelow(top, models.front(), root);
    FbxLeftOut left = walk.leftOut();
    left.hidden += unconnected(models);
    return left;
}
} // namespace app
