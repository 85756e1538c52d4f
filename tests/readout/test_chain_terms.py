"""Why a number: the terms of a coefficient add up to it, each is its product, and it takes no time."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.readout.scenes import SCENES, scene

from helicoide import readout
from helicoide.geometry.clifford import CL031
from helicoide.readout import Chain, chain_terms


@pytest.mark.parametrize(("name", "seed"), SCENES)
def test_the_terms_add_up_to_the_coefficient(name: str, seed: int) -> None:
    state = scene(name, seed)
    chained = 0
    for element in readout.elements(state):
        chain = readout.chain_of(state, element)
        assert (chain is not None) == (element.selection.kind in ("tool", "link", "frame"))
        if chain is None:
            continue
        chained += 1
        values = element.values(state)
        np.testing.assert_allclose(chain.motor, values, atol=1e-12)
        for place in range(CL031.count):
            found = chain_terms(chain, place)
            total = chain.sign * sum(term.value for term in found.terms)
            assert total == pytest.approx(values[place], abs=1e-12)
            sizes = [abs(term.value) for term in found.terms]
            assert sizes == sorted(sizes, reverse=True)
            assert 0.0 not in sizes
    assert chained > len(state.robot.joints)


@pytest.mark.parametrize(("name", "seed"), SCENES[::3])
def test_each_term_is_the_product_of_its_factors(name: str, seed: int) -> None:
    """cos and sin of half of each joint value, half of each displacement, and the constant."""
    state = scene(name, seed)
    chain = readout.chain_of(state, readout.elements(state)[0])
    assert chain is not None
    slides = [joint.is_prismatic for joint in state.robot.joints]
    for place in range(CL031.count):
        for term in chain_terms(chain, place).terms:
            factors = [chain.values[i] / 2 if slides[i] else np.sin(chain.values[i] / 2) for i in term.sines]
            factors += [np.cos(chain.values[i] / 2) for i in term.cosines]
            assert term.value == pytest.approx(term.constant * float(np.prod(factors)), abs=1e-12)
            assert not set(term.sines) & set(term.cosines)


def test_a_joint_at_its_zero_is_in_no_sine() -> None:
    state = scene("puma560", 0)
    chain = readout.chain_of(state, readout.elements(state)[0])
    assert chain is not None
    still = replace(chain, values=np.where(np.arange(6) == 2, 0.0, chain.values))
    for place in range(CL031.count):
        assert all(2 not in (*term.sines, *term.cosines) for term in chain_terms(still, place).terms)


def test_a_long_chain_keeps_its_first_joints_together() -> None:
    """Thirteen joints: three stay one factor, the terms of the others add up all the same."""
    state = scene("puma560", 0)
    joints = (*state.robot.joints, *state.robot.joints, state.robot.joints[0])
    long = replace(state.robot, joints=joints)  # its cached properties are made anew
    values = np.random.default_rng(1).uniform(-2, 2, len(joints))
    chain = Chain(long, values, CL031.blade("1"))
    for place in range(CL031.count):
        found = chain_terms(chain, place)
        assert found.together == 3
        assert sum(term.value for term in found.terms) == pytest.approx(chain.motor[place], abs=1e-11)
