// The measuring of errors, on answers whose errors are known: t off by exactly k ulps must be told as k.
#include "bench/errors.hpp"

#include <cmath>
#include <limits>

#include "bench/mixes.hpp"
#include "tests/catch.hpp"

namespace graze::bench {
namespace {

template <Real T>
T moved(T x, int ulps) {
  for (int i = 0; i < std::abs(ulps); ++i) x = std::nextafter(x, ulps > 0 ? std::numeric_limits<T>::infinity() : T(0));
  return x;
}

template <Real T>
void move(SphereHit<T>& hit, int ulps) {
  for (int i = 0; i < hit.count(); ++i) hit.t[i] = moved(hit.t[i], ulps);
}
template <Real T>
void move(TriangleHit<T>& hit, int ulps) {
  hit.t = moved(hit.t, ulps);
  hit.t_end = moved(hit.t_end, ulps);
}

/// A query whose t is a number of the format, in the middle of a binade, and others like it.
template <Real T>
std::vector<fuzz::RaySphere<T>> exact_queries(const fuzz::RaySphere<T>&) {
  std::vector<fuzz::RaySphere<T>> out;
  for (int i = 1; i < 40; ++i) out.push_back({{{0, 0, 0}, {1, 0, 0}}, {{T(96 + i % 3), 0, 0}, T(20 + i % 5)}});
  return out;
}
template <Real T>
std::vector<fuzz::RayTriangle<T>> exact_queries(const fuzz::RayTriangle<T>&) {
  std::vector<fuzz::RayTriangle<T>> out;
  for (int i = 1; i < 40; ++i)
    out.push_back({{{1, 1, 0}, {0, 0, 1}}, {{0, 0, T(70 + i)}, {9, 0, T(70 + i)}, {0, 9, T(70 + i)}}});
  return out;
}

template <class Query>
Errors errors_of_moved(const std::vector<Query>& queries, int ulps) {
  const std::vector<TruthOf<Query>> truths = truths_of<Query>(queries);
  std::vector<HitOf<Query>> answers;
  for (const TruthOf<Query>& truth : truths) {
    answers.push_back(truth.hit);
    move(answers.back(), ulps);
  }
  return errors_of<Query>(queries, truths, answers, {});
}

}  // namespace

TEMPLATE_TEST_CASE("t off by exactly k ulps is told as k", "", fuzz::RaySphere<float>, fuzz::RaySphere<double>,
                   fuzz::RayTriangle<float>, fuzz::RayTriangle<double>) {
  const std::vector<TestType> queries = exact_queries(TestType{});
  for (const int k : {0, 1, 2, 3, 7, 100, -1, -5, -64}) {
    CAPTURE(k);
    const Errors errors = errors_of_moved(queries, k);
    CHECK(errors.queries == queries.size());
    CHECK(errors.hits == queries.size());
    CHECK(errors.wrong == 0);
    CHECK(errors.values >= queries.size());
    CHECK(errors.correct == (k == 0 ? errors.values : 0));
    CHECK(errors.median == std::abs(k));
    CHECK(errors.p999 == std::abs(k));
    CHECK(errors.max == std::abs(k));
  }
}

TEMPLATE_TEST_CASE("Correctly rounded t errs by half an ulp at most, t one ulp off by half an ulp at least", "",
                   fuzz::RaySphere<float>, fuzz::RaySphere<double>, fuzz::RayTriangle<float>, fuzz::RayTriangle<double>) {
  for (const Mix<TestType>& mix : mixes_of(TestType{})) {
    CAPTURE(mix.name);
    const std::vector<TestType> queries = mix.make(300, 5);
    const Errors right = errors_of_moved(queries, 0);
    CHECK(right.wrong == 0);
    CHECK(right.values > 0);
    CHECK(right.correct == right.values);
    CHECK(right.max <= 0.5);
    if (mix.name == "lattice") continue;  // t = 0, whose neighbours are subnormal
    const Errors off = errors_of_moved(queries, 1);
    CHECK(off.correct == 0);
    CHECK(off.median >= 0.5);
    CHECK(off.max <= 2.5);  // below a power of two the spacing above it counts twice
  }
}

TEST_CASE("One answer among many is told where it belongs: the median stays, the maximum and its case are its own") {
  using Query = fuzz::RayTriangle<double>;
  const std::vector<Query> queries = exact_queries(Query{});
  const auto truths = truths_of<Query>(queries);
  std::vector<TriangleHit<double>> answers;
  for (const auto& truth : truths) answers.push_back(truth.hit);
  move(answers[17], 12);
  answers[20].t = std::numeric_limits<double>::quiet_NaN();
  Errors errors = errors_of<Query>(queries, truths, answers, {});
  CHECK(errors.median == 0);
  CHECK(errors.max == std::numeric_limits<double>::infinity());
  CHECK(errors.correct == errors.values - 2);
  answers[20] = truths[20].hit;
  errors = errors_of<Query>(queries, truths, answers, {});
  CHECK(errors.max == 12);
  CHECK(errors.worst_case.find("0x1.6p+6") != std::string::npos);  // 88 = 70 + 18: the plane of query 17
}

TEST_CASE("Wrong decisions are counted, and their numbers held against nothing") {
  using Query = fuzz::RaySphere<double>;
  const std::vector<Query> queries = exact_queries(Query{});
  const auto truths = truths_of<Query>(queries);
  std::vector<SphereHit<double>> answers;
  std::vector<bool> decisions;
  for (const auto& truth : truths) {
    answers.push_back(truth.hit);
    decisions.push_back(true);
  }
  answers[3].kind = SphereKind::miss;
  answers[4].root = Root::first;
  answers[5].t[1] = 1e9;
  const Errors errors = errors_of<Query>(queries, truths, answers, {});
  CHECK(errors.wrong == 2);
  CHECK(errors.values == 2 * (queries.size() - 2));
  CHECK(errors.correct == errors.values - 1);
  decisions[7] = decisions[8] = false;
  CHECK(errors_of<Query>(queries, truths, decisions, {}).wrong == 2);
}

TEST_CASE("What is declared is allowed for") {
  using Query = fuzz::RayTriangle<double>;
  const std::vector<Query> queries{{{{-1, 1, 0}, {1, 0, 0}}, {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}};  // in the plane
  const auto truths = truths_of<Query>(queries);
  REQUIRE(truths[0].hit.kind == TriangleKind::coplanar);
  const std::vector<bool> decisions{false};
  CHECK(errors_of<Query>(queries, truths, decisions, {}).wrong == 1);
  CHECK(errors_of<Query>(queries, truths, decisions, {{fuzz::Deviation::coplanar_is_miss}}).wrong == 0);
}

TEST_CASE("Quantiles are elements, by the nearest rank") {
  std::vector<double> values;
  for (int i = 1000; i >= 1; --i) values.push_back(i);
  CHECK(quantile(values, 0.5) == 500);
  CHECK(quantile(values, 0.999) == 999);
  CHECK(quantile(values, 1) == 1000);
  std::vector<double> one{7};
  CHECK(quantile(one, 0.001) == 7);
}

}  // namespace graze::bench
