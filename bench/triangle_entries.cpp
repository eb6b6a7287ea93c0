#include "bench/triangle_entries.hpp"

#include "bench/batch_entries.hpp"
#include "bench/cgal_entries.hpp"
#include "bench/wide_formulas.hpp"
#include "fuzz/subjects/cramer.hpp"
#include "fuzz/subjects/moller_trumbore.hpp"
#include "fuzz/subjects/woop_watertight.hpp"
#include "graze/triangle.hpp"

namespace graze::bench {

template <Real T>
std::vector<Entry<fuzz::RayTriangle<T>>> triangle_entries() {
  using Query = fuzz::RayTriangle<T>;
  std::vector<Entry<Query>> all;
  const auto formula = [&]<class F>(const char* label, F) {
    all.push_back(numbers_entry<Query>(std::string(F::name), label, std::string(F::about), F::deviations,
                                       [](const Query& q) { return F::answer(q); }));
  };
  formula("Cramer", fuzz::cramer::Formula{});
  formula("Möller–Trumbore", fuzz::moller_trumbore::Formula{});
  formula("Woop", fuzz::woop_watertight::Formula{});
  if constexpr (sizeof(T) == sizeof(double)) {
    const auto wide_formula = [&]<class N>(const char* name, const char* label, const char* about, std::size_t stride, N) {
      all.push_back(numbers_entry<Query>(name, label, about, wide::Formula<N>::deviations,
                                         [](const Query& q) { return wide::Formula<N>::answer(q); }));
      all.back().stride = stride;
    };
    wide_formula("cramer-80", "80-bit", "Cramer's rule in 80-bit numbers", 1, 0.0L);
    wide_formula("cramer-double-double", "double-double", "Cramer's rule in double-double", 1, DoubleWord());
    wide_formula("cramer-rational", "rational", "Cramer's rule in GMP's rationals, the last digit cut", 64, mpq_class());
  }
  all.push_back(numbers_entry<Query>("graze-intersect", "graze intersect", "this library's intersect", {},
                                     [](const Query& q) { return intersect(q.ray, q.triangle); }));
  all.back().is_ours = true;

  const auto decision = [&](const char* name, const char* label, const char* about, fuzz::Deviations deviations, auto hits) {
    all.push_back(decision_entry<Query>(name, label, about, deviations, hits));
  };
  decision("moller-trumbore-hits", "Möller–Trumbore", "Moeller and Trumbore with early exits, decisions alone",
           wide::triangle_deviations, [](const Query& q) { return fuzz::moller_trumbore::hits(q.ray, q.triangle); });
  decision("cramer-hits", "Cramer", "Cramer's rule with early exits, decisions alone", wide::triangle_deviations,
           [](const Query& q) { return textbook::cramer::hits(q.ray, q.triangle); });
  decision("graze-hits", "graze hits", "this library's hits", {}, [](const Query& q) { return hits(q.ray, q.triangle); });
  all.back().is_ours = true;
  if constexpr (sizeof(T) == sizeof(double)) add_cgal_entries(all);
  add_batch_entries(all);
  return all;
}

template std::vector<Entry<fuzz::RayTriangle<float>>> triangle_entries();
template std::vector<Entry<fuzz::RayTriangle<double>>> triangle_entries();

}  // namespace graze::bench
