#include "tools/trace/settings_file.hpp"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "parser/diagnostic.hpp"

namespace trace {
namespace {

using nlohmann::json;
using parser::Span;

// How many bytes the JSON reader has taken; its events carry no places of their own.
struct CountingIterator {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at;
  std::uint32_t* count;

  reference operator*() const { return *at; }
  CountingIterator& operator++() {
    ++at;
    ++*count;
    return *this;
  }
  bool operator==(const CountingIterator& other) const { return at == other.at; }
  bool operator!=(const CountingIterator& other) const { return at != other.at; }
};

// What a key takes, and where its value goes.
struct Key {
  std::string expects;
  std::function<bool(const json&)> take;  // false where the value does not fit
};

Key boolean(std::optional<bool>* target) {
  return {"true or false", [target](const json& value) {
            if (!value.is_boolean()) return false;
            if (target) *target = value.get<bool>();
            return true;
          }};
}

Key whole(std::optional<int>* target, int low, int high) {
  return {fmt::format("a whole number from {} to {}", low, high), [=](const json& value) {
            if (!value.is_number()) return false;
            const double number = value.get<double>();
            if (!(number >= low && number <= high) || number != static_cast<int>(number)) return false;
            if (target) *target = static_cast<int>(number);
            return true;
          }};
}

Key number(std::optional<double>* target) {
  return {"a number that is not negative", [target](const json& value) {
            if (!value.is_number() || !(value.get<double>() >= 0)) return false;
            if (target) *target = value.get<double>();
            return true;
          }};
}

constexpr int any_limit = 1'000'000;  // for keys without effect

std::map<std::string, Key, std::less<>> keys_of(SettingsFile& file) {
  return {{"size", whole(&file.size, 1, max_width)},
          {"recursion_depth", whole(&file.recursion_depth, -max_depth, max_depth)},
          {"threads", whole(&file.threads, 1, 1024)},
          {"shadows", boolean(&file.shadows)},
          {"smoothshade", boolean(&file.smoothshade)},
          {"backface_culling", boolean(&file.backface_culling)},
          {"internal_reflection", boolean(&file.internal_reflection)},
          {"backface_specular", boolean(&file.backface_specular)},
          {"anti_alias", boolean(&file.anti_alias)},
          {"supersamples", whole(&file.supersamples, 1, max_supersamples)},
          {"aa_threshold", number(&file.aa_threshold)},
          {"threshold", number(&file.threshold)},
          {"blocksize", whole(&file.blocksize, 1, max_block_size)},
          {"kdtree", boolean(nullptr)},
          {"tree_depth", whole(nullptr, 0, any_limit)},
          {"leaf_size", whole(nullptr, 0, any_limit)},
          {"filter_width", whole(nullptr, 0, any_limit)}};
}

// Takes the members of the outermost object as they are read, with their places.
class Reader : public nlohmann::json_sax<json> {
 public:
  Reader(SettingsFile& file, const parser::Source& source, parser::Diagnostics& diagnostics,
         const std::uint32_t& taken)
      : keys_(keys_of(file)), text_(source.text()), diagnostics_(diagnostics), taken_(taken) {}

  bool null() override { return value(json()); }
  bool boolean(bool v) override { return value(json(v)); }
  bool number_integer(number_integer_t v) override { return value(json(v)); }
  bool number_unsigned(number_unsigned_t v) override { return value(json(v)); }
  bool number_float(number_float_t v, const string_t&) override { return value(json(v)); }
  bool string(string_t& v) override { return value(json(v)); }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override {
    if (depth_ > 0) value(json::object());
    ++depth_;
    return true;
  }
  bool start_array(std::size_t) override {
    value(json::array());
    ++depth_;
    return true;
  }
  bool end_object() override {
    --depth_;
    return true;
  }
  bool end_array() override {
    --depth_;
    return true;
  }

  bool key(string_t& name) override {
    if (depth_ != 1) return true;
    name_ = name;
    key_end_ = taken_;
    const std::size_t quote = text_.rfind('"', key_end_ >= 2 ? key_end_ - 2 : 0);
    const Span span{quote == text_.npos ? 0 : static_cast<std::uint32_t>(quote), key_end_};
    const auto found = keys_.find(name);
    key_ = found == keys_.end() ? nullptr : &found->second;
    if (!key_) {
      std::vector<std::string_view> names;
      for (const auto& entry : keys_) names.push_back(entry.first);
      diagnostics_.warning(span, fmt::format("unknown setting '{}' has no effect", name)).suggestion =
          parser::closest(name, names);
    }
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception&) override {
    const auto size = static_cast<std::uint32_t>(text_.size());
    const std::uint32_t at = std::min(static_cast<std::uint32_t>(position > 0 ? position - 1 : 0), size);
    diagnostics_.error({at, std::min(at + 1, size)},
                       at < size ? "this is not valid JSON" : "the JSON text ends too early");
    return false;
  }

 private:
  bool value(const json& v) {
    if (depth_ == 0) {
      diagnostics_.error({0, 1}, "a settings file holds one object: { \"key\": value, ... }");
      return false;
    }
    if (depth_ != 1 || !key_) return true;
    if (!key_->take(v)) {
      diagnostics_.error(value_span(), fmt::format("'{}' takes {}", name_, key_->expects));
    }
    return true;
  }

  // From behind the colon up to a comma, brace or white space (strings: up to where the reader is).
  Span value_span() const {
    std::size_t begin = text_.find_first_not_of(" \t\r\n:", key_end_);
    if (begin == text_.npos) begin = key_end_;
    const std::size_t end =
        text_[begin] == '"' ? taken_ : std::min(text_.find_first_of(", \t\r\n}]", begin), text_.size());
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(std::max(end, begin + 1))};
  }

  std::map<std::string, Key, std::less<>> keys_;
  std::string_view text_;
  parser::Diagnostics& diagnostics_;
  const std::uint32_t& taken_;
  int depth_ = 0;
  std::string name_;
  const Key* key_ = nullptr;
  std::uint32_t key_end_ = 0;
};

}  // namespace

SettingsFile read_settings(const std::string& file) {
  SettingsFile result;
  std::optional<parser::Source> source;
  try {
    source = parser::Source::from_file(file);
  } catch (const std::runtime_error& e) {
    result.valid = false;
    result.messages = fmt::format("trace: error: {}\n", e.what());
    return result;
  }
  const std::string_view text = source->text();
  std::uint32_t taken = 0;
  parser::Diagnostics diagnostics;
  Reader reader(result, *source, diagnostics, taken);
  json::sax_parse(CountingIterator{text.data(), &taken}, CountingIterator{text.data() + text.size(), &taken},
                  &reader);
  result.valid = !diagnostics.has_errors();
  result.messages = parser::render(*source, diagnostics);
  return result;
}

void SettingsFile::apply(RenderOptions& options) const {
  const auto set = [](auto& target, const auto& value) {
    if (value) target = *value;
  };
  set(options.width, size);
  set(options.depth, recursion_depth);
  if (options.depth < 0) options.depth = 0;
  set(options.threads, threads);
  set(options.shading.shadows, shadows);
  set(options.shading.smooth_shading, smoothshade);
  set(options.shading.backface_culling, backface_culling);
  set(options.shading.internal_reflection, internal_reflection);
  set(options.shading.backface_specular, backface_specular);
  set(options.antialiasing.enabled, anti_alias);
  set(options.antialiasing.supersamples, supersamples);
  set(options.antialiasing.threshold, aa_threshold);
  set(options.blocks.threshold, threshold);
  set(options.blocks.size, blocksize);
}

}  // namespace trace
