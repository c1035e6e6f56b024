// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/piece_files.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>

#include <fmt/core.h>

#include "app/mold_set.h"
#include "molds/print_size.h"

namespace latticast {
namespace {

bool same_at_float32(const TriangleMesh& a, const TriangleMesh& b) {
  const auto same = [](const Point& p, const Point& q) {
    return std::equal(p.begin(), p.end(), q.begin(), [](double x, double y) {
      return static_cast<float>(x) == static_cast<float>(y);
    });
  };
  return a.triangles == b.triangles && std::equal(a.vertices.begin(), a.vertices.end(),
                                                  b.vertices.begin(), b.vertices.end(), same);
}

// Tells most meshes apart without keeping them. -0 is written as 0 is read.
std::uint64_t mark_of(const TriangleMesh& mesh) {
  std::uint64_t mark = 0xCBF29CE484222325ULL;
  const auto add = [&](std::uint32_t bits) { mark = (mark ^ bits) * 0x100000001B3ULL; };
  for (const Point& p : mesh.vertices) {
    for (const double x : p) add(std::bit_cast<std::uint32_t>(static_cast<float>(x) + 0.0F));
  }
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) add(corner);
  }
  return mark;
}

}  // namespace

PieceFiles piece_files(const std::vector<PlannedMold>& molds,
                       const std::vector<std::string>& stems) {
  PieceFiles result;
  std::multimap<std::uint64_t, std::size_t> known;
  for (std::size_t m = 0; m < molds.size(); ++m) {
    std::vector<std::size_t>& numbers = result.of_piece.emplace_back();
    for (std::size_t p = 0; p < molds[m].mold.pieces.size(); ++p) {
      const MoldPiece& piece = molds[m].mold.pieces[p];
      const TriangleMesh printed = printing_pose(piece);
      const auto [begin, end] = known.equal_range(mark_of(printed));
      const auto same = std::find_if(begin, end, [&](const auto& entry) {
        const PieceFile& file = result.files[entry.second];
        return same_at_float32(printing_pose(molds[file.mold].mold.pieces[file.piece]), printed);
      });
      const std::string name = stems[m] + "-" + piece.name;
      if (same != end) {
        numbers.push_back(same->second);
      } else {
        numbers.push_back(result.files.size());
        known.emplace(mark_of(printed), result.files.size());
        result.files.push_back({m, p, name, {}});
      }
      result.files[numbers.back()].uses.push_back(name);
    }
  }
  return result;
}

std::string shared_files_text(const PieceFiles& files, std::size_t mold) {
  std::string text;
  std::vector<std::size_t> numbers = files.of_piece[mold];
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  for (const std::size_t number : numbers) {
    const PieceFile& file = files.files[number];
    if (file.uses.size() < 2) continue;
    text += fmt::format("- `{}`: print {} \u00D7, as", file.stem, file.uses.size());
    for (const std::string& use : file.uses) {
      text += fmt::format("{} {}", &use == &file.uses.front() ? "" : ",", use);
    }
    text += '\n';
  }
  return text.empty() ? text
                      : "\n## Pieces that share a file\n\nOf all molds of the design:\n\n" + text;
}

}  // namespace latticast
