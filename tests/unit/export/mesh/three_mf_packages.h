// SPDX-License-Identifier: GPL-3.0-or-later
// 3MF packages made for tests, as other programs might write them.
#pragma once

#include <array>
#include <string>

#include "export/mesh/zip_archive.h"

namespace latticast {

inline std::string package(const std::string& model,
                           const std::string& target = "/3D/3dmodel.model") {
  const std::string relationships =
      "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
      "<Relationship Target=\"/thumbnail.png\" Id=\"a\" Type=\"http://thumbnail\"/>"
      "<Relationship Target=\"" +
      target +
      "\" Id=\"b\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
      "</Relationships>";
  return zip(
      std::array<ZipEntry, 2>{{{"_rels/.rels", relationships}, {"3D/3dmodel.model", model}}});
}

inline std::string model_of(const std::string& resources, const std::string& build,
                            const std::string& attributes = "") {
  return "<?xml version=\"1.0\"?>\n<c:model " + attributes +
         " xmlns:c=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
         "xmlns:s=\"http://schemas.microsoft.com/3dmanufacturing/slice/2015/07\" "
         "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\">\n"
         "<c:resources><s:slicestack id=\"9\"><s:slice><s:vertices><s:vertex x=\"5\" y=\"6\"/>"
         "</s:vertices></s:slice></s:slicestack>\n" +
         resources + "</c:resources>\n<c:build>" + build + "</c:build></c:model>";
}

inline const std::string triangle_object =
    "<c:object id=\"1\" type=\"model\"><c:mesh><c:vertices><c:vertex x=\"1\" y=\"2\" z=\"+3e0\"/>"
    "<c:vertex x=\"4\" y=\"2.0\" z=\"3\"/><c:vertex x=\"1\" y=\"5\" z=\"3\"/></c:vertices>"
    "<c:triangles><c:triangle v1=\"0\" v2=\"1\" v3=\"2\"/></c:triangles></c:mesh></c:object>\n";

}  // namespace latticast
