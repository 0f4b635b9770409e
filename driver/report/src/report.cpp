// SPDX-License-Identifier: Apache-2.0
#include "report/report.hpp"

#include <fmt/format.h>

#include "base/build_info.hpp"
#include "base/case_reader.hpp"
#include "gather.hpp"
#include "page_parts.hpp"
#include "results/unit_endings.hpp"

namespace driver {
namespace {

using Json = nlohmann::ordered_json;

// Numbers distinguish results of the same name.
void name_apart(std::vector<Json>& results) {
  for (std::size_t i = 0; i < results.size(); ++i) {
    int number = 1;
    for (std::size_t k = 0; k < i; ++k)
      if (results[k]["name"] == results[i]["label"]) ++number;
    results[i]["name"] = results[i]["label"];
    if (number > 1)
      results[i]["label"] = fmt::format("{} ({})", results[i]["name"].get<std::string>(), number);
  }
}

// JSON as text for an HTML parser: without `<`, so that no tag or comment can begin.
std::string as_text(const Json& data) {
  const std::string json = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string text;
  text.reserve(json.size() + json.size() / 64);
  for (const char c : json)
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

}  // namespace

std::string report_page(const std::vector<std::filesystem::path>& results, const ReportOptions& options) {
  Json data{{"gasjet", fmt::format("{} ({})", build_info::version, build_info::commit)}};
  data["units"] = unit_endings;
  std::vector<Json> list;
  for (const auto& result : results) try {
      for (Json& one : gather(result, options)) list.push_back(std::move(one));
    } catch (const Json::exception&) {
      throw CaseError(result.string() + ": its JSON is not from gasjet");
    }
  name_apart(list);
  data["results"] = std::move(list);
  const PageParts parts = page_parts();
  const std::string script = fmt::format("{}{}{}{}", parts.charts, parts.series, parts.scene, parts.main);
  const std::string text = as_text(data);
  const std::pair<std::string_view, std::string_view> places[] = {{"@@STYLE@@", parts.style},
                                                                  {"@@DATA@@", text},
                                                                  {"@@THREE@@", parts.three},
                                                                  {"@@ORBIT@@", parts.orbit},
                                                                  {"@@SCRIPT@@", script}};
  std::string page;
  std::size_t begin = 0;
  for (const auto& [mark, content] : places) {
    const std::size_t end = parts.html.find(mark, begin);
    page.append(parts.html.substr(begin, end - begin)).append(content);
    begin = end + mark.size();
  }
  return page.append(parts.html.substr(begin));
}

}  // namespace driver
