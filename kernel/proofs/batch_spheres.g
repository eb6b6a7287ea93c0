# The terms of a sphere's quadratic in lanes, each format by itself (src/batch/spheres-inl.hpp), and by the unit direction
# (src/batch/unit_spheres-inl.hpp).
#
# Scaled as in sphere_filter.g: a = 1, |b| <= 1, |c| <= 1, D = b^2 - c; F is of k roundings, H of what underflows, in units.
#
# Proved, in this order: what underflows in D is less than 2^20 f (A + 1) or than 2^-20 of 8 units of A S, f the least normal number, in a
# few cases of |L| and |d|; C errs by 6 roundings, its bound is computed in 5; D's first form errs by less than its bound as computed, in 10
# roundings; a number is placed by two forms whose bounds cover them; B's sign is right where C and D are beyond their bounds.
# Then in rounding to nearest, in v = u / 2: the length of d errs by 2.5, a component of the unit direction by 3.5, B by 7.5. Scaled so that
# Q = 1: C errs by 7 where s = r^2 <= 1, which is less than the bound as computed, in 7 roundings; then D errs by less than that too.
#
# Left to say: as in sphere_filter.g; x = sqrt(1 + F3 v) - 1 is F3 v / (sqrt(1 + F3 v) + 1); (1 + F5 v - s (1 + E v)) (1 + K1 v) falls with s, so
# for s >= 1 the computed C is at most what it may be at s = 1.
batch_sphere_c_error = 8b0;              # bound: src/batch/bounds.hpp
batch_sphere_discriminant_error = 32b0;  # bound: src/batch/bounds.hpp
batch_sphere_place_error = 8b0;          # bound: src/batch/bounds.hpp
batch_unit_sphere_error = 16b0;          # bound: src/batch/bounds.hpp
batch_float_low = 1b-24;                 # domain: src/batch/bounds.hpp
batch_float_high = 1b30;                 # domain: src/batch/bounds.hpp
batch_float_most_squares = 1b64;         # domain: src/batch/bounds.hpp
batch_double_low = 1b-200;               # domain: src/batch/bounds.hpp
batch_double_high = 1b200;               # domain: src/batch/bounds.hpp
batch_double_most_squares = 1b400;       # domain: src/batch/bounds.hpp
u = 1b-52;                               # and 1b-23

v = u / 2;
db = DB * u; dc = DC * u; f3 = F3 * u; g2 = G2 * u; k2 = K2 * u; h = H * u;
dbv = DB * v; dcv = DC * v; g2v = G2 * v; k1v = K1 * v; hv = H * v;

# 16 f (A + 1) (1 + |L|) (|d| |L| + 1), of f (A + 1) where |L| is small.
{ L in [0, 1b-16] /\ d in [0, 1b30] -> 16 * (1 + L) * (d * L + 1) in [0, 1b20] }
{ L in [0, 1b-190] /\ d in [0, 1b200] -> 16 * (1 + L) * (d * L + 1) in [0, 1b20] }
# Of A L^2 elsewhere: m = 1 / |L|, i = 1 / |d|, A = d^2.
{ m in [0, 1b16] /\ i in [1, 1b24] /\ d in [0, 1] -> 16 * 1b-126 * (1 + i * i) * (1 + m) * (d + m) / (8 * 1b-23) in [0, 1b-20] }
{ m in [0, 1b16] /\ i in [0, 1] /\ d in [1, 1b30] -> 16 * 1b-126 * (1 + i * i) * (1 + m) * (d + m) / (8 * 1b-23) in [0, 1b-20] }
{ m in [0, 1b190] /\ i in [0, 1b200] /\ d in [0, 1b200] -> 16 * 1b-1022 * (1 + i * i) * (1 + m) * (d + m) / (8 * 1b-52) in [0, 1b-20] }
# Nothing overflows, with a number x of the range too.
{ batch_float_high * batch_float_high * batch_float_most_squares * 4 in [0, 1b127]
/\ batch_float_high * batch_float_high * batch_float_high * batch_float_high * 4 in [0, 1b127]
/\ batch_double_high * batch_double_high * batch_double_most_squares * 4 in [0, 1b1000]
/\ batch_double_high * batch_double_high * batch_double_high * batch_double_high * 4 in [0, 1b1000] }

# C, D, f and g.
{ |F6| <= 98310b-14 /\ |H| <= 1b-16 /\ |F5| <= 81925b-14 -> |(F6 + H) / (batch_sphere_c_error * (1 + F5 * u))| <= 1 }
{ |b| <= 1 /\ |c| <= 1 /\ |DB| <= 65541b-14 /\ |F3| <= 49156b-14 /\ |DC| <= 98311b-14 /\ |G2| <= 32770b-14 /\ |K2| <= 32770b-14
/\ |F10| <= 163850b-14 /\ |H| <= 1b-16 ->
   |((2 * b * db + db * db) * (1 + g2) + b * b * g2 - (dc + f3 * c + f3 * dc) * (1 + k2) - c * k2 + h) / u
     / (batch_sphere_discriminant_error * (1 + F10 * u))| <= 1 }
{ |F7| <= 114696b-14 /\ |H| <= 1b-16 /\ |F10| <= 163850b-14 -> |(F7 + H) / (batch_sphere_place_error * (1 + F10 * u))| <= 1 }
{ |F6| <= 98311b-14 /\ |F5| <= 81925b-14 -> batch_sphere_c_error * (1 + F5 * u) - F6 >= 1b-1 }
{ |DB| <= 65541b-14 -> DB * DB * u in [0, 1b-1] }

# By the unit direction. Its length, a component, B, C, D; and B's sign, where b^2 > C > 2 v unit_sphere_error - 7 v.
{ |F3| <= 49155b-14 -> |F3 / (sqrt(1 + F3 * v) + 1)| <= 24580b-14 }
{ |X| <= 24580b-14 /\ |E| <= 1 -> |X + E + X * E * v| <= 40966b-14 }
{ |X| <= 40966b-14 /\ |E| <= 1 -> |(E - X) / (1 + X * v)| <= 57352b-14 }
{ |Y| <= 57352b-14 /\ |F4| <= 65540b-14 -> |Y + F4 + Y * F4 * v| <= 122900b-14 }
{ s in [0, 1] /\ |F5| <= 81925b-14 /\ |E| <= 1 /\ |K1| <= 1 -> |(F5 - E * s) * (1 + K1 * v) + K1 * (1 - s)| <= 114698b-14 }
{ |DC| <= 114698b-14 /\ |F7| <= 114698b-14 /\ |H| <= 1b-16 -> |(DC + H) / (2 * batch_unit_sphere_error * (1 + F7 * v))| <= 1 }
{ |b| <= 1 /\ |c| <= 1 /\ |DB| <= 122900b-14 /\ |DC| <= 114698b-14 /\ |G2| <= 32770b-14 /\ |K1| <= 16385b-14 /\ |F7| <= 114698b-14 /\ |H| <= 1b-16 ->
   |((2 * b * dbv + dbv * dbv) * (1 + g2v) + b * b * g2v - dcv * (1 + k1v) - c * k1v + hv) / v / (2 * batch_unit_sphere_error * (1 + F7 * v))| <= 1 }
{ |DB| <= 122900b-14 -> DB * DB * v in [0, 1b-1] }
