#include "app/output/json_file.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

/// Builds the value of a JSON text. An array or object is made once its last member is known: an ordered_json that
/// grows member by member copies everything inside it each time that its memory is moved.
class TreeBuilder : public nlohmann::json_sax<Json> {
 public:
  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t& /*text*/) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t& /*value*/) override { return false; }
  bool key(string_t& name) override {
    open_.back().key = std::move(name);
    return true;
  }
  bool start_object(std::size_t /*size*/) override { return open(true); }
  bool start_array(std::size_t /*size*/) override { return open(false); }
  bool end_array() override {
    Json array = Json(std::move(open_.back().elements));
    open_.pop_back();
    return add(std::move(array));
  }
  bool end_object() override {
    Members members = std::move(open_.back().members);
    open_.pop_back();
    if (!keys_differ(members)) {
      return false;
    }
    Json object = Json::object();
    auto& storage = object.get_ref<Json::object_t&>();
    storage.reserve(members.size());
    for (auto& [name, value] : members) {
      storage.emplace_back(std::move(name), std::move(value));
    }
    return add(std::move(object));
  }
  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::detail::exception& /*error*/) override {
    fault_ = fmt::format("it is not valid JSON from its byte {} on; is it cut off?", position);
    return false;
  }

  [[nodiscard]] const std::string& fault() const { return fault_; }
  Json take() { return std::move(root_); }

 private:
  using Members = std::vector<std::pair<std::string, Json>>;
  struct Open {
    bool is_object = false;
    std::string key;  // of the member that is read next
    Members members;
    Json::array_t elements;
  };

  bool open(bool is_object) {
    if (open_.size() == max_json_depth) {
      fault_ = fmt::format("its values are nested more than {} deep", max_json_depth);
      return false;
    }
    open_.push_back({is_object, {}, {}, {}});
    return true;
  }

  template <typename Value>
  bool add(Value&& value) {
    if (open_.empty()) {
      root_ = std::forward<Value>(value);
    } else if (open_.back().is_object) {
      open_.back().members.emplace_back(std::move(open_.back().key), std::forward<Value>(value));
    } else {
      open_.back().elements.emplace_back(std::forward<Value>(value));
    }
    return true;
  }

  bool keys_differ(const Members& members) {
    std::vector<std::string_view> keys;
    keys.reserve(members.size());
    for (const auto& [name, value] : members) {
      keys.emplace_back(name);
    }
    std::sort(keys.begin(), keys.end());
    const auto twice = std::adjacent_find(keys.begin(), keys.end());
    if (twice != keys.end()) {
      fault_ = fmt::format("the key {} is there twice in one object", in_quotes(*twice));
    }
    return twice == keys.end();
  }

  std::vector<Open> open_;
  Json root_;
  std::string fault_;
};

}  // namespace

Expected<Json> parse_json(std::string_view text, std::string_view what, const std::string& path) {
  TreeBuilder builder;
  if (!Json::sax_parse(text.begin(), text.end(), &builder)) {
    return bad_input(fmt::format("this is no {}: {}", what, builder.fault()), path);
  }
  return builder.take();
}

}  // namespace artcal
