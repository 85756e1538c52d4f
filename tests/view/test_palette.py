"""The palette has everything that the tabs lead to, by name, in both languages."""

from __future__ import annotations

import pytest

from helicoide import content, studies
from helicoide.ik import methods
from helicoide.kinematics.library import load_robot, robot_titles
from helicoide.text import LANGUAGES
from helicoide.view import layers, panels
from helicoide.view.palette import ARM, LAYER, LESSON, METHOD, POSE, STUDY, TAB, palette
from helicoide.view.requests import ForArm, ForLab, ForStudyPanel, ShowTab


@pytest.mark.parametrize("name", robot_titles())
def test_the_palette_has_every_tab_layer_lesson_study_pose_method_and_arm(name: str) -> None:
    robot = load_robot(name)
    known = list(palette(robot))
    there = {text.en for text, _ in known}
    kinds = {
        TAB: len(panels.all_panels()),
        LAYER: len(layers.optional()),
        LESSON: len(list(content.content_folders("lessons"))),
        STUDY: len(list(studies.study_names())),
        POSE: len(robot.poses),
        METHOD: len(list(methods.names())),
        ARM: len(robot_titles()),
    }
    for form, number in kinds.items():
        assert sum(words.startswith(form.en.partition("{")[0]) for words in there) == number, form.en
    for language in LANGUAGES:
        assert len({text[language] for text, _ in known}) == len(known)
    assert sum(isinstance(request, ShowTab) for _, request in known) == kinds[TAB]
    assert sum(isinstance(request, ForLab) for _, request in known) == kinds[ARM]
    assert sum(isinstance(request, ForStudyPanel) for _, request in known) == kinds[STUDY]
    assert sum(isinstance(request, ForArm) for _, request in known) >= kinds[POSE] + kinds[METHOD]
