"""Exercises of the six kinds, as lessons set them."""

from __future__ import annotations

from helicoide.lines import GivenKind, GivenName, LineExercise, LineKind
from helicoide.text import untranslated


def given(words: str) -> tuple[GivenName, ...]:
    """Names from words such as "angle: q1 q2; length: a"; a formula is written g = rotor(0, 0, 1, q1)."""
    names: list[GivenName] = []
    for part in filter(None, words.split(";")):
        if "=" in part:
            name, formula = part.split("=")
            names.append(GivenName(name.strip(), "formula", untranslated(name.strip()), formula.strip()))
        else:
            kind, several = part.split(":")
            names += [GivenName(name, kinds[kind.strip()], untranslated(name)) for name in several.split()]
    return tuple(names)


kinds: dict[str, GivenKind] = {
    "number": "number", "angle": "angle", "length": "length", "point": "point", "direction": "direction",
    "line": "line", "plane": "plane", "rotation": "rotation", "vector": "vector", "motor": "motor",
}  # fmt: skip


def exercise(kind: LineKind, names: str, expected: str) -> LineExercise:
    return LineExercise(kind, given(names), expected)


PQ = "number: p0 p1 p2 p3 q0 q1 q2 q3"
EXERCISES: dict[str, LineExercise] = {
    # quaternion product
    "rotate a vector": exercise("quaternion product", "rotation: q; vector: v", "q*v*conj(q)"),
    "first p then q": exercise("quaternion product", "rotation: p q", "q*p"),
    "yaw then pitch": exercise("quaternion product", "angle: a b", "(cos(a/2) + sin(a/2)*k)*(cos(b/2) + sin(b/2)*j)"),
    "real part": exercise("quaternion product", PQ, "p0*q0 - p1*q1 - p2*q2 - p3*q3"),
    "i part": exercise("quaternion product", PQ, "p0*q1 + p1*q0 + p2*q3 - p3*q2"),
    "inverse": exercise("quaternion product", "number: w x y z; p = quaternion(w, x, y, z)", "conj(p)/norm(p)**2"),
    # motor of a screw
    "rotor about z": exercise("motor", "angle: theta", "cos(theta/2) + sin(theta/2)*e1e2"),
    "screw about z": exercise(
        "motor",
        "angle: theta; length: a d",
        "translator(0, 0, d)*exp(theta/2*line(point(a, 0, 0), direction(0, 0, 1)))",
    ),
    "translation": exercise("motor", "length: x y z", "1 + x/2*e1e + y/2*e2e + z/2*e3e"),
    "rotor and shift": exercise(
        "motor", "angle: theta; length: x y; g = rotor(0, 0, 1, theta); t = x*e1 + y*e2", "g + 0.5*t*g*e"
    ),
    "about a line": exercise("motor", "angle: theta; line: L K", "exp(theta/2*L)"),
    "about a parallel of z": exercise("motor", "angle: theta; length: a", "cos(theta/2) + sin(theta/2)*(e1e2 - a*e2e)"),
    # chain of forward kinematics
    "planar 2R": exercise(
        "chain",
        "angle: q1 q2; length: a1 a2",
        "rotor(0, 0, 1, q1)*translator(a1, 0, 0)*rotor(0, 0, 1, q2)*translator(a2, 0, 0)",
    ),
    "successive screws": exercise(
        "chain", "angle: q1 q2 q3; line: L1 L2 L3; motor: M0", "screw(L1, q1)*screw(L2, q2)*screw(L3, q3)*M0"
    ),
    "moved point": exercise("chain", "angle: q1 q2; line: L1 L2; point: p", "exp(q1/2*L1)*exp(q2/2*L2) >> p"),
    "x of 3R": exercise(
        "chain", "angle: q1 q2 q3; length: a1 a2 a3", "a1*cos(q1) + a2*cos(q1 + q2) + a3*cos(q1 + q2 + q3)"
    ),
    "tool from station": exercise("chain", "motor: S W T", "conj(S)*W*T"),
    "polar arm": exercise(
        "chain",
        "angle: q1 q2; length: h d",
        "rotor(0, 0, 1, q1)*translator(0, 0, h)*rotor(0, -1, 0, q2)*translator(d, 0, 0)",
    ),
    # join or meet
    "line of two points": exercise("incidence", "point: p q", "join(p, q)"),
    "plane of three points": exercise("incidence", "point: p q r", "join(p, q, r)"),
    "line of two planes": exercise("incidence", "plane: A B", "meet(A, B)"),
    "point on a plane": exercise("incidence", "point: p q; plane: A B", "meet(join(p, q), A)"),
    "distance from a plane": exercise("incidence", "point: p q; plane: A", "0.5*dual(A*p - p*A)"),
    "vertical line": exercise("incidence", "length: x y", "e1e2 + y*e1e - x*e2e"),
    # column of a Jacobian
    "dx by dq1": exercise("jacobian", "angle: q1 q2; length: a1 a2", "-a1*sin(q1) - a2*sin(q1 + q2)"),
    "second column": exercise("jacobian", "angle: q1 q2; length: a1 a2", "-a2*sin(q1 + q2)*e1 + a2*cos(q1 + q2)*e2"),
    "moved axis": exercise("jacobian", "angle: q1 q2; line: L1 L2", "screw(L1, q1) >> L2"),
    "third axis": exercise("jacobian", "angle: q1 q2 q3; line: L1 L2 L3", "exp(q1/2*L1)*exp(q2/2*L2) >> L3"),
    "twist at the tool": exercise("jacobian", "length: x y; number: px py", "e1e2 + (y - py)*e1e - (x - px)*e2e"),
    "axis from the tool": exercise("jacobian", "length: x y z; line: L", "translator(-x, -y, -z) >> L"),
    # error of orientation or pose
    "orientation in the world": exercise("error", "rotation: wanted q", "wanted*conj(q)"),
    "orientation in the tool": exercise("error", "rotation: wanted q", "conj(q)*wanted"),
    "position": exercise("error", "point: target p", "target - p"),
    "screw in the tool": exercise("error", "motor: M D", "2*log(conj(M)*D)"),
    "pose in the world": exercise("error", "motor: M D", "D*conj(M)"),
    "feedback": exercise("error", "number: gain xd x vd", "vd + gain*(xd - x)"),
    # others of all kinds
    "dot": exercise("quaternion product", "vector: u v", "-0.5*(u*v + v*u)"),
    "cross": exercise("quaternion product", "vector: u v", "0.5*(u*v - v*u)"),
    "k part": exercise("quaternion product", "number: p0 p1 p2 p3 q0 q1 q2 q3", "p0*q3 + p3*q0 + p1*q2 - p2*q1"),
    "relative": exercise("quaternion product", "rotation: qa qb", "conj(qa)*qb"),
    "tilted": exercise("motor", "angle: phi; point: c; direction: n", "exp(phi/2*line(c, n))"),
    "pure x": exercise("motor", "angle: phi; length: d", "translator(d, 0, 0)*rotor(1, 0, 0, phi)"),
    "about x comps": exercise("motor", "angle: phi; length: d", "cos(phi/2) + sin(phi/2)*e2e3"),
    "dh": exercise(
        "chain",
        "angle: theta alpha; length: d a",
        "rotor(0, 0, 1, theta)*translator(0, 0, d)*translator(a, 0, 0)*rotor(1, 0, 0, alpha)",
    ),
    "y of 2R": exercise("chain", "angle: q1 q2; length: a1 a2", "a1*sin(q1) + a2*sin(q1 + q2)"),
    "r of polar": exercise("chain", "angle: q2; length: d h", "h + d*sin(q2)"),
    "hand": exercise("chain", "motor: A B C", "A*B*conj(C)"),
    "plane line point": exercise("incidence", "line: L; point: p", "join(L, p)"),
    "three planes": exercise("incidence", "plane: A B C", "meet(A, B, C)"),
    "foot": exercise("incidence", "plane: A; point: p", "project(p, A)"),
    "plane coords": exercise("incidence", "number: a b c; length: d", "a*e1 + b*e2 + c*e3 + d*e"),
    "col1 y": exercise("jacobian", "angle: q1 q2; length: a1 a2", "a1*cos(q1) + a2*cos(q1 + q2)"),
    "prismatic": exercise("jacobian", "angle: q1; length: d", "cos(q1)*e1e + sin(q1)*e2e"),
    "axis y": exercise("jacobian", "length: x z", "e3e1 - z*e1e + x*e3e"),
    "dls": exercise("error", "number: s lambda", "s/(s**2 + lambda**2)"),
    "rot err": exercise("error", "rotation: qd q", "2*part(qd*conj(q), k)"),
    "blend": exercise("error", "motor: M N; number: s", "M*exp(s*log(conj(M)*N))"),
    "euler zyx": exercise(
        "quaternion product",
        "angle: yaw pitch roll",
        "(cos(yaw/2) + sin(yaw/2)*k)*(cos(pitch/2) + sin(pitch/2)*j)*(cos(roll/2) + sin(roll/2)*i)",
    ),
    "rodrigues": exercise(
        "quaternion product", "angle: phi; number: a; vector: v", "v*cos(phi) + 0.5*(k*v - v*k)*sin(phi)"
    ),
    "slerp": exercise("quaternion product", "rotation: qa qb; number: s", "qa*exp(s*log(conj(qa)*qb))"),
    "screw pitch": exercise("motor", "angle: theta; length: h; line: L", "screw(L, theta, h*theta)"),
    "two turns": exercise("motor", "angle: alpha beta", "exp(alpha/2*e12)*exp(beta/2*e23)"),
    "scara": exercise(
        "chain",
        "angle: q1 q2; length: a1 a2 d",
        "rotor(0, 0, 1, q1)*translator(a1, 0, 0)*rotor(0, 0, 1, q2)*translator(a2, 0, -d)",
    ),
    "conjugated": exercise("chain", "motor: T; line: L; angle: q", "conj(T)*screw(L, q)*T"),
    "z of elbow": exercise("chain", "angle: q2 q3; length: h a2 a3", "h + a2*sin(q2) + a3*sin(q2 + q3)"),
    "plane of line": exercise("incidence", "point: p q r; plane: A", "meet(join(p, q, r), A)"),
    "common normal": exercise("incidence", "line: L1 L2", "common_normal(L1, L2)"),
    "angle of planes": exercise("incidence", "plane: A B", "angle(A, B)"),
    "y column": exercise("jacobian", "angle: q1 q2 q3; length: a1 a2 a3", "a2*cos(q1 + q2) + a3*cos(q1 + q2 + q3)"),
    "axis turned": exercise("jacobian", "angle: q1", "cos(q1)*e2e3 + sin(q1)*e3e1"),
    "rate": exercise("jacobian", "angle: q1 q2; length: a1; number: w1 w2", "w1*e12 + w2*(screw(e12, q1) >> e31)"),
    "pose err": exercise("error", "motor: M D", "log(D*conj(M))"),
    "weighted": exercise("error", "number: x xd y yd", "(xd - x)**2 + (yd - y)**2"),
}
