"""The filtered inverse of a matrix (Vargas 2013, §§4.3–4.4): what each inversion error does, seen in the axes of K."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import ceil

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import filtered_inverse, modal
from helicoide.ik.filtered_inverse import Parts, Update
from helicoide.kinematics.differential import frame_jacobian
from helicoide.studies.study import BY_CONSTRUCTION, Chart, ChartLine, Progress, Result, Row
from helicoide.studies.vargas.arms import planar_problem
from helicoide.studies.vargas.table import (
    SECONDS,
    Gain,
    run_row,
    sentence_statement,
    study_result,
    subsampled,
    symbol_value,
)
from helicoide.text import Text, untranslated

TITLE = Text(en="What Θ learns of a matrix", pt_BR="O que Θ aprende de uma matriz")
SOURCE = "Vargas 2013, §§4.3–4.4, eqs. 4.18–4.54, fig. 4.6"
ABOUT = Text(
    en="""Θ is on its way to the inverse of a Jacobian K that stands still, begun anywhere. In the axes of K it is a \
diagonal, dᵢ, which comes to 1/σᵢ, with the singular values σᵢ of K, and residuals rᵢⱼ, which come to zero. Look at \
what is left when only one of the two inversion errors acts, S_r = KΘ − I or S_ℓ = ΘK − I: a redundant joint keeps a \
motion that was not asked for, a coordinate too many keeps a reaction. Where σ is zero nothing is learnt, and nothing \
is forgotten.""",
    pt_BR="""Θ vai para a inversa de um Jacobiano constante K, partindo de qualquer valor. Nos eixos de K ela é uma \
diagonal, dᵢ, que chega a 1/σᵢ, com os valores singulares σᵢ de K, e resíduos rᵢⱼ, que chegam a zero. Observe o que \
sobra quando age só um dos dois erros de inversão, S_r = KΘ − I ou S_ℓ = ΘK − I: uma junta redundante mantém um \
movimento que ninguém pediu, uma coordenada a mais mantém uma reação. Onde σ é zero nada se aprende e nada se \
esquece.""",
)
ROBOT = "planar3r"
READY, STRETCHED = (np.pi / 6,) * 3, (np.pi / 2, 0.0, 0.0)
FIGURE = "fig. 4.6"
BOTH: dict[str, Update] = {"composite": "composite", "right": "right", "left": "left"}
NAMES = {
    "composite": Text(en="both errors", pt_BR="ambos os erros"),
    "right": Text(en="S_r alone", pt_BR="S_r sozinho"),
    "left": Text(en="S_ℓ alone", pt_BR="S_ℓ sozinho"),
}
# Γ_r = 2 Γ and Γ_ℓ = Γ/2; and a Γ that is no multiple of I
UNEQUAL: Parts = (2.0, 0.5)
MATRIX = np.array([[2.0, 0.5, 0.0], [0.5, 1.0, 0.3], [0.0, 0.3, 0.5]])
# how many of the steps show the first 3 % of the time, and from how many Θ(0) it is begun
EARLY, STARTS = 190, 10


@dataclass(frozen=True)
class Options:
    """gain: γ."""

    gain: Gain = 1.0


@dataclass(frozen=True, eq=False)
class FilterPath:
    """Θ (k, n, r) at times t (k,), s, for a constant K (r, n)."""

    K: Array
    t: Array
    Theta: Array

    @property
    def off(self) -> Array:
        """‖Θ − K†‖, (k,)."""
        return np.asarray(np.linalg.norm(self.Theta - np.linalg.pinv(self.K), axis=(1, 2)))

    def seen(self, gain: float) -> list[modal.ModalDiagnosis]:
        """The modal diagnosis of each."""
        return [modal.diagnosed(self.K, Theta, gain) for Theta in self.Theta]


def filter_path(K: Array, gain: Array | float, update: Update | Parts, seconds: float) -> FilterPath:
    """From a random Θ(0), by the rule of tab. 4.1, with a tenth of the stable step, stored more often at first."""
    t: Array = seconds * np.linspace(0, 1, 601) ** 3
    longest = filtered_inverse.step_limit(K, float(np.linalg.norm(np.atleast_2d(gain), 2)), update) / 10
    Theta = np.random.default_rng(1).normal(size=K.T.shape)
    found = [Theta]
    for between in np.diff(t):
        steps = ceil(between / longest)
        for _ in range(steps):
            Theta = filtered_inverse.euler(K, Theta, gain, between / steps, update)
        found.append(Theta)
    return FilterPath(K, t, np.array(found))


def largest_remaining_error(K: Array, gain: float, seconds: float) -> float:
    """The largest ‖Θ − K†‖ that remains from random Θ(0), by the rule of tab. 4.1, with half the stable step."""
    steps, left = ceil(2 * seconds / filtered_inverse.step_limit(K, gain)), []
    for Theta in np.random.default_rng(1).normal(size=(STARTS, *K.T.shape)):
        for _ in range(steps):
            Theta = filtered_inverse.euler(K, Theta, gain, seconds / steps)
        left.append(float(np.linalg.norm(Theta - np.linalg.pinv(K))))
    return max(left)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """A Jacobian of a redundant arm, its transpose, and a singular one."""
    gain, robot = options.gain, planar_problem().robot
    wide, singular = frame_jacobian(robot, READY)[:2], frame_jacobian(robot, STRETCHED)[:2]
    seconds = 100.0 / gain
    spare = {key: filter_path(wide, gain, update, seconds) for key, update in BOTH.items()}
    many = {key: filter_path(wide.T.copy(), gain, update, seconds) for key, update in BOTH.items()}
    stuck = filter_path(singular, gain, "composite", seconds)
    progress(0.5)
    of_matrix = filter_path(wide, gain * MATRIX, "composite", seconds)
    unequal = filter_path(wide, gain, UNEQUAL, seconds)
    rows = [
        *_converged({"2 × 3": largest_remaining_error(wide, gain, seconds), "3 × 2": largest_remaining_error(wide.T,
        gain, seconds)}, of_matrix), _growth(spare["composite"]), *_modes(spare["composite"], gain),
        *_kept(spare["right"], many["left"], stuck, gain), run_row(Text(en="‖Θ − K†‖ at the end, Γ_r = 2Γ, Γ_ℓ = Γ/2",
        pt_BR="‖Θ − K†‖ no fim, Γ_r = 2Γ, Γ_ℓ = Γ/2"), None,
            float(unequal.off[-1])),
    ]  # fmt: skip
    crossings = [_crossing(k * gain, 4e-3 if short else 1e-3) for k in (10.0, 100.0, 1000.0)]
    progress(1.0)
    gains = {
        untranslated("Γ = γI"): spare["composite"],
        untranslated("Γ_r = 2Γ, Γ_ℓ = Γ/2"): unequal,
        MATRICES: of_matrix,
    }
    charts = (
        _modes_chart(spare["composite"], gain),
        _residuals_chart(spare, gain),
        _over_time("V_c", {NAMES[key]: (one.t[:EARLY], _errors(one)[:EARLY]) for key, one in spare.items()}, log=False),
        _over_time("‖Θ − K†‖, 2 × 3", {NAMES[key]: (one.t, one.off) for key, one in spare.items()}),
        _over_time("‖Θ − K†‖, 3 × 2", {NAMES[key]: (one.t, one.off) for key, one in many.items()}),
        _over_time("‖Θ − K†‖, Γ", {name: (one.t, one.off) for name, one in gains.items()}),
        _plane(crossings, gain),
    )
    return study_result(rows, charts)


MATRICES = Text(en="a matrix Γ", pt_BR="Γ matricial")


def _errors(path: FilterPath) -> Array:
    """V_c = ½ tr(S_rᵀS_r) + ½ tr(S_ℓᵀS_ℓ)."""
    return np.array([sum(filtered_inverse.lyapunov(path.K, Theta)) for Theta in path.Theta])


def _converged(left: Mapping[str, float], of_matrix: FilterPath) -> list[Row]:
    """Where Θ comes to; left: how far it still is from there, by the shape of K."""
    comes = sentence_statement("Θ → K† from any Θ(0)", "Θ → K† de qualquer Θ(0)", "§4.3", 1e-6, "≤")
    any_gain = sentence_statement("Γ = Γᵀ > 0: Θ converges", "Γ = Γᵀ > 0: Θ converge", "§4.3", 1e-6, "≤")
    end = Text(en="‖Θ − K†‖ at the end, {which}", pt_BR="‖Θ − K†‖ no fim, {which}")
    of_ten = Text(en="{K}, largest of ten random Θ(0)", pt_BR="{K}, a maior de dez Θ(0) aleatórios")
    return [
        *(run_row(end.format(which=of_ten.format(K=K)), None, off, "", comes) for K, off in left.items()),
        run_row(end.format(which=MATRICES), None, float(of_matrix.off[-1]), "", any_gain),
    ]


def _growth(path: FilterPath) -> Row:
    """Rows: V_c never increases."""
    falls = sentence_statement("V̇_c ≤ 0", "V̇_c ≤ 0", "§4.3", 1e-9, "≤")
    grows = Text(en="largest growth of V_c in a step", pt_BR="maior crescimento de V_c em um passo")
    return run_row(grows, None, float(np.diff(_errors(path)).max()), "", falls)


def _modes(path: FilterPath, gain: float) -> list[Row]:
    """Θ̇ in the axes of K beside the laws of its diagonal and of its residuals; how fast both then fade, by tab. 4.1."""
    U, _, Vt = np.linalg.svd(path.K)
    off_diagonal, off_residual = 0.0, 0.0
    for Theta, here in zip(path.Theta, path.seen(gain), strict=True):
        moving = Vt @ filtered_inverse.filter_slope(path.K, Theta, gain) @ U
        d = -2 * gain * (here.sigma * here.d - 1) * here.sigma
        off_diagonal = max(off_diagonal, float(np.abs(moving.diagonal() - d).max()))
        np.fill_diagonal(moving, 0.0)
        off_residual = max(off_residual, float(np.abs(moving + here.rates * here.R).max()))
    law = "ḋᵢ = −2γ(σᵢdᵢ − 1)σᵢ", "ṙᵢⱼ = −γ(σᵢ² + σⱼ²)rᵢⱼ"
    differs = Text(en="largest difference of {what}", pt_BR="maior diferença de {what}")
    share = Text(en="rate at which {what} fades, over {rate}", pt_BR="taxa com que {what} se apaga, sobre {rate}")
    laws = [sentence_statement(said, said, place, 1e-9, "≤") for said, place in zip(law, PLACES, strict=True)]
    seen = path.seen(gain)
    slow = seen[0].sigma[1]
    faded = [[abs(one.d[1] - 1 / slow) for one in seen], [abs(one.R[2, 1]) for one in seen]]
    rates = [_rate(path.t, np.array(values)) for values in faded]
    half = [2 * gain * slow**2, gain * slow**2]
    names = [share.format(what="d₂ − 1/σ₂", rate="2γσ₂²"), share.format(what="r₃₂", rate="γσ₂²")]
    return [
        run_row(differs.format(what="ḋᵢ"), None, off_diagonal, "", laws[0], given=BY_CONSTRUCTION),
        run_row(differs.format(what="ṙᵢⱼ"), None, off_residual, "", laws[1], given=BY_CONSTRUCTION),
        *(
            run_row(name, None, rate / asked, "", sentence_statement(said, said, place, 1.0, "=", 0.05))
            for name, rate, asked, said, place in zip(names, rates, half, law, PLACES, strict=True)
        ),
    ]


PLACES = ("eq. 4.52", "eq. 4.54")


def _rate(t: Array, values: Array) -> float:
    """The decay rate, 1/s, of values, down to a thousandth of the first if they reach it."""
    there = int((values < 1e-3 * values[0]).argmax()) or len(values)
    return float(-np.polyfit(t[:there], np.log(values[:there]), 1)[0])


def _kept(spare: FilterPath, many: FilterPath, stuck: FilterPath, gain: float) -> list[Row]:
    """Rows: the parts of Θ that never decay."""
    of_spare, of_many, of_stuck = (one.seen(gain) for one in (spare, many, stuck))
    rows_of = sentence_statement(
        "with S_r alone the rows of Nul(K) never decay", "só com S_r as linhas de Nul(K) não decaem",
        "§4.4, obs. 1–3", 1.0, "=", 1e-6,
    )  # fmt: skip
    columns_of = sentence_statement(
        "with S_ℓ alone the columns of Nul(Kᵀ) never decay", "só com S_ℓ as colunas de Nul(Kᵀ) não decaem",
        "§4.4, obs. 1–3", 1.0, "=", 1e-6,
    )  # fmt: skip
    frozen = sentence_statement("σᵢ = 0: dᵢ is frozen", "σᵢ = 0: dᵢ fica congelado", "eq. 4.52", 1e-9, "≤")
    left = Text(en="residuals of {where} left, {alone}", pt_BR="resíduos de {where} que restam, {alone}")

    def share(first: Array, last: Array) -> float:
        return float(np.linalg.norm(last) / np.linalg.norm(first))

    moved = abs(float(of_stuck[-1].d[-1] - of_stuck[0].d[-1]))
    return [
        run_row(
            left.format(where="Nul(K)", alone=NAMES["right"]),
            None,
            share(of_spare[0].R[2], of_spare[-1].R[2]),
            "",
            rows_of,
            given=BY_CONSTRUCTION,
        ),
        run_row(
            left.format(where="Nul(Kᵀ)", alone=NAMES["left"]),
            None,
            share(of_many[0].R[:, 2], of_many[-1].R[:, 2]),
            "",
            columns_of,
            given=BY_CONSTRUCTION,
        ),
        run_row(
            Text(en="motion of d₂ where σ₂ = 0", pt_BR="movimento de d₂ onde σ₂ = 0"),
            None,
            moved,
            "",
            frozen,
            given=BY_CONSTRUCTION,
        ),
    ]


def _crossing(gain: float, dt: float) -> tuple[Array, Array]:
    """σ₃ = cos t and d₃ from 1 to 2π s, of K = diag(1, 0.5, cos t) in fixed axes."""
    t, Theta, found = np.arange(1, 2 * np.pi, dt), np.zeros((3, 3)), []
    for now in t:
        found.append(Theta[2, 2])
        Theta = filtered_inverse.exact_update(np.diag([1, 0.5, np.cos(now)]), Theta, gain, dt)
    return np.cos(t), np.array(found)


def _modes_chart(path: FilterPath, gain: float) -> Chart:
    d = np.array([one.d for one in path.seen(gain)]).T
    sigma = path.seen(gain)[0].sigma
    title = Text(en="diagonal, on its way to 1/σᵢ", pt_BR="diagonal, a caminho de 1/σᵢ")
    lines = [
        ChartLine(symbol_value(f"d{i}, σ{i}", round(s, 3)), path.t[:EARLY], of[:EARLY])
        for i, (s, of) in enumerate(zip(sigma, d, strict=True), 1)
    ]
    return Chart(title, SECONDS, untranslated("dᵢ"), tuple(lines), "§4.4")


def _residuals_chart(paths: Mapping[str, FilterPath], gain: float) -> Chart:
    lines = [
        ChartLine(NAMES[key], one.t, np.array([np.linalg.norm(here.R) for here in one.seen(gain)]))
        for key, one in paths.items()
    ]
    return Chart(
        Text(en="residuals", pt_BR="resíduos"), SECONDS, untranslated("‖R‖ = ‖(rᵢⱼ)‖"), tuple(lines), "§4.4", log=True
    )


def _over_time(up: str, values: Mapping[Text, tuple[Array, Array]], log: bool = True) -> Chart:
    lines = tuple(ChartLine(name, t, value) for name, (t, value) in values.items())
    title = Text(en="Θ on its way: {up}", pt_BR="Θ a caminho: {up}").format(up=up)
    return Chart(title, SECONDS, untranslated(up), lines, "§4.3", log)


def _plane(crossings: list[tuple[Array, Array]], gain: float) -> Chart:
    """The phase plane of a singular value that crosses zero twice."""
    lines = [
        ChartLine(symbol_value("γ", k * gain), subsampled(sigma), subsampled(d))
        for k, (sigma, d) in zip((10.0, 100.0, 1000.0), crossings, strict=True)
    ]
    return Chart(
        Text(en="d₃ over σ₃", pt_BR="d₃ em função de σ₃"), untranslated("σ₃"), untranslated("d₃"), tuple(lines), FIGURE
    )
