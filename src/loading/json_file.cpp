#include "loading/json_file.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

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

// Builds the tree from the reader's events. `taken_` is behind the token of an event, or one further where
// the reader had to see the character behind a number.
class TreeBuilder : public nlohmann::json_sax<json> {
 public:
  TreeBuilder(std::string_view text, parser::Diagnostics& diagnostics, const std::uint32_t& taken)
      : text_(text), diagnostics_(diagnostics), taken_(taken) {}

  std::optional<JsonValue> take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool v) override { return add(v); }
  bool number_integer(number_integer_t v) override { return add(static_cast<double>(v)); }
  bool number_unsigned(number_unsigned_t v) override { return add(static_cast<double>(v)); }
  bool number_float(number_float_t v, const string_t&) override { return add(v); }
  bool string(string_t& v) override { return add(std::move(v)); }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return open(JsonValue::Object()); }
  bool start_array(std::size_t) override { return open(JsonValue::Array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    const Span span{token_begin(), taken_};
    previous_end_ = taken_;
    JsonMember& member = std::get<JsonValue::Object>(open_.back().value).emplace_back();
    member.name = std::move(name);
    member.name_span = span;
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
  std::uint32_t token_begin() const {
    const std::size_t begin = text_.find_first_not_of(" \t\r\n:,", previous_end_);
    return static_cast<std::uint32_t>(std::min(begin, text_.size()));
  }

  template <class Kind>
  bool add(Kind value) {
    const std::uint32_t begin = token_begin();
    const std::size_t end =
        text_[begin] == '"' ? taken_ : std::min(text_.find_first_of(", \t\r\n}]", begin), text_.size());
    previous_end_ = static_cast<std::uint32_t>(end);
    JsonValue& target = next();
    target.span = {begin, previous_end_};
    target.value = std::move(value);
    return true;
  }

  template <class Kind>
  bool open(Kind empty) {
    const Span bracket{taken_ - 1, taken_};
    previous_end_ = taken_;
    if (open_.size() == max_json_depth) {
      diagnostics_.error(bracket, "lists and objects are nested too deeply");
      return false;
    }
    JsonValue& container = open_.emplace_back();
    container.span = bracket;
    container.value = std::move(empty);
    return true;
  }

  bool close() {
    JsonValue done = std::move(open_.back());
    open_.pop_back();
    done.span.end = previous_end_ = taken_;
    next() = std::move(done);
    return true;
  }

  // Where the next value belongs.
  JsonValue& next() {
    if (open_.empty()) return root_.emplace();
    auto& container = open_.back().value;
    if (auto* object = std::get_if<JsonValue::Object>(&container)) return object->back().value;
    return std::get<JsonValue::Array>(container).emplace_back();
  }

  std::string_view text_;
  parser::Diagnostics& diagnostics_;
  const std::uint32_t& taken_;
  std::uint32_t previous_end_ = 0;
  std::vector<JsonValue> open_;
  std::optional<JsonValue> root_;
};

}  // namespace

std::optional<JsonValue> parse_json(const parser::Source& source, parser::Diagnostics& diagnostics) {
  const std::string_view text = source.text();
  std::uint32_t taken = 0;
  TreeBuilder builder(text, diagnostics, taken);
  const bool valid = json::sax_parse(CountingIterator{text.data(), &taken},
                                     CountingIterator{text.data() + text.size(), &taken}, &builder);
  return valid ? builder.take() : std::nullopt;
}

}  // namespace trace
