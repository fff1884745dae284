// Nodes, animations, cameras and lights of Assimp scenes.
#include <algorithm>
#include <cmath>

#include "common/base/files.h"
#include "common/scene/import_parts.h"

namespace lightwalk {
namespace {

// FBX and 3MF state unit and up axis; Assimp converts Collada itself.
glm::mat4 to_metres_y_up(const aiScene& scene, const std::string& extension, const std::string& name, Model& model) {
    const glm::mat4 z_up(1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1);
    if (extension == ".3mf") return z_up * glm::scale(glm::mat4(1), glm::vec3(metres_of_3mf(read_file(name), model)));
    if (extension != ".fbx" || !scene.mMetaData) return glm::mat4(1);
    int32_t up = 1, up_sign = 1, ahead = 2, ahead_sign = 1, side = 0, side_sign = 1;
    double centimetres = 1;
    scene.mMetaData->Get("UpAxis", up);
    scene.mMetaData->Get("UpAxisSign", up_sign);
    scene.mMetaData->Get("FrontAxis", ahead);
    scene.mMetaData->Get("FrontAxisSign", ahead_sign);
    scene.mMetaData->Get("CoordAxis", side);
    scene.mMetaData->Get("CoordAxisSign", side_sign);
    if (float single = 0; scene.mMetaData->Get("UnitScaleFactor", single)) centimetres = single;
    scene.mMetaData->Get("UnitScaleFactor", centimetres);
    glm::mat4 turn(0.0f);
    turn[3][3] = 1;
    const int32_t axes[3] = {side, up, ahead}, signs[3] = {side_sign, up_sign, ahead_sign};
    for (int i = 0; i < 3; ++i)
        if (axes[i] >= 0 && axes[i] < 3) turn[axes[i]][i] = signs[i] < 0 ? -1.0f : 1.0f;
    // Assimp 5.4 rotates the root node; 5.2 does not.
    if (std::abs(glm::determinant(glm::mat3(turn))) < 0.5f || !scene.mRootNode->mTransformation.IsIdentity())
        turn = glm::mat4(1);
    const float scale = centimetres > 1e-6 && centimetres < 1e6 ? static_cast<float>(0.01 * centimetres) : 0.01f;
    return glm::scale(turn, glm::vec3(scale));
}

// Parents before children. Iterative, since files may nest arbitrarily deep.
std::vector<Node> to_nodes(const aiNode& root, const glm::mat4& metres) {
    std::vector<Node> nodes = {{"", -1, metres, {}}};
    if (metres == glm::mat4(1)) nodes.clear();
    std::vector<std::pair<const aiNode*, int>> waiting = {{&root, static_cast<int>(nodes.size()) - 1}};
    while (!waiting.empty()) {
        const auto [from, parent] = waiting.back();
        waiting.pop_back();
        Node& to = nodes.emplace_back();
        to.name = from->mName.C_Str();
        to.parent = parent;
        to.local = to_glm(from->mTransformation);
        to.meshes.assign(from->mMeshes, from->mMeshes + from->mNumMeshes);
        for (unsigned i = from->mNumChildren; i-- > 0;)
            waiting.emplace_back(from->mChildren[i], static_cast<int>(nodes.size() - 1));
    }
    return nodes;
}

template <class T, class Key, class Convert>
KeyTrack<T> to_values(const Key* keys, unsigned count, double ticks_per_s, Convert convert) {
    KeyTrack<T> values;
    for (unsigned i = 0; i < count; ++i)
        values.push_back({static_cast<float>(keys[i].mTime / ticks_per_s), convert(keys[i].mValue)});
    return values;
}

void add_motions(const aiScene& scene, Model& model) {
    if (scene.mNumAnimations == 0 || !(scene.mAnimations[0]->mDuration > 0)) return;
    for (unsigned i = 1; i < scene.mNumAnimations; ++i) leave_out(model, "further animations", "animation");
    const aiAnimation& from = *scene.mAnimations[0];
    const double ticks_per_s = from.mTicksPerSecond > 0 ? from.mTicksPerSecond : 25;
    model.motions_s = static_cast<float>(from.mDuration / ticks_per_s);
    for (unsigned i = 0; i < from.mNumChannels; ++i) {
        const aiNodeAnim& channel = *from.mChannels[i];
        const auto node = std::find_if(model.nodes.begin(), model.nodes.end(),
                                       [&](const Node& n) { return n.name == channel.mNodeName.C_Str(); });
        const aiNode* own = scene.mRootNode->FindNode(channel.mNodeName);
        if (node == model.nodes.end() || !own) continue;
        aiVector3D scale, position;
        aiQuaternion rotation;
        own->mTransformation.Decompose(scale, rotation, position);
        const auto to_quat = [](const aiQuaternion& q) { return glm::quat(q.w, q.x, q.y, q.z); };
        const auto to_vec = [](const aiVector3D& v) { return to_glm(v); };
        NodeMotion motion{
            .node = static_cast<uint32_t>(node - model.nodes.begin()),
            .position = to_values<glm::vec3>(channel.mPositionKeys, channel.mNumPositionKeys, ticks_per_s, to_vec),
            .scale = to_values<glm::vec3>(channel.mScalingKeys, channel.mNumScalingKeys, ticks_per_s, to_vec),
            .rotation = to_values<glm::quat>(channel.mRotationKeys, channel.mNumRotationKeys, ticks_per_s, to_quat)};
        if (motion.position.empty()) motion.position = {{0, to_glm(position)}};
        if (motion.scale.empty()) motion.scale = {{0, to_glm(scale)}};
        if (motion.rotation.empty()) motion.rotation = {{0, to_quat(rotation)}};
        model.motions.push_back(std::move(motion));
    }
}

}  // namespace

void add_import_nodes(const aiScene& scene, const std::string& name, const std::string& extension, Model& model) {
    model.nodes = to_nodes(*scene.mRootNode, to_metres_y_up(scene, extension, name, model));
    add_motions(scene, model);
}

// Cameras and lights belong to the node of equal name, with an offset of their own.
void add_import_cameras(const aiScene& scene, Model& model) {
    const auto node_of = [&](const aiString& name, const aiVector3D& at, aiVector3D ahead, aiVector3D up) {
        const auto found =
            std::find_if(model.nodes.begin(), model.nodes.end(), [&](const Node& n) { return n.name == name.C_Str(); });
        const int parent = found == model.nodes.end() ? -1 : static_cast<int>(found - model.nodes.begin());
        if (ahead.SquareLength() == 0) ahead = {0, 0, -1};
        if ((ahead ^ up).SquareLength() < 1e-12f)
            up = std::abs(ahead.y) < std::abs(ahead.x) ? aiVector3D(0, 1, 0) : aiVector3D(1, 0, 0);
        const glm::mat4 look = glm::inverse(glm::lookAt(to_glm(at), to_glm(at + ahead), to_glm(up)));
        model.nodes.push_back({"", parent, look, {}});
        return static_cast<uint32_t>(model.nodes.size() - 1);
    };
    for (unsigned i = 0; i < scene.mNumCameras; ++i) {
        const aiCamera& from = *scene.mCameras[i];
        FileCamera camera{node_of(from.mName, from.mPosition, from.mLookAt, from.mUp), {}, from.mName.C_Str()};
        const float aspect = from.mAspect > 0 ? from.mAspect : 16.0f / 9;
        camera.camera.fov_y_rad = std::clamp(2 * std::atan(std::tan(0.5f * from.mHorizontalFOV) / aspect), 0.01f, 3.1f);
        if (std::isfinite(camera.camera.fov_y_rad)) model.cameras.push_back(camera);
    }
    for (unsigned i = 0; i < scene.mNumLights; ++i) {
        const aiLight& from = *scene.mLights[i];
        if (from.mType != aiLightSource_DIRECTIONAL && from.mType != aiLightSource_POINT &&
            from.mType != aiLightSource_SPOT) {
            leave_out(model, "ambient and area lights", "light");
            continue;
        }
        Light light;
        light.kind = from.mType == aiLightSource_SPOT    ? Light::Kind::spot
                     : from.mType == aiLightSource_POINT ? Light::Kind::point
                                                         : Light::Kind::directional;
        const glm::vec3 color(from.mColorDiffuse.r, from.mColorDiffuse.g, from.mColorDiffuse.b);
        const float brightest = std::max({color.r, color.g, color.b, 1e-6f});
        if (!std::isfinite(brightest)) continue;
        light.color = glm::clamp(color / brightest, 0.0f, 1.0f);
        light.intensity = std::min(brightest, 1e6f);
        light.outer_rad = std::clamp(0.5f * from.mAngleOuterCone, 0.0f, 1.5f);
        light.inner_rad = std::clamp(0.5f * from.mAngleInnerCone, 0.0f, light.outer_rad);
        light.range_m = 1e6f;
        light.name = from.mName.C_Str();
        model.lights.push_back({node_of(from.mName, from.mPosition, from.mDirection, {0, 1, 0}), light});
    }
}

}  // namespace lightwalk
