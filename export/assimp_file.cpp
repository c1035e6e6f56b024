// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/assimp_file.h"

#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <assimp/BaseImporter.h>
#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include "spec/file_error.h"

namespace latticast {
namespace {

/// An importer that knows one extension only: assimp otherwise offers a file that one reader
/// refuses to all the others.
class NarrowImporter {
 public:
  explicit NarrowImporter(const std::string& extension) {
    for (std::size_t i = importer_.GetImporterCount(); i-- > 0;) {
      Assimp::BaseImporter* reader = importer_.GetImporter(i);
      std::set<std::string> extensions;
      reader->GetExtensionList(extensions);
      if (extensions.count(extension) == 0) {
        importer_.UnregisterLoader(reader);
        removed_.emplace_back(reader);
      }
    }
  }

  Assimp::Importer& operator*() { return importer_; }

 private:
  Assimp::Importer importer_;
  std::vector<std::unique_ptr<Assimp::BaseImporter>> removed_;  // ours once unregistered
};

/// assimp hands on face indices as the file has them.
bool is_valid(const aiMesh& mesh) {
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    for (unsigned corner = 0; corner < face.mNumIndices; ++corner) {
      if (face.mIndices[corner] >= mesh.mNumVertices) {
        return false;
      }
    }
  }
  return true;
}

void append_mesh(const aiMesh& mesh, const aiMatrix4x4& placement, TriangleMesh& all) {
  const auto first = static_cast<std::uint32_t>(all.vertices.size());
  const bool moved = !placement.IsIdentity();
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D p = moved ? placement * mesh.mVertices[i] : mesh.mVertices[i];
    all.vertices.push_back({p.x, p.y, p.z});
  }
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    for (unsigned corner = 2; corner < face.mNumIndices; ++corner) {
      all.triangles.push_back({first + face.mIndices[0], first + face.mIndices[corner - 1],
                               first + face.mIndices[corner]});
    }
  }
}

void append_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent,
                 TriangleMesh& all) {
  const aiMatrix4x4 placement = parent * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    append_mesh(*scene.mMeshes[node.mMeshes[i]], placement, all);
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) {
    append_node(scene, *node.mChildren[i], placement, all);
  }
}

}  // namespace

TriangleMesh decode_with_assimp(const std::filesystem::path& file, std::string_view bytes,
                                std::string_view extension) {
  const std::string hint(extension.substr(1));
  NarrowImporter importer(hint);
  const aiScene* scene =
      (*importer).ReadFileFromMemory(bytes.data(), bytes.size(), 0, hint.c_str());
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw FileError(file, std::string("cannot be read: ") + (*importer).GetErrorString());
  }
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    if (!is_valid(*scene->mMeshes[i])) {
      throw FileError(file, "has a face that names a vertex that it does not have");
    }
  }
  TriangleMesh all;
  append_node(*scene, *scene->mRootNode, aiMatrix4x4(), all);
  return all;
}

}  // namespace latticast
