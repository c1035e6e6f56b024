// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/zip_archive.h"

#include <array>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <utility>

#include <zip.h>

#include "design/file_error.h"

namespace latticast {
namespace {

constexpr zip_uint16_t first_of_january_1980 = 0x21;
// Level 6 takes more than twice as long and saves a quarter.
constexpr zip_uint32_t compression_level = 1;

struct CloseFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};
struct DiscardArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, FreeSource>;

[[noreturn]] void fail_to_zip() {
  throw std::runtime_error("a zip archive could not be made in memory");
}

void add(zip_t* archive, const ZipEntry& entry) {
  Source bytes(zip_source_buffer(archive, entry.bytes.data(), entry.bytes.size(), 0));
  const zip_int64_t index =
      bytes ? zip_file_add(archive, entry.name.c_str(), bytes.get(), ZIP_FL_ENC_UTF_8) : -1;
  if (index < 0) {
    fail_to_zip();
  }
  static_cast<void>(bytes.release());  // the archive's from here on
  const auto number = static_cast<zip_uint64_t>(index);
  if (zip_set_file_compression(archive, number, ZIP_CM_DEFLATE, compression_level) != 0 ||
      zip_file_set_dostime(archive, number, 0, first_of_january_1980, 0) != 0) {
    fail_to_zip();
  }
}

std::string content(zip_source_t* source) {
  zip_stat_t status;
  if (zip_source_stat(source, &status) != 0 || zip_source_open(source) != 0) {
    fail_to_zip();
  }
  std::string bytes(status.size, '\0');
  const zip_int64_t taken = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (taken != static_cast<zip_int64_t>(bytes.size())) {
    fail_to_zip();
  }
  return bytes;
}

}  // namespace

std::string part_name(std::string_view name) {
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i) {
    unsigned code = 0;
    if (name[i] == '%' && i + 2 < name.size() &&
        std::from_chars(&name[i + 1], &name[i + 1] + 2, code, 16).ptr == &name[i + 1] + 2) {
      result += static_cast<char>(code);
      i += 2;
    } else {
      result += name[i] == '\\' ? '/' : name[i];
    }
  }
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  while (result.starts_with('/') || result.starts_with("./")) {
    result.erase(0, result.front() == '/' ? 1 : 2);
  }
  return result;
}

std::string zip(std::span<const ZipEntry> entries) {
  const Source source(zip_source_buffer_create(nullptr, 0, 0, nullptr));
  if (!source) {
    fail_to_zip();
  }
  std::unique_ptr<zip_t, DiscardArchive> archive(
      zip_open_from_source(source.get(), ZIP_TRUNCATE, nullptr));
  if (!archive) {
    fail_to_zip();
  }
  zip_source_keep(source.get());  // one for the archive, one for content()
  for (const ZipEntry& entry : entries) {
    add(archive.get(), entry);
  }
  if (zip_close(archive.get()) != 0) {
    fail_to_zip();
  }
  static_cast<void>(archive.release());
  return content(source.get());
}

struct ZipReader::Archive {
  std::optional<zip_uint64_t> find(const std::string& name) const {
    const std::string wanted = part_name(name);
    const zip_int64_t count = zip_get_num_entries(open.get(), 0);
    for (zip_int64_t i = 0; i < count; ++i) {
      const auto index = static_cast<zip_uint64_t>(i);
      const char* const entry = zip_get_name(open.get(), index, 0);
      if (entry != nullptr && part_name(entry) == wanted) return index;
    }
    return std::nullopt;
  }

  std::unique_ptr<zip_t, DiscardArchive> open;
};

ZipReader::ZipReader(std::filesystem::path file, std::string_view bytes)
    : file_(std::move(file)), archive_(std::make_unique<Archive>()) {
  Source source(zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr));
  if (source) {
    archive_->open.reset(zip_open_from_source(source.get(), ZIP_RDONLY | ZIP_CHECKCONS, nullptr));
  }
  if (!archive_->open) {
    throw FileError(file_, "is no zip archive, or a damaged one");
  }
  static_cast<void>(source.release());
}

ZipReader::~ZipReader() = default;

bool ZipReader::has(const std::string& name) const {
  return archive_->find(name).has_value();
}

void ZipReader::read(const std::string& name,
                     const std::function<void(std::string_view)>& take) const {
  const std::optional<zip_uint64_t> index = archive_->find(name);
  const std::unique_ptr<zip_file_t, CloseFile> entry(
      index ? zip_fopen_index(archive_->open.get(), *index, 0) : nullptr);
  if (!entry) {
    throw FileError(file_, "has no readable \"" + name + "\" inside");
  }
  std::array<char, 1 << 16> piece;
  zip_int64_t size = 0;
  while ((size = zip_fread(entry.get(), piece.data(), piece.size())) > 0) {
    take(std::string_view(piece.data(), static_cast<std::size_t>(size)));
  }
  if (size < 0) {
    throw FileError(file_, "has damaged bytes in \"" + name + "\" inside");
  }
}

}  // namespace latticast
