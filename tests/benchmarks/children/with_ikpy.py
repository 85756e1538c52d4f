"""ikpy, which has poses and no Jacobian; its vectors of joints have a place for the base and for the tool."""

from tempfile import NamedTemporaryFile

import numpy as np
from answer import Rows, Task, answer
from ikpy.chain import Chain


def tasks_of(urdf: str, tool: str, postures: Rows) -> list[Task]:
    with NamedTemporaryFile("w", suffix=".urdf") as file:
        file.write(urdf)
        file.flush()
        moving = [False, *(True for _ in postures[0]), False]
        chain = Chain.from_urdf_file(file.name, base_elements=["base"], active_links_mask=moving)
    qs = np.zeros((len(postures), len(moving)))
    qs[:, moving] = postures
    names = {"chain": chain, "qs": qs, "q": qs[0]}
    poses = "[chain.forward_kinematics(q) for q in qs]"
    return [
        Task("pose", "chain.forward_kinematics(q)", "chain.forward_kinematics(q)", names),
        Task("10,000 poses", "for q in qs: chain.forward_kinematics(q)", poses, names),
    ]


answer(tasks_of)
