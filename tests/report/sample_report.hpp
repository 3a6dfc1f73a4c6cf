// A report with one pair of each kind, made by hand.
#pragma once

#include "report/diff_report.hpp"

namespace trace::test {

inline Measurements sample_measurements() {
  Measurements m;
  m.width = 4;
  m.height = 2;
  m.channels = 3;
  m.error = {0.5, 3.25, 37.5, -0.125, 16};
  m.channel = {m.error, ErrorFigures{}, {1, 2, 42, -1, 4}};
  m.largest = {{3, 1}, 2, 255, 239};
  m.percent_different = 25;
  m.percent_over_one = 12.5;
  m.percent_over_threshold = 12.5;
  m.percentiles = {0, 4, 16, 16};
  m.ssim = 0.75;
  m.foreground = {4, m.error, 25};
  m.edge_tolerant = {1.5, 4, 6.25};
  m.worst = {{2, 0, 4, 2, 3, 8.5}};
  return m;
}

inline Judgement judged(Verdict verdict, const std::string& reason = "") {
  Judgement judgement;
  judgement.verdict = verdict;
  judgement.reason = reason;
  return judgement;
}

inline DiffReport sample_report() {
  Judgement beyond = judged(Verdict::beyond, "RMSE 3.25 is over 0.5");
  beyond.measurements = sample_measurements();
  beyond.diagnosis = Diagnosis{Diagnosis::Kind::shadows_missing, "shadows are missing"};
  Judgement identical = judged(Verdict::identical);
  identical.measurements = Measurements{};
  identical.measurements->width = identical.measurements->height = identical.measurements->channels = 1;
  identical.measurements->channel.resize(1);
  return {
      "A",
      "B",
      {{"beyond", "A/beyond.png", "B/beyond.png", beyond},
       {"same", "A/same.png", "B/same.bmp", identical},
       {"simple/extra", std::nullopt, "B/simple/extra.png", judged(Verdict::extra, "there is none in A")},
       {"simple/lost", "A/simple/lost.png", std::nullopt, judged(Verdict::missing, "there is none in B")}}};
}

}  // namespace trace::test
