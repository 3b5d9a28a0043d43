#!/usr/bin/env python3
"""Makes distances.csv and prints the numbers that tests/identification/robust_loss_test.cpp holds the program to.

numpy 1.24 and scipy 1.10; nothing here comes from the program. Run: /usr/bin/python3 make.py
"""
import csv
import numpy as np
from scipy import integrate, optimize, stats

HUBER, CAUCHY = 1.345, 2.385


def slope(loss, s):  # derivative of rho by s, rho as in scipy.optimize.least_squares with f_scale
    s = np.asarray(s, dtype=float)
    if loss == "huber":
        return np.where(s <= HUBER**2, 1.0, HUBER / np.sqrt(np.maximum(s, 1e-300)))
    return 1.0 / (1.0 + s / CAUCHY**2)


def moments(loss, n):
    """E[psi^2], Var[psi^2], E[psi'] and E[slope] of s = chi2(n)/n; psi' by differentiating, not by Stein's lemma."""
    pdf = stats.chi2(n).pdf
    knee = n * HUBER**2

    def mean(f):
        parts = [(0.0, knee), (knee, 30.0), (30.0, 400.0)]
        return sum(integrate.quad(lambda x: f(x / n) * pdf(x), a, b, epsabs=1e-13, epsrel=1e-12, limit=500)[0]
                   for a, b in parts)

    def second(s):  # derivative of the slope by s
        if loss == "huber":
            return 0.0 if s <= HUBER**2 else -0.5 * HUBER * s**-1.5
        return -1.0 / CAUCHY**2 / (1.0 + s / CAUCHY**2) ** 2

    square = mean(lambda s: slope(loss, s)**2 * s)
    variance = mean(lambda s: (slope(loss, s)**2 * s)**2) - square**2
    derivative = mean(lambda s: slope(loss, s) + 2.0 / n * second(s) * s)
    return square, variance, derivative, mean(lambda s: slope(loss, s))


# The arm of Gao, Lu, Yang 2013, Table 1; standard Denavit-Hartenberg, mm and rad.
D = [300.0, 65.5, 792.7, 65.5, 883.2, 0.0]
ALPHA = [np.pi / 2] * 6
TIP = 183.5
FREE = ["d3", "d5", "alpha2", "theta4"]  # what is identified; all else is known


def tips(q, p):
    """Tips of joint angles q (n x 6) with the free parameters p added to the nominal ones."""
    n = len(q)
    point = np.tile([0.0, 0.0, TIP, 1.0], (n, 1))[:, :, None]
    for i in range(5, -1, -1):
        d = D[i] + (p[0] if i == 2 else p[1] if i == 4 else 0.0)
        alpha = ALPHA[i] + (p[2] if i == 1 else 0.0)
        theta = q[:, i] + (p[3] if i == 3 else 0.0)
        ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
        z = np.zeros(n)
        t = np.stack([np.stack([ct, -st * ca, st * sa, z], 1), np.stack([st, ct * ca, -ct * sa, z], 1),
                      np.stack([z, z + sa, z + ca, z + d], 1), np.stack([z, z, z, z + 1.0], 1)], 1)
        point = t @ point
    return point[:, :3, 0]


SIGMA, U, COUNT = 0.02, 0.01, 120  # mm: of a coordinate of a reading, of a certified distance
SPREAD = np.sqrt(2.0 * SIGMA**2 + U**2)  # of a distance that is read once at each end
SCALE = np.array([1.0, 1.0, 1e-3, 1e-3])


def estimate(q, lengths, loss):
    def residuals(x):
        p = x * SCALE
        apart = np.linalg.norm(tips(q[:, 0], p) - tips(q[:, 1], p), axis=1)
        return (apart - lengths) / SPREAD

    f_scale = {"linear": 1.0, "huber": HUBER, "cauchy": CAUCHY}[loss]
    x = np.zeros(4)
    for kind in ("linear", "huber", loss):  # to the minimum next to that of least squares
        x = optimize.least_squares(residuals, x, loss=kind, f_scale={"linear": 1.0, "huber": HUBER}.get(kind, f_scale),
                                   xtol=1e-14, ftol=1e-14, gtol=1e-14).x
    return x * SCALE


def main():
    for loss in ("huber", "cauchy"):
        for n in (1, 3):
            square, variance, derivative, mean = moments(loss, n)
            print(f"{{Loss::{loss.capitalize()}, {n}, {square:.12g}, {variance:.12g}, "
                  f"{derivative**2 / (square * mean):.12g}}},")
    random = np.random.default_rng(20261128)
    q = random.uniform(-2.5, 2.5, (COUNT, 2, 6))
    truth = np.array([0.4, -0.3, 4e-4, -6e-4])
    clean = np.linalg.norm(tips(q[:, 0], truth) - tips(q[:, 1], truth), axis=1)
    lengths = clean + SPREAD * random.normal(size=COUNT)
    lengths[77] = clean[77] + 5.0 * SPREAD
    q, lengths = np.round(q, 12), np.round(lengths, 9)
    with open("distances.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([f"{end}_q{i + 1}" for end in "ab" for i in range(6)] + ["length"])
        for i in range(COUNT):
            writer.writerow([f"{x:.12f}" for x in q[i].ravel()] + [f"{lengths[i]:.9f}"])
    for loss in ("linear", "huber", "cauchy"):
        print(loss, ", ".join(f"{name} {x:.9g}" for name, x in zip(FREE, estimate(q, lengths, loss))))
    draws = np.array([estimate(q, clean + SPREAD * random.normal(size=COUNT), "cauchy") for _ in range(300)])
    print("standard deviation of 300 cauchy estimates", draws.std(axis=0, ddof=1))


main()
