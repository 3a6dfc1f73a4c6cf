// The HTML report as a file; what it does in a browser is tested in browser_test.cpp.
#include "report/html.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <regex>

#include "image/image.hpp"
#include "tests/support/temporary_folder.hpp"

namespace trace::test {
namespace {

using Json = nlohmann::ordered_json;

Json result(const std::string& scene, const Json& picture = nullptr, const Json& solution = nullptr,
            const std::string& verdict = "beyond") {
  Json comparison;
  if (solution.is_string())
    comparison = {{"verdict", verdict}, {"reason", ""}, {"diagnosis", nullptr}, {"measurements", nullptr}};
  return {{"scene", scene},       {"renderer", "trace"}, {"outcome", "rendered"},
          {"message", ""},        {"seconds", 0.1},      {"picture", picture},
          {"solution", solution}, {"heat", nullptr},     {"comparison", comparison}};
}

Json batch(const std::vector<Json>& results, const std::string& title = "t") {
  return {{"format", "trace-batch"},
          {"version", 1},
          {"title", title},
          {"renderers", {"trace"}},
          {"results", results}};
}

// A picture file of 2 x 1 pixels, the first of this gray.
std::string picture(const TemporaryFolder& folder, const std::string& name, std::uint8_t gray) {
  const std::string file = (folder / name).string();
  write_image(file, Image{2, 1, {gray, gray, gray, 255, 255, 255}});
  return file;
}

std::string page_of(const TemporaryFolder& folder, const Json& report, const HtmlOptions& options = {}) {
  const auto file = folder / "report.html";
  write_html_report(report, file, options);
  return read_text(file);
}

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t number = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += what.size()) ++number;
  return number;
}

// What the page's script reads.
Json data_of(const std::string& page) {
  const std::string open = "<script type=\"application/json\" id=\"report\">";
  const std::size_t begin = page.find(open) + open.size();
  return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

constexpr const char* embedded = "<script type=\"image/png\"";

}  // namespace

TEST_CASE("the report is one HTML page with its style, scripts and data") {
  const TemporaryFolder folder;
  const std::string page = page_of(folder, batch({result("a.ray")}));
  CHECK(page.rfind("<!doctype html>", 0) == 0);
  CHECK(page.find("</html>") != page.npos);
  CHECK(page.find("{{") == page.npos);
  CHECK(page.find("var uPlot") != page.npos);
  CHECK(page.find("customElements.define(\"img-comparison-slider\"") != page.npos);
  CHECK(data_of(page)["results"][0]["scene"] == "a.ray");
  CHECK(folder.names() == std::vector<std::string>{"report.html"});
}

TEST_CASE("the report without its pictures is below a megabyte for 200 scenes") {
  const TemporaryFolder folder;
  std::vector<Json> results;
  for (int i = 0; i < 200; ++i) results.push_back(result("scenes/number" + std::to_string(i) + ".ray"));
  CHECK(page_of(folder, batch(results)).size() < 1'000'000);
}

TEST_CASE("the report names no address that a browser would load") {
  const TemporaryFolder folder;
  const std::string page = page_of(folder, batch({result("a.ray")}));
  const std::regex loads(
      R"((src|href|action|data)\s*=\s*["']?(https?:)?//|url\(\s*["']?(https?:)?//|@import|import\()",
      std::regex::icase);
  CHECK_FALSE(std::regex_search(page, loads));
  CHECK(page.find("sourceMappingURL") == page.npos);
  CHECK(page.find("default-src 'none'") != page.npos);
}

TEST_CASE("the vendored scripts come with their licences") {
  const TemporaryFolder folder;
  const std::string page = page_of(folder, batch({result("a.ray")}));
  CHECK(page.find("Copyright (c) 2022 Leon Sorokin") != page.npos);
  CHECK(page.find("Copyright (c) 2019 Dmitry Snisarenko") != page.npos);
}

TEST_CASE("nothing in the report's data can end its element or begin a comment") {
  const TemporaryFolder folder;
  const std::string nasty = "</script><script>alert(1)</script><!-- \" ' & \xE2\x80\xA8";
  const std::string page = page_of(folder, batch({result(nasty)}, nasty));
  CHECK(page.find("alert(1)</script><!--") == page.npos);
  CHECK(page.find("<title>&lt;/script&gt;&lt;script&gt;alert(1)") != page.npos);
  CHECK(data_of(page)["results"][0]["scene"] == nasty);
}

TEST_CASE("names that are not UTF-8 do not break the report") {
  const TemporaryFolder folder;
  CHECK(data_of(page_of(folder, batch({result("caf\xE9.ray")})))["results"][0]["scene"] == "caf\uFFFD.ray");
}

TEST_CASE("a PNG is embedded as it is") {
  const TemporaryFolder folder;
  const std::string file = picture(folder, "a.png", 7);
  // Anything that begins like a PNG; 10 bytes, so that base64 ends in padding.
  const std::string bytes = "\x89PNG\r\n\x1a\n\xff\x01";
  write_text(file, bytes);
  const std::string page = page_of(folder, batch({result("a.ray", file)}));
  CHECK(page.find("id=\"picture-0\">iVBORw0KGgr/AQ==</script>") != page.npos);
  CHECK(data_of(page)["results"][0]["places"]["picture"]["id"] == 0);
}

TEST_CASE("a picture of another kind is embedded as a PNG") {
  const TemporaryFolder folder;
  const std::string bmp = picture(folder, "a.bmp", 7), png = picture(folder, "b.png", 7);
  const std::string from_bmp = page_of(folder, batch({result("a.ray", bmp)}));
  const std::string from_png = page_of(folder, batch({result("a.ray", png)}));
  const auto element = [](const std::string& page) { return page.substr(page.find(embedded)); };
  CHECK(element(from_bmp) == element(from_png));
}

TEST_CASE("a solution that is identical to the picture is embedded once") {
  const TemporaryFolder folder;
  // The files differ; the verdict says that their pixels do not.
  const std::string ours = picture(folder, "a.png", 1), theirs = picture(folder, "b.bmp", 1);
  const std::string page = page_of(folder, batch({result("a.ray", ours, theirs, "identical")}));
  CHECK(occurrences(page, embedded) == 1);
  const Json places = data_of(page)["results"][0]["places"];
  CHECK(places["solution"] == places["picture"]);
}

TEST_CASE("files with the same bytes are embedded once, others each") {
  const TemporaryFolder folder;
  const std::string a = picture(folder, "a.png", 1), same = picture(folder, "same.png", 1),
                    other = picture(folder, "other.png", 2);
  const std::string page = page_of(folder, batch({result("a.ray", a, same), result("b.ray", other, a)}));
  CHECK(occurrences(page, embedded) == 2);
  const Json data = data_of(page);
  CHECK(data["results"][0]["places"]["picture"] == data["results"][1]["places"]["solution"]);
  CHECK(data["results"][1]["places"]["picture"] != data["results"][1]["places"]["solution"]);
}

TEST_CASE("a missing or unreadable picture is told of in its place") {
  const TemporaryFolder folder;
  write_text(folder / "text.png", "this is no picture");
  const std::string page = page_of(folder, batch({result("a.ray", (folder / "none.png").string()),
                                                  result("b.ray", (folder / "text.png").string())}));
  CHECK(page.find("id=\"picture-0\" data-error=\"no such file\"></script>") != page.npos);
  CHECK(page.find("id=\"picture-1\" data-error=\"not a picture this program can read\"></script>") !=
        page.npos);
}

TEST_CASE("without embedding, pictures are linked from the page's folder") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "out");
  const std::string file = picture(folder, "out/a b#1.png", 1);
  const std::string page = page_of(folder, batch({result("a.ray", file)}), {.embed_pictures = false});
  CHECK(occurrences(page, embedded) == 0);
  CHECK(data_of(page)["results"][0]["places"]["picture"]["href"] == "out/a%20b%231.png");
}

TEST_CASE("a report of another format is refused and leaves the file as it was") {
  const TemporaryFolder folder;
  const auto file = folder / "report.html";
  write_text(file, "before");
  Json report = batch({});
  report["version"] = 2;
  CHECK_THROWS_AS(write_html_report(report, file), std::invalid_argument);
  CHECK_THROWS_AS(write_html_report(Json(3), file), std::invalid_argument);
  CHECK(read_text(file) == "before");
}

TEST_CASE("a report that cannot be written is an error") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(write_html_report(batch({}), folder / "none/report.html"), ImageError);
}

}  // namespace trace::test
