// SPDX-License-Identifier: GPL-3.0-or-later
// Files of mold pieces: pieces of one shape share one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace latticast {

struct PlannedMold;

/// What is printed from one file, perhaps several times.
struct PieceFile {
  std::size_t mold = 0;  ///< of the first piece
  std::size_t piece = 0;
  std::string stem;
  std::vector<std::string> uses;  ///< one a print: the piece's name in its own mold
};

/// For every piece of every mold the number of its file; pieces share one when their meshes as they
/// are printed are the same at float32, corner by corner.
struct PieceFiles {
  std::vector<PieceFile> files;
  std::vector<std::vector<std::size_t>> of_piece;  ///< by mold and piece
};

/// `stems` are the molds' names, as files carry them.
PieceFiles piece_files(const std::vector<PlannedMold>& molds,
                       const std::vector<std::string>& stems);

/// For the page to cast by: which file each piece is printed from, and how often. Empty where every
/// piece has a file of its own name.
std::string shared_files_text(const PieceFiles& files, std::size_t mold);

}  // namespace latticast
