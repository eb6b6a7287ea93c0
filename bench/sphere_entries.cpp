#include "bench/sphere_entries.hpp"

#include "bench/batch_entries.hpp"
#include "bench/cgal_entries.hpp"
#include "bench/kahan_sphere.hpp"
#include "bench/wide_formulas.hpp"
#include "fuzz/subjects/goualard_quadratic.hpp"
#include "fuzz/subjects/haines_sphere.hpp"
#include "fuzz/subjects/pbrt_interval.hpp"
#include "fuzz/subjects/textbook_naive.hpp"
#include "fuzz/subjects/textbook_repaired.hpp"
#include "fuzz/subjects/textbook_stable.hpp"
#include "graze/sphere.hpp"

namespace graze::bench {

template <Real T>
std::vector<Entry<fuzz::RaySphere<T>>> sphere_entries() {
  using Query = fuzz::RaySphere<T>;
  std::vector<Entry<Query>> all;
  const auto formula = [&]<class F>(const char* label, F) {
    all.push_back(numbers_entry<Query>(std::string(F::name), label, std::string(F::about), F::deviations,
                                       [](const Query& q) { return F::answer(q); }));
  };
  formula("naive", fuzz::textbook_naive::Formula{});
  formula("stable", fuzz::textbook_stable::Formula{});
  formula("repaired", fuzz::textbook_repaired::Formula{});
  formula("Kahan", kahan_sphere::Formula{});
  formula("Goualard", fuzz::goualard_quadratic::Formula{});
  formula("Haines", fuzz::haines_sphere::Formula{});
  formula("pbrt", fuzz::pbrt_interval::Formula{});
  if constexpr (sizeof(T) == sizeof(double)) {
    const auto wide_formula = [&]<class N>(const char* name, const char* label, const char* about, std::size_t stride, N) {
      all.push_back(numbers_entry<Query>(name, label, about, wide::Formula<N>::deviations,
                                         [](const Query& q) { return wide::Formula<N>::answer(q); }));
      all.back().stride = stride;
    };
    wide_formula("repaired-80", "80-bit", "the repaired quadratic in 80-bit numbers", 1, 0.0L);
    wide_formula("repaired-double-double", "double-double", "the repaired quadratic in double-double", 1, DoubleWord());
    wide_formula("repaired-rational", "rational", "the repaired quadratic in GMP's rationals, the root to 256 bits", 64,
                 mpq_class());
  }
  all.push_back(numbers_entry<Query>("graze-intersect", "graze intersect", "this library's intersect", {},
                                     [](const Query& q) { return intersect(q.ray, q.sphere); }));
  all.back().is_ours = true;

  const auto decision = [&](const char* name, const char* label, const char* about, auto hits) {
    all.push_back(decision_entry<Query>(name, label, about, {}, hits));
  };
  decision("textbook-naive-hits", "naive", "the naive quadratic, decisions alone",
           [](const Query& q) { return textbook::naive::hits(q.ray, q.sphere); });
  decision("textbook-repaired-hits", "repaired", "the repaired quadratic, decisions alone",
           [](const Query& q) { return textbook::repaired::hits(q.ray, q.sphere); });
  decision("graze-hits", "graze hits", "this library's hits", [](const Query& q) { return hits(q.ray, q.sphere); });
  all.back().is_ours = true;
  if constexpr (sizeof(T) == sizeof(double)) add_cgal_entries(all);
  add_batch_entries(all);
  return all;
}

template std::vector<Entry<fuzz::RaySphere<float>>> sphere_entries();
template std::vector<Entry<fuzz::RaySphere<double>>> sphere_entries();

}  // namespace graze::bench
