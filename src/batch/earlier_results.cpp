#include "batch/earlier_results.hpp"

#include <algorithm>

#include "batch/run_job.hpp"

namespace trace {
namespace {

// Has it all members, of the kinds that are relied on?
bool is_record(const Record& record) {
  const auto is = [&](const char* name, auto check) {
    const auto found = record.find(name);
    return found != record.end() && check(*found);
  };
  const auto text = [](const Record& value) { return value.is_string(); };
  const auto number = [](const Record& value) { return value.is_number(); };
  const auto comparison = [](const Record& value) {
    return value.is_null() || (value.is_object() && value.value("verdict", Record()).is_string() &&
                               value.contains("reason") && value.contains("diagnosis"));
  };
  const auto any = [](const Record&) { return true; };
  return is("scene", text) && is("renderer", text) && is("outcome", text) && is("message", text) &&
         is("drawing_message", text) && is("seconds", number) && is("cpu_seconds", number) &&
         is("rays", any) && is("heat", any) && is("key", text) && is("comparison", comparison);
}

}  // namespace

EarlierResults::EarlierResults(const std::vector<Record>& records, const std::string& program)
    : program_(program) {
  for (const Record& record : records) {
    if (is_record(record))
      latest_[{record.at("scene").get<std::string>(), record.at("renderer").get<std::string>()}] = &record;
  }
}

const Record* EarlierResults::find(const Job& job) const {
  const auto found = latest_.find({job.name, job.renderer.name});
  return found == latest_.end() ? nullptr : found->second;
}

EarlierResults::Left EarlierResults::left_of(const Job& job, Record& record) {
  const Record* known = find(job);
  if (!known || !picture_is_current(*known, job, program_, files_)) return Left::everything;
  record = *known;
  place(job, record);
  if (comparison_is_current(record, job, program_, files_)) return Left::nothing;
  return Left::comparison;
}

bool EarlierResults::drew_picture_of(const Job& job) const {
  const Record* known = find(job);
  const std::optional<std::string> hash = file_hash(job.picture);
  return known && hash && known->value("picture_hash", "") == *hash;
}

double EarlierResults::seconds_of(const Job& job) const {
  const Record* known = find(job);
  return known ? known->at("seconds").get<double>() : -1;
}

}  // namespace trace
