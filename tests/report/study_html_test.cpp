// The HTML report of a study as a file; what it does in a browser is tested in browser_test.cpp.
#include "report/study_html.hpp"

#include <catch2/catch.hpp>
#include <regex>

#include "image/image.hpp"
#include "tests/report/sample_study.hpp"
#include "tests/support/temporary_folder.hpp"

namespace trace::test {
namespace {

using StudyPageJson = nlohmann::ordered_json;

std::string study_page(const TemporaryFolder& folder, const StudyPageJson& report,
                       const NamedPictures& pictures = {}) {
  const auto file = folder / "study.html";
  write_study_report(report, pictures, file);
  return read_text(file);
}

// What the page's script reads.
StudyPageJson study_data(const std::string& page) {
  const std::string open = "<script type=\"application/json\" id=\"report\">";
  const std::size_t begin = page.find(open) + open.size();
  return StudyPageJson::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

std::size_t embedded_pictures(const std::string& page) {
  const std::string element = "<script type=\"image/png\"";
  std::size_t number = 0;
  for (std::size_t at = 0; (at = page.find(element, at)) != page.npos; at += element.size()) ++number;
  return number;
}

}  // namespace

TEST_CASE("the report of a study is one HTML page that names no address a browser would load") {
  const TemporaryFolder folder;
  const std::string page = study_page(folder, made_up_study(2, 14));
  CHECK(page.rfind("<!doctype html>", 0) == 0);
  CHECK(page.find("</html>") != page.npos);
  CHECK(page.find("{{") == page.npos);
  CHECK(page.find("var uPlot") != page.npos);
  CHECK(page.find("Copyright (c) 2022 Leon Sorokin") != page.npos);
  CHECK(page.find("default-src 'none'") != page.npos);
  const std::regex loads(
      R"((src|href|action|data)\s*=\s*["']?(https?:)?//|url\(\s*["']?(https?:)?//|@import|import\()",
      std::regex::icase);
  CHECK_FALSE(std::regex_search(page, loads));
  CHECK(folder.names() == std::vector<std::string>{"study.html"});
}

TEST_CASE("pictures of a study are embedded as they are, each of the same bytes once") {
  const TemporaryFolder folder;
  StudyPageJson report = made_up_study(2, 3);
  report["scenes"][0]["converged"]["picture"] = "a converged";
  report["scenes"][0]["results"][1]["picture"] = "a 2x2";
  report["scenes"][0]["results"][1]["heat"] = "a 2x2 heat";
  report["scenes"][1]["converged"]["picture"] = "b converged";
  const NamedPictures pictures{{"a converged", {0x89, 'P', 'N', 'G', 0xff, 1}},
                               {"a 2x2", {1, 2, 3}},
                               {"a 2x2 heat", {1, 2, 3}},
                               {"b converged", {0x89, 'P', 'N', 'G', 0xff, 1}},
                               {"not mentioned", {9}}};
  const std::string page = study_page(folder, report, pictures);
  CHECK(embedded_pictures(page) == 2);
  CHECK(page.find("id=\"picture-0\">iVBOR/8B</script>") != page.npos);
  CHECK(page.find("id=\"picture-1\">AQID</script>") != page.npos);
  const StudyPageJson scenes = study_data(page)["scenes"];
  CHECK(scenes[0]["places"]["converged"]["id"] == 0);
  CHECK(scenes[1]["places"]["converged"]["id"] == 0);
  CHECK(scenes[0]["results"][1]["places"]["picture"]["id"] == 1);
  CHECK(scenes[0]["results"][1]["places"]["heat"]["id"] == 1);
  CHECK(scenes[0]["results"][0]["places"].empty());
}

TEST_CASE("the solution in the report of a study is a file, and told of where it is missing") {
  const TemporaryFolder folder;
  const auto solution = folder / "solution.png";
  write_image(solution, Image{1, 1, {1, 2, 3}});
  StudyPageJson report = made_up_study(2, 1);
  report["scenes"][0]["solution"] = solution.string();
  report["scenes"][1]["solution"] = (folder / "none.png").string();
  const std::string page = study_page(folder, report);
  CHECK(page.find("id=\"picture-0\">iVBORw0KGgo") != page.npos);
  CHECK(page.find("id=\"picture-1\" data-error=\"no such file\"></script>") != page.npos);
  CHECK(study_data(page)["scenes"][1]["places"]["solution"]["id"] == 1);
}

TEST_CASE("nothing in the data of a study can end its element or begin a comment") {
  const TemporaryFolder folder;
  const std::string nasty = "</script><script>alert(1)</script><!-- \" ' &";
  StudyPageJson report = made_up_study(1, 2);
  report["title"] = nasty;
  report["scenes"][0]["scene"] = nasty;
  report["settings"][0]["options"] = nasty;
  const std::string page = study_page(folder, report);
  CHECK(page.find("alert(1)</script><!--") == page.npos);
  CHECK(page.find("<title>&lt;/script&gt;&lt;script&gt;alert(1)") != page.npos);
  CHECK(study_data(page)["scenes"][0]["scene"] == nasty);
}

TEST_CASE("what is no study is refused and leaves the file as it was") {
  const TemporaryFolder folder;
  const auto file = folder / "study.html";
  write_text(file, "before");
  StudyPageJson report = made_up_study(1, 1);
  report["version"] = 2;
  CHECK_THROWS_AS(write_study_report(report, {}, file), std::invalid_argument);
  report["version"] = 1;
  report["format"] = "trace-batch";
  CHECK_THROWS_AS(write_study_report(report, {}, file), std::invalid_argument);
  CHECK_THROWS_AS(write_study_report(StudyPageJson("text"), {}, file), std::invalid_argument);
  CHECK(read_text(file) == "before");
  CHECK_THROWS_AS(write_study_report(made_up_study(1, 1), {}, folder / "none/study.html"), ImageError);
}

}  // namespace trace::test
