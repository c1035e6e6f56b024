// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/slicer_settings.h"

#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include "export/mesh/xml_reader.h"

namespace latticast {
namespace {

template <class Number>
std::optional<Number> number(const XmlAttributes& attributes, std::string_view name) {
  const std::string_view word = attributes.find(name).value_or("");
  Number value = 0;
  const auto parsed = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || parsed.ec != std::errc() || parsed.ptr != word.data() + word.size()) {
    return std::nullopt;
  }
  return value;
}

class SettingsReader {
 public:
  explicit SettingsReader(const std::filesystem::path& file)
      : xml_(file, {.start = [this](std::string_view name,
                                    const XmlAttributes& attributes) { start(name, attributes); },
                    .end = [this](std::string_view name) { end(name); }}) {}

  SlicerSettings read(const ZipReader& package, const std::string& entry) {
    package.read(entry, [&](std::string_view piece) { xml_.read(piece); });
    xml_.finish();
    return std::move(settings_);
  }

 private:
  void start(std::string_view name, const XmlAttributes& attributes) {
    if (name == "object") {
      object_ = number<std::uint32_t>(attributes, "id");
    } else if (name == "volume" && object_) {
      start_volume(attributes);
    } else if (name == "part" && object_) {
      start_part(attributes);
    } else if (name == "metadata" && volume_) {
      read_metadata(attributes);
    }
  }

  void start_volume(const XmlAttributes& attributes) {
    const auto first = number<std::size_t>(attributes, "firstid");
    const auto last = number<std::size_t>(attributes, "lastid");
    if (first && last) volume_ = SlicerVolume{*first, *last};
  }

  void start_part(const XmlAttributes& attributes) {
    const auto component = number<std::uint32_t>(attributes, "id");
    if (component && attributes.find("subtype").value_or("normal_part") != "normal_part") {
      settings_.unprinted_components.emplace(*object_, *component);
    }
  }

  // Versions before 2.0 know modifiers only.
  void read_metadata(const XmlAttributes& attributes) {
    const std::string_view key = attributes.find("key").value_or("");
    const std::string_view value = attributes.find("value").value_or("");
    if (key == "volume_type") volume_->printed = value == "ModelPart";
    if (key == "modifier" && value == "1") volume_->printed = false;
  }

  void end(std::string_view name) {
    if (name == "volume" && volume_) {
      settings_.volumes[*object_].push_back(*volume_);
      volume_.reset();
    } else if (name == "object") {
      object_.reset();
    }
  }

  XmlReader xml_;
  SlicerSettings settings_;
  std::optional<std::uint32_t> object_;
  std::optional<SlicerVolume> volume_;
};

}  // namespace

SlicerSettings read_slicer_settings(const std::filesystem::path& file, const ZipReader& package) {
  for (const char* entry : {"Metadata/Slic3r_PE_model.config", "Metadata/Slic3r_model.config",
                            "Metadata/model_settings.config"}) {
    if (package.has(entry)) return SettingsReader(file).read(package, entry);
  }
  return {};
}

}  // namespace latticast
