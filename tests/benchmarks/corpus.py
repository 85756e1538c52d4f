"""Every URDF file of many packages: read or refused, forward, there and back, and drawn."""

from __future__ import annotations

import logging
import warnings
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import cache
from time import perf_counter

from tests.benchmarks.corpus_files import FOLDER, files, pins
from tests.benchmarks.corpus_findings import Findings, reason_of
from tests.benchmarks.corpus_look import PATIENCE, POSES, POSTURES, look
from tests.benchmarks.peers import LeftOut
from tests.benchmarks.report import verdict

from helicoide.kinematics.library import load_robot, robot_names

TITLE = "URDF files as others write them: each has an arm or is refused for a reason that is all right"
HOW = (
    "Each file by itself and with --tip for each end that moves where it branches or has no arm by itself. Forward",
    f"kinematics by all roads in {POSTURES} postures of each arm beside a reading of our own; there and back by what",
    f"`ik` calls from {POSES} postures in the limits, once per set of joints; a picture. {PATIENCE:.0f} s of CPU each.",
)
# Reasons for which a file is to be refused: it is no robot arm, or no URDF, or contradicts itself.
RIGHT = (
    "line #, column #: this is no XML",
    "the limits of joint … are # to #; lower must be below upper",
    "joint … has origin xyz=…: it is xacro",
    "joint … has origin rpy=…: give finite numbers",
    "joint … has limit lower=…: give finite numbers",
    "joint … is of type spherical; use one of",
    "it has no moving joints",
    "it has no links",
    "it has several roots",
    "it is xacro",
    "it starts with",
    "joint … names link …, which is not there",
    "joint … needs a name of its own",
    "link … needs a name of its own",
    "syntax error",
    "the links go in a circle",
    "two parents of link",
)
Named = Mapping[str, Findings]


def run(only: Sequence[str] = ()) -> None:
    """Look at the files of all packages, or of those that are named."""
    print("\n".join(f"  {line}" for line in HOW))
    begun, found = perf_counter(), dict[str, Findings]()
    with _quiet():
        _exercised()
        for pin in (pin for pin in pins() if not only or pin.split("==")[0] in only):
            try:
                of_package = files(pin)
            except LeftOut as reason:
                print(f"  {pin} is LEFT OUT: {reason}")
                continue
            package = pin.split("==")[0]
            seen = {f"{package}: {name}": look(path) for name, path in of_package.items()}
            with_arm = sum(bool(each.arms) for each in seen.values())
            seconds = sum(each.seconds for each in seen.values())
            print(f"  {pin:36} {len(seen):4} files, {with_arm:4} with an arm  {seconds:6.1f} s", flush=True)
            found |= seen
    report(found)
    print(f"  {len(found)} files in {perf_counter() - begun:.0f} s")


def report(found: Named) -> None:
    """Print what came of the files by name: what is listed first, then the figures."""
    _refusals("Files refused", {name: [each.refusal] for name, each in found.items() if each.refusal})
    ends = {name: [words for tip, words in each.refused.items() if tip] for name, each in found.items() if each.arms}
    _refusals("Ends refused in files that have an arm", ends)
    _refusals("Pictures refused", {name: [_unseen(name, each)] for name, each in found.items() if each.unseen})
    empty = [name for name, each in found.items() if each.picture == 0]
    _listed(
        "Empty pictures", (f"{name} ({'' if found[name].is_drawn else 'no '}visuals in the file)" for name in empty)
    )
    for title, kind in (("Tracebacks", "faults"), ('FALSE "reached"', "false"), ("Not reached", "missed")):
        _listed(title, (f"{name}: {said}" for name, each in found.items() for said in getattr(each, kind)))
    _listed("Too slow", (f"{name}: at {each.late}" for name, each in found.items() if each.late))
    _figures(list(found.values()), found)


def _figures(each: Sequence[Findings], found: Named) -> None:
    arms, asked, missed = (sum(map(count, each)) for count in (_arms, _asked, _missed))
    worst, road, name = max(((*seen.worst, name) for name, seen in found.items()), default=(0.0, "", ""))
    print(f"  {len(each)} files, {sum(bool(seen.arms) for seen in each)} with {arms} arms, {asked} poses")
    wrong = [seen.refusal for seen in each if seen.refusal and not is_right(seen.refusal)]
    verdict("files refused for another reason", len(wrong), 0, "")
    verdict("tracebacks", sum(len(seen.faults) for seen in each), 0, "")
    verdict(f"forward kinematics, worst difference ({name}: {road})", 1e9 * worst, 1, " nm, or 1e-9")
    verdict("not reached, of 1,000 poses", 1000 * missed / max(asked, 1), 1, "")
    verdict('false "reached"', sum(len(seen.false) for seen in each), 0, "")
    verdict("pictures empty or refused", sum(seen.picture == 0 or bool(seen.unseen) for seen in each), 0, "")
    verdict(f"files that take longer than {PATIENCE:.0f} s for one thing", sum(bool(seen.late) for seen in each), 0, "")


def is_right(words: str) -> bool:
    """Whether a file is to be refused for that."""
    return reason_of(words).startswith(RIGHT)


def _arms(each: Findings) -> int:
    return len(each.arms)


def _asked(each: Findings) -> int:
    return each.asked


def _missed(each: Findings) -> int:
    return len(each.missed)


def _unseen(name: str, each: Findings) -> str:
    """Why there is no picture, and whether the package has files of these names somewhere."""
    if "no mesh" not in each.unseen:
        return each.unseen
    return (
        f"{'they are' if set(each.meshes) <= _shipped(name.partition(':')[0]) else 'not'} in the package, {each.unseen}"
    )


@cache
def _shipped(package: str) -> set[str]:
    return {file.name for file in (FOLDER / package).rglob("*")}


def _refusals(title: str, refusals: Mapping[str, Iterable[str]]) -> None:
    """Reasons with how often they are given, the most frequent first; files are named unless a reason is all right."""
    given: dict[str, dict[str, str]] = {}
    counted = Counter[str]()
    for name, each in refusals.items():
        for words in each:
            counted[reason_of(words)] += 1
            given.setdefault(reason_of(words), {}).setdefault(name, words)
    print(f"  {title}: {counted.total()}")
    for reason, count in counted.most_common():
        print(f"    {count:4} × {reason}{' · all right' if is_right(reason) else ''}")
        for name, words in () if is_right(reason) else given[reason].items():
            print(f"             {name}: {words[:150]}")


def _listed(title: str, lines: Iterable[str]) -> None:
    lines = list(lines)
    print(f"  {title}: {len(lines)}")
    for line in lines:
        print(f"    {line}")


def _exercised() -> None:
    """Compile beforehand: no file's time is spent on it."""
    for name in robot_names()[:1]:
        look(load_robot(name).urdf, patience=300.0)


@contextmanager
def _quiet() -> Iterator[None]:
    """Without what the libraries that read files have to say."""
    before = logging.root.manager.disable
    logging.disable(logging.CRITICAL)
    try:
        with warnings.catch_warnings(action="ignore"):
            yield
    finally:
        logging.disable(before)
